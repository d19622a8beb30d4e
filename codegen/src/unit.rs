//! Physical units: rational powers of the seven SI base units.
//!
//! Angles are dimensionless, so `rad` is 1. Only coherent SI units are known; a factor such as that
//! of `deg` or `cm` has no place in a model.

use num_rational::Ratio;
use std::fmt;

/// Symbols of the base units, in the order of [`Unit::exponents`].
pub const BASE: [&str; 7] = ["kg", "m", "s", "A", "K", "mol", "cd"];

/// Largest numerator and denominator of an exponent. No physical unit comes near it; the bound keeps
/// the arithmetic of exponents inside `i32`.
const LARGEST_EXPONENT: i32 = 1000;

/// The named units: symbol and exponents of [`BASE`].
const NAMED: &[(&str, [i32; 7])] = &[
    ("kg", [1, 0, 0, 0, 0, 0, 0]),
    ("m", [0, 1, 0, 0, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0, 0, 0]),
    ("A", [0, 0, 0, 1, 0, 0, 0]),
    ("K", [0, 0, 0, 0, 1, 0, 0]),
    ("mol", [0, 0, 0, 0, 0, 1, 0]),
    ("cd", [0, 0, 0, 0, 0, 0, 1]),
    ("rad", [0; 7]),
    ("sr", [0; 7]),
    ("Hz", [0, 0, -1, 0, 0, 0, 0]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("Pa", [1, -1, -2, 0, 0, 0, 0]),
    ("J", [1, 2, -2, 0, 0, 0, 0]),
    ("W", [1, 2, -3, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 1, 0, 0, 0]),
    ("V", [1, 2, -3, -1, 0, 0, 0]),
    ("F", [-1, -2, 4, 2, 0, 0, 0]),
    ("ohm", [1, 2, -3, -2, 0, 0, 0]),
    ("Omega", [1, 2, -3, -2, 0, 0, 0]),
    ("T", [1, 0, -2, -1, 0, 0, 0]),
    ("Wb", [1, 2, -2, -1, 0, 0, 0]),
    ("H", [1, 2, -2, -2, 0, 0, 0]),
];

/// Units with a factor: symbol, the coherent unit, the factor.
const SCALED: &[(&str, &str, &str)] = &[
    ("deg", "rad", "pi/180"),
    ("rpm", "rad/s", "pi/30"),
    ("min", "s", "60"),
    ("h", "s", "3600"),
    ("t", "kg", "1e3"),
    ("l", "m^3", "1e-3"),
    ("L", "m^3", "1e-3"),
    ("bar", "Pa", "1e5"),
    ("eV", "J", "1.602176634e-19"),
];

/// Prefixes and their powers of ten; `mu` is how the parser spells `µ`.
const PREFIXES: &[(&str, i32)] = &[
    ("mu", -6),
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("n", -9),
    ("p", -12),
];

/// A product of powers of base units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unit {
    /// Exponent of each of [`BASE`].
    pub exponents: [Ratio<i32>; 7],
}

impl Unit {
    /// Dimensionless.
    pub const ONE: Unit = Unit {
        exponents: [Ratio::new_raw(0, 1); 7],
    };

    /// The second.
    pub const SECOND: Unit = Unit {
        exponents: {
            let mut exponents = [Ratio::new_raw(0, 1); 7];
            exponents[2] = Ratio::new_raw(1, 1);
            exponents
        },
    };

    /// The unit with this symbol, in the ASCII spelling of names.
    pub fn named(symbol: &str) -> Option<Unit> {
        let (_, exponents) = NAMED.iter().find(|row| row.0 == symbol)?;
        Some(Unit {
            exponents: exponents.map(Ratio::from_integer),
        })
    }

    /// True for a dimensionless unit.
    pub fn is_one(self) -> bool {
        self == Self::ONE
    }

    /// `self·other`; absent if an exponent gets out of hand.
    pub fn times(self, other: Unit) -> Option<Unit> {
        self.combine(|i, e| e + other.exponents[i])
    }

    /// `self/other`; absent if an exponent gets out of hand.
    pub fn over(self, other: Unit) -> Option<Unit> {
        self.combine(|i, e| e - other.exponents[i])
    }

    /// `self^power`; absent if an exponent gets out of hand.
    pub fn power(self, power: Ratio<i32>) -> Option<Unit> {
        if !in_bounds(power) {
            return None;
        }
        self.combine(|_, e| e * power)
    }

    fn combine(self, f: impl Fn(usize, Ratio<i32>) -> Ratio<i32>) -> Option<Unit> {
        let mut exponents = self.exponents;
        for (i, exponent) in exponents.iter_mut().enumerate() {
            *exponent = f(i, *exponent);
            if !in_bounds(*exponent) {
                return None;
            }
        }
        Some(Unit { exponents })
    }
}

fn in_bounds(exponent: Ratio<i32>) -> bool {
    let largest = LARGEST_EXPONENT as u32;
    exponent.numer().unsigned_abs() <= largest && exponent.denom().unsigned_abs() <= largest
}

/// The symbols that [`Unit::named`] knows.
pub fn symbols() -> impl Iterator<Item = &'static str> {
    NAMED.iter().map(|row| row.0).filter(|&s| s != "Omega")
}

/// For a unit that is not coherent: what to write instead and the factor, `("m", "1e-2")` for `cm`.
pub fn coherent(symbol: &str) -> Option<(&'static str, String)> {
    if let Some(row) = SCALED.iter().find(|row| row.0 == symbol) {
        return Some((row.1, row.2.to_owned()));
    }
    if symbol == "g" {
        return Some(("kg", "1e-3".to_owned()));
    }
    PREFIXES.iter().find_map(|&(prefix, power)| {
        let base = symbol.strip_prefix(prefix)?;
        if base == "g" {
            return Some(("kg", format!("1e{}", power - 3)));
        }
        let (symbol, _) = NAMED.iter().find(|row| row.0 == base && base != "kg")?;
        Some((*symbol, format!("1e{power}")))
    })
}

/// `kg*m^2/s^2`, `1/s`, `m^(1/2)`; `1` if dimensionless. Reads back as the same unit.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let zero = Ratio::from_integer(0);
        let factors = || BASE.iter().zip(self.exponents);
        let mut empty = true;
        for (symbol, exponent) in factors().filter(|&(_, e)| e > zero) {
            if !empty {
                f.write_str("*")?;
            }
            write_power(f, symbol, exponent)?;
            empty = false;
        }
        if empty {
            f.write_str("1")?;
        }
        for (symbol, exponent) in factors().filter(|&(_, e)| e < zero) {
            f.write_str("/")?;
            write_power(f, symbol, -exponent)?;
        }
        Ok(())
    }
}

fn write_power(f: &mut fmt::Formatter<'_>, symbol: &str, exponent: Ratio<i32>) -> fmt::Result {
    if exponent == Ratio::from_integer(1) {
        f.write_str(symbol)
    } else if exponent.is_integer() {
        write!(f, "{symbol}^{}", exponent.numer())
    } else {
        write!(f, "{symbol}^({exponent})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derived_units_print_in_base_units() {
        let printed = |symbol| Unit::named(symbol).map(|u| u.to_string());
        assert_eq!(printed("J").as_deref(), Some("kg*m^2/s^2"));
        assert_eq!(printed("Hz").as_deref(), Some("1/s"));
        assert_eq!(printed("Pa").as_deref(), Some("kg/m/s^2"));
        assert_eq!(printed("rad").as_deref(), Some("1"));
        assert_eq!(printed("cm"), None);
    }

    #[test]
    fn halves_survive_and_runaway_exponents_do_not() {
        let metre = Unit::named("m").expect("a base unit");
        let root = metre.power(Ratio::new(1, 2)).expect("small exponent");
        assert_eq!(root.to_string(), "m^(1/2)");
        assert_eq!(root.times(root), Some(metre));
        assert_eq!(metre.over(metre), Some(Unit::ONE));
        let large = metre.power(Ratio::from_integer(600)).expect("in bounds");
        assert_eq!(large.times(large), None);
        assert_eq!(metre.power(Ratio::from_integer(i32::MIN)), None);
    }

    #[test]
    fn a_unit_with_a_factor_names_the_coherent_one() {
        let advice = |symbol| coherent(symbol).map(|(unit, factor)| format!("{factor} {unit}"));
        assert_eq!(advice("cm").as_deref(), Some("1e-2 m"));
        assert_eq!(advice("deg").as_deref(), Some("pi/180 rad"));
        assert_eq!(advice("mg").as_deref(), Some("1e-6 kg"));
        assert_eq!(advice("kN").as_deref(), Some("1e3 N"));
        assert_eq!(advice("furlong"), None);
    }
}
