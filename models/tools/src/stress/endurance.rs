//! A run of millions of steps, looked at from time to time.

use std::ops::ControlFlow;

use residua::Settings;
use residua::erased::AnySolver;
use residua::erased::Point;
use residua::erased::Run;
use residua_models::Entry;
use residua_models::values;

use super::Format;
use super::Twin;
use super::Verdict;
use super::wrong;

/// The step of models, in s; scenes have their own.
const STEP: f64 = 0.01;

/// Steps that are compared with those of the twin.
const LOOKS: u64 = 1000;

/// How a long run went.
pub struct Endurance {
    /// Steps that were taken.
    pub steps: u64,
    /// What came of those that were looked at.
    pub verdict: Verdict,
    /// The largest change of an invariant that one number tells, in units of its first value or, where that is small, of 1;
    /// and its name.
    pub drift: Option<(&'static str, f64)>,
}

/// Runs `entry` as its file has it.
pub fn endure(entry: &Entry, solver: &dyn AnySolver, twin: &Twin, steps: u64) -> Endurance {
    let model = entry.catalogued;
    let parameters = values::defaults(model);
    let start = values::start(model, &parameters);
    let h = model.description.scene.map_or(STEP, |scene| scene.step);
    let run = Run {
        parameters: &parameters,
        start: &start,
        h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
    };
    let between = (steps / LOOKS).max(1);
    let mut outputs =
        vec![0.0; values::total(model.description.outputs.iter().map(|o| &o.variable))];
    let mut invariants = |t: f64, state: &[f64]| -> Vec<f64> {
        model.model.outputs(&parameters, h, t, state, &mut outputs);
        scalars(entry)
            .map(|(_, position)| outputs[position])
            .collect()
    };
    let before = invariants(0.0, &start);
    let mut worst = vec![0.0_f64; before.len()];
    let mut seen = start.clone();
    let (mut taken, mut is_open, mut found) = (0, false, None);
    let outcome = solver.simulate(&run, &mut |sample| {
        if sample.step % between == 0 && sample.step > 0 {
            let at = Point {
                parameters: &parameters,
                h,
                t: h * (sample.step - 1) as f64,
                state: &seen,
            };
            match twin.step(solver, Format::Double, &at, sample.state) {
                Some(exact) => found = wrong(sample.step - 1, sample.state, &exact),
                None => is_open = true,
            }
            let now = invariants(sample.t, sample.state);
            for ((worst, now), before) in worst.iter_mut().zip(&now).zip(&before) {
                let change = (now - before).abs() / before.abs().max(1.0);
                // A NaN stays one.
                *worst = if change <= *worst || worst.is_nan() {
                    *worst
                } else {
                    change
                };
            }
        }
        taken = sample.step;
        seen.copy_from_slice(sample.state);
        match found {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        }
    });
    let verdict = match found {
        Some(wrong) => Verdict::Wrong(wrong),
        None if is_open => Verdict::Open,
        None if outcome.is_err() => Verdict::Refused,
        None => Verdict::Right,
    };
    let named = scalars(entry).map(|(name, _)| name).zip(worst);
    let drift = named.max_by(|a, b| a.1.total_cmp(&b.1));
    Endurance {
        steps: taken,
        verdict,
        drift,
    }
}

/// Invariants of one component, and where they are among the outputs.
fn scalars(entry: &Entry) -> impl Iterator<Item = (&'static str, usize)> {
    let mut offset = 0;
    let placed = entry
        .catalogued
        .description
        .outputs
        .iter()
        .map(move |output| {
            offset += values::size(&output.variable);
            (output, offset - values::size(&output.variable))
        });
    let scalar =
        placed.filter(|(output, _)| output.invariant && values::size(&output.variable) == 1);
    scalar.map(|(output, position)| (output.variable.name, position))
}
