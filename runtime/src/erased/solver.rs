//! Residual, Jacobian and steps of one solver over flat slices.

use core::marker::PhantomData;
#[cfg(feature = "ensemble")]
use std::vec::Vec;

#[cfg(feature = "dual")]
use num_dual::Dual64;

use super::model;
use super::simulate::Observer;
use super::simulate::Run;
#[cfg(feature = "single")]
use super::single;
use crate::description::Solver;
#[cfg(feature = "ensemble")]
use crate::ensemble::Ensemble;
#[cfg(feature = "ensemble")]
use crate::ensemble::Fleet;
#[cfg(feature = "ensemble")]
use crate::ensemble::Outcome;
#[cfg(feature = "ensemble")]
use crate::ensemble::Wide;
#[cfg(feature = "ensemble")]
use crate::error::InvalidRun;
use crate::error::RunError;
use crate::linear::Solvable;
use crate::linear::SquareMatrix;
use crate::model::Model;
use crate::model::Record;
use crate::model::StateArray;
use crate::model::System;
use crate::report::Statistics;
use crate::scalar::Scalar;
use crate::stepper::Stepper;

/// Where a step starts: the known side of the equations.
#[derive(Debug, Clone, Copy)]
pub struct Point<'a> {
    /// In file order.
    pub parameters: &'a [f64],
    /// The step, in s where the model has units.
    pub h: f64,
    /// The time at which the step starts.
    pub t: f64,
    /// The flat state there.
    pub state: &'a [f64],
}

/// A [`System`] over flat slices.
pub trait AnySolver: Sync {
    /// What the model says about it.
    fn solver(&self) -> &'static Solver;
    /// Overwrites `out` with the first guess of the unknowns.
    fn guess(&self, at: &Point, out: &mut [f64]);
    /// Overwrites `out` with r(x).
    fn residual(&self, at: &Point, x: &[f64], out: &mut [f64]);
    /// Overwrites `out` with the generated ∂r/∂x, n·n entries row by row.
    fn jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]);
    /// Overwrites `out` with ∂r/∂x by dual numbers, which know nothing of the generated derivative.
    #[cfg(feature = "dual")]
    fn dual_jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]);
    /// Overwrites `out` with the state after a step with the unknowns `x`.
    fn next(&self, at: &Point, x: &[f64], out: &mut [f64]);
    /// Runs the solver and shows states to `observer`, which may stop it.
    fn simulate(&self, run: &Run, observer: &mut Observer) -> Result<Statistics, RunError>;
    /// The same in `f32`: the numbers of the run are rounded to it, and the observer is shown its states.
    #[cfg(feature = "single")]
    fn simulate_in_single(
        &self,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError>;
    /// Runs many trajectories, and returns how each of them ended; see [`Ensemble`].
    ///
    /// Errors: the step is 0, or it or the start time is infinite or NaN.
    #[cfg(feature = "ensemble")]
    fn fly(&self, fleet: &Fleet) -> Result<Vec<Outcome>, InvalidRun>;
}

/// A system that works on all that an [`ErasedSolver`] computes with: `f64`, with the feature `dual` dual numbers, with
/// the feature `single` `f32`, with the feature `ensemble` lanes. Generated systems do.
pub trait Differentiable: Solvable<f64> + OnDuals + OnSingles + OnLanes {}
impl<S: Solvable<f64> + OnDuals + OnSingles + OnLanes> Differentiable for S {}

#[cfg(feature = "dual")]
pub trait OnDuals: System<Dual64> {}
#[cfg(feature = "dual")]
impl<S: System<Dual64>> OnDuals for S {}
#[cfg(not(feature = "dual"))]
pub trait OnDuals {}
#[cfg(not(feature = "dual"))]
impl<S> OnDuals for S {}

#[cfg(feature = "single")]
pub trait OnSingles: Solvable<f32> {}
#[cfg(feature = "single")]
impl<S: Solvable<f32>> OnSingles for S {}
#[cfg(not(feature = "single"))]
pub trait OnSingles {}
#[cfg(not(feature = "single"))]
impl<S> OnSingles for S {}

#[cfg(feature = "ensemble")]
pub trait OnLanes: Wide + 'static {}
#[cfg(feature = "ensemble")]
impl<S: Wide + 'static> OnLanes for S {}
#[cfg(not(feature = "ensemble"))]
pub trait OnLanes {}
#[cfg(not(feature = "ensemble"))]
impl<S> OnLanes for S {}

/// `S` as an [`AnySolver`].
pub struct ErasedSolver<S>(PhantomData<fn() -> S>);

impl<S> ErasedSolver<S> {
    /// The only value.
    pub const NEW: Self = Self(PhantomData);
}

impl<S: Differentiable> AnySolver for ErasedSolver<S> {
    fn solver(&self) -> &'static Solver {
        &<S as System<f64>>::Model::DESCRIPTION.solvers[<S as System<f64>>::SOLVER]
    }

    fn guess(&self, at: &Point, out: &mut [f64]) {
        let guess = Located::<S, f64>::new(at).guess();
        out.copy_from_slice(guess.as_ref());
    }

    fn residual(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        let r = Located::<S, f64>::new(at).residual(&unknowns::<S, f64>(x));
        out.copy_from_slice(r.as_ref());
    }

    fn jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        let j = Located::<S, f64>::new(at).jacobian(&unknowns::<S, f64>(x));
        out.copy_from_slice(j.entries());
    }

    #[cfg(feature = "dual")]
    fn dual_jacobian(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        let located = Located::<S, Dual64>::new(at);
        for column in 0..x.len() {
            let mut seeded = unknowns::<S, Dual64>(x);
            seeded.as_mut()[column].eps = 1.0;
            let r = located.residual(&seeded);
            for (row, r) in r.as_ref().iter().enumerate() {
                out[row * x.len() + column] = r.eps;
            }
        }
    }

    fn next(&self, at: &Point, x: &[f64], out: &mut [f64]) {
        let next = Located::<S, f64>::new(at).next(&unknowns::<S, f64>(x));
        out.copy_from_slice(next.as_ref());
    }

    fn simulate(&self, run: &Run, observer: &mut Observer) -> Result<Statistics, RunError> {
        let (parameters, start) = run.records::<<S as System<f64>>::Model, f64>()?;
        let stepper = Stepper::<S>::new(parameters, start, run.h)?.at(run.t0)?;
        run.through(stepper.with_settings(run.settings), observer)
    }

    #[cfg(feature = "single")]
    fn simulate_in_single(
        &self,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        single::simulate::<S>(run, observer)
    }

    #[cfg(feature = "ensemble")]
    fn fly(&self, fleet: &Fleet) -> Result<Vec<Outcome>, InvalidRun> {
        Ensemble::<S>::NEW.fly(fleet)
    }
}

/// A solver with its caches at a point.
struct Located<S: System<T>, T: Scalar> {
    scene: S::Scene,
    step: S::Step,
}

impl<S: System<T>, T: Scalar> Located<S, T> {
    fn new(at: &Point) -> Self {
        let parameters = model::parameters::<S::Model, T>(at.parameters);
        let state = model::state::<S::Model, T>(&parameters, at.state);
        let scene = S::scene(&parameters, T::constant(at.h));
        let step = S::step(&scene, T::constant(at.t), &state.to_array());
        Self { scene, step }
    }

    fn guess(&self) -> S::Unknowns {
        S::guess(&self.scene, &self.step)
    }

    fn residual(&self, x: &S::Unknowns) -> S::Unknowns {
        let (mut r, _) = S::zeros();
        S::residual(&self.scene, &self.step, x, &mut r);
        r
    }

    fn jacobian(&self, x: &S::Unknowns) -> S::Jacobian {
        let (mut r, mut j) = S::zeros();
        S::residual_and_jacobian(&self.scene, &self.step, x, &mut r, &mut j);
        j
    }

    fn next(&self, x: &S::Unknowns) -> StateArray<S, T> {
        S::next(&self.scene, &self.step, x)
    }
}

fn unknowns<S: System<T>, T: Scalar>(values: &[f64]) -> S::Unknowns {
    let (mut unknowns, _) = S::zeros();
    model::fill(&mut unknowns, values);
    unknowns
}

#[cfg(test)]
mod tests;
