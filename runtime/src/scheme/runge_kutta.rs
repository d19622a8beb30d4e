//! The explicit baseline: the classical Runge–Kutta method.

use super::rates;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::integration::require_finite;
use crate::model::Flow;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;

/// A run of the continuous equations dx/dt = f(t, x) of the model `M` with the classical method of order 4:
///
/// k₁ = f(t, x), k₂ = f(t + h/2, x + h k₁/2), k₃ = f(t + h/2, x + h k₂/2), k₄ = f(t + h, x + h k₃),
/// x ← x + h (k₁ + 2 k₂ + 2 k₃ + k₄)/6.
///
/// Source: Kutta (1901); Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, table 1.2.
pub type RungeKutta4<M, T = f64> = Integration<Explicit<M, T>, T>;

/// The method of a [`RungeKutta4`].
pub struct Explicit<M: Flow<T>, T: Real> {
    scene: M::FlowScene,
    h: T,
}

impl<M: Flow<T>, T: Real> Method<T> for Explicit<M, T> {
    type Model = M;

    fn new(parameters: &M::Parameters, h: T) -> Self {
        let scene = M::flow_scene(parameters);
        Self { scene, h }
    }

    fn advance(
        &mut self,
        t: T,
        x: &mut FlatState<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        let (scene, h) = (&self.scene, self.h);
        let half = h / T::constant(2.0);
        let k1 = rates::<M, T>(scene, t, x);
        let k2 = rates::<M, T>(scene, t + half, &moved(x, half, &k1));
        let k3 = rates::<M, T>(scene, t + half, &moved(x, half, &k2));
        let k4 = rates::<M, T>(scene, t + h, &moved(x, h, &k3));
        statistics.flows += 4;

        let (two, sixth) = (T::constant(2.0), h / T::constant(6.0));
        let mut next = *x;
        for (i, next) in next.as_mut().iter_mut().enumerate() {
            let middle = two * (k2.as_ref()[i] + k3.as_ref()[i]);
            *next = *next + sixth * (k1.as_ref()[i] + middle + k4.as_ref()[i]);
        }
        require_finite(&next)?;
        *x = next;
        Ok(Report::converged(0))
    }
}

/// x + factor · k
fn moved<T: Real, A: AsRef<[T]> + AsMut<[T]> + Copy>(x: &A, factor: T, k: &A) -> A {
    let mut moved = *x;
    for (x, k) in moved.as_mut().iter_mut().zip(k.as_ref()) {
        *x = *x + factor * *k;
    }
    moved
}

#[cfg(test)]
mod tests;
