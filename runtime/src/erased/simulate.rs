//! Runs that stream their states to an observer.

use core::ops::ControlFlow;

use super::model;
use crate::error::InvalidRun;
use crate::error::RunError;
use crate::error::StepError;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Model;
use crate::model::Record;
use crate::report::Statistics;
use crate::scalar::Scalar;
use crate::settings::Settings;

/// A run to be made.
#[derive(Debug, Clone, Copy)]
pub struct Run<'a> {
    /// In file order.
    pub parameters: &'a [f64],
    /// The flat state at `t0`.
    pub start: &'a [f64],
    /// The step, in s where the model has units; negative runs backwards in time.
    pub h: f64,
    /// The time of the start state.
    pub t0: f64,
    /// Steps to take.
    pub steps: u64,
    /// Shows every so many steps; 0 shows the start and the end only.
    pub every: u64,
    /// For implicit methods.
    pub settings: Settings<f64>,
}

/// A state of a run.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'a> {
    /// Steps taken since the start.
    pub step: u64,
    /// Its time.
    pub t: f64,
    /// Its flat state.
    pub state: &'a [f64],
    /// What the run has cost up to here.
    pub statistics: Statistics,
}

/// Takes the start, every so many states and the last one; `Break` ends the run early, without an error.
pub type Observer<'a> = dyn FnMut(Sample) -> ControlFlow<()> + 'a;

impl Run<'_> {
    /// Parameters and start state of `M`, if there are as many values as `M` has.
    pub(super) fn records<M: Model<T>, T: Scalar>(
        &self,
    ) -> Result<(M::Parameters, M::State), InvalidRun> {
        let defaults = M::Parameters::default().to_array();
        require_length("parameters", defaults.as_ref().len(), self.parameters)?;
        let parameters = model::parameters::<M, T>(self.parameters);
        let shape = M::start(&parameters).to_array();
        require_length("start values", shape.as_ref().len(), self.start)?;
        let start = model::state::<M, T>(&parameters, self.start);
        Ok((parameters, start))
    }

    /// Takes the steps of the run.
    pub(super) fn through<M: Method<f64>>(
        &self,
        mut integration: Integration<M, f64>,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        self.drive(&mut integration, observer)
    }

    /// The same, compiled once.
    pub(super) fn drive(
        &self,
        integration: &mut dyn Steps,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        let mut now = integration.sample();
        let mut shown = observer(now);
        while shown.is_continue() && now.step < self.steps {
            let left = self.steps - now.step;
            let count = if self.every > 0 {
                left.min(self.every)
            } else {
                left
            };
            integration.advance(count)?;
            now = integration.sample();
            shown = observer(now);
        }
        Ok(integration.sample().statistics)
    }
}

/// A run by whatever method.
pub(super) trait Steps {
    fn advance(&mut self, count: u64) -> Result<(), StepError>;
    fn sample(&self) -> Sample<'_>;
}

impl<M: Method<f64>> Steps for Integration<M, f64> {
    fn advance(&mut self, count: u64) -> Result<(), StepError> {
        Integration::advance(self, count)
    }

    fn sample(&self) -> Sample<'_> {
        Sample {
            step: self.steps(),
            t: self.t(),
            state: self.state_array().as_ref(),
            statistics: self.statistics(),
        }
    }
}

fn require_length(what: &'static str, expected: usize, given: &[f64]) -> Result<(), InvalidRun> {
    if expected == given.len() {
        return Ok(());
    }
    Err(InvalidRun::Length {
        what,
        expected,
        found: given.len(),
    })
}

#[cfg(test)]
mod tests;
