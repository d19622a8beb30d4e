//! A model under stress: every step either right within its bound or refused, and nothing silently wrong.
//!
//! Runs are made from the description of the model (`cases`), and each accepted step is compared with its [`Twin`] in
//! double-double numbers, from the state that it began with.

mod cases;
mod twin;

use std::ops::ControlFlow;

use residua::RunError;
use residua::Settings;
use residua::erased::AnySolver;
use residua::erased::Point;
use residua::erased::Run;

use crate::Entry;

pub use cases::Case;
pub use cases::Kind;
pub use cases::cases;
pub use twin::Exact;
pub use twin::Twin;
use twin::off;

/// How a run went.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// All steps were right.
    Right,
    /// Some steps were right, if any, and then one was refused, or the run was.
    Refused,
    /// No step was wrong, but of one at least there is no telling: what 31 digits or the range of `f64` hold is exceeded.
    Open,
    /// A step was accepted that is not right.
    Wrong(Wrong),
}

/// A step that should not have been accepted.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// Steps before it.
    pub step: u64,
    /// The component that is furthest off.
    pub component: usize,
    /// What it is.
    pub found: f64,
    /// What it should be.
    pub expected: f64,
    /// How far it may be off.
    pub bound: f64,
}

/// Makes the run of `case`, `steps` long, and judges it.
pub fn judge(solver: &dyn AnySolver, twin: &Twin, case: &Case, steps: u64) -> Verdict {
    let mut states: Vec<Vec<f64>> = Vec::new();
    let run = Run {
        parameters: &case.parameters,
        start: &case.start,
        h: case.h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
    };
    let outcome = solver.simulate(&run, &mut |sample| {
        states.push(sample.state.to_vec());
        ControlFlow::Continue(())
    });
    if case.kind == Kind::NotFinite && !matches!(outcome, Err(RunError::Invalid(_))) {
        return Verdict::Wrong(Wrong {
            step: 0,
            component: 0,
            found: f64::NAN,
            expected: f64::NAN,
            bound: 0.0,
        });
    }
    let mut is_open = false;
    for (step, pair) in states.windows(2).enumerate() {
        let at = Point {
            parameters: &case.parameters,
            h: case.h,
            t: step as f64 * case.h,
            state: &pair[0],
        };
        match twin.step(solver, &at, &pair[1]) {
            Some(exact) => {
                if let Some(wrong) = wrong(step as u64, &pair[1], &exact) {
                    return Verdict::Wrong(wrong);
                }
            }
            None => is_open = true,
        }
    }
    match (outcome.is_err(), is_open) {
        (_, true) => Verdict::Open,
        (true, false) => Verdict::Refused,
        (false, false) => Verdict::Right,
    }
}

/// The component that is furthest beyond its bound.
fn wrong(step: u64, found: &[f64], exact: &Exact) -> Option<Wrong> {
    let mut worst: Option<(f64, Wrong)> = None;
    for (component, (&found, next)) in found.iter().zip(&exact.next).enumerate() {
        let bound = exact.bound[component];
        let off = off(found, *next);
        // What is not a number is beyond every bound.
        let ratio = if off <= bound {
            continue;
        } else if off.is_nan() {
            f64::INFINITY
        } else {
            off / bound
        };
        if worst.as_ref().is_none_or(|(most, _)| ratio > *most) {
            let expected = next.to_f64();
            let wrong = Wrong {
                step,
                component,
                found,
                expected,
                bound,
            };
            worst = Some((ratio, wrong));
        }
    }
    worst.map(|(_, wrong)| wrong)
}

/// The twins of all solvers of `entry`, each with its solver.
pub fn twins(entry: &Entry) -> Vec<(&'static dyn AnySolver, Twin)> {
    let solvers = entry.catalogued.solvers.iter().copied();
    solvers
        .filter_map(|solver| Some((solver, Twin::new(entry, solver)?)))
        .collect()
}
