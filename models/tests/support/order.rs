//! How the order of a scheme is measured, in double-double numbers: between errors that are not yet hᵖ and such that are
//! rounding lie twenty digits, enough for order 24.

use residua_models::exact::Double;

/// The largest difference.
pub fn distance(a: &[Double], b: &[Double]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| most.max((*a - *b).abs().to_f64()))
}

/// Errors from here on are proportional to hᵖ: rounding is 1e-31, a thousand steps add it up, and the motion stretches it by
/// ten.
const LEAST_ERROR: f64 = 1e-26;

/// The most steps of low orders: there, what is next in h is a thousandth.
const MOST_STEPS: u32 = 256;

/// The order of a scheme with that error in so many steps: its slope between the shortest step whose error is none of
/// rounding and twice that step.
pub fn order_of(error: impl Fn(u32) -> f64) -> f64 {
    let (mut steps, mut coarse, mut order) = (4, error(4), f64::NAN);
    while steps < MOST_STEPS {
        steps *= 2;
        let fine = error(steps);
        if fine < LEAST_ERROR {
            break;
        }
        order = (coarse / fine).log2();
        coarse = fine;
    }
    order
}
