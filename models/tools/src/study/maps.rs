//! Which schemes are the same map: they take the same steps, in whatever variables.

use super::case::Case;
use super::distance::largest_size;
use super::method::Method;
use super::signals::Correspondence;
use super::signals::Course;
use super::signals::Signals;
use residua::erased::Sample;
use std::ops::ControlFlow;

/// The step of the comparison: so large that schemes of second order differ by 1e-3.
pub const STEP: f64 = 0.05;
/// Its steps.
pub const STEPS: u64 = 40;
/// Largest difference, relative to the size of a signal, of maps that are the same: Newton's tolerance
/// and rounding, magnified along the motion, leave 1e-11.
pub const SAME: f64 = 1e-9;

/// A scheme with its course.
pub struct Map {
    /// Its model.
    pub model: &'static str,
    /// `next` or `increment`.
    pub form: &'static str,
    /// Why it has no course.
    pub error: Option<String>,
    /// Position of the first scheme in the list that takes the same steps; its own if there is none before.
    pub class: usize,
    /// Largest relative difference from each scheme before it in the list, and of how many signals; `None`
    /// where there is nothing to compare.
    pub differences: Vec<Option<(f64, usize)>>,
}

/// A scheme, run.
struct Walk {
    exact: Course,
    signals: Vec<Vec<f64>>,
    error: Option<String>,
}

/// The implicit schemes of `cases`, each with the class it belongs to. The cases must be one motion, without
/// symmetries, up to the time `until`, in which signals are matched.
pub fn same_maps(cases: &[Case], until: f64) -> Vec<Map> {
    let mut maps: Vec<Map> = Vec::new();
    let mut walks: Vec<Walk> = Vec::new();
    for case in cases {
        let exact = Course::new(case, until);
        for method in Method::of(case.model) {
            let Method::Newton(_) = method else { continue };
            let walk = Walk::new(case, method, exact.clone());
            let differences: Vec<_> = walks.iter().map(|w| walk.difference(w)).collect();
            let twin = differences
                .iter()
                .position(|d| d.is_some_and(|(difference, _)| difference <= SAME));
            maps.push(Map {
                model: case.model.description.name,
                form: method.name(),
                error: walk.error.clone(),
                class: twin.map_or(maps.len(), |twin| maps[twin].class),
                differences,
            });
            walks.push(walk);
        }
    }
    maps
}

impl Walk {
    fn new(case: &Case, method: Method, exact: Course) -> Self {
        let mut signals = Vec::new();
        let outcome = method.simulate(&case.run(STEP, STEPS), &mut |sample: Sample<'_>| {
            signals.push(Signals::read(case, STEP, sample.t, sample.state).values);
            ControlFlow::Continue(())
        });
        Self {
            exact,
            signals,
            error: outcome.err().map(|error| error.to_string()),
        }
    }

    /// The largest difference of what both have, and how many signals that is.
    fn difference(&self, other: &Walk) -> Option<(f64, usize)> {
        if self.error.is_some() || other.error.is_some() {
            return None;
        }
        let alike = Correspondence::new(&[&self.exact], &[&other.exact]);
        let scales = self.exact.scales();
        let pairs = self.signals.iter().zip(&other.signals);
        let differences: Vec<f64> = pairs
            .map(|(one, other)| alike.difference(one, other, scales))
            .collect();
        let shared = alike.pairs.len();
        (shared > 0).then(|| (largest_size(&differences), shared))
    }
}
