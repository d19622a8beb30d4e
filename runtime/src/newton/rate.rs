//! What two corrections in a row tell of those to come.

use crate::scalar::Real;
use crate::settings::RATE_MARGIN;
use crate::settings::TELLING;

/// Whether corrections of that relative size are near enough to the solution to tell how fast they shrink.
#[inline]
pub(crate) fn is_telling<T: Real>(size: T) -> bool {
    size <= T::constant(TELLING)
}

/// Whether the error left after a correction of relative size `e` is within the tolerance even if convergence were
/// only linear, at the rate e/`before` of the last two corrections (Hairer and Wanner, *Solving ODEs II*, IV.8). An iterate that
/// comes back from far away has a small e/`before`, too, and is nowhere near a solution.
#[inline]
pub(crate) fn is_last<T: Real>(e: T, before: T, tolerance: T) -> bool {
    is_telling(before) && e * e <= T::constant(RATE_MARGIN) * tolerance * before
}
