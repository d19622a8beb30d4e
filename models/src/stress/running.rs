//! Numbers of `f64` that know how far they may be off: a running error analysis (Wilkinson, 1963; Higham, *Accuracy and
//! Stability of Numerical Algorithms*, section 3.3).

use std::ops::Add;
use std::ops::Mul;

use residua_codegen::dag::Elementary;
use residua_codegen::dag::Number;

/// Units of rounding of an elementary function, more than those of any that is used here.
const FUNCTION: f64 = 4.0;

/// A value and a bound of its error to first order, whatever the order of sums and products it came from.
#[derive(Clone, Copy, Debug)]
pub struct Running {
    /// In `f64`.
    pub value: f64,
    /// How far it may be from what it would be without rounding.
    pub error: f64,
}

impl Running {
    /// A number that is what it is.
    pub fn exact(value: f64) -> Self {
        Self { value, error: 0.0 }
    }
}

impl Add for Running {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let terms = self.value.abs() + other.value.abs();
        Self {
            value: self.value + other.value,
            error: self.error + other.error + f64::EPSILON * terms,
        }
    }
}

impl Mul for Running {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value.abs(), other.value.abs());
        Self {
            value: self.value * other.value,
            error: a * other.error + b * self.error + f64::EPSILON * a * b,
        }
    }
}

impl Number for Running {
    fn constant(high: f64, low: f64) -> Self {
        Self {
            value: high,
            error: low.abs(),
        }
    }

    fn power(self, exponent: i32) -> Self {
        let value = self.value.powi(exponent);
        let times = f64::from(exponent.unsigned_abs());
        let rounding = times * f64::EPSILON * value.abs();
        // n xⁿ⁻¹ times the error of x, where it has one.
        let inherited = match self.error {
            0.0 => 0.0,
            error => times * self.value.powi(exponent - 1).abs() * error,
        };
        Self {
            value,
            error: if exponent == 1 {
                inherited
            } else {
                inherited + rounding
            },
        }
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        let at = |x: f64, y: Option<f64>| f64::call(function, x, y);
        let (x_value, y_value) = (x.value, y.map(|y| y.value));
        let value = at(x_value, y_value);
        let mut error = FUNCTION * f64::EPSILON * value.abs();
        // How much it changes over the error of an argument; NaN beyond the domain, which is no bound.
        for sign in [-1.0, 1.0] {
            error += (at(x_value + sign * x.error, y_value) - value).abs();
            if let Some(y) = y {
                error += (at(x_value, Some(y.value + sign * y.error)) - value).abs();
            }
        }
        Self { value, error }
    }
}

#[cfg(test)]
mod tests {
    use super::Running;
    use crate::exact::Double;
    use rand::RngExt;
    use rand::SeedableRng;
    use rand::rngs::StdRng;
    use residua_codegen::dag::Elementary;
    use residua_codegen::dag::Number;

    /// x y − y x by two ways round, over a root and a sine: what cancels exactly in one order of products does not in
    /// another, and the bound holds for both.
    fn expression<N: Number>(number: impl Fn(f64) -> N, values: [f64; 3]) -> [N; 2] {
        let [x, y, z] = values.map(number);
        let minus = N::constant(-1.0, 0.0);
        let sine = N::call(Elementary::Sin, x * y + z, None);
        let root = N::call(Elementary::Sqrt, z.power(2) + N::constant(1.0, 0.0), None);
        let first = (x * y) * z + minus * (y * (x * z)) + sine * root.power(-1);
        let second = (x * (y * z)) + minus * ((x * y) * z) + root.power(-1) * sine;
        [first, second]
    }

    #[test]
    fn the_bound_holds_and_is_not_much_too_large() {
        let mut rng = StdRng::seed_from_u64(7);
        let mut share = 0.0_f64;
        for _ in 0..10_000 {
            let values = [(); 3].map(|()| rng.random_range(-30.0..30.0_f64));
            let exact = expression(Double::from, values)[0];
            for found in expression(Running::exact, values) {
                let off = (Double::from(found.value) - exact).to_f64().abs();
                assert!(off <= found.error, "{values:?}: {off:e} {found:?}");
                share = share.max(off / found.error);
            }
        }
        assert!(share > 0.05, "{share}");
    }
}
