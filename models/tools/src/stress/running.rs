//! Numbers that know how far rounding may have taken them: a running error analysis (Wilkinson, 1963; Higham, *Accuracy and
//! Stability of Numerical Algorithms*, section 3.3).

use std::ops::Add;
use std::ops::Mul;

use residua::Real;
use residua_codegen::dag::Elementary;
use residua_codegen::dag::Number;

/// Units of rounding of an elementary function, more than those of any that is used here.
const FUNCTION: f64 = 4.0;

/// A value and a bound of its error to first order, whatever the order of sums and products it came from.
#[derive(Clone, Copy, Debug)]
pub struct Running<T> {
    /// As computed.
    pub value: T,
    /// How far it may be from what it would be without rounding.
    pub error: T,
}

impl<T: Real> Running<T> {
    /// The number nearest to `value`, as what is meant.
    pub fn exact(value: f64) -> Self {
        Self {
            value: T::constant(value),
            error: T::constant(0.0),
        }
    }
}

impl<T: Real> Add for Running<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let terms = self.value.abs() + other.value.abs();
        Self {
            value: self.value + other.value,
            error: self.error + other.error + T::EPSILON * terms,
        }
    }
}

impl<T: Real> Mul for Running<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.value.abs(), other.value.abs());
        Self {
            value: self.value * other.value,
            error: a * other.error + b * self.error + T::EPSILON * a * b + lost(a, b),
        }
    }
}

/// What a product may lose that is too small for its digits: nothing where a factor is 0.
fn lost<T: Real>(a: T, b: T) -> T {
    let zero = T::constant(0.0);
    if a == zero || b == zero {
        return zero;
    }
    T::EPSILON * T::LEAST
}

impl<T: Real> Number for Running<T> {
    fn constant(high: f64, low: f64) -> Self {
        let value = T::constant(high);
        Self {
            value,
            error: T::constant((high - value.to_f64()).abs() + low.abs()),
        }
    }

    fn power(self, exponent: i32) -> Self {
        let power = |exponent| T::constant(self.value.to_f64().powi(exponent));
        let value = power(exponent);
        let times = T::constant(f64::from(exponent.unsigned_abs()));
        let zero = T::constant(0.0);
        // n xⁿ⁻¹ times the error of x, where it has one.
        let inherited = match self.error == zero {
            true => zero,
            false => times * power(exponent - 1).abs() * self.error,
        };
        if exponent == 1 {
            let error = inherited;
            return Self { value, error };
        }
        // The inverse of a power beyond all numbers is 0.
        let lost = if exponent < 0 {
            T::LEAST
        } else {
            lost(value, value)
        };
        let error = inherited + times * T::EPSILON * value.abs() + lost;
        Self { value, error }
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        let at = |x: f64, y: Option<f64>| f64::call(function, x, y);
        let (x_value, y_value) = (x.value.to_f64(), y.map(|y| y.value.to_f64()));
        let value = at(x_value, y_value);
        let mut error = FUNCTION * T::EPSILON.to_f64() * value.abs();
        if matches!(function, Elementary::Sin | Elementary::Cos) {
            // They turn back within errors of a radian, which differences would not see.
            error += x.error.to_f64().powi(2).min(2.0);
        }
        // How much it changes over the error of an argument; NaN beyond the domain, which is no bound.
        for sign in [-1.0, 1.0] {
            error += (at(x_value + sign * x.error.to_f64(), y_value) - value).abs();
            if let (Some(y), Some(y_value)) = (y, y_value) {
                error += (at(x_value, Some(y_value + sign * y.error.to_f64())) - value).abs();
            }
        }
        Self {
            value: T::constant(value),
            error: T::constant(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Running;
    use rand::RngExt;
    use rand::SeedableRng;
    use rand::rngs::StdRng;
    use residua_codegen::dag::Elementary;
    use residua_codegen::dag::Number;
    use residua_models::exact::Double;

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
    fn the_bound_holds_and_is_not_much_too_large_in_single_precision() {
        let mut rng = StdRng::seed_from_u64(7);
        let mut share = 0.0_f64;
        for _ in 0..10_000 {
            let values = [(); 3].map(|()| f64::from(rng.random_range(-30.0..30.0_f32)));
            let exact = expression(Double::from, values)[0].to_f64();
            for found in expression(Running::<f32>::exact, values) {
                let (value, error) = (f64::from(found.value), f64::from(found.error));
                let off = (value - exact).abs();
                assert!(off <= error, "{values:?}: {off:e} {found:?}");
                share = share.max(off / error);
            }
        }
        assert!(share > 0.05, "{share}");
    }

    #[test]
    fn the_bound_holds_and_is_not_much_too_large() {
        let mut rng = StdRng::seed_from_u64(7);
        let mut share = 0.0_f64;
        for _ in 0..10_000 {
            let values = [(); 3].map(|()| rng.random_range(-30.0..30.0_f64));
            let exact = expression(Double::from, values)[0];
            for found in expression(Running::<f64>::exact, values) {
                let off = (Double::from(found.value) - exact).to_f64().abs();
                assert!(off <= found.error, "{values:?}: {off:e} {found:?}");
                share = share.max(off / found.error);
            }
        }
        assert!(share > 0.05, "{share}");
    }
}
