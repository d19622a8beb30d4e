//! What two corrections in a row tell of those to come.

use crate::scalar::Real;
use crate::settings::HARMLESS;
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

/// Whether the error left after a correction of relative size `e` is within the tolerance, at the quadratic convergence that it
/// and the one `before` it tell: e³/before².
#[inline]
pub(crate) fn is_settled<T: Real>(e: T, before: T, tolerance: T) -> bool {
    is_telling(before) && e * e * e <= T::constant(RATE_MARGIN) * tolerance * before * before
}

/// The largest part of what it corrects that a correction may be without another to tell how fast they shrink. Equations that
/// were linear need not stay so: a curvature of 1, where convergence was measured with less, leaves a tenth of the tolerance.
/// A kink on the way to the solution would leave a share of the correction itself.
#[inline]
pub(crate) fn most_enough<T: Real>(tolerance: T, has_kinks: bool) -> T {
    match has_kinks {
        true => tolerance,
        false => (T::constant(RATE_MARGIN) * tolerance).sqrt(),
    }
}

/// The part of what it corrects up to which a first correction is usual, whatever the one of the step before.
#[inline]
pub(crate) fn most_harmless<T: Real>() -> T {
    T::constant(HARMLESS) * T::EPSILON.sqrt()
}
