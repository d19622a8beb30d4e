//! Double-double arithmetic at build time, for coefficients.
//!
//! Source: Dekker, *A floating-point technique for extending the available precision*, Numer. Math. 18 (1971).

use crate::scalar::Scalar;

/// The unevaluated sum of two `f64`, some 31 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extended {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

impl Extended {
    pub(crate) const ZERO: Self = Self::new(0.0);
    pub(crate) const ONE: Self = Self::new(1.0);

    pub(crate) const fn new(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }

    pub(crate) const fn add(self, other: Self) -> Self {
        let sum = two_sum(self.hi, other.hi);
        let rest = two_sum(self.lo, other.lo);
        let sum = fast_sum(sum.hi, sum.lo + rest.hi);
        fast_sum(sum.hi, sum.lo + rest.lo)
    }

    pub(crate) const fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }

    pub(crate) const fn sub(self, other: Self) -> Self {
        self.add(other.neg())
    }

    pub(crate) const fn mul(self, other: Self) -> Self {
        let product = two_product(self.hi, other.hi);
        let cross = self.hi * other.lo + self.lo * other.hi;
        fast_sum(product.hi, product.lo + cross)
    }

    pub(crate) const fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self.sub(other.mul(Self::new(first)));
        let second = rest.hi / other.hi;
        let rest = rest.sub(other.mul(Self::new(second)));
        fast_sum(first, second).add(Self::new(rest.hi / other.hi))
    }

    /// In the numbers of a run.
    pub(crate) fn to<T: Scalar>(self) -> T {
        T::constant(self.hi) + T::constant(self.lo)
    }
}

/// a + b and what is rounded off it (Knuth, *The Art of Computer Programming* 2, 4.2.2, theorem B).
const fn two_sum(a: f64, b: f64) -> Extended {
    let hi = a + b;
    let part = hi - a;
    Extended {
        hi,
        lo: (a - (hi - part)) + (b - part),
    }
}

/// The same for |a| ≥ |b|.
const fn fast_sum(a: f64, b: f64) -> Extended {
    let hi = a + b;
    Extended {
        hi,
        lo: b - (hi - a),
    }
}

/// a b and what is rounded off it.
const fn two_product(a: f64, b: f64) -> Extended {
    let (a1, a2) = halves(a);
    let (b1, b2) = halves(b);
    let hi = a * b;
    Extended {
        hi,
        lo: ((a1 * b1 - hi) + a1 * b2 + a2 * b1) + a2 * b2,
    }
}

/// Two halves of 26 bits.
const fn halves(a: f64) -> (f64, f64) {
    let shifted = 134_217_729.0 * a;
    let high = shifted - (shifted - a);
    (high, a - high)
}
