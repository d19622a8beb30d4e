//! What `residua simulate` says of a step that fails.

mod support;

use support::{assert_refused, residua, succeed};

#[test]
fn the_expression_without_a_value_is_shown_in_the_file() {
    let outcome = residua("simulate elastic --start r=0 --until 1 -q");
    let said = [
        "step 0 at t = 0",
        "the state before it: r = 0, θ = 1.2, p = 0, L = 0",
        "not finite: NaN here",
        "elastic.model:36:17",
        "`L[k+1/2]^2` = 0, `(m*r[k+1/2]^3)` = 0",
    ];
    assert_refused(&outcome, 1, &said);
    // The start was written before the step failed.
    assert_eq!(outcome.stdout.lines().count(), 2);
}

#[test]
fn a_step_too_long_is_shown_with_one_that_works() {
    let long = residua("simulate elastic --step 1 --until 20 -q");
    let said = [
        "Newton diverged after",
        "the state before it: r = -2.312173, θ = -10.84166, p = -3.749112, L = -0.830396",
        "correction  largest  condition  furthest from 0",
        "help: from this state, --step 0.25 works; --halve 2 takes such steps where they are needed",
    ];
    assert_refused(&long, 1, &said);
    let from = "--start r=-2.312173 --start θ=-10.84166 --start p=-3.749112 --start L=-0.830396";
    succeed(&format!("simulate elastic {from} --step 0.25 --until 1 -q"));
    let half = residua(&format!("simulate elastic {from} --step 0.5 --until 1 -q"));
    assert_refused(&half, 1, &["step 0 at t = 0"]);
    let halved = succeed(&format!(
        "simulate elastic {from} --step 1 --until 1 --halve 2"
    ));
    assert!(
        halved.stderr.contains(", 1 step taken as shorter ones\n"),
        "{}",
        halved.stderr
    );
}

#[test]
fn a_tolerance_below_rounding_is_reported() {
    let outcome = succeed("simulate elastic --tolerance 1e-17 --until 1");
    let said = "steps ended at the rounding floor, above the tolerance";
    assert!(outcome.stderr.contains(said), "{}", outcome.stderr);
    assert!(
        !succeed("simulate elastic --until 1")
            .stderr
            .contains("floor")
    );
}

#[test]
fn a_state_that_cannot_be_known_is_refused() {
    // 1e7 radians in a step: the attitude after it has lost more than half of its digits.
    let outcome = residua("simulate spatial_exponential --start ω.z=1e9 --until 1 -q");
    let said = [
        "state R(1,1) at the end of the step is not known: on its way from the unknowns, rounding grows",
        "a shorter step may do",
        "help: from this state, --step 0.00125 works",
    ];
    assert_refused(&outcome, 1, &said);
}

#[test]
fn single_precision_is_what_it_says() {
    let run =
        |options: &str| succeed(&format!("simulate planar_reduced --until 1 {options}")).stdout;
    let [single, double] = [run("--single"), run("")];
    assert_ne!(single, double);
    let last = |rows: &str| -> Vec<f64> {
        let last = rows.lines().last().unwrap();
        last.split(',')
            .map(|value| value.parse().unwrap())
            .collect()
    };
    for (single, double) in last(&single).iter().zip(last(&double)) {
        assert!((single - double).abs() < 1e-4, "{single} {double}");
    }
    let other = residua("simulate planar_reduced --single --scheme rk4");
    assert_refused(&other, 2, &["--single are of Newton's method"]);
    let small = residua("simulate planar_reduced --single --set l=1e-46");
    assert_refused(
        &small,
        2,
        &["parameter l is 1e-46, expected 0 or at least 1.17"],
    );
}

#[test]
fn scenes_say_what_they_can() {
    let start = "--start ω=[1e170,1e170,1e170]";
    let outcome = residua(&format!("simulate spatial_free {start} --until 1 -q"));
    let said = [
        "is inf after 0 iterations",
        "the state before it: ω.x = 1.000e170",
        "no shorter step",
    ];
    assert_refused(&outcome, 1, &said);
}
