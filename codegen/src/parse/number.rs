//! Literals: exact numbers from their text.

use crate::unit;
use crate::unit::Unit;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Num;

/// Largest power of ten, either sign: beyond it a value is no longer a normal `f64`, and a larger
/// one would cost memory in proportion.
const LARGEST_POWER: i64 = 300;

/// Longest literal, in characters. `f64` needs 17 digits; reading takes time with the square.
const LONGEST_LITERAL: usize = 1000;

/// The value of a literal, `9.81` as 981/100; otherwise what is wrong with it and what to do.
pub(super) fn read(text: &str) -> Result<BigRational, (String, Option<String>)> {
    let complain = |message: String, help: Option<&str>| Err((message, help.map(str::to_owned)));
    if text.len() > LONGEST_LITERAL {
        let message = format!("a number of {} characters is too long", text.len());
        return complain(message, None);
    }
    if !text.starts_with(|c: char| c.is_ascii_digit()) {
        return complain(format!("expected a number, found the literal {text}"), None);
    }
    if text.starts_with("0x") || text.starts_with("0b") || text.starts_with("0o") {
        return complain(format!("`{text}` is not a decimal number"), None);
    }
    let (number, suffix) = split_suffix(text);
    if matches!(suffix, "e" | "E") {
        return complain(format!("expected a power of ten behind `{text}`"), None);
    }
    if !suffix.is_empty() {
        let message = format!("`{text}` runs a number and the name `{suffix}` together");
        let rust = ["f32", "f64", "i32", "i64", "u32", "u64", "usize"];
        return Err(if rust.contains(&suffix) {
            (
                format!("`{text}` has the suffix `{suffix}`, expected a plain number"),
                Some(format!("write {number}")),
            )
        } else {
            let help = unit_help(number, suffix);
            let help = help.unwrap_or_else(|| format!("write {number}*{suffix}"));
            (message, Some(help))
        });
    }
    let digits = number.replace('_', "");
    let (mantissa, power) = match digits.split_once(['e', 'E']) {
        Some((mantissa, power)) => (mantissa, power.parse::<i64>().ok()),
        None => (digits.as_str(), Some(0)),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let Some(power) = power.filter(|p| p.abs() <= LARGEST_POWER) else {
        let message = format!("the power of ten in `{text}` is out of range");
        let help = format!("powers from -{LARGEST_POWER} to {LARGEST_POWER} are possible");
        return complain(message, Some(&help));
    };
    let Ok(value) = BigInt::from_str_radix(&format!("{whole}{fraction}"), 10) else {
        return complain(format!("`{text}` is not a decimal number"), None);
    };
    let power = power - fraction.len() as i64;
    let scale = BigInt::from(10).pow(power.unsigned_abs() as u32);
    Ok(if power < 0 {
        BigRational::new(value, scale)
    } else {
        BigRational::from_integer(value * scale)
    })
}

/// What to write for a number with a unit behind it. A single letter is more likely a name.
pub(super) fn unit_help(number: &str, symbol: &str) -> Option<String> {
    if symbol.chars().count() < 2 {
        return None;
    }
    let value = match Unit::named(symbol) {
        Some(_) => number.to_owned(),
        None => format!("{number}*{}", unit::coherent(symbol)?.1),
    };
    Some(format!(
        "numbers carry no units, declarations do; write {value}"
    ))
}

/// The number and what is glued to its end: `("2", "m")` for `2m`.
fn split_suffix(text: &str) -> (&str, &str) {
    let is_number = |c: char| c.is_ascii_digit() || c == '.' || c == '_';
    let mantissa = text.find(|c| !is_number(c)).unwrap_or(text.len());
    let Some(rest) = text[mantissa..].strip_prefix(['e', 'E']) else {
        return text.split_at(mantissa);
    };
    let digits = rest.strip_prefix(['+', '-']).unwrap_or(rest);
    if !digits.starts_with(|c: char| c.is_ascii_digit()) {
        return text.split_at(mantissa);
    }
    let is_power = |c: char| c.is_ascii_digit() || c == '_';
    let power = digits.find(|c| !is_power(c)).unwrap_or(digits.len());
    text.split_at(text.len() - digits.len() + power)
}
