//! `residua simulate`, as users run it.

mod support;

use std::fs;
use support::{assert_refused, folder, residua};

/// The number of columns of `planar_reduced`: t, ω, Γ.x, Γ.y, θ, energy, norm_squared.
const HEADER: &str = "t,ω,Γ.x,Γ.y,θ,energy,norm_squared";

fn rows(csv: &str) -> Vec<Vec<f64>> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let numbers = |record: csv::StringRecord| record.iter().map(|x| x.parse().unwrap()).collect();
    reader
        .records()
        .map(|record| numbers(record.unwrap()))
        .collect()
}

#[test]
fn rows_are_time_states_observables_invariants() {
    let outcome = residua(&[
        "simulate",
        "planar_reduced",
        "--step",
        "0.1",
        "--until",
        "1",
    ]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(outcome.stdout.lines().next(), Some(HEADER));
    let rows = rows(&outcome.stdout);
    assert_eq!(rows.len(), 11);
    assert_eq!(rows[0][..4], [0.0, 1.0, 0.0, 1.0]);
    assert!((rows[10][0] - 1.0).abs() < 1e-12);
}

#[test]
fn every_nth_step_and_the_last_are_kept() {
    let arguments = [
        "simulate",
        "planar_reduced",
        "--step",
        "0.1",
        "--until",
        "1",
        "--every",
        "4",
    ];
    let times: Vec<f64> = rows(&residua(&arguments).stdout)
        .iter()
        .map(|row| row[0])
        .collect();
    assert_eq!(times.len(), 4);
    assert!(
        times
            .iter()
            .zip([0.0, 0.4, 0.8, 1.0])
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
}

#[test]
fn numbers_come_back_as_they_were() {
    let csv = residua(&[
        "simulate",
        "planar_reduced",
        "--step",
        "0.01",
        "--until",
        "0.5",
    ])
    .stdout;
    let fields = csv.lines().skip(1).flat_map(|line| line.split(','));
    for field in fields {
        let value: f64 = field.parse().unwrap();
        assert_eq!(format!("{value:?}"), field);
    }
}

#[test]
fn values_are_expressions_in_either_spelling() {
    for (parameter, start) in [("J=0.4+0.08", "ω=2"), ("J=0.48", "omega=sqrt(4)")] {
        let arguments = [
            "simulate",
            "planar_reduced",
            "--set",
            parameter,
            "--start",
            start,
        ];
        let outcome = residua(&[&arguments[..], &["--until", "0.1"]].concat());
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert_eq!(rows(&outcome.stdout)[0][1], 2.0);
    }
    let arguments = [
        "simulate",
        "spatial_group",
        "--set",
        "J=diag(1,2.8,2)",
        "--set",
        "J(3,3)=2.5",
    ];
    let more = [
        "--start",
        "ω=[0.5,-0.5,0.4]",
        "--start",
        "omega.x=pi/3",
        "--until",
        "0.1",
    ];
    let outcome = residua(&[&arguments[..], &more].concat());
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(
        rows(&outcome.stdout)[0][1..4],
        [std::f64::consts::FRAC_PI_3, -0.5, 0.4]
    );
}

#[test]
fn start_expressions_know_the_parameters() {
    let arguments = [
        "simulate",
        "planar_reduced",
        "--set",
        "l=2.4525",
        "--start",
        "ω=sqrt(g/l)",
    ];
    assert_eq!(rows(&residua(&arguments).stdout)[0][1], 2.0);
}

#[test]
fn bad_input_is_one_clear_message() {
    let model = "planar_reduced";
    assert_refused(
        &["simulate", "planar_reducd"],
        2,
        &["planar_reducd", "did you mean `planar_reduced`"],
    );
    assert_refused(
        &["simulate", model, "--set", "mm=3"],
        2,
        &["no parameter `mm`", "did you mean `m`"],
    );
    assert_refused(
        &["simulate", model, "--start", "Γ.z=3"],
        2,
        &["no such component"],
    );
    assert_refused(&["simulate", model, "--set", "m=1/0"], 2, &["m"]);
    assert_refused(&["simulate", model, "--set", "m=NaN"], 2, &["NaN"]);
    assert_refused(&["simulate", model, "--set", "m"], 2, &["NAME=EXPR"]);
    assert_refused(&["simulate", model, "--set", "m=[1,2]"], 2, &["m"]);
    assert_refused(&["simulate", model, "--step", "0"], 2, &["the step is 0"]);
    assert_refused(
        &["simulate", model, "--step", "-0.1"],
        2,
        &["the step is -0.1"],
    );
    assert_refused(
        &["simulate", model, "--step", "NaN"],
        2,
        &["the step is NaN"],
    );
    assert_refused(
        &["simulate", model, "--until", "inf"],
        2,
        &["the end time is inf"],
    );
    assert_refused(
        &["simulate", model, "--until", "-1"],
        2,
        &["the end time is -1"],
    );
    assert_refused(
        &["simulate", model, "--step", "0.1", "--until", "0.01"],
        2,
        &["first step"],
    );
    assert_refused(
        &["simulate", model, "--step", "1e-9", "--until", "1e9"],
        2,
        &["1.0e18 steps"],
    );
    assert_refused(&["simulate", model, "--form", "nxt"], 2, &["no form `nxt`"]);
    assert_refused(
        &["simulate", model, "--scheme", "rk4", "--form", "next"],
        2,
        &["--form"],
    );
    assert_refused(&["simulate", model, "--every", "0"], 2, &["--every"]);
    assert_refused(&["simulate", model, "--tolerance", "-1"], 2, &["tolerance"]);
}

#[test]
fn a_run_that_ends_early_says_so() {
    let outcome = residua(&[
        "simulate",
        "planar_reduced",
        "--step",
        "0.3",
        "--until",
        "1",
    ]);
    assert_eq!(outcome.code, 0);
    assert!(
        outcome.stderr.contains("the run ends at t = 0.9"),
        "{}",
        outcome.stderr
    );
    assert_eq!(rows(&outcome.stdout).len(), 4);
}

#[test]
fn decimal_steps_reach_the_end() {
    let outcome = residua(&[
        "simulate",
        "planar_reduced",
        "--step",
        "0.1",
        "--until",
        "0.3",
    ]);
    assert!(!outcome.stderr.contains("note:"), "{}", outcome.stderr);
    assert_eq!(rows(&outcome.stdout).len(), 4);
}

#[test]
fn a_failed_step_leaves_the_rows_before_it() {
    let folder = folder("failed_step");
    let out = folder.join("run.csv");
    // A step far longer than the period, from rest near the top: Newton has no solution to find.
    let arguments = [
        "simulate",
        "planar_cayley",
        "--start",
        "ω=8",
        "--step",
        "0.2",
        "--until",
        "20",
    ];
    let path = out.to_str().unwrap();
    let outcome = residua(&[&arguments[..], &["--out", path]].concat());
    assert_eq!(outcome.code, 1, "{}", outcome.stderr);
    assert!(
        outcome.stderr.contains("error: step "),
        "{}",
        outcome.stderr
    );
    let rows = rows(&fs::read_to_string(out).unwrap());
    assert!(!rows.is_empty());
    let step: usize = outcome
        .stderr
        .split("error: step ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    assert_eq!(rows.len(), step + 1, "{}", outcome.stderr);
    assert!(rows.iter().flatten().all(|value| value.is_finite()));
}

#[test]
fn files_are_named_and_hold_the_run() {
    let folder = folder("files");
    let (csv, svg) = (folder.join("run.csv"), folder.join("run.svg"));
    let arguments = [
        "simulate",
        "spatial_group",
        "--until",
        "2",
        "--out",
        csv.to_str().unwrap(),
    ];
    let outcome = residua(&[&arguments[..], &["--plot", svg.to_str().unwrap()]].concat());
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(outcome.stdout, "");
    assert!(
        outcome.stderr.contains("200 steps") && outcome.stderr.contains("run.csv"),
        "{}",
        outcome.stderr
    );
    assert_eq!(fs::read_to_string(csv).unwrap().lines().count(), 202);
    let picture = fs::read_to_string(svg).unwrap();
    assert!(picture.starts_with("<svg width=\"960\"") && picture.contains("Γ3.z"));
}

#[test]
fn output_that_cannot_be_written_fails() {
    let path = folder("unwritable").join("missing").join("run.csv");
    let arguments = [
        "simulate",
        "planar_reduced",
        "--out",
        path.to_str().unwrap(),
    ];
    assert_refused(&arguments, 1, &["cannot write", "run.csv"]);
}

#[test]
fn runge_kutta_runs_the_continuous_equations() {
    let run = |scheme| {
        residua(&[
            "simulate",
            "planar_reduced",
            "--scheme",
            scheme,
            "--until",
            "1",
        ])
    };
    let (newton, rk4) = (rows(&run("newton").stdout), rows(&run("rk4").stdout));
    let difference = (newton[100][4] - rk4[100][4]).abs();
    assert!(difference > 0.0 && difference < 1e-3, "{difference}");
}
