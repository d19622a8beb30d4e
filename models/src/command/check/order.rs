//! How errors shrink with the step: convergence, consistency with the flow, drift of invariants.

use super::report::{Decay, InvariantReport};
use super::residual::{largest_difference, solve};
use crate::columns::{ordered_outputs, size};
use crate::values;
use residua::erased::{AnySolver, Point, Run, Sample};
use residua::{Catalogued, Settings};
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

/// Parameters and start state.
pub struct Start {
    /// Flat.
    pub parameters: Vec<f64>,
    /// Flat.
    pub state: Vec<f64>,
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

impl Start {
    /// The model's own.
    pub fn of(model: &Catalogued) -> Self {
        let parameters = values::defaults(model);
        let state = values::start(model, &parameters);
        Self { parameters, state }
    }
}

/// Every state of a run.
fn trajectory(
    solver: &dyn AnySolver,
    start: &Start,
    h: f64,
    steps: u64,
) -> Result<Vec<Moment>, String> {
    let run = Run {
        parameters: &start.parameters,
        start: &start.state,
        h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
    };
    let mut moments = Vec::new();
    let outcome = solver.simulate(&run, &mut |sample: Sample<'_>| {
        moments.push(Moment {
            t: sample.t,
            state: sample.state.to_vec(),
        });
        ControlFlow::Continue(())
    });
    outcome.map(|_| moments).map_err(|error| error.to_string())
}

/// The three runs of a solver from the model's own start.
pub fn runs(model: &Catalogued, solver: &dyn AnySolver, range: &Range) -> Result<Runs, String> {
    let start = Start::of(model);
    let run = |halvings: u32| {
        let parts = 1 << halvings;
        trajectory(solver, &start, range.h / parts as f64, range.steps * parts)
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
    model: &Catalogued,
    solver: &dyn AnySolver,
    range: &Range,
    run: &[Moment],
) -> Result<Option<Decay>, String> {
    let Some(flow) = model.flow else {
        return Ok(None);
    };
    let start = Start::of(model);
    let mut errors = [0.0; 3];
    let mut floor = 0.0_f64;
    for moment in run.iter().step_by(run.len().div_ceil(N_LOOKS)) {
        for (halvings, error) in errors.iter_mut().enumerate() {
            let h = range.h / f64::from(1 << halvings);
            let at = Point {
                parameters: &start.parameters,
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
            flow.flow(&start.parameters, moment.t + h / 2.0, &middle, &mut rate);
            *error = f64::max(*error, largest_difference(&slope, &rate));
            floor = floor.max(ROUNDING * largest_size(&moment.state) / h);
        }
    }
    Ok(Some(Decay::new(&errors, floor)))
}

/// Drift of every invariant over the runs with h and h/2.
pub fn invariants(model: &Catalogued, [coarse, middle, _]: &Runs) -> Vec<InvariantReport> {
    let placed = ordered_outputs(model.description);
    let n_outputs = placed.iter().map(|output| size(output.variable)).sum();
    let Start { parameters, .. } = Start::of(model);
    let outputs = |moment: &Moment, h: f64| {
        let mut values = vec![0.0; n_outputs];
        model
            .model
            .outputs(&parameters, h, moment.t, &moment.state, &mut values);
        values
    };
    let mut reports = Vec::new();
    for output in placed.iter().filter(|output| output.invariant) {
        let own = output.offset..output.offset + size(output.variable);
        let drift = |run: &[Moment]| {
            let h = run.get(1).map_or(0.0, |moment| moment.t - run[0].t);
            let first = outputs(&run[0], h)[own.clone()].to_vec();
            let drifts = run
                .iter()
                .map(|m| largest_difference(&outputs(m, h)[own.clone()], &first));
            drifts.fold(0.0, f64::max)
        };
        let terms = middle.last().map_or(0.0, |moment| {
            term_size(&moment.state, |state| {
                let shifted = Moment {
                    t: moment.t,
                    state: state.to_vec(),
                };
                outputs(&shifted, 0.0)[own.clone()].to_vec()
            })
        });
        reports.push(InvariantReport {
            name: output.variable.name,
            drift: Decay::new(&[drift(coarse), drift(middle)], ROUNDING * terms),
        });
    }
    reports
}

/// Σⱼ |∂y/∂xⱼ| |xⱼ|: how large the terms of y are, even where they cancel.
fn term_size(state: &[f64], value: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
    const SHIFT: f64 = 1e-3;
    let here = value(state);
    let mut shifted = state.to_vec();
    let mut sum = largest_size(&here);
    for (j, &x) in state.iter().enumerate() {
        shifted[j] = x * (1.0 + SHIFT);
        sum += largest_difference(&value(&shifted), &here) / SHIFT;
        shifted[j] = x;
    }
    sum
}

fn largest_size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |size, value| size.max(value.abs()))
}
