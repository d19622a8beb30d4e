//! How errors shrink with the step: convergence, consistency with the flow, drift of invariants.

use super::report::{Consistency, InvariantReport};
use super::residual::solve;
use residua::erased::{AnySolver, Point, Sample};
use residua::{Catalogued, Component};
use residua_tools::study::{
    Case, Conservation, Decay, Method, conservation, largest_difference, largest_size,
};
use std::ops::ControlFlow;

/// Relative size from which a difference between runs counts as rounding. Runs of some hundred steps
/// collect some hundred ε, and Newton's tolerance adds less.
const ROUNDING: f64 = 1e-11;

/// Steps of a run that consistency is looked at from.
const N_LOOKS: usize = 8;

/// The largest number of steps of a run: checks are short.
const MAX_STEPS: f64 = 1e5;

/// A short run on which orders are measured.
pub struct Range {
    /// Coarsest step.
    pub h: f64,
    /// Number of coarsest steps.
    pub steps: u64,
}

/// A state of a run.
pub struct Moment {
    /// Time.
    pub t: f64,
    /// Flat.
    pub state: Vec<f64>,
}

/// Runs of the same length with h, h/2 and h/4.
pub type Runs = [Vec<Moment>; 3];

impl Range {
    /// From 0 to `until` in steps of `h`.
    pub fn new(h: f64, until: f64) -> Result<Self, String> {
        let steps = (until / h).round();
        match h > 0.0 && h.is_finite() && (1.0..=MAX_STEPS).contains(&steps) {
            true => Ok(Self {
                h,
                steps: steps as u64,
            }),
            false => Err(format!(
                "{until} / {h} are {steps} steps; a check takes 1 to {MAX_STEPS} of positive length"
            )),
        }
    }
}

/// Every state of a run.
fn trajectory(
    solver: &dyn AnySolver,
    case: &Case,
    h: f64,
    steps: u64,
) -> Result<Vec<Moment>, String> {
    let mut moments = Vec::new();
    let outcome = solver.simulate(&case.run(h, steps), &mut |sample: Sample<'_>| {
        moments.push(Moment {
            t: sample.t,
            state: sample.state.to_vec(),
        });
        ControlFlow::Continue(())
    });
    outcome.map(|_| moments).map_err(|error| error.to_string())
}

/// The three runs of a solver from the model's own start.
pub fn runs(
    model: &'static Catalogued,
    solver: &dyn AnySolver,
    range: &Range,
) -> Result<Runs, String> {
    let case = Case::of_file(model);
    let run = |halvings: u32| {
        let parts = 1 << halvings;
        trajectory(solver, &case, range.h / parts as f64, range.steps * parts)
    };
    Ok([run(0)?, run(1)?, run(2)?])
}

/// Order of convergence from the last states: |x_h − x_{h/2}| against |x_{h/2} − x_{h/4}|.
pub fn convergence([coarse, middle, fine]: &Runs) -> Decay {
    let last = |run: &[Moment]| run.last().map_or(Vec::new(), |moment| moment.state.clone());
    let (coarse, middle, fine) = (last(coarse), last(middle), last(fine));
    let errors = [
        largest_difference(&coarse, &middle),
        largest_difference(&middle, &fine),
    ];
    Decay::new(&errors, ROUNDING * largest_size(&fine))
}

/// Largest |Δx/h − f(t + h/2, (x + x[k+1])/2)| over states along a run, for h, h/2 and h/4; `None` if the
/// model has no continuous equations. It vanishes with h if the residual discretises them.
pub fn consistency(
    model: &'static Catalogued,
    solver: &dyn AnySolver,
    range: &Range,
    run: &[Moment],
) -> Result<Option<Consistency>, String> {
    let Some(flow) = model.flow else {
        return Ok(None);
    };
    let case = Case::of_file(model);
    let mut errors = [0.0; 3];
    let mut floor = 0.0_f64;
    let mut worst = 0;
    for moment in run.iter().step_by(run.len().div_ceil(N_LOOKS)) {
        for (halvings, error) in errors.iter_mut().enumerate() {
            let h = range.h / f64::from(1 << halvings);
            let at = Point {
                parameters: &case.parameters,
                h,
                t: moment.t,
                state: &moment.state,
            };
            let solution = solve(solver, &at)
                .ok_or_else(|| format!("a step of {h} from t = {} has no solution", moment.t))?;
            let ends = moment.state.iter().zip(&solution.next);
            let middle: Vec<f64> = ends.clone().map(|(a, b)| a + (b - a) / 2.0).collect();
            let slope: Vec<f64> = ends.map(|(a, b)| (b - a) / h).collect();
            let mut rate = vec![0.0; slope.len()];
            flow.flow(&case.parameters, moment.t + h / 2.0, &middle, &mut rate);
            let apart = largest_difference(&slope, &rate);
            if apart > *error {
                *error = apart;
                let off = |i: usize| (slope[i] - rate[i]).abs();
                let components = 0..slope.len();
                worst = components
                    .max_by(|&i, &j| off(i).total_cmp(&off(j)))
                    .unwrap_or(0);
            }
            floor = floor.max(ROUNDING * largest_size(&moment.state) / h);
        }
    }
    let component = Component {
        variables: model.description.states,
        position: worst,
    };
    Ok(Some(Consistency {
        decay: Decay::new(&errors, floor),
        worst: component.to_string(),
    }))
}

/// Drift of every invariant over runs with h, h/2 and h/4.
pub fn invariants(
    model: &'static Catalogued,
    solver: &'static dyn AnySolver,
    range: &Range,
) -> Result<Vec<InvariantReport>, String> {
    let case = Case::of_file(model);
    let kept = conservation(&case, Method::Newton(solver), range.h, range.steps);
    let report = |found: Conservation| InvariantReport {
        name: found.name,
        drift: found.drift,
    };
    let kept = kept.map_err(|error| error.to_string())?;
    Ok(kept.into_iter().map(report).collect())
}
