//! Verdicts on claims: what is wrong is found, whatever its size, and nothing else.

use proc_macro2::TokenStream;
use residua_codegen::Analysis;
use residua_codegen::analyse;
use residua_codegen::finding::Finding;
use residua_codegen::source::lex;
use residua_codegen::source::read_source;
use std::fs;
use std::path::Path;

fn analysis(name: &str, tokens: TokenStream) -> Analysis {
    match analyse(name, tokens) {
        Ok(analysis) => analysis,
        Err(errors) => panic!("{name}: {errors}"),
    }
}

/// The findings in an oscillator with a parameter φ < 0, a ψ > 0, and more statements.
fn findings(statements: &str) -> Vec<Finding> {
    let text = format!(
        "param φ = -0.3; param ψ = 0.3; param zero = 0; param c: 1/s^2 = 1;
         state x; state v: 1/s;
         {statements}
         start {{ x = 1; v = 0; }}"
    );
    analysis("oscillator", lex(&text).expect("lexes")).findings
}

/// The first residual below, times a factor.
fn residual(factor: &str) -> String {
    format!(
        "residual {{ {factor}*Δx = {factor}*h*v[k+1/2]; Δv = -h*c*abs(φ)*x[k+1/2]; }} solve for increment;"
    )
}

/// Whether `claim`, the only one, is right.
fn is_right(factor: &str, claim: &str) -> bool {
    let found = findings(&format!("{} {claim}", residual(factor)));
    assert_eq!(found.len(), 1);
    found[0].differences.is_empty()
}

/// Whether an equation is right.
fn holds(equation: &str) -> bool {
    is_right("1", &format!("claim equation \"E\" {{ {equation}; }}"))
}

#[test]
fn small_terms_are_compared_as_large_ones_are() {
    // The last is below all doubles.
    for small in ["1e-11", "1e-30", "1e-200", "1e-200*1e-110", "1e-200*1e-200"] {
        let wrong = format!("x*{small} = 2*x*{small}");
        assert!(!holds(&wrong), "{wrong}");
        let literal = format!("{small} = 2*{small}");
        assert!(!holds(&literal), "{literal}");
        let right = format!("x*{small} = (x + x)*{small}/2");
        assert!(holds(&right), "{right}");
    }
    assert!(holds("x*1e-200*(sin(x)^2 + cos(x)^2) = x*1e-200"));
    assert!(!holds("x*1e-200*(sin(x)^2 - cos(x)^2) = x*1e-200"));
}

#[test]
fn a_wrong_flow_of_small_rates_is_wrong() {
    let flow = "flow { der(x) = v; der(v) = -1e-11*c*x; } residual { Δx = h*v[k+1/2]; Δv = -1e-11*h*c*x[k+1/2]; }";
    let verdict = |claim: &str| {
        let found = findings(&format!("{flow} claim flow \"W\" {{ der(v) = {claim}; }}"));
        found[0].differences.is_empty()
    };
    assert!(!verdict("1e-11*c*x^2"));
    assert!(verdict("-1e-11*c*x"));
    // The same by another way, so that what is left is rounding and no 0.
    assert!(verdict("-1e-11*c*x*(cos(x)^2 + sin(x)^2)"));
    assert!(!verdict("-1e-11*c*x*(cos(x)^2 - sin(x)^2)"));
}

#[test]
fn parameters_have_the_signs_of_the_file() {
    for wrong in [
        "acos(cos(φ)) = φ",
        "sqrt(φ^2) = φ",
        "sign(φ) = 1",
        "sqrt(zero^2) = zero",
        "sqrt(zero^2) = -zero",
    ] {
        assert!(!holds(wrong), "{wrong}");
    }
    for right in [
        "acos(cos(φ)) = -φ",
        "sqrt(φ^2) = -φ",
        "sign(φ) = -1",
        "sqrt(ψ^2) = ψ",
        "exp(log(ψ)) = ψ",
        "sqrt(zero^2) = abs(zero)",
    ] {
        assert!(holds(right), "{right}");
    }
    let jacobian = |entry: &str| {
        let claim = format!("claim jacobian \"J\" {{ [[1, -h/2], [h*c*{entry}/2, 1]] }}");
        is_right("1", &claim)
    };
    assert!(jacobian("abs(φ)"));
    assert!(jacobian("(-φ)"));
    assert!(!jacobian("φ"));
    let line = |factor: &str| {
        let claim =
            format!("claim residual \"R\" {{ Δx = h*v[k+1/2]; Δv = -h*c*{factor}*x[k+1/2]; }}");
        is_right("1", &claim)
    };
    assert!(line("abs(φ)"));
    assert!(line("(-φ)"));
    assert!(!line("φ"));
}

#[test]
fn a_run_may_begin_before_time_0() {
    assert!(!holds("sqrt(t^2) = t"));
    assert!(!holds("sqrt(t^2) = -t"));
    assert!(holds("sqrt(h^2) = h"));
}

#[test]
fn a_side_without_a_value_differs_from_one_with_a_value() {
    assert!(!holds("(x^3)^(1/3) = x"));
    assert!(!holds("exp(log(x)) = x"));
    assert!(holds("log(x^2) = 2*log(abs(x))"));
    // Neither has one.
    assert!(!holds("log(-1 - x^2) = log(-2 - 2*x^2)"));
}

#[test]
fn a_side_may_lack_a_value_where_the_model_does() {
    let found = findings(
        "residual { Δx = h*v[k+1/2]; Δv = -h*c*log(x); } claim equation \"E\" { exp(log(x)) = x; }",
    );
    assert!(found[0].differences.is_empty());
}

#[test]
fn what_is_too_large_for_a_number_is_no_difference() {
    assert!(holds("exp(1000*x)*exp(-1000*x) = 1"));
    assert!(!holds("exp(1000*x)*exp(-1000*x) = 2"));
}

#[test]
fn factors_of_any_size_are_allowed() {
    for factor in ["1", "1e-6", "1e-11", "1e200", "1e-200"] {
        let verdict = |velocity: &str| {
            let claim =
                format!("claim residual \"R\" {{ Δx = h*{velocity}; Δv = -h*c*abs(φ)*x[k+1/2]; }}");
            is_right(factor, &claim)
        };
        assert!(verdict("v[k+1/2]"), "{factor}");
        assert!(!verdict("v"), "{factor}");
        assert!(!verdict("(v[k+1/2] + 1e-9*v)"), "{factor}");
    }
}

#[test]
fn a_factor_is_printed_with_its_digits() {
    let claim = "claim residual \"R\" { [Δx, h*Δv] = [h*v[k+1/2], -2*h^2*c*x]; }";
    let residual =
        "residual { 1e-11*[Δx, h*Δv] = 1e-11*[h*v[k+1/2], -h^2*c*x]; } solve for increment;";
    // The second component alone is wrong.
    let found = findings(&format!("{residual} {claim}"));
    let derived = &found[0].differences[0].derived;
    assert!(derived.starts_with("1e11*("), "{derived}");
}

#[test]
fn what_cancels_is_decided_where_it_does_not() {
    for right in [
        "cosh(20*x)^2 - sinh(20*x)^2 = 1",
        "cosh(20*x)^2 - sinh(20*x)^2 - 1 = 0",
        "cosh(1000*x)^2 - sinh(1000*x)^2 = 1",
        "(1 - cos(x/1000))/(x/1000)^2 = cosc(x/1000)",
        "(1 - cos(x/1000000))/(x/1000000)^2 = cosc(x/1000000)",
        "(x + 1e9)^3 = x^3 + 3e9*x^2 + 3e18*x + 1e27",
        "sin(x)^2 + cos(x)^2 - 1 = 0",
    ] {
        assert!(holds(right), "{right}");
    }
    for wrong in [
        "cosh(20*x)^2 - sinh(20*x)^2 = 2",
        "cosh(1000*x)^2 - sinh(1000*x)^2 - 2 = 0",
        "(1 - cos(x/1000))/(x/1000)^2 = cosc(x/999)",
        "sin(x)^2 + cos(x)^2 - 1 = 1e-9",
    ] {
        assert!(!holds(wrong), "{wrong}");
    }
}

/// The claims of the catalogue that are wrong, and the number of entries in which they are: misprints and what takes
/// their place. The reasons stand beside them in the files.
const WRONG: &[(&str, &str, usize)] = &[
    (
        "planar_algebra",
        "Eq. 37 in the plane, with the R[k+1/2] of Eq. 31",
        4,
    ),
    ("planar_algebra", "Eq. 66", 4),
    ("planar_algebra", "Eq. 66, tan(θ/2) for θ", 1),
    ("planar_algebra", "Eq. 64", 1),
    ("planar_algebra", "Eq. 65", 1),
    ("planar_recursive", "Eq. 56", 6),
    ("planar_recursive", "Eq. 56, e12ᵀ read as I", 2),
    ("spatial_cardan", "Eq. 11", 6),
    (
        "spatial_cardan",
        "Eq. 16, ‖R‖ as the root of the sum of squares",
        1,
    ),
    ("spatial_cardan", "Eq. 22 with the η of Eq. 20", 9),
    ("spatial_cardan", "Eq. 36 in space", 9),
    ("spatial_cardan", "Eq. 37 in space, as R exp(S(dη/2))", 9),
    ("spatial_cardan", "Eq. 84", 3),
    ("spatial_cardan", "Eq. 85", 6),
    ("spatial_cardan", "Eq. 86", 6),
    ("spatial_cardan", "Eq. 87", 18),
    ("spatial_group", "Eq. 82", 9),
    (
        "spatial_group",
        "Eq. 83, columns in the order of the text: ω, Γ3, Γ2, Γ1",
        48,
    ),
    ("spatial_recursive", "Eq. 71", 3),
];

/// Right claims of the catalogue.
const RIGHT: usize = 59;

#[test]
fn the_catalogue_has_its_misprints_and_no_other() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/dsl");
    let files = fs::read_dir(folder).expect("the catalogue");
    let mut files: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    files.retain(|file| file.extension().is_some_and(|e| e == "model"));
    files.sort();
    let (mut wrong, mut right) = (Vec::new(), 0);
    for file in files {
        let name = file.file_stem().expect("a stem").to_string_lossy();
        let tokens = read_source(&fs::read(&file).expect("readable")).expect("a model");
        for finding in analysis(&name, tokens).findings {
            match finding.differences.len() {
                0 => right += 1,
                n => wrong.push((name.to_string(), finding.label, n)),
            }
        }
    }
    let wrong: Vec<_> = wrong.iter().map(|(m, l, n)| (&m[..], &l[..], *n)).collect();
    assert_eq!(wrong, WRONG);
    assert_eq!(right, RIGHT);
}
