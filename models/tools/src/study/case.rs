//! A catalogued model with parameters and a start.

use residua::Catalogued;
use residua::Settings;
use residua::erased::Run;
use residua_models::values;
use residua_models::values::size;
use residua_models::values::total;

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

    /// Replaces the start values of the states that are rates (their unit has `/s`), in file order.
    pub fn with_rates(mut self, rates: &[f64]) -> Self {
        let mut rates = rates.iter();
        let mut offset = 0;
        for variable in self.model.description.states {
            let n = size(variable);
            if variable.unit.contains("/s") {
                let values = &mut self.start[offset..offset + n];
                values.iter_mut().zip(&mut rates).for_each(|(v, r)| *v = *r);
            }
            offset += n;
        }
        self
    }

    /// A run of this case that shows every state.
    pub fn run(&self, h: f64, steps: u64) -> Run<'_> {
        Run {
            parameters: &self.parameters,
            start: &self.start,
            h,
            t0: 0.0,
            steps,
            every: 1,
            settings: Settings::default(),
        }
    }

    /// Invariants and observables at `t` and `state`.
    pub fn outputs(&self, h: f64, t: f64, state: &[f64]) -> Vec<f64> {
        let variables = self.model.description.outputs.iter().map(|o| &o.variable);
        let mut out = vec![0.0; total(variables)];
        let model = self.model.model;
        model.outputs(&self.parameters, h, t, state, &mut out);
        out
    }
}
