//! Double-double numbers: a sum of two `f64`, some 31 digits.
//!
//! Written here because the crates at hand fall short of 1e-30: `twofloat` 0.8.4 divides to 1e-17 (the
//! residual of its reciprocal is rounded) and has sines to 1e-21; `qd` 0.8.0 has neither sine nor arc
//! tangent, and sums without a bound where they cancel.
//!
//! Source: Joldeș, Muller and Popescu, *Tight and rigorous error bounds for basic building blocks of
//! double-word arithmetic*, ACM Trans. Math. Softw. 44 (2017); Dekker, *A floating-point technique for
//! extending the available precision*, Numer. Math. 18 (1971).

mod decimal;
mod functions;
mod scalar;

pub use decimal::NotDecimal;

use core::ops::Add;
use core::ops::Div;
use core::ops::Mul;
use core::ops::Neg;
use core::ops::Sub;

/// The unevaluated sum hi + lo with hi = fl(hi + lo).
///
/// Sums, products, quotients and roots have relative errors below 2⁻¹⁰⁰ while no product over- or
/// underflows.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double {
    hi: f64,
    lo: f64,
}

impl Double {
    /// 0
    pub const ZERO: Self = Self::new(0.0, 0.0);
    /// 1
    pub const ONE: Self = Self::new(1.0, 0.0);
    /// π
    pub const PI: Self = Self::new(core::f64::consts::PI, 1.2246467991473532e-16);
    /// ln 2
    pub(crate) const LN_2: Self = Self::new(core::f64::consts::LN_2, 2.3190468138462996e-17);

    const fn new(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// The nearest `f64`.
    pub const fn to_f64(self) -> f64 {
        self.hi
    }

    /// Neither infinite nor NaN.
    pub fn is_finite(self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }

    /// The product with a power of two, without rounding.
    fn scaled(self, power: f64) -> Self {
        Self::new(self.hi * power, self.lo * power)
    }

    /// x², one product less than x · x.
    pub fn squared(self) -> Self {
        let p = product(self.hi, self.hi);
        fast_sum(p.hi, p.lo + 2.0 * self.hi * self.lo)
    }
}

impl From<f64> for Double {
    fn from(value: f64) -> Self {
        Self::new(value, 0.0)
    }
}

/// a + b for |a| ≥ |b| (Dekker 1971).
#[inline]
fn fast_sum(a: f64, b: f64) -> Double {
    let s = a + b;
    Double::new(s, b - (s - a))
}

/// a + b (Møller 1965, Knuth 1969).
#[inline]
fn sum(a: f64, b: f64) -> Double {
    let s = a + b;
    let a_part = s - b;
    let b_part = s - a_part;
    Double::new(s, (a - a_part) + (b - b_part))
}

/// a · b: by a fused multiply-add where that is an instruction, else in halves of 26 bits (Veltkamp, Dekker 1971).
#[inline]
fn product(a: f64, b: f64) -> Double {
    let p = a * b;
    if cfg!(target_feature = "fma") {
        return Double::new(p, a.mul_add(b, -p));
    }
    let (a_hi, a_lo) = halves(a);
    let (b_hi, b_lo) = halves(b);
    let low = ((a_hi * b_hi - p) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo;
    Double::new(p, low)
}

#[inline]
fn halves(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = SPLITTER * a;
    let hi = scaled - (scaled - a);
    (hi, a - hi)
}

impl Add for Double {
    type Output = Self;

    /// Joldeș et al., algorithm 6.
    #[inline]
    fn add(self, other: Self) -> Self {
        let high = sum(self.hi, other.hi);
        let low = sum(self.lo, other.lo);
        let mid = fast_sum(high.hi, high.lo + low.hi);
        fast_sum(mid.hi, mid.lo + low.lo)
    }
}

impl Sub for Double {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Neg for Double {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.hi, -self.lo)
    }
}

impl Mul for Double {
    type Output = Self;

    /// Joldeș et al., algorithm 10.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let p = product(self.hi, other.hi);
        fast_sum(p.hi, p.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Mul<f64> for Double {
    type Output = Self;

    #[inline]
    fn mul(self, other: f64) -> Self {
        let p = product(self.hi, other);
        fast_sum(p.hi, p.lo + self.lo * other)
    }
}

impl Div for Double {
    type Output = Self;

    /// Long division: three quotients of `f64`.
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        let third = rest.hi / other.hi;
        fast_sum(first, second) + Self::from(third)
    }
}

impl Div<f64> for Double {
    type Output = Self;

    #[inline]
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}
