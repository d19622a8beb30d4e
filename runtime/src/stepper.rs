//! The implicit stepper: one Newton solve per step.

use crate::description::Solver;
use crate::error::Fault;
use crate::integration::Integration;
use crate::integration::Method;
use crate::linear::Solvable;
use crate::model::Model;
use crate::model::StateArray;
use crate::newton::Newton;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;
use crate::settings::Settings;

/// A run of the solver `S`, such as the generated `Next` or `Increment`: each step solves r(x) = 0 for the
/// unknowns x of the step and takes the next state from them.
pub type Stepper<S, T = f64> = Integration<Implicit<S, T>, T>;

/// The method of a [`Stepper`].
pub struct Implicit<S: Solvable<T>, T: Real> {
    scene: S::Scene,
    newton: Newton<S, T>,
}

impl<S: Solvable<T>, T: Real> Stepper<S, T> {
    /// The same run with other settings of Newton's method.
    pub fn with_settings(mut self, settings: Settings<T>) -> Self {
        self.method.newton = Newton::new(settings);
        self
    }
}

impl<S: Solvable<T>, T: Real> Method<T> for Implicit<S, T> {
    type Model = S::Model;

    fn new(parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        Self {
            scene: S::scene(parameters, h),
            newton: Newton::new(Settings::default()),
        }
    }

    fn advance(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<(StateArray<S, T>, Report), Fault> {
        let step = S::step(&self.scene, t, state);
        let (x, report) = self
            .newton
            .solve(&self.scene, &step, state.as_ref(), statistics)?;
        Ok((S::next(&self.scene, &step, &x), report))
    }

    fn history(&self) -> History {
        self.newton.history()
    }

    fn solver() -> Option<&'static Solver> {
        Some(&S::Model::DESCRIPTION.solvers[S::SOLVER])
    }
}

#[cfg(test)]
mod tests;
