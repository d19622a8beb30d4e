//! Double-double numbers from decimals: 9.81 is 981/100.

use std::fmt;
use std::str::FromStr;

use super::Double;

/// Powers of ten up to 10⁴⁵ are exact, and more than these no number of a pendulum needs.
const LARGEST_EXPONENT: i32 = 300;

/// The text is not a decimal number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotDecimal;

impl fmt::Display for NotDecimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("not a decimal number")
    }
}

impl std::error::Error for NotDecimal {}

impl FromStr for Double {
    type Err = NotDecimal;

    /// Reads `-12.5e-3`: relative error below 2⁻¹⁰⁰ for any number of digits.
    fn from_str(text: &str) -> Result<Self, NotDecimal> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse().map_err(|_| NotDecimal)?),
            None => (text, 0),
        };
        let (negative, digits) = match mantissa.strip_prefix('-') {
            Some(digits) => (true, digits),
            None => (false, mantissa),
        };
        let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
        if whole.is_empty() && fraction.is_empty() {
            return Err(NotDecimal);
        }
        let mut value = Double::ZERO;
        for digit in whole.chars().chain(fraction.chars()) {
            let digit = digit.to_digit(10).ok_or(NotDecimal)?;
            value = value * 10.0 + f64::from(digit).into();
        }
        let places = i32::try_from(fraction.len()).map_err(|_| NotDecimal)?;
        let value = shifted(value, i32::saturating_sub(exponent, places))?;
        Ok(if negative { -value } else { value })
    }
}

/// value · 10^exponent
fn shifted(value: Double, exponent: i32) -> Result<Double, NotDecimal> {
    if exponent.abs() > LARGEST_EXPONENT {
        return Err(NotDecimal);
    }
    let mut power = Double::ONE;
    for _ in 0..exponent.abs() {
        power = power * 10.0;
    }
    let shifted = if exponent < 0 {
        value / power
    } else {
        value * power
    };
    if shifted.is_finite() {
        Ok(shifted)
    } else {
        Err(NotDecimal)
    }
}
