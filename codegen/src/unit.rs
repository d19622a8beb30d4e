//! Physical units: rational powers of the seven SI base units.
//!
//! Angles are dimensionless, so `rad` is 1. Only coherent SI units are known; a factor such as that
//! of `deg` or `cm` has no place in a model.

use num_rational::Ratio;

/// Symbols of the base units, in the order of [`Unit::exponents`].
pub const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// A product of powers of base units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// Exponent of each of [`BASE`].
    pub exponents: [Ratio<i32>; 7],
}
