//! The Stumpff functions against their series in exact arithmetic.

use num_bigint::BigInt;
use std::vec::Vec;

use crate::scalar::Real;
use crate::scalar::Scalar;

/// Fractional bits of the exact values: the terms of the series at s = 10⁴ reach e¹⁰⁰ ≈ 2¹⁴⁴.
const BITS: i32 = 256;

/// The exact value of a finite number times 2^BITS, cut below 1.
fn fixed(value: f64) -> BigInt {
    let bits = value.abs().to_bits();
    let exponent = (bits >> 52) as i32;
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let (mantissa, exponent) = match exponent {
        0 => (fraction, -1074),
        _ => (fraction | 1 << 52, exponent - 1075),
    };
    let shifted = shift(BigInt::from(mantissa), exponent + BITS);
    if value < 0.0 { -shifted } else { shifted }
}

fn shift(value: BigInt, bits: i32) -> BigInt {
    match u32::try_from(bits) {
        Ok(left) => value << left,
        Err(_) => value >> bits.unsigned_abs(),
    }
}

/// A fixed number in `f64`.
fn float(value: &BigInt) -> f64 {
    let excess = value.bits() as i32 - 64;
    let top = shift(value.clone(), -excess);
    let top: i128 = top.try_into().expect("64 bits");
    top as f64 * f64::powi(2.0, excess - BITS)
}

/// Σ (−s)^j / (n + 2j)! in fixed arithmetic.
fn exact(n: u32, s: f64) -> BigInt {
    let s = fixed(s);
    let factorial: BigInt = (1..=n).product();
    let mut term = (BigInt::from(1) << BITS) / factorial;
    let mut sum = BigInt::ZERO;
    let mut k = n;
    while term != BigInt::ZERO {
        sum += &term;
        // Division truncates towards zero, so that the terms end at zero.
        term = -(term * &s) / (BigInt::from((k + 1) * (k + 2)) << BITS);
        k += 2;
    }
    sum
}

/// |error| in units of ε (|cₙ| + |s cₙ'|): what rounding of s and of the result do.
fn error<T: Real>(n: u32, s: T) -> f64 {
    let x = s.to_f64();
    let value = exact(n, x);
    let slope = (exact(n + 2, x) * n - exact(n + 1, x)) / 2;
    let conditioned = float(&value).abs() + (x * float(&slope)).abs();
    let difference = fixed(s.stumpff(n).to_f64()) - value;
    float(&difference).abs() / conditioned / T::EPSILON.to_f64()
}

/// Stated in the docs of [`super::stumpff`] for n ≤ 8 and for n ≤ 32.
const BOUND: f64 = 2.0;
const HIGH_BOUND: f64 = 8.0;

/// Arguments of both signs: magnitudes from the smallest denormal to 10⁴, and evenly across the
/// ends of the series and beyond.
fn arguments(n: u32) -> Vec<f64> {
    let first = f64::from((n + 1) * (n + 2));
    let powers = (-1074..=13)
        .rev()
        .step_by(11)
        .map(|e| 1.37 * f64::powi(2.0, e));
    let across = (1..64).map(|i| f64::from(i) * 0.0701 * first);
    let far = (1..32).map(|i| f64::from(i) * 311.7);
    powers
        .chain(across)
        .chain(far)
        .flat_map(|s| [s, -s])
        // Beyond −7800, c₀ overflows in single precision.
        .filter(|s| (-7e3..=1e4).contains(s))
        .collect()
}

fn worst<T: Real>(n: u32) -> (f64, f64) {
    let errors = arguments(n)
        .into_iter()
        .map(|s| (error(n, T::constant(s)), s));
    errors.fold((0.0, 0.0), |worst, (error, s)| {
        assert!(error.is_finite(), "c_{n}({s})");
        if error > worst.0 { (error, s) } else { worst }
    })
}

#[test]
fn double_precision_is_within_the_stated_bound() {
    for n in 0..=8 {
        let (error, s) = worst::<f64>(n);
        assert!(error <= BOUND, "c_{n}({s:e}): {error}");
    }
}

#[test]
fn single_precision_is_within_the_stated_bound() {
    for n in 0..=8 {
        let (error, s) = worst::<f32>(n);
        assert!(error <= BOUND, "c_{n}({s:e}): {error}");
    }
}

#[test]
fn orders_up_to_32_are_within_the_stated_bound() {
    for n in [16, 31, 32] {
        let (error, s) = worst::<f64>(n);
        assert!(error <= HIGH_BOUND, "c_{n}({s:e}): {error}");
    }
}

#[test]
fn nothing_happens_at_zero() {
    let reciprocals = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0];
    for (n, reciprocal) in (0..).zip(reciprocals) {
        for s in [0.0, -0.0, 5e-324, -5e-324, f64::MIN_POSITIVE] {
            assert_eq!(s.stumpff(n), reciprocal);
        }
    }
}

#[test]
fn what_is_no_number_stays_none() {
    for n in 0..=8 {
        assert!(f64::NAN.stumpff(n).is_nan());
        assert!(f64::INFINITY.stumpff(n).is_nan());
        assert!(!f64::NEG_INFINITY.stumpff(n).is_finite());
        assert!(f64::MAX.stumpff(n).is_finite());
        assert!(!f64::MIN.stumpff(n).is_finite());
    }
}

/// The identity n c_{n+2} − c_{n+1} = 2 cₙ' against the derivative that dual numbers find for themselves.
#[cfg(feature = "dual")]
#[test]
fn dual_numbers_find_the_derivative() {
    use num_dual::Dual64;

    for n in 0..=8 {
        for s in arguments(n) {
            let dual = Dual64::new(s, 1.0).stumpff(n);
            let (c1, c2) = (s.stumpff(n + 1), s.stumpff(n + 2));
            let slope = (f64::from(n) * c2 - c1) / 2.0;
            // The derivative is as sensitive to s as the second derivative says.
            let size = s.stumpff(n).abs() + c1.abs() + (1.0 + s.abs().sqrt()) * c2.abs();
            let value = (dual.re - s.stumpff(n)).abs() / (size * f64::EPSILON);
            assert!(value <= 4.0, "c_{n}({s:e}): {value}");
            let error = (dual.eps - slope).abs() / (size * f64::EPSILON);
            assert!(error <= 32.0, "c_{n}'({s:e}): {error}");
        }
    }
}
