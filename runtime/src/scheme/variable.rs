//! Schemes that can try steps of any length, and what their errors may be.

use crate::error::Fault;
use crate::integration::FlatState;
use crate::model::Flow;
use crate::model::Model;
use crate::report::Statistics;
use crate::scalar::Real;

/// What the error of a step may be: |eᵢ| ≤ absolute + relative · max(|xᵢ|, |xᵢ'|) for every component i.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance<T = f64> {
    /// In the units of each component.
    pub absolute: T,
    /// Of the size of each component.
    pub relative: T,
}

impl<T: Real> Tolerance<T> {
    /// The same number for both.
    pub fn both(tolerance: T) -> Self {
        Self {
            absolute: tolerance,
            relative: tolerance,
        }
    }

    /// absolute + relative · max(|x|, |x'|), and no less than rounding.
    #[inline]
    pub fn of(&self, x: T, next: T) -> T {
        let (x, next) = (x.abs(), next.abs());
        let size = if x > next { x } else { next };
        let wanted = self.absolute + self.relative * size;
        let rounding = T::constant(LEAST) * T::EPSILON * size;
        if wanted > rounding { wanted } else { rounding }
    }
}

impl Tolerance {
    /// What no relative tolerance comes below: rounding would be taken for an error of the method.
    pub const LEAST: f64 = LEAST * f64::EPSILON;
}

/// The least tolerance, in ε of a component: with less, rounding would be taken for an error of the method.
const LEAST: f64 = 4.0;

impl<T: Real> Default for Tolerance<T> {
    /// 1e-9, for `f32` 64 ε.
    fn default() -> Self {
        Self::both(T::constant(f64::max(1e-9, 64.0 * T::EPSILON.to_f64())))
    }
}

/// A step that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attempt<T> {
    /// The estimate of its error as a multiple of the tolerance: up to 1 it is good.
    pub error: T,
    /// Corrections or sweeps.
    pub iterations: usize,
}

/// A scheme that can try steps of any length, and knows the motion between.
pub trait Variable<T: Real> {
    /// The model that it advances.
    type Model: Flow<T>;
    /// Steps of the same length cost less than steps of any.
    const PREFERS_EQUAL_STEPS: bool = false;
    /// Computes what depends on the parameters only.
    fn new(parameters: &<Self::Model as Model<T>>::Parameters) -> Self;
    /// p of the error estimate, which is proportional to hᵖ.
    fn order(&self) -> usize;
    /// Tries a step of length h from (t, x), and commits nothing.
    fn attempt(
        &mut self,
        t: T,
        x: &FlatState<Self::Model, T>,
        h: T,
        tolerance: &Tolerance<T>,
        statistics: &mut Statistics,
    ) -> Result<Attempt<T>, Fault>;
    /// Takes the step that was tried last, and returns the state at its end.
    fn accept(&mut self) -> FlatState<Self::Model, T>;
    /// The state at t + θ h of the accepted step, 0 ≤ θ ≤ 1, as exact as the tolerance asks for.
    fn at(&self, theta: T) -> FlatState<Self::Model, T>;
    /// Forgets earlier steps: the next one does not follow them.
    fn restart(&mut self);
}
