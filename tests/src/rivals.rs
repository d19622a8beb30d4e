//! Newton's method as one would write it down with nalgebra, for any generated model: the known state is the guess,
//! a static LU per iteration, corrections until they are below a fixed size.

use nalgebra::{Const, DimMin, SMatrix, SVector};
use num_dual::Dual64;
use residua::{Model, Record, Scalar, StateArray, System};
use std::hint::black_box;

/// The correction below which the iteration stops, in the units of the unknowns: they are of order one. Larger loses
/// digits, smaller iterates on rounding.
const TOLERANCE: f64 = 1e-12;

/// Iterations after which a step has failed; four suffice for ordinary steps.
const MAX_ITERATIONS: usize = 50;

/// `f64` or a dual number.
pub trait Number: Scalar {
    /// Without the derivative.
    fn real(self) -> f64;
}

impl Number for f64 {
    fn real(self) -> f64 {
        self
    }
}

impl Number for Dual64 {
    fn real(self) -> f64 {
        self.re
    }
}

/// A system whose residual and Jacobian can be had with the scalars `T`.
pub trait Pair<T: Scalar, const N: usize>: System<T, Unknowns = [T; N]> {
    /// r(x) and ∂r/∂x
    fn pair(
        scene: &Self::Scene,
        step: &Self::Step,
        x: &SVector<f64, N>,
    ) -> (SVector<f64, N>, SMatrix<f64, N, N>);
}

/// With the generated Jacobian.
impl<S, const N: usize> Pair<f64, N> for S
where
    S: System<f64, Unknowns = [f64; N], Jacobian = [[f64; N]; N]>,
{
    fn pair(
        scene: &Self::Scene,
        step: &Self::Step,
        x: &SVector<f64, N>,
    ) -> (SVector<f64, N>, SMatrix<f64, N, N>) {
        let (mut r, mut j) = S::zeros();
        S::residual_and_jacobian(scene, step, &(*x).into(), &mut r, &mut j);
        (r.into(), SMatrix::from_fn(|row, col| j[row][col]))
    }
}

/// With forward-mode dual numbers, a pass per unknown.
impl<S, const N: usize> Pair<Dual64, N> for S
where
    S: System<Dual64, Unknowns = [Dual64; N]>,
{
    fn pair(
        scene: &Self::Scene,
        step: &Self::Step,
        x: &SVector<f64, N>,
    ) -> (SVector<f64, N>, SMatrix<f64, N, N>) {
        let (mut r, mut j) = (SVector::zeros(), SMatrix::zeros());
        let mut seeded: [Dual64; N] = std::array::from_fn(|i| Dual64::from_re(x[i]));
        let (mut dual, _) = S::zeros();
        for col in 0..N {
            seeded[col].eps = 1.0;
            S::residual(scene, step, &seeded, &mut dual);
            seeded[col].eps = 0.0;
            for row in 0..N {
                (r[row], j[(row, col)]) = (dual[row].re, dual[row].eps);
            }
        }
        (r, j)
    }
}

/// A run of the system `S` from the defaults of its file.
pub struct Straightforward<S: Pair<T, N>, T: Scalar, const N: usize> {
    scene: S::Scene,
    state: StateArray<S, T>,
}

impl<S: Pair<T, N>, T: Number, const N: usize> Straightforward<S, T, N>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// A run with the step `h`.
    pub fn new(h: f64) -> Self {
        let parameters = black_box(<S::Model as Model<T>>::Parameters::default());
        Self {
            scene: S::scene(&parameters, T::constant(black_box(h))),
            state: black_box(S::Model::start(&parameters).to_array()),
        }
    }

    /// Advances by one step and returns the number of iterations; `None` if Newton fails. The models have no time.
    pub fn step(&mut self) -> Option<usize> {
        let step = S::step(&self.scene, T::constant(0.0), &self.state);
        let mut x = SVector::<f64, N>::from(S::guess(&self.scene, &step).map(Number::real));
        for iteration in 1..=MAX_ITERATIONS {
            let (r, j) = S::pair(&self.scene, &step, &x);
            let correction = j.lu().solve(&r)?;
            x -= correction;
            if !correction.iter().all(|d| d.is_finite()) {
                return None;
            }
            if correction.amax() < TOLERANCE {
                let x: [f64; N] = x.into();
                self.state = S::next(&self.scene, &step, &x.map(T::constant));
                return Some(iteration);
            }
        }
        None
    }

    /// The state.
    pub fn state(&self) -> Vec<f64> {
        self.state.as_ref().iter().map(|x| x.real()).collect()
    }
}
