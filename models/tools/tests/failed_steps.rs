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
        "the state before it: r = 0.47357, θ = 1.977311, p = -1.45089, L = -3.197161",
        "correction  largest  condition  furthest from 0",
        "help: from this state, --step 0.25 works",
    ];
    assert_refused(&long, 1, &said);
    let from = "--start r=0.47357 --start θ=1.977311 --start p=-1.45089 --start L=-3.197161";
    succeed(&format!("simulate elastic {from} --step 0.25 --until 1 -q"));
    let half = residua(&format!("simulate elastic {from} --step 0.5 --until 1 -q"));
    assert_refused(&half, 1, &["step 0 at t = 0"]);
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
