//! The arithmetic that hand-written equations need, so that one text runs on `f64`, on dual numbers and
//! on [`Measured`](crate::measured::Measured).

use nalgebra::{ClosedAddAssign, ClosedDivAssign, ClosedMulAssign, ClosedSubAssign};
use num_dual::{Dual64, DualNum};
use num_traits::{One, Zero};
use std::ops::Neg;

/// A number with the ring operations, division, sine and cosine.
pub trait Number:
    nalgebra::Scalar
    + Copy
    + Zero
    + One
    + Neg<Output = Self>
    + ClosedAddAssign
    + ClosedSubAssign
    + ClosedMulAssign
    + ClosedDivAssign
{
    /// The number nearest to `value`.
    fn constant(value: f64) -> Self;
    /// (sin x, cos x)
    fn sin_cos(self) -> (Self, Self);
}

impl Number for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
}

impl Number for Dual64 {
    fn constant(value: f64) -> Self {
        value.into()
    }
    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }
}
