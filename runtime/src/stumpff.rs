//! Stumpff functions, the small-angle family: cₙ(s) = Σ (−s)^j / (n + 2j)!, closed under differentiation.
//!
//! c₀(x²) = cos x, c₁(x²) = sin x / x, c₂(x²) = (1 − cos x)/x², c₃(x²) = (x − sin x)/x³, and with cosh and
//! sinh for negative arguments. Source: Stumpff, *Himmelsmechanik* I (1959); Danby, *Fundamentals of
//! Celestial Mechanics* (1988), section 6.9.

use crate::scalar::Scalar;

/// cₙ(s) for any finite s; NaN for NaN and ∞, and nothing finite for −∞.
///
/// |error| ≤ 2 ε (|cₙ| + |s cₙ'|) for n ≤ 8, twice what rounding s and the result may do; 8 ε for n ≤ 32.
/// That is two or three units in the last place, except near a zero of cₙ and for large |s|, where the
/// phase √s is what counts. Measured against exact arithmetic for −7000 ≤ s ≤ 10⁴, from the least denormal on.
///
/// Near 0 this is the series, beyond it the recurrence c_{n+2} = (1/n! − cₙ)/s, which cancels only as long
/// as cₙ is near 1/n!. They meet at s = (n + 1)(n + 2)/2, below which the alternating terms at least halve,
/// and at s = −2 (n + 1)(n + 2): there the terms are all positive, and the recurrence is slower to get away
/// from 1/n!.
pub(crate) fn stumpff<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let first = f64::from(n + 1) * f64::from(n + 2);
    if T::constant(-2.0 * first) <= s && s <= T::constant(0.5 * first) {
        series(n, s, epsilon)
    } else {
        recurrence(n, s, epsilon)
    }
}

/// Σ (−s)^j / (n + 2j)!, of as many terms as matter.
///
/// The terms fall off faster than the powers of q = |s|/((n+1)(n+2)): steps of an integrator, q ≤ 2⁻¹⁰, need six for n ≤ 8,
/// and twice as far nine. Otherwise the sum ends one term after the first one below ε/4 of the leading term, where terms
/// shrink so fast that the rest is smaller than that one, also in the derivative that a dual number carries: up to 17
/// terms for `f64` and n = 1, 27 for n = 8.
#[inline]
fn series<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let first = f64::from(n + 1) * f64::from(n + 2);
    let size = s.abs();
    if n <= 8 && size <= T::constant(first / 1024.0) {
        horner(n, s, 5)
    } else if n <= 8 && size <= T::constant(first / 64.0) {
        horner(n, s, 8)
    } else {
        long_series(n, s, epsilon)
    }
}

fn long_series<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let negligible = T::constant(epsilon / 4.0);
    let (mut last, mut size) = (0, T::constant(1.0));
    while size > negligible {
        let next = f64::from(n + 2 * last + 1) * f64::from(n + 2 * last + 2);
        size = size * s.abs() / T::constant(next);
        last += 1;
    }
    horner(n, s, last)
}

/// The terms up to j = `last`.
#[inline(always)]
pub(crate) fn horner<T: Scalar>(n: u32, s: T, last: u32) -> T {
    let coefficient = |j: u32| T::constant(inverse_factorial(n + 2 * j));
    (0..last)
        .rev()
        .fold(coefficient(last), |sum, j| coefficient(j) - s * sum)
}

/// cₙ(s) away from 0, upwards from c₁ or c₂; c₀ is the cosine itself.
fn recurrence<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let first = if n == 0 { 0 } else { 2 - n % 2 };
    let mut c = match first {
        0 => cosine(s),
        1 => sinc(s),
        _ => {
            // c₂(s) = c₁(s/4)²/2, the half-angle form, keeps its digits where 1 − cos x cancels.
            let half = stumpff(1, s / T::constant(4.0), epsilon);
            half * half / T::constant(2.0)
        }
    };
    for k in (first..n).step_by(2) {
        c = (T::constant(1.0) / T::constant(factorial(k)) - c) / s;
    }
    c
}

/// c₀(s)
fn cosine<T: Scalar + PartialOrd>(s: T) -> T {
    if s < T::constant(0.0) {
        (-s).sqrt().cosh()
    } else {
        s.sqrt().cos()
    }
}

/// c₁(s), s ≠ 0
fn sinc<T: Scalar + PartialOrd>(s: T) -> T {
    let root = s.abs().sqrt();
    if s < T::constant(0.0) {
        root.sinh() / root
    } else {
        root.sin() / root
    }
}

/// n! in `f64`: exact up to n = 22.
const fn factorial(n: u32) -> f64 {
    let (mut product, mut k) = (1.0, 2);
    while k <= n {
        product *= k as f64;
        k += 1;
    }
    product
}

/// 1/n!
#[inline(always)]
fn inverse_factorial(n: u32) -> f64 {
    let known = INVERSE_FACTORIALS.get(n as usize);
    known.copied().unwrap_or_else(|| 1.0 / factorial(n))
}

/// 1/n!, for the orders up to 32 with all their terms.
const INVERSE_FACTORIALS: [f64; 128] = {
    let mut table = [0.0; 128];
    let mut n = 0;
    while n < table.len() {
        table[n] = 1.0 / factorial(n as u32);
        n += 1;
    }
    table
};

#[cfg(test)]
mod tests;
