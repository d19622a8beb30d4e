//! What goes wrong, in words that name the equation, the time and the value.

use core::fmt;

use crate::component::Component;
use crate::component::write_equation;
use crate::component::write_unknown;
use crate::description::Description;
use crate::description::Solver;
use crate::report::History;

/// Why a step failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Failure {
    /// Corrections grew several times in a row.
    Diverged,
    /// The iteration limit was reached above the rounding floor.
    Stalled,
    /// The Jacobian has a pivot that is exactly 0.
    Singular,
    /// Some of the state follows from the unknowns, and rounding of these would leave it less than ten digits, in `f32` five.
    Undetermined,
    /// The equations hold to rounding, which leaves an unknown fewer than ten digits, in `f32` five.
    Loose,
    /// Rounding of the unknowns makes an equation another one: a number is too large for the format.
    Unresolved,
    /// Rounding in an equation, or in what follows from the unknowns, leaves the state fewer than ten digits, in `f32` five: terms
    /// that cancel, or an angle, are too large for the format.
    Drowned,
    /// NaN or infinity in a residual, an unknown or the state after the step.
    NotFinite,
    /// The stages of a scheme could not be solved for.
    Stages,
    /// A step within the tolerance would be too short to change the time.
    StepTooSmall,
}

/// Where a step failed, by position in a flat array.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A row of the residual.
    Equation(usize),
    /// An unknown.
    Unknown(usize),
    /// A component of the state after the step.
    State(usize),
}

/// What went wrong in a step.
#[derive(Debug, Clone, Copy)]
pub struct Fault {
    /// Why the step failed.
    pub failure: Failure,
    /// The first component that is not finite, what is undetermined, loose, unresolved or drowned, or else the row of the largest residual.
    pub place: Place,
    /// The value there; of what is undetermined, how many times rounding grows, of what is loose, by which part of it, of
    /// what is drowned, by which part of the state.
    pub value: f64,
}

/// A step that failed. The state is as it was before the step.
#[derive(Clone, Copy)]
pub struct StepError {
    /// What went wrong.
    pub fault: Fault,
    /// Steps completed before.
    pub step: u64,
    /// The time at which the failed step starts, in s where the model has units.
    pub t: f64,
    /// The corrections of the failed step.
    pub history: History,
    /// The model.
    pub description: &'static Description,
    /// The equations being solved, for implicit methods.
    pub solver: Option<&'static Solver>,
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let iterations = self.history.iterations();
        let value = self.fault.value;
        write!(f, "step {} at t = {}: ", self.step, self.t)?;
        let outcome = match self.fault.failure {
            Failure::Diverged => "Newton diverged",
            Failure::Stalled => "Newton stalled",
            Failure::Singular => "the Jacobian became singular",
            Failure::Stages => {
                return f.write_str(
                    "the stages of the scheme could not be solved for; a shorter step may do",
                );
            }
            Failure::StepTooSmall => {
                return write!(
                    f,
                    "steps of {value:.1e} miss the tolerance, and shorter ones would not change the time"
                );
            }
            Failure::Undetermined => {
                self.write_place(f)?;
                return write!(
                    f,
                    " is not known: on its way from the unknowns, rounding grows {value:.1e} times; a shorter step may do"
                );
            }
            Failure::Loose => {
                self.write_place(f)?;
                return write!(
                    f,
                    " is not known: the equations hold to rounding, and that moves it by {value:.1e} of its size"
                );
            }
            Failure::Unresolved => {
                f.write_str("rounding of the unknowns changes ")?;
                self.write_place(f)?;
                return f.write_str(": they are too large for numbers of so few digits");
            }
            Failure::Drowned => {
                f.write_str("rounding of the terms of ")?;
                self.write_place(f)?;
                if !value.is_finite() {
                    return f.write_str(" is all that moves the state");
                }
                return write!(f, " moves the state by {value:.1e} of its size");
            }
            Failure::NotFinite => {
                self.write_place(f)?;
                let comma = match self.fault.place {
                    Place::Equation(_) => ",",
                    Place::Unknown(_) | Place::State(_) => "",
                };
                return write!(f, "{comma} is {value} after {}", Iterations(iterations));
            }
        };
        write!(f, "{outcome} after {}", Iterations(iterations))?;
        // A residual that vanishes has nothing to tell.
        if value == 0.0 {
            return Ok(());
        }
        write!(f, "; largest residual {value:.1e} in ")?;
        self.write_place(f)
    }
}

impl StepError {
    fn write_place(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.fault.place {
            Place::Equation(row) => {
                let equations = self.solver.map_or(&[][..], |solver| solver.equations);
                write_equation(f, equations, row)
            }
            Place::Unknown(position) => {
                let unknowns = self.solver.map_or(&[][..], |solver| solver.unknowns);
                write_unknown(f, unknowns, position)
            }
            Place::State(position) => {
                let variables = self.description.states;
                let component = Component {
                    variables,
                    position,
                };
                write!(f, "state {component} at the end of the step")
            }
        }
    }
}

/// `1 iteration`, `2 iterations`.
struct Iterations(usize);

impl fmt::Display for Iterations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plural = if self.0 == 1 { "" } else { "s" };
        write!(f, "{} iteration{plural}", self.0)
    }
}

/// As displayed: `unwrap`, and `main` with `?`, print errors by `Debug`.
impl fmt::Debug for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for StepError {}

/// A run that cannot start.
#[derive(Clone, Copy)]
pub enum InvalidRun {
    /// The step is 0, infinite or NaN.
    StepSize(f64),
    /// The start time is infinite or NaN.
    StartTime(f64),
    /// A step does not change the start time: it is less than rounding of it.
    StandingTime {
        /// The start time.
        t0: f64,
        /// The step.
        h: f64,
    },
    /// A parameter is infinite or NaN.
    Parameter(Component, f64),
    /// A parameter is not 0, but less than the least number that a run computes with in all digits.
    TooSmall {
        /// Which.
        component: Component,
        /// The value given.
        value: f64,
        /// That number.
        least: f64,
    },
    /// A start value is infinite or NaN.
    StartValue(Component, f64),
    /// A start value is not 0 although the scene has done without the component: it would have stayed 0.
    NotZero {
        /// Which.
        component: Component,
        /// The value given.
        value: f64,
        /// Why 0 would have stayed 0.
        reason: &'static str,
    },
    /// A slice has the wrong number of values.
    Length {
        /// `parameters` or `start values`.
        what: &'static str,
        /// Values that the model has.
        expected: usize,
        /// Values given.
        found: usize,
    },
}

impl fmt::Display for InvalidRun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let finite = "expected a finite number";
        match self {
            Self::StepSize(h) => write!(f, "step h is {h}, {finite} other than 0"),
            Self::StartTime(t) => write!(f, "start time is {t}, {finite}"),
            Self::StandingTime { t0, h } => write!(
                f,
                "a step of {h} does not change the start time {t0:e}: it is less than rounding of it"
            ),
            Self::Parameter(component, value) => {
                write!(f, "parameter {component} is {value}, {finite}")
            }
            Self::TooSmall {
                component,
                value,
                least,
            } => write!(
                f,
                "parameter {component} is {value:e}, expected 0 or at least {least:e}: less has not all digits here"
            ),
            Self::StartValue(component, value) => {
                write!(f, "start value {component} is {value}, {finite}")
            }
            Self::NotZero {
                component,
                value,
                reason,
            } => write!(
                f,
                "start value {component} is {value}, and the scene relies on 0: {reason}"
            ),
            Self::Length {
                what,
                expected,
                found,
            } => write!(f, "expected {expected} {what}, found {found}"),
        }
    }
}

impl fmt::Debug for InvalidRun {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for InvalidRun {}

/// A run that did not reach its end.
#[derive(Clone, Copy)]
pub enum RunError {
    /// It could not start.
    Invalid(InvalidRun),
    /// A step failed.
    Step(StepError),
}

impl From<InvalidRun> for RunError {
    fn from(error: InvalidRun) -> Self {
        Self::Invalid(error)
    }
}

impl From<StepError> for RunError {
    fn from(error: StepError) -> Self {
        Self::Step(error)
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(error) => fmt::Display::fmt(error, f),
            Self::Step(error) => fmt::Display::fmt(error, f),
        }
    }
}

impl fmt::Debug for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl core::error::Error for RunError {}

#[cfg(test)]
mod tests;
