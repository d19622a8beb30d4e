//! What a group needs of a model: one Newton correction of all its trajectories, as a loop over them.
//!
//! The body of the loop is the code that the generator has emitted, without a branch, on [`Lanes`]: the compiler
//! makes vector instructions of it, once for each instruction set, and the machine is asked which to run.

use core::marker::PhantomData;
use std::boxed::Box;

use pulp::Arch;
use pulp::NullaryFnOnce;

use super::rows::Row;
use super::rows::WIDTH;
use super::rows::get;
use super::rows::lanes;
use super::rows::set_lanes;
use crate::compensated::compensated_sum;
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
use crate::model::StateArray;
use crate::model::System;
use crate::report::Statistics;
use crate::resolution::unresolved;
use crate::scalar::Scalar;
use crate::sensitivity::amplification;
use crate::sensitivity::follows;
use crate::settings::MOST_GROWTH;
use crate::settings::Settings;
use crate::settings::USUAL;
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
    /// Whether rounding of the unknowns leaves the equations what they are.
    fn is_resolved(&self, at: At) -> bool;
    /// One trajectory by itself.
    fn alone(&self, departure: &Departure) -> Result<Box<dyn Alone>, InvalidRun>;
}

/// A step of one trajectory.
#[derive(Clone, Copy)]
pub(crate) struct At<'a> {
    pub(crate) lane: usize,
    pub(crate) t: f64,
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

/// The scene, the step, the state and the unknowns of one trajectory.
#[expect(clippy::type_complexity, reason = "a tuple of what System names")]
fn gather<S: Wide>(
    at: At,
) -> (
    <Core<S, f64> as System<f64>>::Scene,
    <Core<S, f64> as System<f64>>::Step,
    StateArray<S, f64>,
    <Core<S, f64> as System<f64>>::Unknowns,
) {
    let parameters = <<S as System<f64>>::Model as Model<f64>>::Parameters::default();
    let mut known = <<S as System<f64>>::Model as Model<f64>>::start(&parameters).to_array();
    get(at.state, at.lane, known.as_mut());
    let (mut x, _) = Core::<S, f64>::zeros();
    get(at.x, at.lane, x.as_mut());
    let scene = <Core<S, f64> as System<f64>>::Scene::gather(|j| at.scene[j][at.lane]);
    let step = Core::<S, f64>::step(&scene, at.t, &known);
    (scene, step, known, x)
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
        let (scene, step, known, x) = gather::<S>(at);
        amplification::<Core<S, f64>, f64>(&scene, &step, &x, &known).times
    }

    fn is_resolved(&self, at: At) -> bool {
        let (scene, step, known, x) = gather::<S>(at);
        unresolved::<Core<S, f64>, f64>(&scene, &step, known.as_ref(), &x).is_none()
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

/// [`correct`] with its arguments, for [`Arch::dispatch`].
struct Correct<'a, C, const N: usize> {
    start: Start<'a>,
    landing: Landing<'a>,
    system: PhantomData<C>,
}

impl<C: System<Lanes<N>>, const N: usize> NullaryFnOnce for Correct<'_, C, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let (from, to) = (self.start, self.landing);
        correct::<C, N>(
            from.t,
            from.scene,
            from.state,
            from.lost,
            from.shift,
            from.enough,
            from.harmless,
            from.reach,
            to.shift,
            to.x,
            to.correction,
            to.next,
            to.lost,
            to.sound,
            to.within,
        );
    }
}

/// x = guess + shift, c = J(x)⁻¹ r(x), x ← x − c, and the state after that.
///
/// All is passed one by one: only references that are arguments are known not to overlap, and only with that known is
/// the loop taken several lanes at a time.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "see above")]
fn correct<C: System<Lanes<N>>, const N: usize>(
    t: f64,
    scene: &[Row],
    state: &[Row],
    losses: &[Row],
    shifts: &[Row],
    enough: &[Row],
    harmless: &[Row],
    reach: &[Row],
    shift: &mut [Row],
    x: &mut [Row],
    correction: &mut [Row],
    next: &mut [Row],
    lost: &mut [Row],
    sound: &mut Row,
    within: &mut Row,
) {
    // Only to say how many components there are.
    let parameters = <C::Model as Model<Lanes<N>>>::Parameters::default();
    let states = C::Model::start(&parameters).to_array();
    let (unknowns, _) = C::zeros();

    let n = unknowns.as_ref().len();
    let (shifts, enough, harmless) = (&shifts[..n], &enough[..n], &harmless[..n]);
    let (shift, x, correction) = (&mut shift[..n], &mut x[..n], &mut correction[..n]);
    let n = states.as_ref().len();
    let (state, losses, reach) = (&state[..n], &losses[..n], &reach[..n]);
    let (next, lost) = (&mut next[..n], &mut lost[..n]);
    let scene = &scene[..C::Scene::LEN];
    for i in 0..WIDTH / N {
        let scene = C::Scene::gather(|j| lanes(&scene[j], i));
        let known = columns(states, state, i);
        let step = C::step(&scene, Lanes::constant(t), &known);
        let guess = C::guess(&scene, &step);
        let mut at = guess;
        for (at, shift) in at.as_mut().iter_mut().zip(shifts) {
            *at = *at + lanes(shift, i);
        }

        let (c, growth) = C::correction(&scene, &step, &at);
        let mut is_within = [true; N];
        for j in 0..shifts.len() {
            let (c, enough) = (c.as_ref()[j], lanes::<N>(&enough[j], i));
            let (harmless, before) = (lanes::<N>(&harmless[j], i), lanes::<N>(&correction[j], i));
            let corrected = at.as_ref()[j] - c;
            at.as_mut()[j] = corrected;
            set_lanes(&mut correction[j], i, c);
            set_lanes(&mut x[j], i, corrected);
            set_lanes(&mut shift[j], i, corrected - guess.as_ref()[j]);
            for (k, is_within) in is_within.iter_mut().enumerate() {
                let size = c.0[k].abs();
                let is_usual = (size <= USUAL * before.0[k].abs()) | (size <= harmless.0[k]);
                *is_within &= (size <= enough.0[k]) & is_usual;
            }
        }

        let eliminated = C::growth(&scene, &step, &at);
        let mut after = known;
        if C::HAS_CHANGE {
            let change = C::change(&scene, &step, &at);
            for j in 0..losses.len() {
                let loss = lanes(&losses[j], i);
                let (sum, loss) = compensated_sum(known.as_ref()[j], change.as_ref()[j] + loss);
                after.as_mut()[j] = sum;
                set_lanes(&mut lost[j], i, loss);
            }
        } else {
            after = C::next(&scene, &step, &at);
        }
        let mut is_known = [true; N];
        for (j, next) in next.iter_mut().enumerate() {
            let (after, reach) = (after.as_ref()[j], lanes::<N>(&reach[j], i));
            set_lanes(next, i, after);
            for (k, is_known) in is_known.iter_mut().enumerate() {
                // False for NaN and infinity.
                *is_known &= after.0[k].abs() < reach.0[k];
            }
        }
        for (k, is_within) in is_within.into_iter().enumerate() {
            let at = i + k * (WIDTH / N);
            let is_sound =
                (growth.0[k] <= MOST_GROWTH) & (eliminated.0[k] <= MOST_GROWTH) & is_known[k];
            let is_enough = is_sound & is_within;
            sound[at] = if is_sound { 1.0 } else { 0.0 };
            within[at] = if is_enough { 1.0 } else { 0.0 };
        }
    }
}

/// Column `i` of `rows`, in an array like `shape`.
#[inline(always)]
fn columns<A: AsMut<[Lanes<N>]>, const N: usize>(mut shape: A, rows: &[Row], i: usize) -> A {
    for (component, row) in shape.as_mut().iter_mut().zip(rows) {
        *component = lanes(row, i);
    }
    shape
}
