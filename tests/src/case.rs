//! What tests do with a catalogued model, its parameters and a start.

use crate::points::Points;
use residua::description::Variable;
use residua::erased::{AnySolver, Catalogued, Point, Run, Sample};
use residua::{Fleet, Outcome, Settings};
use std::ops::ControlFlow;

pub use residua_tools::study::Case;

/// A [`Case`] in a test.
pub trait Tested: Sized {
    /// Parameters near those of the file. A symmetric matrix stays symmetric; zeros do not stay zero.
    fn varied(model: &'static Catalogued, points: &mut Points) -> Self;
    /// The same with 3 to 6 added to every state that is a rate or a momentum (its unit has `/s`), so that
    /// the motion is large.
    fn kicked(self, points: &mut Points) -> Self;
    /// The point at which a step of size `h` starts at `state`.
    fn at<'a>(&'a self, h: f64, state: &'a [f64]) -> Point<'a>;
    /// Runs `solver` and collects the state at every step, the start included.
    fn states(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<Vec<f64>>;
    /// Runs `solver` and returns the state after the last step.
    fn last_state(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<f64>;
    /// A run of which only the end is shown.
    fn unobserved(&self, h: f64, steps: u64) -> Run<'_>;
    /// An ensemble of one by `increment`, which is shown after each step.
    fn fly(&self, h: f64, steps: u64, observer: &(dyn Fn(Sample) + Sync)) -> Outcome;
}

impl Tested for Case {
    fn varied(model: &'static Catalogued, points: &mut Points) -> Self {
        let mut parameters = Self::of_file(model).parameters;
        let mut offset = 0;
        for variable in model.description.parameters {
            let n = variable.rows * variable.cols;
            vary(variable, &mut parameters[offset..offset + n], points);
            offset += n;
        }
        Self::with_parameters(model, parameters)
    }

    fn kicked(mut self, points: &mut Points) -> Self {
        let mut offset = 0;
        for variable in self.model.description.states {
            let n = variable.rows * variable.cols;
            if variable.unit.contains("/s") {
                for (value, kick) in self.start[offset..offset + n]
                    .iter_mut()
                    .zip(points.numbers(n))
                {
                    *value += 4.5 + 0.75 * kick;
                }
            }
            offset += n;
        }
        self
    }

    fn at<'a>(&'a self, h: f64, state: &'a [f64]) -> Point<'a> {
        Point {
            parameters: &self.parameters,
            h,
            t: 0.0,
            state,
        }
    }

    fn states(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<Vec<f64>> {
        let mut states = Vec::new();
        let run = self.run(h, steps);
        let outcome = solver.simulate(&run, &mut |sample| {
            states.push(sample.state.to_vec());
            ControlFlow::Continue(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", self.model.description.name));
        states
    }

    fn last_state(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<f64> {
        let mut last = Vec::new();
        let outcome = solver.simulate(&self.unobserved(h, steps), &mut |sample| {
            last = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", self.model.description.name));
        last
    }

    fn unobserved(&self, h: f64, steps: u64) -> Run<'_> {
        Run {
            every: 0,
            ..self.run(h, steps)
        }
    }

    fn fly(&self, h: f64, steps: u64, observer: &(dyn Fn(Sample) + Sync)) -> Outcome {
        let fleet = Fleet {
            trajectories: 0..1,
            fill: &|_, parameters, start| {
                parameters.copy_from_slice(&self.parameters);
                start.copy_from_slice(&self.start);
            },
            h,
            t0: 0.0,
            steps,
            every: 1,
            settings: Settings::default(),
            observer: &|_, sample| observer(sample),
        };
        let outcomes = solver(self.model, "increment").fly(&fleet);
        outcomes.expect("a run")[0]
    }
}

/// The solver of `model` for `form`.
pub fn solver(model: &Catalogued, form: &str) -> &'static dyn AnySolver {
    let found = model.solvers.iter().find(|s| s.solver().form == form);
    *found.unwrap_or_else(|| panic!("{} has no form {form}", model.description.name))
}

fn vary(variable: &Variable, values: &mut [f64], points: &mut Points) {
    let (rows, cols) = (variable.rows, variable.cols);
    let file = values.to_vec();
    for (value, by) in values.iter_mut().zip(points.numbers(rows * cols)) {
        *value += 0.1 * by * if *value == 0.0 { 1.0 } else { *value };
    }
    let mirrored = |k: usize| (k % cols) * cols + k / cols;
    if rows == cols && (0..file.len()).all(|k| file[k] == file[mirrored(k)]) {
        for k in 0..file.len() {
            values[k] = values[k.min(mirrored(k))];
        }
    }
}
