//! Several trajectories in one number: what generated code computes with when it advances an ensemble.

mod angle;
mod series;

use core::array;
use core::ops::Add;
use core::ops::Div;
use core::ops::Mul;
use core::ops::Neg;
use core::ops::Sub;

use crate::scalar::Scalar;

/// `N` numbers that are computed with at a time, one of each of `N` trajectories.
///
/// Every operation is that of `f64`, lane by lane, and so are its results, but for `sin`, `cos`, `tan` and `stumpff`.
/// These are written without branches, that a loop over lanes becomes vector instructions, and know where they end:
/// beyond 1.6·10⁶ rad, and beyond |s| = 4 or n = 8, they are NaN, which tells an [`Ensemble`](crate::Ensemble) to take
/// that step of that trajectory in `f64`. Within, `sin` and `cos` are off by less than one unit in the last place, and
/// `stumpff` is as good as that of `f64`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self(array::from_fn(|i| f(self.0[i])))
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

impl<const N: usize> Add for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, |a, b| a * b)
    }
}

impl<const N: usize> Div for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, |a, b| a / b)
    }
}

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

macro_rules! lane_by_lane {
    ($($function:ident)*) => {
        $(
            #[inline(always)]
            fn $function(self) -> Self {
                self.map(Scalar::$function)
            }
        )*
    };
}

impl<const N: usize> Scalar for Lanes<N> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self([value; N])
    }

    #[inline(always)]
    fn sin(self) -> Self {
        self.map(|x| angle::sin_cos(x).0)
    }

    #[inline(always)]
    fn cos(self) -> Self {
        self.map(|x| angle::sin_cos(x).1)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        // What is computed twice here is found to be the same.
        (self.sin(), self.cos())
    }

    #[inline(always)]
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    lane_by_lane! { asin acos atan sinh cosh tanh exp ln sqrt abs positive }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.with(x, Scalar::atan2)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.map(|x| {
            let negative = if x < 0.0 { -1.0 } else { x };
            if x > 0.0 { 1.0 } else { negative }
        })
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.with(exponent, Scalar::powf)
    }

    #[inline(always)]
    fn stumpff(self, n: u32) -> Self {
        self.map(|s| series::stumpff(n, s))
    }
}

#[cfg(test)]
mod tests;
