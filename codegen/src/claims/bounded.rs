//! Numbers that know how far rounding may have taken them: a running error analysis (Wilkinson, 1963; Higham, *Accuracy
//! and Stability of Numerical Algorithms*, section 3.3).

use crate::dag::Elementary;
use crate::dag::Number;
use std::ops::Add;
use std::ops::Mul;

/// Units of rounding of an elementary function, more than those of any standard library.
const FUNCTION: f64 = 4.0;

/// Errors taken as equal to their bounds: what the bounds leave out is of second order.
const SLACK: f64 = 4.0;

/// Largest error, relative to the terms of a difference, that shows well whether it is 0. Smaller values leave fewer
/// points that can decide; larger ones take a difference for rounding.
const PRECISE: f64 = 1e-10;

/// Largest such error that shows it at all, for what cancels everywhere.
const USEFUL: f64 = 1e-6;

/// What a comparison comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Verdict {
    /// Equal but for rounding, which is small.
    Equal,
    /// Equal but for rounding, which hides small differences.
    Similar,
    /// Further apart than rounding explains.
    Different,
    /// One of both has no value, and the other has one.
    OneSided,
    /// Neither can be told.
    Undecided,
}

/// A value with a bound of its error to first order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    /// As computed; meaningless where it is outside.
    pub(super) value: f64,
    /// How far it may be from what it would be without rounding; infinite or NaN if nothing is known.
    error: f64,
    /// What the error must be small against: the value or, where that may be 0, the smallest of the terms that cancel.
    size: f64,
    /// A function has no value there, however its argument was rounded.
    outside: bool,
}

impl Bounded {
    /// The number `value` itself.
    pub(super) fn exact(value: f64) -> Self {
        let size = match value {
            // No term, so nothing that could be lost against it.
            0.0 => f64::INFINITY,
            _ => value.abs(),
        };
        Self {
            value,
            error: 0.0,
            size,
            outside: false,
        }
    }

    /// Exactly 1.
    pub(super) fn is_one(self) -> bool {
        self.value == 1.0 && self.error == 0.0
    }

    /// True for a value with a bound, and for what has no value for certain.
    pub(super) fn is_known(self) -> bool {
        self.outside || self.value.is_finite() && self.error.is_finite()
    }

    /// True where a function has no value.
    pub(super) fn is_outside(self) -> bool {
        self.outside
    }

    /// As computed; NaN outside.
    pub(super) fn shown(self) -> f64 {
        if self.outside { f64::NAN } else { self.value }
    }

    /// Largest relative error; infinite where the value may be 0.
    pub(super) fn relative_error(self) -> f64 {
        if self.is_known() && !self.outside && self.value.abs() > self.error {
            self.error / self.value.abs()
        } else {
            f64::INFINITY
        }
    }

    /// 1/x
    pub(super) fn inverse(self) -> Self {
        self.power(-1)
    }

    /// Whether both are the same number.
    pub(super) fn compare(self, other: Self) -> Verdict {
        if !self.is_known() || !other.is_known() || self.outside && other.outside {
            return Verdict::Undecided;
        }
        if self.outside || other.outside {
            return Verdict::OneSided;
        }
        let gap = self + Self::exact(-1.0) * other;
        if gap.value.abs() > SLACK * gap.error {
            Verdict::Different
        } else if gap.error <= PRECISE * gap.size {
            Verdict::Equal
        } else if gap.error <= USEFUL * gap.size {
            Verdict::Similar
        } else {
            Verdict::Undecided
        }
    }

    /// From a value, its error and the size of what cancelled, should the value be no larger than its error.
    fn new(value: f64, error: f64, terms: f64, outside: bool) -> Self {
        let size = if value.abs() > error {
            value.abs()
        } else {
            terms
        };
        Self {
            value,
            error,
            size,
            outside,
        }
    }
}

impl Add for Bounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        let rounding = f64::EPSILON * (self.value.abs() + other.value.abs());
        let error = self.error + other.error + rounding;
        let outside = self.outside || other.outside;
        Self::new(value, error, self.size.min(other.size), outside)
    }
}

impl Mul for Bounded {
    type Output = Self;

    /// The error has a part for what is too small for its digits, for products of 0 too: the 0 may be a number below all
    /// others.
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value.abs(), other.value.abs());
        let value = self.value * other.value;
        let inherited = a * other.error + b * self.error + self.error * other.error;
        let error = inherited + f64::EPSILON * (a * b) + f64::MIN_POSITIVE * f64::EPSILON;
        let outside = self.outside || other.outside;
        Self::new(value, error, self.size * other.size, outside)
    }
}

impl Number for Bounded {
    fn constant(high: f64, low: f64) -> Self {
        match low {
            0.0 => Self::exact(high),
            _ => Self::new(high, low.abs(), 0.0, false),
        }
    }

    fn power(self, exponent: i32) -> Self {
        if exponent == 1 {
            return self;
        }
        let value = self.value.powi(exponent);
        let times = f64::from(exponent.unsigned_abs());
        // Where the derivative n xⁿ⁻¹ is largest.
        let end = if exponent < 0 {
            self.value.abs() - self.error
        } else {
            self.value.abs() + self.error
        };
        let inherited = if exponent < 0 && end <= 0.0 {
            f64::INFINITY
        } else if self.error == 0.0 {
            0.0
        } else {
            times * (self.error / end) * end.powi(exponent)
        };
        let error = inherited + times * f64::EPSILON * value.abs() + f64::MIN_POSITIVE;
        Self::new(value, error, self.size.powi(exponent), self.outside)
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        let at = |x: f64, y: Option<f64>| f64::call(function, x, y);
        let second = y.map(|y| y.value);
        let is_known = x.is_known() && y.is_none_or(Self::is_known);
        let inherits = x.outside || y.is_some_and(|y| y.outside);
        let value = at(x.value, second);
        let mut ends = Vec::new();
        for sign in [-1.0, 1.0] {
            ends.push(at(x.value + sign * x.error, second));
            if let Some(y) = y {
                ends.push(at(x.value, Some(y.value + sign * y.error)));
            }
        }
        let outside = inherits || is_known && value.is_nan() && ends.iter().all(|end| end.is_nan());
        // NaN where an end is beyond the domain, which is no bound.
        let across: f64 = ends.iter().map(|end| (end - value).abs()).sum();
        let error = across + rounding(function, x.value, value) + turning(function, x.error);
        // A small value has its zero from its argument.
        let slope = if x.error > 0.0 { across / x.error } else { 1.0 };
        let terms = x.size.min(y.map_or(x.size, |y| y.size)) * slope.min(1.0);
        Self::new(value, error, terms, outside)
    }
}

/// Rounding within a function.
fn rounding(function: Elementary, x: f64, value: f64) -> f64 {
    let units = FUNCTION * f64::EPSILON;
    match function {
        // The argument √|s| of a sine or an exponential is rounded, and so is what is taken from 1/n!.
        Elementary::Stumpff(n) => {
            let first = (1..=n).fold(1.0, |product, i| product / f64::from(i));
            units * (1.0 + x.abs().sqrt()) * value.abs().max(first)
        }
        _ => units * value.abs() + f64::MIN_POSITIVE * f64::EPSILON,
    }
}

/// By how much a function may turn back within the error of its argument, which its values at both ends would not show.
fn turning(function: Elementary, error: f64) -> f64 {
    match function {
        Elementary::Sin | Elementary::Cos | Elementary::Stumpff(_) => error.powi(2).min(2.0),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::Bounded;
    use super::Verdict;
    use crate::dag::Elementary;
    use crate::dag::Number;

    fn exact(value: f64) -> Bounded {
        Bounded::exact(value)
    }

    fn call(function: Elementary, x: Bounded) -> Bounded {
        Bounded::call(function, x, None)
    }

    #[test]
    fn the_bound_holds_and_is_not_much_too_large() {
        // (x + y)³ − x³ − 3x²y − 3xy² − y³ of thirds is 0.
        let third =
            |n: i32| Bounded::constant(f64::from(n) / 3.0, f64::EPSILON * f64::from(n) / 6.0);
        let mut share = 0.0_f64;
        for (n, m) in (1..200).flat_map(|n| (1..50).map(move |m| (n, m))) {
            let (x, y) = (third(n), third(m));
            let times = |factor: f64, a: Bounded, b: Bounded| exact(factor) * a * b;
            let cubes = x.power(3) + y.power(3);
            let rest = times(3.0, x.power(2), y) + times(3.0, x, y.power(2));
            let zero = (x + y).power(3) + exact(-1.0) * (cubes + rest);
            assert!(zero.value.abs() <= zero.error, "{n} {m} {zero:?}");
            share = share.max(zero.value.abs() / zero.error);
        }
        assert!(share > 0.03, "{share}");
    }

    #[test]
    fn sums_are_compared_with_their_terms() {
        let tiny = exact(1e-200);
        let twice = exact(2.0) * tiny;
        assert_eq!(tiny.compare(twice), Verdict::Different);
        assert_eq!(twice.compare(tiny + tiny), Verdict::Equal);
        // What is lost in 1e16 + 1 may be 1 or 2.
        let lost = (exact(1e16) + exact(1.0)) + exact(-1e16);
        assert_eq!(lost.compare(exact(1.0)), Verdict::Undecided);
        assert_eq!(lost.compare(exact(2.0)), Verdict::Undecided);
        assert_eq!((lost + exact(-2.0)).compare(exact(0.0)), Verdict::Undecided);
        let nearly = (exact(1e7) + exact(1.0)) + exact(-1e7);
        assert_eq!(nearly.compare(exact(1.0)), Verdict::Similar);
        assert_eq!(nearly.compare(exact(2.0)), Verdict::Different);
    }

    #[test]
    fn products_below_all_numbers_are_not_0() {
        let small = exact(1e-200) * exact(1e-200);
        assert_eq!(small.compare(exact(0.0)), Verdict::Undecided);
        assert_eq!((small * exact(3.0)).compare(small), Verdict::Undecided);
        assert_eq!(exact(0.0).compare(exact(0.0)), Verdict::Equal);
    }

    #[test]
    fn what_has_no_value_differs_from_what_has_one() {
        let root = call(Elementary::Sqrt, exact(-1.0));
        assert!(root.is_outside());
        assert_eq!((root * exact(2.0)).compare(exact(1.0)), Verdict::OneSided);
        assert_eq!(root.compare(root), Verdict::Undecided);
        // 0 but for rounding may have a root, and what overflows has a value.
        let zero = (exact(0.1) + exact(0.2)) + exact(-0.3);
        let rooted = call(Elementary::Sqrt, exact(-1.0) * zero);
        assert_eq!(rooted.compare(exact(1.0)), Verdict::Undecided);
        let large = call(Elementary::Exp, exact(1000.0));
        assert_eq!(
            (large * large.inverse()).compare(exact(2.0)),
            Verdict::Undecided
        );
    }
}
