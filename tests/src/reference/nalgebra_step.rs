//! One Newton step as one would write it with nalgebra by hand: the Jacobian of [`Form`], static LU, no tricks.
//! The rival of the generated steppers, and a second opinion on their trajectories.

use super::{Form, Scene};
use nalgebra::{Const, DimMin, SVector};

/// The correction below which the iteration stops, in the units of the unknowns (limits of the paper's runs:
/// all unknowns are of order one). Larger loses digits, smaller iterates on rounding.
const TOLERANCE: f64 = 1e-12;

/// Iterations after which a step has failed; four suffice for the paper's steps.
const MAX_ITERATIONS: usize = 50;

/// A run of the form `F`.
pub struct Stepper<F: Form<M, N>, const M: usize, const N: usize> {
    scene: F::Scene<f64>,
    h: f64,
    state: SVector<f64, M>,
}

impl<F: Form<M, N>, const M: usize, const N: usize> Stepper<F, M, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// Starts at `state` with the parameters in the order of the model file.
    pub fn new(parameters: &[f64], state: &[f64], h: f64) -> Self {
        Stepper {
            scene: F::Scene::from_slice(parameters),
            h,
            state: SVector::from_column_slice(state),
        }
    }

    /// Advances by one step and returns the number of iterations; `None` if Newton fails, the state untouched.
    pub fn step(&mut self) -> Option<usize> {
        let mut x = F::guess(&self.state);
        for iteration in 1..=MAX_ITERATIONS {
            let r = F::residual(&self.scene, self.h, &self.state, &x);
            let j = F::jacobian(&self.scene, self.h, &self.state, &x);
            let correction = j.lu().solve(&r)?;
            x -= correction;
            if !correction.iter().all(|d| d.is_finite()) {
                return None;
            }
            if correction.amax() < TOLERANCE {
                self.state = F::next(self.h, &self.state, &x);
                return Some(iteration);
            }
        }
        None
    }

    /// The state, in the order of the model file.
    pub fn state(&self) -> &[f64] {
        self.state.as_slice()
    }
}
