//! A run of a model: time and state, advanced by a numerical method.

use crate::component::Component;
use crate::description::Solver;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::InvalidRun;
use crate::error::Place;
use crate::error::StepError;
use crate::model::Model;
use crate::model::Record;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::report::Success;
use crate::scalar::Real;
use crate::scalar::all_finite;
use crate::scalar::first_not_finite;

/// A step in a million parts is hopeless.
const MOST_HALVINGS: u32 = 20;

/// The flat state of a model, `[T; n]`.
pub type FlatState<M, T> = <<M as Model<T>>::State as Record<T>>::Array;

/// A one-step method with its workspace: from the state at t to the state at t + h.
pub trait Method<T: Real> {
    /// The model that it advances.
    type Model: Model<T>;
    /// Computes what depends on the parameters and the step `h` only.
    fn new(parameters: &<Self::Model as Model<T>>::Parameters, h: T) -> Self;
    /// The same method for another step.
    fn with_step(&self, parameters: &<Self::Model as Model<T>>::Parameters, h: T) -> Self
    where
        Self: Sized,
    {
        Self::new(parameters, h)
    }
    /// Takes `state` from t to t + h. Where that fails, or gives a state that is not finite, `state` is as it was.
    fn advance(
        &mut self,
        t: T,
        state: &mut FlatState<Self::Model, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault>;
    /// Takes `state` on by as many of `count` steps, the first at time(0), the second at time(1), as need nothing but what is
    /// at hand, and returns how many; [`Method::advance`] takes the one after these.
    #[inline]
    fn advance_quickly(
        &mut self,
        _time: impl Fn(u64) -> T,
        _count: u64,
        _state: &mut FlatState<Self::Model, T>,
        _statistics: &mut Statistics,
    ) -> u64 {
        0
    }
    /// The corrections of the last step: none for methods without Newton's.
    fn history(&self) -> History {
        History::default()
    }
    /// The equations that faults refer to, for methods that solve those of the model.
    fn solver() -> Option<&'static Solver> {
        None
    }
}

/// A run of a model from a start state, with a fixed step: a [`Stepper`](crate::Stepper) or a
/// [`RungeKutta4`](crate::RungeKutta4).
///
/// All memory is in the value itself; a step allocates nothing.
pub struct Integration<M: Method<T>, T: Real> {
    pub(crate) method: M,
    parameters: <M::Model as Model<T>>::Parameters,
    state: FlatState<M::Model, T>,
    h: T,
    t0: T,
    pub(crate) halvings: u32,
    statistics: Statistics,
}

impl<M: Method<T>, T: Real> Integration<M, T> {
    /// A run from `start` at t = 0 with the step `h` (in s where the model has units). A negative `h` runs
    /// backwards in time.
    ///
    /// Errors: `h` is 0; `h`, a parameter or a start value is infinite or NaN; or a start value is not 0 that a
    /// scene relies on being 0.
    pub fn new(
        parameters: <M::Model as Model<T>>::Parameters,
        start: <M::Model as Model<T>>::State,
        h: T,
    ) -> Result<Self, InvalidRun> {
        let state = start.to_array();
        validate::<M::Model, T>(&parameters, &state, h)?;
        Ok(Self {
            method: M::new(&parameters, h),
            parameters,
            state,
            h,
            t0: T::constant(0.0),
            halvings: 0,
            statistics: Statistics::default(),
        })
    }

    /// The same run with the time `t0` at its start.
    ///
    /// Errors: `t0` is infinite or NaN, or a step does not change it.
    pub fn at(self, t0: T) -> Result<Self, InvalidRun> {
        validate_time(t0, self.h)?;
        Ok(Self { t0, ..self })
    }

    /// The same run as if it had taken so many steps already.
    #[cfg(feature = "ensemble")]
    pub(crate) fn after(mut self, steps: u64) -> Self {
        self.statistics.steps = steps;
        self
    }

    /// Advances by one step.
    ///
    /// Errors: see [`Failure`](crate::Failure). A failed step leaves time and state as they were.
    #[inline]
    pub fn step(&mut self) -> Result<Report, StepError> {
        let t = self.t();
        match self
            .method
            .advance(t, &mut self.state, &mut self.statistics)
        {
            Ok(report) => {
                self.statistics.steps += 1;
                self.statistics.at_floor += u64::from(report.success == Success::AtFloor);
                Ok(report)
            }
            Err(fault) => self.halve(fault),
        }
    }

    /// Takes the step that failed as 2, 4, 8, … shorter ones, as often as the settings allow it.
    #[cold]
    fn halve(&mut self, fault: Fault) -> Result<Report, StepError> {
        let mut parts = 1_u32;
        for _ in 0..self.halvings.min(MOST_HALVINGS) {
            parts *= 2;
            if let Ok((state, report)) = self.in_parts(parts) {
                self.state = state;
                // What it knows of earlier steps does not lead to the next.
                self.method = self.method.with_step(&self.parameters, self.h);
                self.statistics.steps += 1;
                self.statistics.halved += 1;
                return Ok(report);
            }
        }
        Err(self.error(fault))
    }

    /// The state after a step, taken as so many.
    fn in_parts(&mut self, parts: u32) -> Result<(FlatState<M::Model, T>, Report), Fault> {
        let h = self.h / T::constant(parts.into());
        let mut method = self.method.with_step(&self.parameters, h);
        let (t, mut state) = (self.t(), self.state);
        let mut report = method.advance(t, &mut state, &mut self.statistics)?;
        for part in 1..parts {
            let t = t + T::constant(part.into()) * h;
            report = method.advance(t, &mut state, &mut self.statistics)?;
        }
        Ok((state, report))
    }

    /// Advances by `count` steps: what as many calls of [`Integration::step`] do, in less time, since what one step hands
    /// to the next is not looked at in between.
    ///
    /// Errors: as there. The steps before a failed one are taken.
    pub fn advance(&mut self, count: u64) -> Result<(), StepError> {
        let end = self.steps() + count;
        while self.steps() < end {
            let (first, t0, h) = (self.steps(), self.t0, self.h);
            let time = |k| time(t0, h, first + k);
            let taken = self.method.advance_quickly(
                time,
                end - first,
                &mut self.state,
                &mut self.statistics,
            );
            self.statistics.steps += taken;
            if self.steps() < end {
                self.step()?;
            }
        }
        Ok(())
    }

    /// The time t₀ + k h after k steps: one rounded product, never a sum of k steps.
    pub fn t(&self) -> T {
        time(self.t0, self.h, self.statistics.steps)
    }

    /// The step h.
    pub fn h(&self) -> T {
        self.h
    }

    /// Steps completed.
    pub fn steps(&self) -> u64 {
        self.statistics.steps
    }

    /// The state under its names.
    pub fn state(&self) -> <M::Model as Model<T>>::State {
        Record::from_array(self.state)
    }

    /// The flat state, components in file order.
    pub fn state_array(&self) -> &FlatState<M::Model, T> {
        &self.state
    }

    /// Invariants and observables of the state.
    pub fn outputs(&self) -> <M::Model as Model<T>>::Outputs {
        M::Model::outputs(&self.parameters, self.h, self.t(), &self.state())
    }

    /// What the run has cost so far.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    #[cold]
    fn error(&self, fault: Fault) -> StepError {
        StepError {
            fault,
            step: self.steps(),
            t: self.t().to_f64(),
            history: self.method.history(),
            description: M::Model::DESCRIPTION,
            solver: M::solver(),
        }
    }
}

/// Refuses what [`Integration::new`] does: compiled once per model, whatever advances it.
#[inline(never)]
/// Time has to be finite, and to go on.
pub(crate) fn validate_time<T: Real>(t0: T, h: T) -> Result<(), InvalidRun> {
    if !t0.is_finite() {
        return Err(InvalidRun::StartTime(t0.to_f64()));
    }
    if t0 + h == t0 {
        let (t0, h) = (t0.to_f64(), h.to_f64());
        return Err(InvalidRun::StandingTime { t0, h });
    }
    Ok(())
}

fn validate<M: Model<T>, T: Real>(
    parameters: &M::Parameters,
    state: &FlatState<M, T>,
    h: T,
) -> Result<(), InvalidRun> {
    if !h.is_finite() || h == T::constant(0.0) {
        return Err(InvalidRun::StepSize(h.to_f64()));
    }
    if let Some((position, value)) = first_not_finite(parameters.to_array().as_ref()) {
        let variables = M::DESCRIPTION.parameters;
        let component = Component {
            variables,
            position,
        };
        return Err(InvalidRun::Parameter(component, value));
    }
    if let Some((position, value)) = first_not_finite(state.as_ref()) {
        let variables = M::DESCRIPTION.states;
        let component = Component {
            variables,
            position,
        };
        return Err(InvalidRun::StartValue(component, value));
    }
    for zero in M::DESCRIPTION.scene.map_or(&[][..], |s| s.zeros) {
        let value = state.as_ref()[zero.component].to_f64();
        if value != 0.0 {
            let component = Component {
                variables: M::DESCRIPTION.states,
                position: zero.component,
            };
            return Err(InvalidRun::NotZero {
                component,
                value,
                reason: zero.reason,
            });
        }
    }
    Ok(())
}

#[inline]
fn time<T: Real>(t0: T, h: T, steps: u64) -> T {
    t0 + T::constant(steps as f64) * h
}

/// Refuses a state with a component that is not finite.
#[inline]
pub(crate) fn require_finite<T: Real, X: AsRef<[T]>>(state: X) -> Result<X, Fault> {
    if all_finite(state.as_ref()) {
        return Ok(state);
    }
    Err(not_finite(state.as_ref()))
}

/// The first component that is not finite.
#[cold]
#[inline(never)]
fn not_finite<T: Real>(state: &[T]) -> Fault {
    let (position, value) = first_not_finite(state).unwrap_or((0, f64::NAN));
    Fault {
        failure: Failure::NotFinite,
        place: Place::State(position),
        value,
    }
}
