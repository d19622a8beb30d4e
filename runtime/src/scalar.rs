//! What generated code computes with: `f64`, `f32` and, for checks, dual numbers.

#[cfg(feature = "dual")]
mod dual;
mod real;
mod rounded;

use core::ops::{Add, Div, Mul, Neg, Range, Sub};

pub use rounded::Rounded;

/// A number that generated code can compute with: `f64`, `f32`, a dual number, SIMD lanes.
pub trait Scalar:
    Copy
    + core::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to `value`.
    fn constant(value: f64) -> Self;
    /// sin x
    fn sin(self) -> Self;
    /// cos x
    fn cos(self) -> Self;
    /// (sin x, cos x)
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    /// tan x
    fn tan(self) -> Self;
    /// asin x
    fn asin(self) -> Self;
    /// acos x
    fn acos(self) -> Self;
    /// atan x
    fn atan(self) -> Self;
    /// The angle of (x, y) with y = self.
    fn atan2(self, x: Self) -> Self;
    /// sinh x
    fn sinh(self) -> Self;
    /// cosh x
    fn cosh(self) -> Self;
    /// tanh x
    fn tanh(self) -> Self;
    /// eˣ
    fn exp(self) -> Self;
    /// ln x
    fn ln(self) -> Self;
    /// √x
    fn sqrt(self) -> Self;
    /// |x|
    fn abs(self) -> Self;
    /// −1, 0 or 1; NaN for NaN.
    fn sign(self) -> Self;
    /// max(x, 0); NaN for NaN. By default (x + |x|)/2, which is exact up to half the largest number.
    fn positive(self) -> Self {
        Self::constant(0.5) * (self + self.abs())
    }
    /// x^y
    fn powf(self, exponent: Self) -> Self;
    /// The Stumpff function cₙ(s) = Σ (−s)^j / (n + 2j)! of s = self, the small-angle family: c₀(x²) = cos x,
    /// c₁(x²) = sin x / x, c₂(x²) = (1 − cos x)/x², c₃(x²) = (x − sin x)/x³.
    ///
    /// For `f64` and `f32`, |error| ≤ 2 ε (|cₙ| + |s cₙ'|) for n ≤ 8 and any s, 0 and denormals included:
    /// two or three units in the last place but near zeros of cₙ and for large |s|, where the phase √s is
    /// what counts; 8 ε for n ≤ 32. NaN gives NaN; infinite s gives NaN or infinity.
    fn stumpff(self, n: u32) -> Self;
}

/// A real number that Newton's method can compare and judge: `f64` and `f32`.
pub trait Real: Scalar + PartialOrd {
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The least positive number that has all its digits.
    const LEAST: Self;
    /// Neither infinite nor NaN.
    fn is_finite(self) -> bool;
    /// The number itself, or for narrower types its exact image.
    fn to_f64(self) -> f64;
}

/// The larger of two; the first where one of them is NaN.
#[inline]
pub(crate) fn larger<T: Real>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

/// The largest magnitude among those of `part` that are numbers; 0 where there is none.
///
/// A slice of `values` would be checked to be one, at the cost of a way to panic.
#[inline]
pub(crate) fn largest_of<T: Real>(values: &[T], part: &Range<usize>) -> T {
    let part = values.iter().take(part.end).skip(part.start);
    part.fold(T::constant(0.0), |most, value| larger(most, value.abs()))
}

/// False where one of them is infinite or NaN. All are looked at, so that there is one branch.
#[inline]
pub(crate) fn all_finite<T: Real>(values: &[T]) -> bool {
    values
        .iter()
        .fold(true, |all, value| all & value.is_finite())
}

/// False for NaN.
pub(crate) fn is_infinite<T: Real>(value: &T) -> bool {
    value.abs() > T::constant(0.0) && !value.is_finite()
}

/// Position and value of the first number that is infinite or NaN.
pub(crate) fn first_not_finite<T: Real>(values: &[T]) -> Option<(usize, f64)> {
    let position = values.iter().position(|value| !value.is_finite())?;
    Some((position, values[position].to_f64()))
}

#[cfg(test)]
mod tests;
