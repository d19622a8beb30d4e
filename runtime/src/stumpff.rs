//! Stumpff functions, the small-angle family: cₙ(s) = Σ (−s)^j / (n + 2j)!, closed under differentiation.
//!
//! c₀(x²) = cos x, c₁(x²) = sin x / x, c₂(x²) = (1 − cos x)/x², c₃(x²) = (x − sin x)/x³, and with cosh and
//! sinh for negative arguments. Source: Stumpff, *Himmelsmechanik* I (1959); Danby, *Fundamentals of
//! Celestial Mechanics* (1988), section 6.9.

use crate::scalar::Scalar;

/// cₙ(s) for any real s, near 0 as accurate as anywhere else.
///
/// Below |s| = (n + 1)(n + 2)/2 the series, whose terms at least halve there; above it the recurrence
/// c_{n+2} = (1/n! − cₙ)/s, which loses nothing there because cₙ has left 1/n! far enough.
/// NaN gives NaN, and so does an infinite s.
pub(crate) fn stumpff<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let limit = f64::from(n + 1) * f64::from(n + 2) / 2.0;
    if s.abs() <= T::constant(limit) {
        series(n, s, epsilon)
    } else {
        recurrence(n, s, epsilon)
    }
}

/// cₙ(s) = 1/n! (1 − s/((n+1)(n+2)) (1 − s/((n+3)(n+4)) (1 − …))) for |s| ≤ (n + 1)(n + 2)/2.
///
/// The sum ends one term after the first one below ε/4 of the leading term. The rest is smaller than that
/// term, and so is the rest of the derivative that a dual number carries.
fn series<T: Scalar + PartialOrd>(n: u32, s: T, epsilon: f64) -> T {
    let ratio = |j: u32| s / T::constant(f64::from(n + 2 * j + 1) * f64::from(n + 2 * j + 2));
    let negligible = T::constant(epsilon / 4.0);

    let mut terms = 0;
    let mut size = T::constant(1.0);
    while size > negligible {
        size = size * ratio(terms).abs();
        terms += 1;
    }

    let one = T::constant(1.0);
    let sum = (0..terms + 1)
        .rev()
        .fold(one, |sum, j| one - ratio(j) * sum);
    sum / T::constant(factorial(n))
}

/// cₙ(s) for |s| > (n + 1)(n + 2)/2, upwards from c₁ or c₂; c₀ is the cosine itself.
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
fn factorial(n: u32) -> f64 {
    (2..=n).map(f64::from).product()
}

#[cfg(test)]
mod tests;
