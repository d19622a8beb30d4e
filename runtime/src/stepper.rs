//! The implicit stepper: one Newton solve per step.

use crate::compensated::compensated_sums;
use crate::description;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::integration::Integration;
use crate::integration::Method;
use crate::integration::require_finite;
use crate::linear::Correctable;
use crate::linear::Solvable;
use crate::model::Model;
use crate::model::Record;
use crate::model::StateArray;
use crate::model::System;
use crate::newton::Newton;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::report::Success;
use crate::resolution::Solved;
use crate::scalar::Real;
use crate::sensitivity::Amplification;
use crate::sensitivity::amplification;
use crate::sensitivity::follows;
use crate::sensitivity::reach;
use crate::settings::Settings;
use crate::settings::Strategy;
use crate::settings::most_growth;

/// A run of the solver `S`, such as the generated `Next` or `Increment`: each step solves r(x) = 0 for the
/// unknowns x of the step and takes the next state from them.
pub type Stepper<S, T = f64> = Integration<Implicit<S, T>, T>;

/// The method of a [`Stepper`]: Newton on the core of `S`, and on all its unknowns where that fails.
pub struct Implicit<S: Solvable<T>, T: Real> {
    core: Solver<S::Core, T>,
    full: Solver<S, T>,
    /// What the sums of increments have lost to rounding, component by component.
    lost: StateArray<S, T>,
    /// The last step was taken with all unknowns.
    fell_back: bool,
}

/// A system with its scene and Newton's method for it.
struct Solver<S: Correctable<T>, T: Real> {
    /// Some of the state follows from unknowns that are not its own.
    follows: bool,
    /// States below that are resolved, and known from the unknowns, as they were where that was looked at.
    reach: StateArray<S, T>,
    parameters: <S::Model as Model<T>>::Parameters,
    h: T,
    scene: S::Scene,
    newton: Newton<S, T>,
}

impl<S: Solvable<T>, T: Real> Stepper<S, T> {
    /// The same run with other settings of Newton's method.
    pub fn with_settings(mut self, settings: Settings<T>) -> Self {
        self.method.set(settings);
        self.halvings = settings.halvings;
        self
    }
}

impl<S: Correctable<T>, T: Real> Solver<S, T> {
    fn new(parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        let mut reach = S::Model::start(parameters).to_array();
        reach.as_mut().fill(T::constant(0.0));
        Self {
            follows: follows::<S, T>(),
            reach,
            parameters: *parameters,
            h,
            scene: S::scene(parameters, h),
            newton: Newton::new(Settings::default()),
        }
    }

    /// Takes `state` one step on, unless what follows from the solution cannot be trusted, or `check` has something against
    /// a step from one state to the other that was not solved quickly.
    fn advance(
        &mut self,
        t: T,
        state: &mut StateArray<S, T>,
        lost: &mut StateArray<S, T>,
        statistics: &mut Statistics,
        check: impl FnOnce(&StateArray<S, T>, &StateArray<S, T>) -> Result<(), Fault>,
    ) -> Result<Report, Fault> {
        let before = statistics.iterations;
        if self.advance_quickly(|_| t, 1, state, lost, statistics) == 1 {
            let iterations = statistics.iterations - before;
            return Ok(Report::converged(iterations as usize));
        }
        let scene = &self.scene;
        let step = S::step(scene, t, state);
        let solved = self.newton.solve(scene, &step, state.as_ref(), statistics);
        let (x, report) = match solved {
            Ok(solved) => solved,
            Err(fault) => self.at_rounding(t, step, state).ok_or(fault)?,
        };
        self.require_determined(&step, state, &x)?;
        let scene = &self.scene;
        if !is_trusted::<S, T>(scene, &step, &x) {
            return Err(self.newton.fault(Failure::Singular));
        }
        let (next, lost_then) = self.after(&step, state, &x, lost);
        require_finite(&next)?;
        check(state, &next)?;
        if !self.is_within_reach(&next)
            && let Some(fault) = self.solved(t, step, state, x).doubt()
        {
            return Err(fault);
        }
        self.reach = reach::<S, T>(&self.reach, &next);
        (*state, *lost) = (next, lost_then);
        Ok(report)
    }

    /// The last iterate of an iteration without an end, where no other is better.
    #[cold]
    #[inline(never)]
    fn at_rounding(
        &self,
        t: T,
        step: S::Step,
        state: &StateArray<S, T>,
    ) -> Option<(S::Unknowns, Report)> {
        let x = self.newton.last();
        let report = Report {
            iterations: self.newton.history().iterations(),
            success: Success::AtFloor,
        };
        let is_rounding = self.solved(t, step, state, x).is_rounding();
        is_rounding.then_some((x, report))
    }

    fn solved(
        &self,
        t: T,
        step: S::Step,
        state: &StateArray<S, T>,
        x: S::Unknowns,
    ) -> Solved<S, T> {
        Solved {
            parameters: self.parameters,
            h: self.h,
            t,
            scene: self.scene,
            step,
            state: *state,
            x,
        }
    }

    /// Refuses a step between two states in which the equations do not hold but for rounding that may have grown, or do not
    /// tell the second; nothing where states do not tell the unknowns.
    #[cold]
    #[inline(never)]
    fn check(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        next: &StateArray<S, T>,
    ) -> Result<(), Fault> {
        let Some(x) = unknowns::<S, T>(state.as_ref(), next.as_ref()) else {
            return Ok(());
        };
        let step = S::step(&self.scene, t, state);
        if !self.newton.holds_at(&self.scene, &step, state.as_ref(), x) {
            return Err(self.newton.fault(Failure::Singular));
        }
        self.require_determined(&step, state, &x)
    }

    /// Refuses a solution of which rounding grows too much on its way to the state.
    fn require_determined(
        &self,
        step: &S::Step,
        state: &StateArray<S, T>,
        x: &S::Unknowns,
    ) -> Result<(), Fault> {
        if !self.follows {
            return Ok(());
        }
        let Amplification { times, state } = amplification::<S, T>(&self.scene, step, x, state);
        if times > most_growth::<T>() {
            return Err(undetermined(times, state));
        }
        Ok(())
    }

    /// Takes `state` on by as many of `count` steps as can be solved quickly.
    #[inline]
    fn advance_quickly(
        &mut self,
        time: impl Fn(u64) -> T,
        count: u64,
        state: &mut StateArray<S, T>,
        lost: &mut StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> u64 {
        let count = self.newton.trusted(count);
        // Held here, not behind a reference, they stay in registers from step to step.
        let (mut here, mut lost_here) = (*state, *lost);
        let mut taken = 0;
        while taken < count {
            let step = S::step(&self.scene, time(taken), &here);
            let Some((x, guess)) =
                self.newton
                    .solve_quickly(&self.scene, &step, here.as_ref(), statistics)
            else {
                break;
            };
            let (next, lost_then) = self.after(&step, &here, &x, &lost_here);
            if !(is_trusted::<S, T>(&self.scene, &step, &x) & self.is_within_reach(&next)) {
                break;
            }
            (here, lost_here) = (next, lost_then);
            self.newton.follow(&x, &guess);
            taken += 1;
        }
        (*state, *lost) = (here, lost_here);
        self.newton.spend(taken);
        taken
    }

    /// Whether the state is finite, and such states have been looked at.
    #[inline]
    fn is_within_reach(&self, state: &StateArray<S, T>) -> bool {
        let pairs = state.as_ref().iter().zip(self.reach.as_ref());
        pairs.fold(true, |all, (x, reach)| all & (x.abs() < *reach))
    }

    /// The state after the step, and what its sums have lost to rounding.
    #[inline]
    fn after(
        &self,
        step: &S::Step,
        state: &StateArray<S, T>,
        x: &S::Unknowns,
        lost: &StateArray<S, T>,
    ) -> (StateArray<S, T>, StateArray<S, T>) {
        if S::HAS_CHANGE && self.newton.settings.compensated {
            let change = S::change(&self.scene, step, x);
            return compensated_sums(state, &change, lost);
        }
        (S::next(&self.scene, step, x), *lost)
    }
}

#[cold]
fn undetermined<T: Real>(times: T, state: usize) -> Fault {
    Fault {
        failure: Failure::Undetermined,
        place: Place::State(state),
        value: times.to_f64(),
    }
}

/// Whether what is eliminated follows from `x` to more than rounding. False for NaN.
#[inline]
fn is_trusted<S: System<T>, T: Real>(scene: &S::Scene, step: &S::Step, x: &S::Unknowns) -> bool {
    S::growth(scene, step, x) <= most_growth::<T>()
}

/// The unknowns of a step between two states, if these tell.
fn unknowns<S: System<T>, T: Real>(state: &[T], next: &[T]) -> Option<S::Unknowns> {
    let solver = S::Model::DESCRIPTION.solvers.get(S::SOLVER)?;
    let (mut x, _) = S::zeros();
    for (unknown, i) in x.as_mut().iter_mut().zip(solver.own_states()?) {
        let (after, before) = (*next.get(i)?, *state.get(i)?);
        *unknown = if solver.is_increment() {
            after - before
        } else {
            after
        };
    }
    Some(x)
}

impl<S: Solvable<T>, T: Real> Method<T> for Implicit<S, T> {
    type Model = S::Model;

    fn new(parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        let mut lost = S::Model::start(parameters).to_array();
        lost.as_mut().fill(T::constant(0.0));
        Self {
            core: Solver::new(parameters, h),
            full: Solver::new(parameters, h),
            lost,
            fell_back: false,
        }
    }

    fn with_step(&self, parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        let mut method = Self::new(parameters, h);
        method.set(self.core.newton.settings);
        method
    }

    fn advance(
        &mut self,
        t: T,
        state: &mut StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        if self.core.newton.settings.strategy == Strategy::Full {
            return self.all_unknowns(t, state, statistics);
        }
        let Self {
            core, full, lost, ..
        } = self;
        let core = core.advance(t, state, lost, statistics, |state, next| {
            if S::HAS_CORE {
                full.check(t, state, next)
            } else {
                Ok(())
            }
        });
        if core.is_err() && S::HAS_CORE {
            return self.fall_back(t, state, statistics);
        }
        self.fell_back = false;
        core
    }

    #[inline]
    fn advance_quickly(
        &mut self,
        time: impl Fn(u64) -> T,
        count: u64,
        state: &mut StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> u64 {
        let lost = &mut self.lost;
        match self.core.newton.settings.strategy {
            Strategy::Core => self
                .core
                .advance_quickly(time, count, state, lost, statistics),
            Strategy::Full => self
                .full
                .advance_quickly(time, count, state, lost, statistics),
        }
    }

    fn history(&self) -> History {
        match self.fell_back {
            true => self.full.newton.history(),
            false => self.core.newton.history(),
        }
    }

    fn solver() -> Option<&'static description::Solver> {
        Some(&S::Model::DESCRIPTION.solvers[S::SOLVER])
    }
}

impl<S: Solvable<T>, T: Real> Implicit<S, T> {
    fn set(&mut self, settings: Settings<T>) {
        self.core.newton = Newton::new(settings);
        self.full.newton = Newton::new(settings);
    }

    #[cold]
    fn fall_back(
        &mut self,
        t: T,
        state: &mut StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        statistics.fallbacks += 1;
        // What one of them knows of earlier steps ends where the other takes over; and the other may not compensate.
        self.core.newton.forget();
        self.lost.as_mut().fill(T::constant(0.0));
        if !self.fell_back {
            self.full.newton.forget();
            // What the core has looked at is no other for all unknowns.
            self.full.reach = self.core.reach;
        }
        self.all_unknowns(t, state, statistics)
    }

    fn all_unknowns(
        &mut self,
        t: T,
        state: &mut StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        self.fell_back = true;
        self.full
            .advance(t, state, &mut self.lost, statistics, |_, _| Ok(()))
    }
}

#[cfg(test)]
mod guards;
#[cfg(test)]
mod tests;
