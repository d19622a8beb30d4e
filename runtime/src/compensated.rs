//! Sums of many increments with the rounding error of one.

use crate::scalar::Real;

/// state + (change + lost) rounded, and what the rounding lost (Møller 1965; the error-free sum of Knuth,
/// *The Art of Computer Programming* 2, 4.2.2, theorem B): the error of many sums is that of one.
#[inline]
pub(crate) fn compensated_sum<T: Real, X: AsRef<[T]> + AsMut<[T]> + Copy>(
    state: &X,
    change: &X,
    lost: &X,
) -> (X, X) {
    let (mut sums, mut errors) = (*state, *lost);
    let results = sums.as_mut().iter_mut().zip(errors.as_mut());
    for ((sum, error), change) in results.zip(change.as_ref()) {
        let (x, y) = (*sum, *change + *error);
        *sum = x + y;
        let part = *sum - x;
        *error = (x - (*sum - part)) + (y - part);
    }
    (sums, errors)
}
