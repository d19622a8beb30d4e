//! A number beside the size of the terms that it is the sum of: how much rounding it may carry.

use crate::number::Number;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// A value and its size.
///
/// The size of a sum is the sum of the sizes, that of a product the product, and that of a function
/// follows its derivative. So a value whose longest path has n operations, computed in any order of its
/// sums, lies within n ε/2 · size of the exact one (running error analysis, Higham 2002, section 3.3,
/// to first order in ε).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The number.
    pub value: f64,
    /// The magnitudes of its terms, added up.
    pub size: f64,
}

impl Number for Measured {
    fn constant(value: f64) -> Self {
        Measured {
            value,
            size: value.abs(),
        }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        let measured = |value: f64, derivative: f64| Measured {
            value,
            size: value.abs() + derivative.abs() * self.size,
        };
        (measured(sin, cos), measured(cos, sin))
    }
}

impl Add for Measured {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Measured {
            value: self.value + other.value,
            size: self.size + other.size,
        }
    }
}

impl Sub for Measured {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Measured {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Measured {
            value: self.value * other.value,
            size: self.size * other.size,
        }
    }
}

impl Div for Measured {
    type Output = Self;
    /// |∂(a/b)| brings the relative size of the divisor with it.
    fn div(self, other: Self) -> Self {
        Measured {
            value: self.value / other.value,
            size: self.size * other.size / (other.value * other.value),
        }
    }
}

impl Neg for Measured {
    type Output = Self;
    fn neg(self) -> Self {
        Measured {
            value: -self.value,
            size: self.size,
        }
    }
}

impl AddAssign for Measured {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Measured {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Measured {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl DivAssign for Measured {
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl Zero for Measured {
    fn zero() -> Self {
        Measured::constant(0.0)
    }
    fn is_zero(&self) -> bool {
        self.size == 0.0
    }
}

impl One for Measured {
    fn one() -> Self {
        Measured::constant(1.0)
    }
}
