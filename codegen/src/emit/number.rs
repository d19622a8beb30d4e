//! Numbers in emitted code: exact ones become the nearest double, under a name.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use num_traits::ToPrimitive;
use proc_macro2::Literal;
use proc_macro2::TokenStream;
use quote::quote;

/// Longest decimal or quotient that makes a name.
const LONGEST: usize = 10;

/// Words for the numbers that formulas are full of.
const WORDS: &[(i64, i64, &str)] = &[
    (0, 1, "zero"),
    (1, 1, "one"),
    (2, 1, "two"),
    (3, 1, "three"),
    (4, 1, "four"),
    (5, 1, "five"),
    (6, 1, "six"),
    (7, 1, "seven"),
    (8, 1, "eight"),
    (9, 1, "nine"),
    (10, 1, "ten"),
    (12, 1, "twelve"),
    (16, 1, "sixteen"),
    (1, 2, "half"),
    (1, 3, "third"),
    (1, 4, "quarter"),
    (1, 6, "sixth"),
    (1, 8, "eighth"),
    (2, 3, "two_thirds"),
    (3, 2, "three_halves"),
    (3, 4, "three_quarters"),
    (4, 3, "four_thirds"),
];

/// A name for a number ≥ 0: `half`, `c9_81`, `c22_over_7`.
pub(super) fn name(value: &BigRational) -> Option<String> {
    let word = WORDS.iter().find(|(numerator, denominator, _)| {
        *value.numer() == (*numerator).into() && *value.denom() == (*denominator).into()
    });
    if let Some((_, _, word)) = word {
        return Some((*word).to_string());
    }
    let decimal = double(value).to_string();
    let quotient = format!("{}_over_{}", value.numer(), value.denom());
    let is_short = |text: &str| text.len() <= LONGEST;
    let digits = if is_short(&decimal) {
        decimal
    } else {
        quotient
    };
    (is_short(&digits) && !value.is_negative()).then(|| format!("c{}", digits.replace('.', "_")))
}

/// Multiplication by ±2ⁿ does not round.
pub(super) fn is_power_of_two(value: &BigRational) -> bool {
    let is_power = |n: &BigInt| n.magnitude().count_ones() == 1;
    is_power(value.numer()) && is_power(value.denom())
}

/// The nearest double.
fn double(value: &BigRational) -> f64 {
    if value.is_one() {
        return 1.0;
    }
    value.to_f64().unwrap_or(f64::NAN)
}

/// A count or an index without the suffix that quote would give it.
pub(super) fn whole(n: usize) -> Literal {
    Literal::usize_unsuffixed(n)
}

/// The nearest double as a literal.
pub(super) fn literal(value: &BigRational) -> TokenStream {
    float(double(value))
}

/// Numerator and denominator of what is no double, if they are: their quotient rounds to the nearest double, and to more
/// digits where `T` has them.
pub(super) fn quotient(value: &BigRational) -> Option<[TokenStream; 2]> {
    let is_double = |n: &BigInt| n.magnitude().bits() <= u64::from(f64::MANTISSA_DIGITS);
    let is_binary = value.denom().magnitude().count_ones() == 1;
    if is_binary || !is_double(value.numer()) || !is_double(value.denom()) {
        return None;
    }
    let whole = |n: &BigInt| literal(&BigRational::from_integer(n.clone()));
    Some([whole(value.numer()), whole(value.denom())])
}

/// Any double as an expression.
pub(super) fn float(value: f64) -> TokenStream {
    if value.is_nan() {
        quote!(::core::f64::NAN)
    } else if value.is_infinite() && value > 0.0 {
        quote!(::core::f64::INFINITY)
    } else if value.is_infinite() {
        quote!(::core::f64::NEG_INFINITY)
    } else {
        let magnitude = Literal::f64_unsuffixed(value.abs());
        if value.is_sign_negative() {
            quote!(-#magnitude)
        } else {
            quote!(#magnitude)
        }
    }
}
