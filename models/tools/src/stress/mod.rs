//! A model under stress: every step either right within its bound or refused, and nothing silently wrong.
//!
//! Runs are made from the description of the model (`cases`), and each accepted step is compared with its [`Twin`] in
//! double-double numbers, from the state that it began with.

mod back;
mod cases;
mod endurance;
mod format;
mod frames;
mod running;
mod twin;
mod units;

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::PoisonError;

use residua::Fleet;
use residua::RunError;
use residua::Settings;
use residua::Statistics;
use residua::erased::AnySolver;
use residua::erased::Observer;
use residua::erased::Point;
use residua::erased::Run;
use residua_models::Entry;

pub use back::on_their_way_back;
pub use cases::Case;
pub use cases::Kind;
pub use cases::cases;
pub use endurance::Endurance;
pub use endurance::endure;
pub use format::Format;
pub use frames::in_other_frames;
pub use running::Running;
pub use twin::Exact;
pub use twin::Twin;
use twin::off;
pub use units::in_other_units;

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

/// Makes the run of `case`, `steps` long, by itself and as an ensemble of one, and tells what was the worse.
pub fn judge(solver: &dyn AnySolver, twin: &Twin, case: &Case, steps: u64) -> Verdict {
    let [alone, together] = [alone(solver, case, steps), together(solver, case, steps)]
        .map(|made| judge_run(solver, twin, Format::Double, case, &made));
    let severity = |verdict: &Verdict| match verdict {
        Verdict::Right => 0,
        Verdict::Refused => 1,
        Verdict::Open => 2,
        Verdict::Wrong(_) => 3,
    };
    match severity(&together) > severity(&alone) {
        true => together,
        false => alone,
    }
}

/// Makes the run in `f32`, with the numbers of `case` rounded to it.
pub fn judge_in_single(solver: &dyn AnySolver, twin: &Twin, case: &Case, steps: u64) -> Verdict {
    let format = Format::Single;
    let nearest = |values: &[f64]| values.iter().map(|x| format.nearest(*x)).collect();
    let case = Case {
        kind: case.kind,
        parameters: nearest(&case.parameters),
        start: nearest(&case.start),
        h: format.nearest(case.h),
    };
    let made = alone_by(&case, steps, |run, observer| {
        solver.simulate_in_single(run, observer)
    });
    judge_run(solver, twin, format, &case, &made)
}

/// A run that was made.
struct Made {
    times: Vec<f64>,
    states: Vec<Vec<f64>>,
    error: Option<RunError>,
}

fn alone(solver: &dyn AnySolver, case: &Case, steps: u64) -> Made {
    alone_by(case, steps, |run, observer| solver.simulate(run, observer))
}

fn alone_by(
    case: &Case,
    steps: u64,
    simulate: impl Fn(&Run, &mut Observer) -> Result<Statistics, RunError>,
) -> Made {
    let (mut times, mut states) = (Vec::new(), Vec::new());
    let run = Run {
        parameters: &case.parameters,
        start: &case.start,
        h: case.h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
    };
    let outcome = simulate(&run, &mut |sample| {
        times.push(sample.t);
        states.push(sample.state.to_vec());
        ControlFlow::Continue(())
    });
    let error = outcome.err();
    Made {
        times,
        states,
        error,
    }
}

fn together(solver: &dyn AnySolver, case: &Case, steps: u64) -> Made {
    let shown = Mutex::new(BTreeMap::new());
    let fleet = Fleet {
        trajectories: 0..1,
        fill: &|_, parameters, start| {
            parameters.copy_from_slice(&case.parameters);
            start.copy_from_slice(&case.start);
        },
        h: case.h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
        observer: &|_, sample| {
            let mut shown = shown.lock().unwrap_or_else(PoisonError::into_inner);
            shown.insert(sample.step, (sample.t, sample.state.to_vec()));
        },
    };
    let error = match solver.fly(&fleet) {
        Ok(outcomes) => outcomes.first().and_then(|outcome| outcome.error),
        Err(invalid) => Some(invalid.into()),
    };
    let shown = shown.into_inner().unwrap_or_else(PoisonError::into_inner);
    let (times, states) = shown.into_values().unzip();
    Made {
        times,
        states,
        error,
    }
}

fn judge_run(
    solver: &dyn AnySolver,
    twin: &Twin,
    format: Format,
    case: &Case,
    made: &Made,
) -> Verdict {
    let Made {
        times,
        states,
        error,
    } = made;
    if case.kind == Kind::NotFinite && !matches!(error, Some(RunError::Invalid(_))) {
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
            t: times[step],
            state: &pair[0],
        };
        match twin.step(solver, format, &at, &pair[1]) {
            Some(exact) => {
                if let Some(wrong) = wrong(step as u64, &pair[1], &exact) {
                    return Verdict::Wrong(wrong);
                }
            }
            None => is_open = true,
        }
    }
    match (error.is_some(), is_open) {
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
