//! Runs, their errors and their times.

use super::contest::Contestant;
use super::contest::Rung;
use super::meter::Errors;
use super::meter::Meter;
use super::problem::Problem;
use super::row::Row;
use crate::race::Lane;
use residua_models::effort::Effort;
use std::time::Instant;

/// Turns in which runs are timed, so that a slow moment of the machine is one for all.
const TURNS: usize = 4;

/// Slow runs in a row after which a ladder ends.
const SLOW: u32 = 2;

/// What may be spent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Budget {
    /// Timed runs of each kind, fewer for slow ones.
    pub runs: usize,
    /// Time for those of one kind, s: what takes longer is run less often, but once.
    pub together: f64,
    /// A contestant climbs its ladder until two runs in a row take longer than this, s: steps so long that their equations are
    /// hard to solve can take longer than shorter ones.
    pub longest: f64,
}

impl Budget {
    /// Runs of what takes `seconds`.
    fn runs(&self, seconds: f64) -> usize {
        let affordable = (self.together / seconds).floor();
        if affordable < self.runs as f64 {
            (affordable as usize).max(1)
        } else {
            self.runs
        }
    }
}

/// Runs all `contestants` and returns a row per run. `progress` is told of each that has been judged or timed: the
/// position and the number of all.
pub fn measure(
    problem: &Problem,
    contestants: &[Contestant<'_>],
    budget: &Budget,
    progress: &mut dyn FnMut(usize, usize),
) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut lanes = Vec::new();
    for (position, contestant) in contestants.iter().enumerate() {
        let mut slow = 0;
        for &rung in &contestant.rungs {
            let (row, mut seconds) = judge(problem, contestant, rung);
            if let Some(seconds) = seconds.as_mut().filter(|taken| **taken > budget.longest) {
                // Once more: the first may have been a slow moment of the machine.
                let clock = Instant::now();
                let again = contestant.solve(rung, None);
                if again.is_ok() {
                    *seconds = seconds.min(clock.elapsed().as_secs_f64());
                }
            }
            let lane = seconds.map(|seconds| {
                let run = move || contestant.solve(rung, None).map(|(end, _)| end);
                (Lane::new("", 1.0, run), budget.runs(seconds))
            });
            rows.push(row);
            lanes.push(lane);
            slow = match seconds {
                Some(seconds) if seconds > budget.longest => slow + 1,
                _ => 0,
            };
            if slow == SLOW {
                break;
            }
        }
        progress(position + 1, contestants.len() * (1 + TURNS));
    }
    for turn in 1..=TURNS {
        for lane in &mut lanes {
            let Some((runner, runs)) = lane else { continue };
            if time(runner, *runs * turn / TURNS).is_err() {
                *lane = None;
            }
        }
        let done = contestants.len() * (1 + turn);
        progress(done, contestants.len() * (1 + TURNS));
    }
    for (row, lane) in rows.iter_mut().zip(&lanes) {
        if let Some((lane, _)) = lane {
            row.seconds = lane.quantile(0.0);
            row.runs = lane.runs();
        }
    }
    rows
}

/// Runs a lane once untimed, then until it was timed so often.
fn time(lane: &mut Lane<'_, String>, runs: usize) -> Result<(), String> {
    if lane.runs() >= runs {
        return Ok(());
    }
    lane.end()?;
    while lane.runs() < runs {
        lane.time()?;
    }
    Ok(())
}

/// The row of a run without its time, and about how long it takes, s, if it gets to its end.
fn judge(problem: &Problem, contestant: &Contestant<'_>, rung: Rung) -> (Row, Option<f64>) {
    let mut meter = Meter::new(problem, contestant.formulation);
    let clock = Instant::now();
    let plain = contestant.solve(rung, None);
    let seconds = clock.elapsed().as_secs_f64();
    let judged = plain.and_then(|(end, effort)| {
        contestant.solve(rung, Some(&mut |state| meter.visit(state)))?;
        let errors = meter.judge(&end);
        match errors.trajectory.is_nan() {
            true => Err("its end is not finite".to_owned()),
            false => Ok((errors, effort)),
        }
    });
    let (errors, effort, failure) = match judged {
        Ok((errors, effort)) => (errors, effort, String::new()),
        Err(failure) => (Errors::NONE, Effort::default(), failure),
    };
    let (step, tolerance) = match rung {
        Rung::Step { h, .. } => (Some(h), None),
        Rung::Tolerance(tolerance) => (None, Some(tolerance)),
    };
    let is_sound = failure.is_empty();
    let row = Row {
        scene: problem.name.clone(),
        model: contestant.formulation.name().to_owned(),
        scheme: contestant.scheme.clone(),
        by: contestant.by.to_owned(),
        step,
        tolerance,
        seconds: f64::NAN,
        runs: 0,
        steps: effort.steps,
        evaluations: effort.evaluations,
        trajectory: f64::NAN,
        phase: f64::NAN,
        energy: f64::NAN,
        constraint: f64::NAN,
        momentum: f64::NAN,
        failure,
    };
    (row.with(errors), is_sound.then_some(seconds))
}
