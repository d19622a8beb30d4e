use num_bigint::BigInt;
use std::format;
use std::vec::Vec;

use super::Lanes;
use crate::scalar::Scalar;

/// Binary digits behind the point of the exact numbers here: twice those of the worst cancellation of any argument.
const BITS: usize = 320;

/// Largest error of sine and cosine, in units in the last place (FDLIBM's claim for its polynomials).
const ULPS: f64 = 1.0;

/// `x` times 2^BITS, exactly, for |x| ≥ 2⁻²⁰⁰ or 0.
fn fixed(x: f64) -> BigInt {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7FF) as i64;
    let mantissa = BigInt::from((bits & ((1 << 52) - 1)) | (u64::from(exponent > 0) << 52));
    let shift = exponent.max(1) - 1075 + BITS as i64;
    let size = if shift < 0 {
        mantissa >> shift.unsigned_abs()
    } else {
        mantissa << shift.unsigned_abs()
    };
    if x < 0.0 { -size } else { size }
}

/// π, by Machin's formula.
fn pi() -> BigInt {
    let arctangent_of_inverse = |n: i64| {
        let mut power = (BigInt::from(1) << (BITS + 32)) / n;
        let (mut sum, mut k) = (BigInt::from(0), 0);
        while power != BigInt::from(0) {
            let term = &power / (2 * k + 1);
            sum = if k % 2 == 0 { sum + term } else { sum - term };
            power /= n * n;
            k += 1;
        }
        sum
    };
    (16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239)) >> 32
}

/// (sin x, cos x) by Taylor's series of the argument modulo 2π, all times 2^BITS.
fn exact(x: f64, pi: &BigInt) -> (BigInt, BigInt) {
    let x = fixed(x) % (2 * pi);
    let (mut sums, mut term) = ([BigInt::from(0), BigInt::from(0)], BigInt::from(1) << BITS);
    for k in 0.. {
        if term == BigInt::from(0) {
            break;
        }
        // 1, x, −x²/2, −x³/6, …
        match k % 4 {
            0 | 1 => sums[1 - k % 2] += &term,
            _ => sums[1 - k % 2] -= &term,
        }
        term = ((term * &x) >> BITS) / (k + 1);
    }
    let [sin, cos] = sums;
    (sin, cos)
}

/// |value − exact| in units in the last place of `value`.
fn ulps(value: f64, exact: &BigInt) -> f64 {
    let unit = fixed(f64::from_bits(value.to_bits() & (0x7FF << 52)) * f64::EPSILON);
    let error: BigInt = (fixed(value) - exact) * 1000 / unit;
    let error: i64 = error.try_into().unwrap_or(i64::MAX);
    error.unsigned_abs() as f64 / 1000.0
}

/// Arguments of all magnitudes up to the last that is taken, and those next to multiples of π/2.
fn arguments() -> Vec<f64> {
    let mut arguments = Vec::new();
    // Weyl's sequence: deterministic, and nowhere near a pattern of binary digits.
    let fraction = |i: u32| (f64::from(i) * 0.618_033_988_749_894_9).fract();
    for exponent in -60..=20 {
        for i in 0..40 {
            arguments.push((1.0 + fraction(i + 1)) * f64::from(exponent).exp2());
        }
    }
    for i in 0..2000 {
        let turns = (fraction(i + 1) * 1_048_575.0).floor();
        let near = turns * core::f64::consts::FRAC_PI_2;
        arguments.extend([near, near.next_up(), near.next_down()]);
    }
    arguments.retain(|x| *x <= 1.64e6);
    let negative: Vec<f64> = arguments.iter().map(|x| -x).collect();
    arguments.extend(negative);
    arguments
}

#[test]
fn sine_and_cosine_are_right_to_the_last_place() {
    let pi = pi();
    let mut worst = (0.0, 0.0);
    for x in arguments() {
        let (sin, cos) = Lanes([x]).sin_cos();
        let (exact_sin, exact_cos) = exact(x, &pi);
        for (name, value, exact) in [("sin", sin.0[0], exact_sin), ("cos", cos.0[0], exact_cos)] {
            let error = ulps(value, &exact);
            // Written so that a NaN fails.
            assert!(
                value.is_finite() && error <= ULPS,
                "{name}({x:e}) = {value:e} is off by {error}"
            );
            if error > worst.0 {
                worst = (error, x);
            }
        }
    }
    // Rounding alone takes half a unit: a smaller one would say that nothing was measured.
    assert!(worst.0 > 0.5, "{worst:?}");
}

#[test]
fn small_angles_are_their_own_sines() {
    for x in [
        0.0,
        5e-324,
        1e-310,
        f64::MIN_POSITIVE,
        1e-300,
        1e-200,
        1e-30,
    ] {
        for x in [x, -x] {
            let (sin, cos) = Lanes([x]).sin_cos();
            assert_eq!((sin.0[0], cos.0[0]), (x, 1.0));
        }
    }
}

#[test]
fn what_is_not_computed_is_not_a_number() {
    let huge = [1.7e6, 1e9, 1e300, f64::MAX, f64::INFINITY, f64::NAN];
    for x in huge.into_iter().chain(huge.map(|x| -x)) {
        let (sin, cos) = Lanes([x]).sin_cos();
        assert!(sin.0[0].is_nan() && cos.0[0].is_nan(), "{x}");
    }
    for s in [4.1, -4.1, 1e300, f64::INFINITY, f64::NAN] {
        assert!(Lanes([s]).stumpff(1).0[0].is_nan());
    }
    assert!(Lanes([1.0]).stumpff(9).0[0].is_nan());
}

#[test]
fn stumpff_functions_are_those_of_a_number() {
    for n in 0..=8 {
        for i in -400..=400 {
            let s = f64::from(i) / 100.0;
            let (lanes, number) = (Lanes([s]).stumpff(n).0[0], Scalar::stumpff(s, n));
            let slope =
                s * (Scalar::stumpff(s, n + 1) - f64::from(n) * Scalar::stumpff(s, n + 2)) / 2.0;
            // What `Scalar::stumpff` claims for each of them.
            let bound = 4.0 * f64::EPSILON * (number.abs() + slope.abs());
            assert!(
                (lanes - number).abs() <= bound,
                "c{n}({s}): {lanes} {number}"
            );
        }
    }
}

#[test]
fn every_lane_is_computed_as_if_alone() {
    let x = Lanes([0.3, -1.7, 0.0, 2.5]);
    let y = Lanes([1.1, 0.4, -0.0, -3.0]);
    type Function = fn(f64, f64) -> f64;
    type OnLanes = fn(Lanes<4>, Lanes<4>) -> Lanes<4>;
    let functions: [(&str, Function, OnLanes); 15] = [
        ("+", |a, b| a + b, |a, b| a + b),
        ("-", |a, b| a - b, |a, b| a - b),
        ("*", |a, b| a * b, |a, b| a * b),
        ("/", |a, b| a / b, |a, b| a / b),
        ("neg", |a, _| -a, |a, _| -a),
        ("sqrt", |a, _| Scalar::sqrt(a), |a, _| a.sqrt()),
        ("abs", |a, _| Scalar::abs(a), |a, _| a.abs()),
        ("sign", |a, _| Scalar::sign(a), |a, _| a.sign()),
        ("positive", |a, _| Scalar::positive(a), |a, _| a.positive()),
        ("exp", |a, _| Scalar::exp(a), |a, _| a.exp()),
        ("ln", |a, _| Scalar::ln(a), |a, _| a.ln()),
        ("atan", |a, _| Scalar::atan(a), |a, _| a.atan()),
        ("tanh", |a, _| Scalar::tanh(a), |a, _| a.tanh()),
        ("atan2", Scalar::atan2, Scalar::atan2),
        ("powf", Scalar::powf, Scalar::powf),
    ];
    for (name, one, all) in functions {
        let expected: Vec<f64> = (0..4).map(|i| one(x.0[i], y.0[i])).collect();
        // NaN is not equal to itself, but prints the same.
        assert_eq!(
            format!("{:?}", all(x, y).0),
            format!("{expected:?}"),
            "{name}"
        );
    }
}
