//! Numbers that know how far rounding may have taken them: a running error analysis (Wilkinson, 1963; Higham, *Accuracy and
//! Stability of Numerical Algorithms*, section 3.3).

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Real;
use super::Scalar;
use super::larger;

/// ε of an elementary function: more than any used here loses.
const FUNCTION: f64 = 2.0;

/// A number and a bound of its error, to first order where arithmetic magnifies it.
///
/// Nothing is inlined: this is computed now and then, and compiled once for each solver.
#[derive(Clone, Copy, Debug)]
pub struct Rounded<T> {
    /// As computed.
    pub(crate) value: T,
    /// How far it may be from what it would be without rounding; NaN where that is anywhere.
    pub(crate) error: T,
}

impl<T: Real> Rounded<T> {
    /// What is meant as it is.
    pub(crate) fn exact(value: T) -> Self {
        Self {
            value,
            error: T::constant(0.0),
        }
    }

    /// The result of an operation that rounds by half of ε, and what its operands bring with them.
    fn of(value: T, inherited: T) -> Self {
        let own = T::constant(0.5) * T::EPSILON * value.abs();
        Self {
            value,
            error: inherited + own,
        }
    }

    /// f(x), from how much it changes over the error of x.
    #[inline(never)]
    fn function(self, f: impl Fn(T) -> T) -> Self {
        let value = f(self.value);
        let zero = T::constant(0.0);
        let mut change = zero;
        if self.error > zero {
            for x in [self.value - self.error, self.value + self.error] {
                // No number beyond the domain, which x is not meant to be.
                change = larger(change, (f(x) - value).abs());
            }
        }
        let own = T::constant(FUNCTION) * T::EPSILON * value.abs();
        Self {
            value,
            error: change + own,
        }
    }

    /// The same for functions that turn back within errors of a radian: |f″| ≤ 1, |f| ≤ 1.
    fn wave(self, f: impl Fn(T) -> T) -> Self {
        let curved = self.error * self.error;
        let most = T::constant(2.0);
        let mut wave = self.function(f);
        wave.error = wave.error + if curved > most { most } else { curved };
        wave
    }

    /// f(x, y), from how much it changes over the error of each.
    fn function_of_two(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        let of_first = self.function(|x| f(x, other.value));
        let of_second = other.function(|y| f(self.value, y));
        Self {
            value: of_first.value,
            error: of_first.error + of_second.error,
        }
    }
}

impl<T: Real> Add for Rounded<T> {
    type Output = Self;

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        Self::of(self.value + other.value, self.error + other.error)
    }
}

impl<T: Real> Sub for Rounded<T> {
    type Output = Self;

    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        Self::of(self.value - other.value, self.error + other.error)
    }
}

impl<T: Real> Mul for Rounded<T> {
    type Output = Self;

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let inherited = self.value.abs() * other.error + other.value.abs() * self.error;
        Self::of(self.value * other.value, inherited)
    }
}

impl<T: Real> Div for Rounded<T> {
    type Output = Self;

    #[inline(never)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let inherited = self.error + quotient.abs() * other.error;
        Self::of(quotient, inherited / other.value.abs())
    }
}

impl<T: Real> Neg for Rounded<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            error: self.error,
        }
    }
}

impl<T: Real> Scalar for Rounded<T> {
    fn constant(value: f64) -> Self {
        let nearest = T::constant(value);
        Self {
            value: nearest,
            error: T::constant((value - nearest.to_f64()).abs()),
        }
    }
    fn sin(self) -> Self {
        self.wave(T::sin)
    }
    fn cos(self) -> Self {
        self.wave(T::cos)
    }
    fn tan(self) -> Self {
        self.function(T::tan)
    }
    fn asin(self) -> Self {
        self.function(T::asin)
    }
    fn acos(self) -> Self {
        self.function(T::acos)
    }
    fn atan(self) -> Self {
        self.function(T::atan)
    }
    fn atan2(self, x: Self) -> Self {
        self.function_of_two(x, T::atan2)
    }
    fn sinh(self) -> Self {
        self.function(T::sinh)
    }
    fn cosh(self) -> Self {
        self.function(T::cosh)
    }
    fn tanh(self) -> Self {
        self.function(T::tanh)
    }
    fn exp(self) -> Self {
        self.function(T::exp)
    }
    fn ln(self) -> Self {
        self.function(T::ln)
    }
    fn sqrt(self) -> Self {
        self.function(T::sqrt)
    }
    fn abs(self) -> Self {
        Self {
            value: self.value.abs(),
            error: self.error,
        }
    }
    /// As if its argument had the sign that it has.
    fn sign(self) -> Self {
        Self::exact(self.value.sign())
    }
    fn positive(self) -> Self {
        let zero = T::constant(0.0);
        let is_none = self.value <= zero && self.error <= -self.value;
        Self {
            value: self.value.positive(),
            error: if is_none { zero } else { self.error },
        }
    }
    fn powf(self, exponent: Self) -> Self {
        self.function_of_two(exponent, T::powf)
    }
    fn stumpff(self, n: u32) -> Self {
        self.function(|s| s.stumpff(n))
    }
}

#[cfg(test)]
mod tests {
    use super::Rounded;
    use super::Scalar;

    /// All operations, sums that cancel among them.
    fn expression<T: Scalar>([x, y, z]: [T; 3]) -> T {
        let one = T::constant(1.0);
        let far = (x + T::constant(1e3)) * y - x * y - T::constant(1e3) * y;
        let angles = (x * z).sin() * (y - x).cos() + (x * y).atan() + y.atan2(x) + z.tanh();
        let roots = (y * y + one).sqrt() / (one + z.abs()) + (x * x + one).ln();
        let small = (x * x).stumpff(3) + (x - y).positive() - (y * y + one).powf(z);
        far + angles * roots - small / (x * y + T::constant(2e3)) + (-z).exp()
    }

    #[test]
    fn the_bound_holds_and_is_not_much_too_large() {
        let mut share = 0.0_f64;
        for n in 1..5_000_u32 {
            // Numbers all over the cube, by the golden ratio's kin.
            let part = |k: f64| (f64::from(n) * k).fract() * 6.0 - 3.0;
            let values = [0.754_877_666, 0.569_840_291, 0.438_744_1].map(|k| part(k) as f32);
            let exact = expression(values.map(f64::from));
            let found = expression(values.map(Rounded::exact));
            let off = (f64::from(found.value) - exact).abs();
            let error = f64::from(found.error);
            assert!(off <= error, "{values:?}: {off:e} beyond {found:?}");
            share = share.max(off / error);
        }
        assert!(share > 0.05, "{share}");
    }

    #[test]
    fn errors_are_passed_on_as_slopes_are() {
        let with = |value: f64, error: f64| Rounded { value, error };
        let (a, b) = (with(10.0, 1e-3), with(-4.0, 1e-4));
        let expected = [
            (a + b, 1.1e-3),
            (a - b, 1.1e-3),
            (a * b, 5e-3),
            (a / b, 1e-3 / 4.0 + 2.5 * 1e-4 / 4.0),
            (-a, 1e-3),
            (b.abs(), 1e-4),
            (a.sqrt(), 1e-3 / (2.0 * 10_f64.sqrt())),
            (a.sin(), 1e-3 * 10_f64.cos().abs()),
            (b.exp(), 1e-4 * (-4_f64).exp()),
            (a.atan2(b), (4.0 * 1e-3 + 10.0 * 1e-4) / 116.0),
            (a.positive(), 1e-3),
            (b.positive(), 0.0),
        ];
        for (found, error) in expected {
            assert!(
                (found.error - error).abs() <= 3e-3 * error,
                "{found:?}, {error:e}"
            );
        }
    }

    #[test]
    fn exact_operands_carry_nothing_but_their_rounding() {
        let [a, b] = [1e16, 1.0].map(Rounded::exact);
        let lost = (a + b) - a;
        assert_eq!(lost.value, 0.0);
        assert!((1.0..3.0).contains(&lost.error), "{lost:?}");
        let root = Rounded::exact(0.0_f64).sqrt();
        assert_eq!((root.value, root.error), (0.0, 0.0));
        let edge = (Rounded::exact(1.0_f64) * Rounded::constant(1.0)).acos();
        assert!(edge.error.is_finite(), "{edge:?}");
    }
}
