//! The implicit stepper: one Newton solve per step.

use crate::description;
use crate::error::Fault;
use crate::integration::Integration;
use crate::integration::Method;
use crate::linear::Correctable;
use crate::linear::Solvable;
use crate::model::Model;
use crate::model::StateArray;
use crate::newton::Newton;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;
use crate::scalar::first_not_finite;
use crate::settings::MOST_GROWTH;
use crate::settings::Settings;
use crate::settings::Strategy;

/// A run of the solver `S`, such as the generated `Next` or `Increment`: each step solves r(x) = 0 for the
/// unknowns x of the step and takes the next state from them.
pub type Stepper<S, T = f64> = Integration<Implicit<S, T>, T>;

/// The method of a [`Stepper`]: Newton on the core of `S`, and on all its unknowns where that fails.
pub struct Implicit<S: Solvable<T>, T: Real> {
    core: Solver<S::Core, T>,
    full: Solver<S, T>,
    /// The last step was taken with all unknowns.
    fell_back: bool,
}

/// A system with its scene and Newton's method for it.
struct Solver<S: Correctable<T>, T: Real> {
    scene: S::Scene,
    newton: Newton<S, T>,
}

impl<S: Solvable<T>, T: Real> Stepper<S, T> {
    /// The same run with other settings of Newton's method.
    pub fn with_settings(mut self, settings: Settings<T>) -> Self {
        self.method.core.newton = Newton::new(settings);
        self.method.full.newton = Newton::new(settings);
        self
    }
}

impl<S: Correctable<T>, T: Real> Solver<S, T> {
    fn new(parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        Self {
            scene: S::scene(parameters, h),
            newton: Newton::new(Settings::default()),
        }
    }

    /// The state after the step, and the growth of rounding in it.
    #[inline]
    fn advance(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<(StateArray<S, T>, T, Report), Fault> {
        let scene = &self.scene;
        let step = S::step(scene, t, state);
        let (x, report) = self
            .newton
            .solve(scene, &step, state.as_ref(), statistics)?;
        let growth = S::growth(scene, &step, &x);
        Ok((S::next(scene, &step, &x), growth, report))
    }
}

impl<S: Solvable<T>, T: Real> Method<T> for Implicit<S, T> {
    type Model = S::Model;

    fn new(parameters: &<S::Model as Model<T>>::Parameters, h: T) -> Self {
        Self {
            core: Solver::new(parameters, h),
            full: Solver::new(parameters, h),
            fell_back: false,
        }
    }

    fn advance(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<(StateArray<S, T>, Report), Fault> {
        if self.core.newton.settings.strategy == Strategy::Full {
            return self.all_unknowns(t, state, statistics);
        }
        let core = self.core.advance(t, state, statistics);
        if !S::HAS_CORE {
            return core.map(|(next, _, report)| (next, report));
        }
        match core {
            Ok((next, growth, report)) if can_be_trusted(growth, &next) => {
                self.fell_back = false;
                Ok((next, report))
            }
            Ok(_) | Err(_) => self.fall_back(t, state, statistics),
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
    #[cold]
    fn fall_back(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<(StateArray<S, T>, Report), Fault> {
        statistics.fallbacks += 1;
        // What one of them knows of earlier steps ends where the other takes over.
        self.core.newton.forget();
        if !self.fell_back {
            self.full.newton.forget();
        }
        self.all_unknowns(t, state, statistics)
    }

    fn all_unknowns(
        &mut self,
        t: T,
        state: &StateArray<S, T>,
        statistics: &mut Statistics,
    ) -> Result<(StateArray<S, T>, Report), Fault> {
        self.fell_back = true;
        let (next, _, report) = self.full.advance(t, state, statistics)?;
        Ok((next, report))
    }
}

/// False for NaN.
#[inline]
fn can_be_trusted<T: Real>(growth: T, next: &impl AsRef<[T]>) -> bool {
    growth <= T::constant(MOST_GROWTH) && first_not_finite(next.as_ref()).is_none()
}

#[cfg(test)]
mod tests;
