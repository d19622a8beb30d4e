//! The Stumpff functions without branches, for small arguments.

use crate::stumpff::horner;

/// Largest |s| of the series, 4: an angle of 2 rad. In a step angles are small.
const LARGEST: f64 = 4.0;

/// Last term of the series. The first one left out is below 4¹³/27!, 10⁻²⁰ of the sum.
const LAST: u32 = 12;

/// Largest n.
const HIGHEST: u32 = 8;

/// cₙ(s) = Σ (−s)ʲ / (n + 2j)!; NaN for |s| > 4 and for n > 8.
#[inline(always)]
pub(super) fn stumpff(n: u32, s: f64) -> f64 {
    let is_known = n <= HIGHEST && s.abs() <= LARGEST;
    horner(n, if is_known { s } else { f64::NAN }, LAST)
}
