//! A catalogued model with parameters and a start: what a test runs.

use crate::points::Points;
use residua::Settings;
use residua::description::Variable;
use residua::erased::{AnySolver, Catalogued, Point, Run};
use residua_models::values;
use residua_models::values::total;
use std::ops::ControlFlow;

/// A model, its parameters and its start values, flat and in file order.
#[derive(Clone)]
pub struct Case {
    /// The model.
    pub model: &'static Catalogued,
    /// Its parameters.
    pub parameters: Vec<f64>,
    /// Its start values.
    pub start: Vec<f64>,
}

impl Case {
    /// The values of the model file.
    pub fn of_file(model: &'static Catalogued) -> Self {
        Self::with_parameters(model, values::defaults(model))
    }

    /// The start values of the file for these parameters.
    pub fn with_parameters(model: &'static Catalogued, parameters: Vec<f64>) -> Self {
        Case {
            model,
            start: values::start(model, &parameters),
            parameters,
        }
    }

    /// Parameters near those of the file. A symmetric matrix stays symmetric; zeros do not stay zero.
    pub fn varied(model: &'static Catalogued, points: &mut Points) -> Self {
        let mut parameters = Self::of_file(model).parameters;
        let mut offset = 0;
        for variable in model.description.parameters {
            let n = variable.rows * variable.cols;
            vary(variable, &mut parameters[offset..offset + n], points);
            offset += n;
        }
        Self::with_parameters(model, parameters)
    }

    /// The same with 3 to 6 added to every state that is a rate or a momentum (its unit has `/s`), so that
    /// the motion is large.
    pub fn kicked(mut self, points: &mut Points) -> Self {
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

    /// The point at which a step of size `h` starts at `state`.
    pub fn at<'a>(&'a self, h: f64, state: &'a [f64]) -> Point<'a> {
        Point {
            parameters: &self.parameters,
            h,
            t: 0.0,
            state,
        }
    }

    /// Runs `solver` and collects the state at every step, the start included.
    pub fn states(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<Vec<f64>> {
        let mut states = Vec::new();
        let run = self.run(h, steps, 1);
        let outcome = solver.simulate(&run, &mut |sample| {
            states.push(sample.state.to_vec());
            ControlFlow::Continue(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", self.model.description.name));
        states
    }

    /// Runs `solver` and returns the state after the last step.
    pub fn last_state(&self, solver: &dyn AnySolver, h: f64, steps: u64) -> Vec<f64> {
        let mut last = Vec::new();
        let outcome = solver.simulate(&self.run(h, steps, 0), &mut |sample| {
            last = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        outcome.unwrap_or_else(|error| panic!("{}: {error}", self.model.description.name));
        last
    }

    /// A run of this case.
    pub fn run(&self, h: f64, steps: u64, every: u64) -> Run<'_> {
        Run {
            parameters: &self.parameters,
            start: &self.start,
            h,
            t0: 0.0,
            steps,
            every,
            settings: Settings::default(),
        }
    }

    /// Invariants and observables at `state`.
    pub fn outputs(&self, h: f64, state: &[f64]) -> Vec<f64> {
        let variables = self.model.description.outputs.iter().map(|o| &o.variable);
        let mut out = vec![0.0; total(variables)];
        self.model
            .model
            .outputs(&self.parameters, h, 0.0, state, &mut out);
        out
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
