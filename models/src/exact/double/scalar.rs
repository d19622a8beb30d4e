//! What generated code, and the graphs that it is generated from, may ask of a number.

use residua::Packed;
use residua::Plain;
use residua::Real;
use residua::Scalar;
use residua::Work;
use residua::convolution::Convolutions;
use residua::convolution::Convolved;
use residua::convolution::Each;
use residua_codegen::dag::Elementary;
use residua_codegen::dag::Number;

use super::Double;

impl Real for Double {
    /// Sums and products are within 2⁻¹⁰⁰.
    const EPSILON: Self = Self::new(f64::EPSILON * f64::EPSILON, 0.0);
    // Where the low part has its digits, too.
    const LEAST: Self = Self::new(f64::MIN_POSITIVE / f64::EPSILON, 0.0);

    fn is_finite(self) -> bool {
        Double::is_finite(self)
    }

    fn to_f64(self) -> f64 {
        Double::to_f64(self)
    }
}

impl Packed for Double {
    type Pack<const N: usize> = residua::Each<Self, N>;

    fn work<W: Work<Self>>(work: W) -> W::Output {
        work.run(Plain)
    }
}

impl Convolved for Double {
    fn convolve<W: Convolutions<Self>>(work: W) {
        work.run(Each);
    }
}

impl Scalar for Double {
    fn constant(value: f64) -> Self {
        value.into()
    }
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    fn sin_cos(self) -> (Self, Self) {
        Double::sin_cos(self)
    }
    fn tan(self) -> Self {
        let (sin, cos) = Double::sin_cos(self);
        sin / cos
    }
    fn asin(self) -> Self {
        Double::atan2(self, ((Self::ONE - self) * (Self::ONE + self)).sqrt())
    }
    fn acos(self) -> Self {
        ((Self::ONE - self) * (Self::ONE + self)).sqrt().atan2(self)
    }
    fn atan(self) -> Self {
        Double::atan2(self, Self::ONE)
    }
    fn atan2(self, x: Self) -> Self {
        Double::atan2(self, x)
    }
    fn sinh(self) -> Self {
        self.sinh_of()
    }
    fn cosh(self) -> Self {
        (Double::exp(self) + Double::exp(-self)).scaled(0.5)
    }
    fn tanh(self) -> Self {
        // e⁻²ˡˣˡ does not overflow.
        if self.hi.abs() < 0.5 {
            return Scalar::sinh(self) / Scalar::cosh(self);
        }
        let e = Double::exp(-Double::abs(self).scaled(2.0));
        Scalar::sign(self) * (Self::ONE - e) / (Self::ONE + e)
    }
    fn exp(self) -> Self {
        Double::exp(self)
    }
    fn ln(self) -> Self {
        Double::ln(self)
    }
    fn sqrt(self) -> Self {
        Double::sqrt(self)
    }
    fn abs(self) -> Self {
        Double::abs(self)
    }
    fn sign(self) -> Self {
        Scalar::sign(self.hi).into()
    }
    fn powf(self, exponent: Self) -> Self {
        Double::exp(exponent * Double::ln(self))
    }
    /// To 31 digits for |s| ≤ 1; beyond, by the recurrence cₙ₊₂ = (1/n! − cₙ)/s, which loses some.
    fn stumpff(self, n: u32) -> Self {
        if self.hi.abs() <= 1.0 {
            return series(self, n);
        }
        let root = Double::sqrt(Double::abs(self));
        let pair = match (self.hi > 0.0, n % 2) {
            (true, 0) => root.cos(),
            (true, _) => root.sin() / root,
            (false, 0) => root.cosh(),
            (false, _) => root.sinh() / root,
        };
        let mut value = pair;
        let mut factorial = Self::ONE;
        for lower in (n % 2..n).step_by(2) {
            value = (Self::ONE / factorial - value) / self;
            factorial = factorial * f64::from(lower + 1) * f64::from(lower + 2);
        }
        value
    }
}

impl Number for Double {
    fn constant(high: f64, low: f64) -> Self {
        Self::from(high) + Self::from(low)
    }

    fn power(self, exponent: i32) -> Self {
        let (mut power, mut base) = (Self::ONE, self);
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            if left % 2 == 1 {
                power = power * base;
            }
            base = base.squared();
            left /= 2;
        }
        if exponent < 0 {
            return Self::ONE / power;
        }
        power
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        let y = y.unwrap_or(Self::from(f64::NAN));
        match function {
            Elementary::Sin => Scalar::sin(x),
            Elementary::Cos => Scalar::cos(x),
            Elementary::Tan => Scalar::tan(x),
            Elementary::Asin => Scalar::asin(x),
            Elementary::Acos => Scalar::acos(x),
            Elementary::Atan => Scalar::atan(x),
            Elementary::Atan2 => Scalar::atan2(x, y),
            Elementary::Sinh => Scalar::sinh(x),
            Elementary::Cosh => Scalar::cosh(x),
            Elementary::Tanh => Scalar::tanh(x),
            Elementary::Exp => Scalar::exp(x),
            Elementary::Log => Scalar::ln(x),
            Elementary::Sqrt => Scalar::sqrt(x),
            Elementary::Abs => Scalar::abs(x),
            Elementary::Sign => Scalar::sign(x),
            Elementary::Positive => Scalar::positive(x),
            Elementary::Power => Scalar::powf(x, y),
            Elementary::Stumpff(n) => Scalar::stumpff(x, n),
        }
    }
}

/// Σ (−s)ʲ/(n + 2j)!, j < 20: for |s| ≤ 1 the next term is below 10⁻⁴⁷.
fn series(s: Double, n: u32) -> Double {
    let mut term = Double::ONE;
    for i in 1..=n {
        term = term / f64::from(i);
    }
    let mut sum = term;
    for j in 1..20 {
        let top = n + 2 * j;
        term = -term * s / (f64::from(top - 1) * f64::from(top));
        sum = sum + term;
    }
    sum
}
