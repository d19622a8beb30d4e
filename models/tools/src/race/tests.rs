//! What counts as the same end, and what is taken of the times.

use super::Lane;
use super::Unfair;
use super::agree;
use super::race;

fn lane(end: &'static [f64]) -> Lane<'static, String> {
    Lane::new("", 1.0, || Ok(end.to_vec()))
}

#[test]
fn ends_that_differ_are_no_race() {
    let mut lanes = [lane(&[1.0, 2.0]), lane(&[1.0, 2.0]), lane(&[1.0, 2.1])];
    assert_eq!(race(&mut lanes, 1e-3, 1), Err(Unfair::Differs(2)));
    assert!(race(&mut lanes, 1e-1, 1).is_ok());
}

#[test]
fn nan_agrees_with_nothing() {
    assert!(!agree(&[f64::NAN], &[f64::NAN], 1.0));
    assert!(!agree(&[1.0], &[f64::NAN], 1.0));
    assert!(!agree(&[1.0], &[], 1.0));
}

#[test]
fn failure_is_passed_on() {
    let failing = Lane::new("", 1.0, || Err("no convergence".to_owned()));
    let outcome = race(&mut [failing], 1.0, 1);
    assert_eq!(outcome, Err(Unfair::Failed("no convergence".to_owned())));
}

#[test]
fn quantiles_are_of_the_sorted_times_of_a_unit() {
    let mut lane = lane(&[]);
    assert!(lane.quantile(0.0).is_nan());
    lane.units = 2.0;
    lane.seconds = vec![6.0, 2.0, 4.0];
    assert_eq!([0.0, 0.5, 1.0].map(|q| lane.quantile(q)), [1.0, 2.0, 3.0]);
}
