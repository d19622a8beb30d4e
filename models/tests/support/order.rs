//! How the order of a scheme is measured, in double-double numbers: between errors that are not yet hᵖ and such that are
//! rounding lie twenty digits, enough for order 24.

use residua_models::exact::Double;

/// The largest difference.
pub fn distance(a: &[Double], b: &[Double]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| most.max((*a - *b).abs().to_f64()))
}

/// The order of a scheme with that error in so many steps: its slope between the shortest step whose error is at least
/// `least`, none of it rounding, and twice that step. There are `most` steps at most: for low orders what is next in h is
/// small by then.
pub fn order_of(most: u32, least: f64, error: impl Fn(u32) -> f64) -> f64 {
    let (mut steps, mut coarse, mut order) = (4, error(4), f64::NAN);
    while steps < most {
        steps *= 2;
        let fine = error(steps);
        if fine < least {
            break;
        }
        order = (coarse / fine).log2();
        coarse = fine;
    }
    order
}
