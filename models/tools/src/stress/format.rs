//! The two formats that models are run in, and what is asked of results in them.

use residua::Real;

/// A floating-point format (IEEE 754).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// `f64`
    Double,
    /// `f32`
    Single,
}

impl Format {
    /// The distance from 1 to the next larger number.
    fn epsilon(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON,
            Self::Single => f64::from(f32::EPSILON),
        }
    }

    /// The least positive number that has all its digits.
    pub(super) fn least(self) -> f64 {
        match self {
            Self::Double => f64::LEAST,
            Self::Single => f64::from(f32::LEAST),
        }
    }

    /// Newton's method may stop at a correction of that size relative to a block, see `Settings::tolerance`.
    pub(super) fn tolerance(self) -> f64 {
        f64::max(1e-12, 64.0 * self.epsilon())
    }

    /// ε times the size of its terms is the rounding of a residual (Higham, section 4.2): 64 terms.
    pub(super) fn rounding(self) -> f64 {
        64.0 * self.epsilon()
    }

    /// What each eliminated unknown may add to an error: two roundings, each grown by 1e6, in single precision by 420, from
    /// where on the elimination is given up.
    pub(super) fn eliminated(self) -> f64 {
        match self {
            Self::Double => 2e6 * self.epsilon(),
            Self::Single => 2.0 * 420.0 * self.epsilon(),
        }
    }

    /// The number of the format that is nearest.
    pub(super) fn nearest(self, value: f64) -> f64 {
        match self {
            Self::Double => value,
            Self::Single => f64::from(value as f32),
        }
    }
}
