//! The equations that the paper misprints, coded from the page by hand: each differs from what is right in just
//! the components that the generator names. And the right ones: with any slip they are wrong.

use nalgebra::{Matrix2, Matrix3, Vector3};
use residua_codegen::analyse;
use residua_codegen::source::read_source;
use residua_tests::printed::{ROUNDING, named, rows, unequal, verdict};
use residua_tests::reference::{axis, rotation, skew};

/// Components of a claim of equations by hand.
fn equations_differ(model: &str, kind: &str, label: &str, printed: &[f64], right: &[f64]) {
    named(&verdict(model, kind, label), 1, &unequal(printed, right));
}

const STATE: [f64; 3] = [0.7, -0.4, 1.1];

fn rx(a: f64) -> Matrix3<f64> {
    let (s, c) = a.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

fn ry(a: f64) -> Matrix3<f64> {
    let (s, c) = a.sin_cos();
    Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c)
}

fn rz(a: f64) -> Matrix3<f64> {
    let (s, c) = a.sin_cos();
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

/// exp S(v) by scaling and squaring its series.
fn exp(v: &Vector3<f64>) -> Matrix3<f64> {
    let a = skew(v) / 1024.0;
    let mut power = Matrix3::identity();
    let mut sum = power;
    for k in 1..12 {
        power = power * a / f64::from(k);
        sum += power;
    }
    (0..10).fold(sum, |m, _| m * m)
}

#[test]
fn eq_11_repeats_a_rate() {
    let [x, y, z] = STATE;
    let [p, q, r] = [0.3, -0.8, 0.5];
    let [e1, e2, e3] = [axis(0), axis(1), axis(2)];
    let terms = rx(x) * skew(&e1) * ry(y) * rz(z) * p + rx(x) * ry(y) * skew(&e2) * rz(z) * q;
    let last = rx(x) * ry(y) * rz(z) * skew(&e3);
    equations_differ(
        "spatial_cardan",
        "flow",
        "Eq. 11",
        &rows(&(terms + last * q)),
        &rows(&(terms + last * r)),
    );
}

#[test]
fn eq_16_holds_of_no_sum_of_squares() {
    let [x, y, z] = STATE;
    let norm = (rx(x) * ry(y) * rz(z)).norm();
    let label = "Eq. 16, ‖R‖ as the root of the sum of squares";
    equations_differ("spatial_cardan", "equation", label, &[1.0], &[norm]);
    assert!((norm - 3.0_f64.sqrt()).abs() < ROUNDING);
}

#[test]
fn eq_22_is_not_the_exponential() {
    let eta = Vector3::from(STATE);
    let square = eta.norm_squared();
    let cayley =
        (Matrix3::identity() * (1.0 - square) + skew(&eta) * 2.0 + eta * eta.transpose() * 2.0)
            / (1.0 + square);
    let label = "Eq. 22 with the η of Eq. 20";
    equations_differ(
        "spatial_cardan",
        "equation",
        label,
        &rows(&cayley),
        &rows(&exp(&eta)),
    );
}

#[test]
fn eqs_36_and_37_need_rotations_that_commute() {
    let (eta, change) = (Vector3::from(STATE), Vector3::new(0.2, 0.9, -0.3));
    let product = |part: f64| rows(&(exp(&eta) * exp(&(change * part))));
    let sum = |part: f64| rows(&exp(&(eta + change * part)));
    equations_differ(
        "spatial_cardan",
        "equation",
        "Eq. 36 in space",
        &sum(1.0),
        &product(1.0),
    );
    let label = "Eq. 37 in space, as R exp(S(dη/2))";
    equations_differ(
        "spatial_cardan",
        "equation",
        label,
        &sum(0.5),
        &product(0.5),
    );
}

#[test]
fn eq_37_is_not_the_mean_of_eq_31() {
    let (now, next) = (0.4, 1.3);
    let mean = (rotation(now) + rotation(next)) / 2.0;
    let label = "Eq. 37 in the plane, with the R[k+1/2] of Eq. 31";
    let half = rotation((now + next) / 2.0);
    equations_differ(
        "planar_algebra",
        "equation",
        label,
        &rows(&half),
        &rows(&mean),
    );
}

#[test]
fn eq_66_has_a_wrong_argument_and_a_term_too_many() {
    let theta = 0.8;
    let printed = |a: f64| {
        let s = Matrix2::new(0.0, -a, a, 0.0);
        let last = Matrix2::new(2.0 * a * a, 0.0, 0.0, 0.0);
        rows(&((Matrix2::identity() * (1.0 - a * a) + s * 2.0 + last) / (1.0 + a * a)))
    };
    let right = rows(&rotation(theta));
    equations_differ(
        "planar_algebra",
        "equation",
        "Eq. 66",
        &printed(theta),
        &right,
    );
    let tan_half = (theta / 2.0).tan();
    equations_differ(
        "planar_algebra",
        "equation",
        "Eq. 66, tan(θ/2) for θ",
        &printed(tan_half),
        &right,
    );
}

#[test]
fn eq_84_has_a_line_of_another_order() {
    let [x, y, z] = STATE;
    let [p, q, r] = [0.3, -0.8, 0.5];
    let [e1, e2, e3] = [axis(0), axis(1), axis(2)];
    let omega = (ry(y) * rz(z)).transpose() * e1 * p + rz(z).transpose() * e2 * q + e3 * r;
    let line_2 = omega - (ry(y) * rx(x)).transpose() * e3 * r - rx(x).transpose() * e2 * q - e1 * p;
    // The first line is the model's own and the third the definition of ω just used.
    let mut printed = [0.0; 9];
    printed[3..6].copy_from_slice(line_2.as_slice());
    equations_differ("spatial_cardan", "flow", "Eq. 84", &printed, &[0.0; 9]);
}

#[test]
fn eq_85_turns_about_the_wrong_axis() {
    let [x, y, z] = STATE;
    let right = [rz(z), rz(z), ry(y), ry(y), rx(x), rx(x)];
    let printed = [
        rz(z),
        rz(z),
        exp(&(axis::<f64>(2) * y)),
        ry(y),
        rx(x),
        rx(x),
    ];
    let flat = |list: &[Matrix3<f64>]| list.iter().flat_map(rows).collect::<Vec<_>>();
    equations_differ(
        "spatial_cardan",
        "equation",
        "Eq. 85",
        &flat(&printed),
        &flat(&right),
    );
}

#[test]
fn eq_71_keeps_a_constant() {
    // What is too much is K5 = 2h S(ω) K3 − 4 K3, in the second equation.
    let (h, omega, k3) = (0.1, Vector3::from(STATE), Vector3::new(0.2, -0.5, 0.9));
    let k5 = skew(&omega) * k3 * (2.0 * h) - k3 * 4.0;
    let mut printed = [0.0; 6];
    printed[3..].copy_from_slice(k5.as_slice());
    equations_differ(
        "spatial_recursive",
        "differential",
        "Eq. 71",
        &printed,
        &[0.0; 6],
    );
}

/// Slips of the pen, the first that fits; a claim with one is wrong.
const SLIPS: [(&str, &str); 6] = [
    (" - ", " + "),
    (" + ", " - "),
    ("-sin", "sin"),
    ("= 1", "= 2"),
    ("*e1)", "*e2)"),
    ("S(", "2*S("),
];

#[test]
fn a_slip_makes_every_right_claim_wrong() {
    let mut tried = 0;
    for entry in residua_models::CATALOGUE {
        let tokens = read_source(entry.source.as_bytes()).expect("compiled");
        let analysis = analyse(entry.name(), tokens).expect("compiled");
        for (i, finding) in analysis.findings.iter().enumerate() {
            if !finding.differences.is_empty() {
                continue;
            }
            let text = with_slip(entry.source, i);
            let tokens = read_source(text.as_bytes()).expect("no other tokens");
            let slipped = analyse(entry.name(), tokens).expect("still a model");
            let wrong = !slipped.findings[i].differences.is_empty();
            assert!(
                wrong,
                "{} {} of {}",
                finding.kind.keyword(),
                finding.label,
                entry.name()
            );
            tried += 1;
        }
    }
    assert!(tried > 40, "{tried}");
}

/// The model file with a slip in its claim number `claim`.
fn with_slip(source: &str, claim: usize) -> String {
    let (start, _) = source
        .match_indices("    claim ")
        .nth(claim)
        .expect("a claim");
    let body = start + source[start..].find('{').expect("a body");
    let mut depth = 0;
    let end = source[body..].find(|c| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        depth == 0
    });
    let end = body + end.expect("balanced braces");
    let printed = &source[body..end];
    let slip = SLIPS
        .iter()
        .find(|slip| printed.contains(slip.0))
        .expect("a slip that fits");
    let slipped = printed.replacen(slip.0, slip.1, 1);
    format!("{}{slipped}{}", &source[..body], &source[end..])
}
