//! Sums that know what they have lost.

use crate::scalar::Scalar;

/// state + (change + lost) rounded, and what the rounding lost (Møller 1965; the error-free sum of Knuth,
/// *The Art of Computer Programming* 2, 4.2.2, theorem B): the error of many sums is that of one.
#[inline]
pub(crate) fn compensated_sums<T: Scalar, X: AsRef<[T]> + AsMut<[T]> + Copy>(
    state: &X,
    change: &X,
    lost: &X,
) -> (X, X) {
    let (mut sums, mut errors) = (*state, *lost);
    let results = sums.as_mut().iter_mut().zip(errors.as_mut());
    for ((sum, error), change) in results.zip(change.as_ref()) {
        (*sum, *error) = compensated_sum(*sum, *change + *error);
    }
    (sums, errors)
}

/// a + b and what is rounded off it.
#[inline(always)]
pub(crate) fn compensated_sum<T: Scalar>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}
