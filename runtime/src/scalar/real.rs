//! `f64` and `f32`, with functions from the standard library or, without it, from `libm`.

use num_traits::Float;

use super::Real;
use super::Scalar;
use crate::stumpff::stumpff;

macro_rules! real {
    ($float:ty) => {
        impl Scalar for $float {
            fn constant(value: f64) -> Self {
                value as $float
            }
            fn sin(self) -> Self {
                Float::sin(self)
            }
            fn cos(self) -> Self {
                Float::cos(self)
            }
            fn sin_cos(self) -> (Self, Self) {
                Float::sin_cos(self)
            }
            fn tan(self) -> Self {
                Float::tan(self)
            }
            fn asin(self) -> Self {
                Float::asin(self)
            }
            fn acos(self) -> Self {
                Float::acos(self)
            }
            fn atan(self) -> Self {
                Float::atan(self)
            }
            fn atan2(self, x: Self) -> Self {
                Float::atan2(self, x)
            }
            fn sinh(self) -> Self {
                Float::sinh(self)
            }
            fn cosh(self) -> Self {
                Float::cosh(self)
            }
            fn tanh(self) -> Self {
                Float::tanh(self)
            }
            fn exp(self) -> Self {
                Float::exp(self)
            }
            fn ln(self) -> Self {
                Float::ln(self)
            }
            fn sqrt(self) -> Self {
                Float::sqrt(self)
            }
            fn abs(self) -> Self {
                Float::abs(self)
            }
            fn sign(self) -> Self {
                if self > 0.0 {
                    1.0
                } else if self < 0.0 {
                    -1.0
                } else {
                    self
                }
            }
            fn powf(self, exponent: Self) -> Self {
                Float::powf(self, exponent)
            }
            fn stumpff(self, n: u32) -> Self {
                stumpff(n, self, f64::from(<$float>::EPSILON))
            }
        }

        impl Real for $float {
            const EPSILON: Self = <$float>::EPSILON;
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}

real!(f64);
real!(f32);
