//! Elementary functions of double-double numbers: an `f64` start and one correction, or a series.

use super::Double;
use super::fast_sum;
use super::product;

/// Terms after which every series here has converged: 0.8³²/32! < 2⁻¹²⁰.
const TERMS: u32 = 32;

/// π/2 less its double-double value, without which the sine of π would keep no digit.
const QUARTER_REST: f64 = -1.4973849048591698e-33;

impl Double {
    /// √x, by one Newton step from the root in `f64` (Karp and Markstein, ACM Trans. Math. Softw. 23, 1997).
    pub fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        let root = self.hi.sqrt();
        let rest = self - product(root, root);
        fast_sum(root, rest.hi / (2.0 * root))
    }

    /// |x|
    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// (sin x, cos x), both to 2⁻¹⁰⁰ max(1, |x|): quarter turns taken off, then Taylor's series.
    pub fn sin_cos(self) -> (Self, Self) {
        let quarter = Self::PI.scaled(0.5);
        let quarters = (self.hi / quarter.hi).round();
        let x = self - quarter * quarters - (QUARTER_REST * quarters).into();
        let square = -x.squared();
        let sin = x * powers(square, 2);
        let cos = powers(square, 1);
        match quarters.rem_euclid(4.0) {
            0.0 => (sin, cos),
            1.0 => (cos, -sin),
            2.0 => (-sin, -cos),
            3.0 => (-cos, sin),
            _ => (Self::from(f64::NAN), Self::from(f64::NAN)),
        }
    }

    /// The angle of (x, y) with y = self: of an angle z in `f64`, tan δ = (y cos z − x sin z)/(x cos z + y sin z)
    /// is what is missing, and δ = tan δ to 10⁻⁴⁸.
    pub fn atan2(self, x: Self) -> Self {
        let near = Self::from(self.hi.atan2(x.hi));
        if self.hi == 0.0 && x.hi == 0.0 {
            return near;
        }
        let (sin, cos) = near.sin_cos();
        near + (self * cos - x * sin) / (x * cos + self * sin)
    }

    /// eˣ: powers of two taken off, then Taylor's series.
    pub fn exp(self) -> Self {
        let twos = (self.hi / Self::LN_2.hi).round();
        // Beyond, 2ⁿ is not an f64; half-way powers keep each factor one.
        let half = 2f64.powf((twos / 2.0).floor());
        let rest = 2f64.powf(twos - (twos / 2.0).floor());
        let x = self - Self::LN_2 * twos;
        let mut term = Self::ONE;
        let mut sum = Self::ONE;
        for n in 1..TERMS {
            term = term * x / f64::from(n);
            sum = sum + term;
        }
        sum.scaled(half).scaled(rest)
    }

    /// ln x, of y in `f64` and e = exp y: y + 2 (x − e)/(x + e), wrong by δ³/12.
    pub fn ln(self) -> Self {
        let near = Self::from(self.hi.ln());
        if !near.is_finite() {
            return near;
        }
        let e = near.exp();
        near + (self - e).scaled(2.0) / (self + e)
    }

    /// The series sinh x for |x| < 1/2, where the exponentials cancel, else (eˣ − e⁻ˣ)/2.
    pub(super) fn sinh_of(self) -> Self {
        if self.hi.abs() < 0.5 {
            return self * powers(self.squared(), 2);
        }
        (self.exp() - (-self).exp()).scaled(0.5)
    }
}

/// Σ sʲ ∏ᵢ 1/((2i + p − 2)(2i + p − 1)), i = 1 … j: with s = −x², cos x for p = 1 and sin x / x for p = 2.
fn powers(s: Double, p: u32) -> Double {
    let mut term = Double::ONE;
    let mut sum = Double::ONE;
    for i in 1..TERMS / 2 {
        let n = 2 * i + p - 2;
        term = term * s / f64::from(n * (n + 1));
        sum = sum + term;
    }
    sum
}
