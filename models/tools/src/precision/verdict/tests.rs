//! Who is the best, and who is not.

use super::LEVELS;
use super::verdicts;
use crate::precision::Kind;
use crate::precision::OURS;
use crate::precision::Row;
use crate::precision::read;
use crate::precision::write;

fn row(scheme: &str, by: &str, trajectory: f64, seconds: f64) -> Row {
    Row {
        scene: "any".to_owned(),
        model: "any".to_owned(),
        scheme: scheme.to_owned(),
        by: by.to_owned(),
        step: None,
        tolerance: Some(1e-3),
        seconds,
        runs: 1,
        steps: 1,
        evaluations: 1,
        trajectory,
        phase: f64::NAN,
        energy: f64::NAN,
        constraint: f64::NAN,
        momentum: f64::NAN,
        failure: String::new(),
    }
}

#[test]
fn what_fails_is_nan_and_never_the_best() {
    let nan = f64::NAN;
    let all = [
        row("failed", OURS, nan, nan),
        row("fast and wrong", OURS, nan, 1e-9),
        row("exact without a time", OURS, 1e-12, nan),
        row("good", OURS, 1e-10, 1e-3),
        row("rival", "other", 1e-10, 1e-2),
    ];
    for verdict in verdicts(&all, Kind::Trajectory, &[1e-9]) {
        assert_eq!(verdict.ours.unwrap().scheme, "good");
        assert_eq!(verdict.rivals[0].scheme, "rival");
    }
    let mut file = Vec::new();
    write(&all, &mut file).unwrap();
    let again = read(file.as_slice()).unwrap();
    assert_eq!(again.len(), all.len());
    assert!(again[0].trajectory.is_nan() && again[0].seconds.is_nan());
    assert_eq!((again[3].trajectory, again[3].seconds), (1e-10, 1e-3));
}

#[test]
fn a_lucky_run_does_not_count() {
    // The error of the coarse step passes zero.
    let all = [
        row("lucky", OURS, 1e-12, 1e-6),
        row("lucky", OURS, 1e-4, 2e-6),
        row("lucky", OURS, 1e-10, 4e-6),
    ];
    let verdict = &verdicts(&all, Kind::Trajectory, &[1e-9])[0];
    assert_eq!(verdict.ours.unwrap().seconds, 4e-6);
}

#[test]
fn steps_of_one_length_are_named_apart() {
    let chosen = row("chosen", OURS, 1e-10, 2e-3);
    let fixed = Row {
        step: Some(0.1),
        tolerance: None,
        ..row("fixed", OURS, 1e-10, 1e-3)
    };
    let rows = [chosen, fixed];
    let verdict = &verdicts(&rows, Kind::Trajectory, &[1e-9])[0];
    assert_eq!(verdict.ours.unwrap().scheme, "chosen");
    assert_eq!(verdict.fixed.unwrap().scheme, "fixed");
}

#[test]
fn levels_are_given_from_coarse_to_fine() {
    assert!(LEVELS.is_sorted_by(|a, b| a > b));
}
