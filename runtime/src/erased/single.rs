//! Runs in single precision.

use std::vec::Vec;

use super::simulate::Observer;
use super::simulate::Run;
use super::simulate::Sample;
use super::simulate::Steps;
use crate::component::Component;
use crate::error::InvalidRun;
use crate::error::RunError;
use crate::error::StepError;
use crate::integration::Integration;
use crate::integration::Method;
use crate::linear::Solvable;
use crate::model::Model;
use crate::report::Statistics;
use crate::settings::Settings;
use crate::stepper::Stepper;

/// Runs `S` in `f32`, with a tolerance that it can meet.
pub(super) fn simulate<S: Solvable<f32>>(
    run: &Run,
    observer: &mut Observer,
) -> Result<Statistics, RunError> {
    let (parameters, start) = run.records::<S::Model, f32>()?;
    require_normal::<S::Model>(run.parameters)?;
    let stepper = Stepper::<S, f32>::new(parameters, start, run.h as f32)?.at(run.t0 as f32)?;
    let finest = Settings::<f32>::default().tolerance;
    let settings = Settings {
        tolerance: finest.max(run.settings.tolerance as f32),
        max_iterations: run.settings.max_iterations,
        max_growths: run.settings.max_growths,
        strategy: run.settings.strategy,
        compensated: run.settings.compensated,
        halvings: run.settings.halvings,
    };
    let mut widened = Widened {
        integration: stepper.with_settings(settings),
        state: Vec::new(),
    };
    widened.widen();
    run.drive(&mut widened, observer)
}

/// Parameters that are not 0 in `f64` are not 0 in `f32` either, nor numbers with fewer digits.
fn require_normal<M: Model<f32>>(parameters: &[f64]) -> Result<(), InvalidRun> {
    let least = f64::from(f32::MIN_POSITIVE);
    let is_small = |value: &f64| *value != 0.0 && value.abs() < least;
    match parameters.iter().position(is_small) {
        Some(position) => Err(InvalidRun::TooSmall {
            component: Component {
                variables: M::DESCRIPTION.parameters,
                position,
            },
            value: parameters[position],
            least,
        }),
        None => Ok(()),
    }
}

/// A run with its state in `f64`, which holds every number of `f32`.
struct Widened<M: Method<f32>> {
    integration: Integration<M, f32>,
    state: Vec<f64>,
}

impl<M: Method<f32>> Widened<M> {
    fn widen(&mut self) {
        let state = self.integration.state_array().as_ref();
        self.state.clear();
        self.state.extend(state.iter().map(|x| f64::from(*x)));
    }
}

impl<M: Method<f32>> Steps for Widened<M> {
    fn advance(&mut self, count: u64) -> Result<(), StepError> {
        let outcome = self.integration.advance(count);
        self.widen();
        outcome
    }

    fn sample(&self) -> Sample<'_> {
        Sample {
            step: self.integration.steps(),
            t: f64::from(self.integration.t()),
            state: &self.state,
            statistics: self.integration.statistics(),
        }
    }
}
