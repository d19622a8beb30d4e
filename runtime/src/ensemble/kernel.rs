//! What a group needs of a model, whichever it is.

mod correct;

use core::marker::PhantomData;
use std::boxed::Box;

use pulp::Arch;

use correct::Correct;

use super::rows::Row;
use super::rows::get;
use crate::description::Count;
use crate::description::Unknown;
use crate::description::Variable;
use crate::erased::parameters;
use crate::erased::state;
use crate::error::InvalidRun;
use crate::error::StepError;
use crate::lanes::Lanes;
use crate::linear::Solvable;
use crate::model::Cache;
use crate::model::Model;
use crate::model::Record;
use crate::model::System;
use crate::report::Statistics;
use crate::resolution::Solved;
use crate::sensitivity::amplification;
use crate::sensitivity::follows;
use crate::settings::Settings;
use crate::stepper::Stepper;

/// Trajectories in one [`Lanes`]. The loop over lanes is what becomes vector instructions; two vectors at a time have
/// more to do while a division lasts, where there are registers for two.
const SINGLE: usize = 1;
const DOUBLE: usize = 2;

/// A system that an ensemble can advance. Nothing implements it by hand: generated systems have it.
pub trait Wide: Solvable<f64> + System<Lanes<SINGLE>> + System<Lanes<DOUBLE>> {}

impl<S: Solvable<f64> + System<Lanes<SINGLE>> + System<Lanes<DOUBLE>>> Wide for S {}

/// Two vectors at a time: where there is one unknown, and nothing but arithmetic.
const fn is_small(blocks: &[Unknown], counts: &[(&str, Count)]) -> bool {
    let mut calls = 0;
    let mut i = 0;
    while i < counts.len() {
        calls += counts[i].1.calls;
        i += 1;
    }
    matches!(blocks, [block] if block.len == 1) && calls == 0
}

/// Numbers of components.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    pub(crate) scene: usize,
    pub(crate) state: usize,
    pub(crate) parameters: usize,
    pub(crate) unknowns: usize,
}

/// Where a correction starts.
pub(crate) struct Start<'a> {
    pub(crate) t: f64,
    pub(crate) scene: &'a [Row],
    pub(crate) state: &'a [Row],
    /// What the sums of increments have lost to rounding.
    pub(crate) lost: &'a [Row],
    /// How far the unknowns lie from their guesses.
    pub(crate) shift: &'a [Row],
    /// Corrections up to here are the last ones,
    pub(crate) enough: &'a [Row],
    /// and those up to here are so even if the one before was much smaller.
    pub(crate) harmless: &'a [Row],
    /// States below that are known from the unknowns.
    pub(crate) reach: &'a [Row],
}

/// What a correction leads to.
pub(crate) struct Landing<'a> {
    /// How far the unknowns lie from their guesses.
    pub(crate) shift: &'a mut [Row],
    /// The unknowns.
    pub(crate) x: &'a mut [Row],
    /// What was subtracted from them; before that, in the step before.
    pub(crate) correction: &'a mut [Row],
    /// The state after the step.
    pub(crate) next: &'a mut [Row],
    /// What the sums of increments have lost then.
    pub(crate) lost: &'a mut [Row],
    /// 1 where all is finite, known and not magnified from rounding, else 0.
    pub(crate) sound: &'a mut Row,
    /// 1 where that is so and the correction is enough, else 0.
    pub(crate) within: &'a mut Row,
}

/// The trajectory of one lane by itself, in `f64`, with all that a [`Stepper`] can do.
pub(crate) trait Alone {
    fn step(&mut self) -> Result<(), StepError>;
    fn state(&self) -> &[f64];
    fn statistics(&self) -> Statistics;
}

impl<S: Solvable<f64>> Alone for Stepper<S> {
    fn step(&mut self) -> Result<(), StepError> {
        Stepper::step(self).map(drop)
    }

    fn state(&self) -> &[f64] {
        self.state_array().as_ref()
    }

    fn statistics(&self) -> Statistics {
        Stepper::statistics(self)
    }
}

/// Where a lane leaves its group.
pub(crate) struct Departure<'a> {
    pub(crate) parameters: &'a [f64],
    pub(crate) state: &'a [f64],
    pub(crate) h: f64,
    pub(crate) t0: f64,
    /// Steps taken since t₀.
    pub(crate) steps: u64,
    pub(crate) settings: Settings<f64>,
}

/// A model, as groups see it.
pub(crate) trait Kernel: Sync {
    fn sizes(&self) -> Sizes;
    /// The blocks of the unknowns.
    fn blocks(&self) -> &'static [Unknown];
    /// The variables of the state.
    fn states(&self) -> &'static [Variable];
    /// Some of the state follows from unknowns that are not its own.
    fn follows(&self) -> bool;
    /// See [`System::HAS_KINKS`].
    fn has_kinks(&self) -> bool;
    /// Corrections are in closed form; without, every trajectory goes alone.
    fn has_correction(&self) -> bool;
    /// Overwrites `out` with the scene of one trajectory.
    fn scene(&self, parameters: &[f64], h: f64, out: &mut [f64]);
    /// Corrects the unknowns of all lanes once.
    fn correct(&self, arch: Arch, start: Start, landing: Landing);
    /// How many times rounding of the unknowns grows on its way to the state after the step, for one trajectory.
    fn amplification(&self, at: At) -> f64;
    /// Whether rounding of the unknowns leaves the equations what they are, and rounding of these the state.
    fn is_resolved(&self, at: At) -> bool;
    /// One trajectory by itself.
    fn alone(&self, departure: &Departure) -> Result<Box<dyn Alone>, InvalidRun>;
}

/// A step of one trajectory.
#[derive(Clone, Copy)]
pub(crate) struct At<'a> {
    pub(crate) lane: usize,
    pub(crate) t: f64,
    pub(crate) h: f64,
    pub(crate) parameters: &'a [Row],
    pub(crate) scene: &'a [Row],
    pub(crate) state: &'a [Row],
    pub(crate) x: &'a [Row],
}

/// The [`Kernel`] of `S`.
pub(crate) struct Emitted<S>(PhantomData<fn() -> S>);

impl<S> Emitted<S> {
    /// The only value.
    pub(crate) const NEW: Self = Self(PhantomData);
}

/// The step of one trajectory by itself.
fn gather<S: Wide>(at: At) -> Solved<Core<S, f64>, f64> {
    let parameters = <<S as System<f64>>::Model as Model<f64>>::Parameters::default();
    let mut state = <<S as System<f64>>::Model as Model<f64>>::start(&parameters).to_array();
    get(at.state, at.lane, state.as_mut());
    let mut given = parameters.to_array();
    get(at.parameters, at.lane, given.as_mut());
    let (mut x, _) = Core::<S, f64>::zeros();
    get(at.x, at.lane, x.as_mut());
    let scene = <Core<S, f64> as System<f64>>::Scene::gather(|j| at.scene[j][at.lane]);
    Solved {
        parameters: Record::from_array(given),
        h: at.h,
        t: at.t,
        scene,
        step: Core::<S, f64>::step(&scene, at.t, &state),
        state,
        x,
    }
}

/// What is left of `S` after elimination, on `T`.
type Core<S, T> = <S as System<T>>::Core;

impl<S: Wide + 'static> Kernel for Emitted<S> {
    fn sizes(&self) -> Sizes {
        let parameters = <<S as System<f64>>::Model as Model<f64>>::Parameters::default();
        let state = <<S as System<f64>>::Model as Model<f64>>::start(&parameters);
        Sizes {
            scene: <Core<S, f64> as System<f64>>::Scene::LEN,
            state: state.to_array().as_ref().len(),
            parameters: parameters.to_array().as_ref().len(),
            unknowns: Core::<S, f64>::zeros().0.as_ref().len(),
        }
    }

    fn blocks(&self) -> &'static [Unknown] {
        Core::<S, f64>::UNKNOWNS
    }

    fn states(&self) -> &'static [Variable] {
        <<S as System<f64>>::Model as Model<f64>>::DESCRIPTION.states
    }

    fn follows(&self) -> bool {
        follows::<Core<S, f64>, f64>()
    }

    fn has_kinks(&self) -> bool {
        Core::<S, f64>::HAS_KINKS
    }

    fn has_correction(&self) -> bool {
        Core::<S, f64>::HAS_CORRECTION
    }

    fn scene(&self, parameters: &[f64], h: f64, out: &mut [f64]) {
        let parameters = self::parameters::<<S as System<f64>>::Model, f64>(parameters);
        Core::<S, f64>::scene(&parameters, h).spread(|i, value| out[i] = value);
    }

    fn correct(&self, arch: Arch, start: Start, landing: Landing) {
        let is_small = const {
            let solvers = <<S as System<f64>>::Model as Model<f64>>::DESCRIPTION.solvers;
            is_small(
                Core::<S, f64>::UNKNOWNS,
                solvers[<S as System<f64>>::SOLVER].counts,
            )
        };
        if is_small {
            arch.dispatch(Correct::<Core<S, Lanes<DOUBLE>>, DOUBLE> {
                start,
                landing,
                system: PhantomData,
            });
        } else {
            arch.dispatch(Correct::<Core<S, Lanes<SINGLE>>, SINGLE> {
                start,
                landing,
                system: PhantomData,
            });
        }
    }

    fn amplification(&self, at: At) -> f64 {
        let solved = gather::<S>(at);
        let Solved {
            scene,
            step,
            state,
            x,
            ..
        } = &solved;
        amplification::<Core<S, f64>, f64>(scene, step, x, state).times
    }

    fn is_resolved(&self, at: At) -> bool {
        gather::<S>(at).doubt().is_none()
    }

    fn alone(&self, departure: &Departure) -> Result<Box<dyn Alone>, InvalidRun> {
        let parameters = self::parameters::<<S as System<f64>>::Model, f64>(departure.parameters);
        let state = self::state::<<S as System<f64>>::Model, f64>(&parameters, departure.state);
        let stepper = Stepper::<S>::new(parameters, state, departure.h)?
            .at(departure.t0)?
            .after(departure.steps);
        Ok(Box::new(stepper.with_settings(departure.settings)))
    }
}
