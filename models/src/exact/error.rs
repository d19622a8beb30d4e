//! Data that describe no pendulum.

use std::fmt;

/// Why there is no exact motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Invalid {
    /// Infinite or not a number.
    NotFinite {
        /// Which one.
        name: &'static str,
        /// What it was.
        value: f64,
    },
    /// Zero or negative where the motion needs a positive number.
    NotPositive {
        /// Which one.
        name: &'static str,
        /// What it was.
        value: f64,
    },
    /// The inertia is not symmetric.
    NotSymmetric,
    /// The text of a number is not a decimal.
    NotDecimal {
        /// Which one.
        name: &'static str,
    },
    /// Times must not decrease, and start at 0 or later.
    TimesNotAscending {
        /// The first that comes too early, s.
        value: f64,
    },
    /// Smaller steps do not bring two resolutions together.
    NotConverged {
        /// By how much they differ.
        error: f64,
    },
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { name, value } => {
                write!(f, "{name} is {value}, expected a finite number")
            }
            Self::NotPositive { name, value } => {
                write!(f, "{name} is {value}, expected a positive number")
            }
            Self::NotSymmetric => f.write_str("the inertia is not symmetric"),
            Self::NotDecimal { name } => write!(f, "{name} is not a decimal number"),
            Self::TimesNotAscending { value } => {
                write!(f, "the time {value} s comes before the one it follows")
            }
            Self::NotConverged { error } => write!(
                f,
                "two resolutions of the motion still differ by {error:.1e}"
            ),
        }
    }
}

impl std::error::Error for Invalid {}

/// The number itself, if it is finite.
pub(crate) fn finite(name: &'static str, value: f64) -> Result<(), Invalid> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(Invalid::NotFinite { name, value })
    }
}

/// The number itself, if it is finite and positive.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<(), Invalid> {
    finite(name, value)?;
    if value > 0.0 {
        Ok(())
    } else {
        Err(Invalid::NotPositive { name, value })
    }
}
