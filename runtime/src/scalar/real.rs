//! `f64` and `f32`, with functions from the standard library or, without it, from `libm`.

use num_traits::Float;

use super::Real;
use super::Scalar;
use crate::stumpff::stumpff;

macro_rules! real {
    ($float:ty) => {
        impl Scalar for $float {
            #[inline]
            fn constant(value: f64) -> Self {
                value as $float
            }
            #[inline]
            fn sin(self) -> Self {
                Float::sin(self)
            }
            #[inline]
            fn cos(self) -> Self {
                Float::cos(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                Float::sin_cos(self)
            }
            #[inline]
            fn tan(self) -> Self {
                Float::tan(self)
            }
            #[inline]
            fn asin(self) -> Self {
                Float::asin(self)
            }
            #[inline]
            fn acos(self) -> Self {
                Float::acos(self)
            }
            #[inline]
            fn atan(self) -> Self {
                Float::atan(self)
            }
            #[inline]
            fn atan2(self, x: Self) -> Self {
                Float::atan2(self, x)
            }
            #[inline]
            fn sinh(self) -> Self {
                Float::sinh(self)
            }
            #[inline]
            fn cosh(self) -> Self {
                Float::cosh(self)
            }
            #[inline]
            fn tanh(self) -> Self {
                Float::tanh(self)
            }
            #[inline]
            fn exp(self) -> Self {
                Float::exp(self)
            }
            #[inline]
            fn ln(self) -> Self {
                Float::ln(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                Float::sqrt(self)
            }
            #[inline]
            fn abs(self) -> Self {
                Float::abs(self)
            }
            #[inline]
            fn sign(self) -> Self {
                if self > 0.0 {
                    1.0
                } else if self < 0.0 {
                    -1.0
                } else {
                    self
                }
            }
            #[inline]
            fn positive(self) -> Self {
                if self <= 0.0 { 0.0 } else { self }
            }
            #[inline]
            fn powf(self, exponent: Self) -> Self {
                Float::powf(self, exponent)
            }
            #[inline]
            fn stumpff(self, n: u32) -> Self {
                stumpff(n, self, f64::from(<$float>::EPSILON))
            }
        }

        impl Real for $float {
            const EPSILON: Self = <$float>::EPSILON;
            const LEAST: Self = <$float>::MIN_POSITIVE;
            #[inline]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}

real!(f64);
real!(f32);
