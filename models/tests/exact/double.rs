//! Double-double arithmetic to 2⁻¹⁰⁰.

use residua::Scalar;
use residua_models::exact::Double;
use residua_models::exact::NotDecimal;

/// Of sums, products, quotients, roots: 2⁻¹⁰⁰.
const ARITHMETIC: f64 = 8e-31;

/// Of functions, which sum some thirty terms: 2⁻⁹⁸.
const FUNCTIONS: f64 = 3e-30;

fn read(text: &str) -> Double {
    text.parse().unwrap()
}

fn assert_near(found: Double, expected: &str, tolerance: f64) {
    let expected = read(expected);
    let error = ((found - expected) / expected).to_f64().abs();
    assert!(error <= tolerance, "{found:?} for {expected:?}: {error:e}");
}

// Expected values: mpmath 1.3.0 with 50 digits.

#[test]
fn arithmetic_keeps_a_hundred_bits() {
    let (a, b) = (
        read("1234.567890123456789012345678901"),
        read("0.0123456789012345678901234567890"),
    );
    assert_near(a + b, "1234.580235802358023580235802357789", ARITHMETIC);
    assert_near(a - b, "1234.555544444555554444455555444211", ARITHMETIC);
    assert_near(a * b, "15.2415787532388367504953515625485445", ARITHMETIC);
    assert_near(
        a.squared(),
        "1524157.87532388367504953515625608901",
        ARITHMETIC,
    );
    assert_near(a / b, "100000.000000000000000000000000081", ARITHMETIC);
    assert_near(b / a, "0.0000099999999999999999999999999999919", ARITHMETIC);
    assert_near(
        a.sqrt(),
        "35.1364182882014425311122238169954914",
        ARITHMETIC,
    );
    assert_near(
        Double::ONE / 49.0,
        "0.02040816326530612244897959183673469",
        ARITHMETIC,
    );
}

#[test]
fn sums_that_cancel_keep_what_is_left() {
    let a = read("1.000000000000000000000000000001");
    let left = (a - Double::ONE).to_f64();
    // The last place of 1 is 2⁻¹⁰⁵.
    assert!((left - 1e-30).abs() <= 2.5e-32, "{left:e}");
}

#[test]
fn functions_keep_ninety_eight_bits() {
    let x = read("0.7");
    assert_near(x.sin(), "0.644217687237691053672614351398720183", FUNCTIONS);
    assert_near(x.cos(), "0.764842187284488426255859990191864909", FUNCTIONS);
    assert_near(x.tan(), "0.842288380463079448128135002212937717", FUNCTIONS);
    assert_near(
        x.asin(),
        "0.775397496610753063740353352714987114",
        FUNCTIONS,
    );
    assert_near(
        x.acos(),
        "0.795398830184143555490968338924764329",
        FUNCTIONS,
    );
    assert_near(
        x.atan(),
        "0.610725964389208616543758876490236094",
        FUNCTIONS,
    );
    assert_near(
        x.sinh(),
        "0.758583701839533503459874647592768154",
        FUNCTIONS,
    );
    assert_near(x.cosh(), "1.25516900563094301816467474099029712", FUNCTIONS);
    assert_near(
        x.tanh(),
        "0.604367777117163496308687183103826475",
        FUNCTIONS,
    );
    assert_near(x.exp(), "2.01375270747047652162454938858306527", FUNCTIONS);
    assert_near(x.ln(), "-0.356674943938732378912638711241184478", FUNCTIONS);
    assert_near(
        x.powf(read("2.3")),
        "0.440276486477413483173881040644970845",
        FUNCTIONS,
    );
    assert_near(
        read("0.2").sinh(),
        "0.201336002541093987625568243010317373",
        FUNCTIONS,
    );
    assert_near(
        read("-0.2").tanh(),
        "-0.197375320224904000738157318811015668",
        FUNCTIONS,
    );
    assert_near(
        (-x).atan2(-Double::ONE),
        "-2.53086668920058462191888450678926679",
        FUNCTIONS,
    );
    // The nearest f64 to π is short of it by this much.
    assert_near(
        Double::from(core::f64::consts::PI).sin(),
        "1.22464679914735317722606593227500106e-16",
        FUNCTIONS,
    );
    assert_near(
        read("100").sin(),
        "-0.506365641109758793656557610459785432",
        FUNCTIONS * 100.0,
    );
    for n in 0..6 {
        let (small, large) = (read("0.7").stumpff(n), read("-3.5").stumpff(n));
        assert_near(small, STUMPFF[n as usize][0], FUNCTIONS);
        // The recurrence divides differences: two steps lose a digit.
        assert_near(large, STUMPFF[n as usize][1], 10.0 * FUNCTIONS);
    }
}

/// c₀ to c₅ of 0.7 and of −3.5.
const STUMPFF: [[&str; 2]; 6] = [
    [
        "0.66994618656797351118044293990364004",
        "3.32383571477293118298203307239283521",
    ],
    [
        "0.887349268570668311216862077196548727",
        "1.69435060116174491300624425970021537",
    ],
    [
        "0.471505447760037841170795800137657085",
        "0.663953061363694623709152306397952918",
    ],
    [
        "0.160929616327616698261625604004930389",
        "0.19838588604621283228749835991434725",
    ],
    [
        "0.0407065031999459411845774283747755925",
        "0.0468437318181984639169006589708436908",
    ],
    [
        "0.0081957861986428120072015180881946817",
        "0.00906263410844176160595191235648016657",
    ],
];

#[test]
fn decimals_are_read_as_they_are() {
    assert_eq!(read("-2.5e-1"), Double::from(-0.25));
    assert_near(read("9.81") * 100.0, "981", ARITHMETIC);
    for wrong in ["", "-", ".", "1.2.3", "1e", "0x1", "1e999", "--1", "inf"] {
        assert_eq!(wrong.parse::<Double>(), Err(NotDecimal), "{wrong}");
    }
}
