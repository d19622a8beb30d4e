//! First-order dual numbers a + b·ε: derivatives by the rules of `num_dual`, not by ours.

use num_dual::Dual64;
use num_dual::DualNum;
use num_traits::Signed;

use super::Scalar;
use crate::stumpff::stumpff;

impl Scalar for Dual64 {
    fn constant(value: f64) -> Self {
        Dual64::from_re(value)
    }
    fn sin(self) -> Self {
        DualNum::sin(&self)
    }
    fn cos(self) -> Self {
        DualNum::cos(&self)
    }
    fn sin_cos(self) -> (Self, Self) {
        DualNum::sin_cos(&self)
    }
    fn tan(self) -> Self {
        DualNum::tan(&self)
    }
    fn asin(self) -> Self {
        DualNum::asin(&self)
    }
    fn acos(self) -> Self {
        DualNum::acos(&self)
    }
    fn atan(self) -> Self {
        DualNum::atan(&self)
    }
    fn atan2(self, x: Self) -> Self {
        DualNum::atan2(&self, x)
    }
    fn sinh(self) -> Self {
        DualNum::sinh(&self)
    }
    fn cosh(self) -> Self {
        DualNum::cosh(&self)
    }
    fn tanh(self) -> Self {
        DualNum::tanh(&self)
    }
    fn exp(self) -> Self {
        DualNum::exp(&self)
    }
    fn ln(self) -> Self {
        DualNum::ln(&self)
    }
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
    fn abs(self) -> Self {
        Signed::abs(&self)
    }
    fn sign(self) -> Self {
        Dual64::from_re(self.re.sign())
    }
    fn powf(self, exponent: Self) -> Self {
        // The general rule takes ln x, which a negative base with a constant exponent has not.
        if exponent.eps == 0.0 {
            DualNum::powf(&self, exponent.re)
        } else {
            DualNum::powd(&self, exponent)
        }
    }
    fn stumpff(self, n: u32) -> Self {
        // The derivative of the algorithm, not the identity that the generator differentiates by.
        stumpff(n, self, f64::EPSILON)
    }
}
