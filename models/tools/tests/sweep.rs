//! `residua sweep`, as users run it.

mod support;

use std::fs;
use support::{assert_refused, folder, residua, residua_in, succeed};

fn table(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let header = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    let fields = |record: csv::StringRecord| record.iter().map(str::to_owned).collect();
    let rows = reader.records().map(Result::unwrap).map(fields).collect();
    (header, rows)
}

/// Columns `from` to the one before `to`, as numbers.
fn numbers(row: &[String], from: usize, to: usize) -> Vec<f64> {
    row[from..to]
        .iter()
        .map(|field| field.parse().unwrap())
        .collect()
}

#[test]
fn a_row_is_a_combination_and_its_end() {
    let line = "sweep planar_reduced --over m=1..3:3 --over start.ω=-1..1:2 --step 0.1 --until 1";
    let (header, rows) = table(&succeed(line).stdout);
    let expected = "m,start.ω,t,ω,Γ.x,Γ.y,θ,energy,norm_squared,iterations,status";
    assert_eq!(header.join(","), expected);
    let points: Vec<_> = rows.iter().map(|row| numbers(row, 0, 3)).collect();
    let expected = [
        [1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0],
        [2.0, -1.0, 1.0],
        [2.0, 1.0, 1.0],
        [3.0, -1.0, 1.0],
        [3.0, 1.0, 1.0],
    ];
    assert_eq!(points, expected);
    assert!(rows.iter().all(|row| row[10] == "ok"));
}

/// In the lanes of a sweep and alone in `simulate`: rounding, grown over ten seconds.
#[test]
fn trajectories_are_those_of_simulate() {
    let line = "sweep spatial_group --over g=9..10:5 --over start.omega.x=0..0.4:9 --every 250";
    let (header, rows) = table(&succeed(line).stdout);
    assert_eq!(header[..3], ["g", "start.omega.x", "t"]);
    assert_eq!(rows.len(), 5 * 9 * 5);
    for (point, rows) in rows
        .chunks(5)
        .enumerate()
        .filter(|(point, _)| point % 11 == 4)
    {
        let (g, omega) = (&rows[0][0], &rows[0][1]);
        let line = format!("simulate spatial_group --set g={g} --start ω.x={omega} --every 250");
        let (_, alone) = table(&succeed(&line).stdout);
        for (row, alone) in rows.iter().zip(&alone) {
            let (a, b) = (numbers(row, 2, 15), numbers(alone, 0, 13));
            for (a, b) in a.iter().zip(&b) {
                assert!((a - b).abs() <= 1e-10, "{point}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_table_does_not_depend_on_the_threads() {
    let line = "sweep elastic --over start.r=0.9..1.1:70 --until 2 --every 50 --threads";
    let one = succeed(&format!("{line} 1")).stdout;
    assert_eq!(one, succeed(&format!("{line} 2")).stdout);
    assert_eq!(one, succeed(&format!("{line} 4")).stdout);
}

#[test]
fn every_model_and_form_can_be_swept() {
    for entry in residua_models::CATALOGUE {
        for solver in entry.catalogued.solvers {
            let state = &entry.catalogued.description.states[0];
            let pick = match (state.rows, state.cols) {
                (1, 1) => "",
                (_, 1) => "(1)",
                _ => "(1,1)",
            };
            let line = format!(
                "sweep {} --form {} --over start.{}{pick}=1..1.1:3 --until 0.5",
                entry.name(),
                solver.solver().form,
                state.ascii,
            );
            let (_, rows) = table(&succeed(&line).stdout);
            assert_eq!(rows.len(), 3, "{line}");
        }
    }
}

#[test]
fn who_fails_has_a_row_that_says_so() {
    let folder = folder("sweep_failures");
    let line = "sweep elastic --over c=30..50:41 --step 0.5 --until 300 --out sweep.csv";
    let outcome = residua_in(&folder, line);
    assert_eq!(outcome.code, 1, "{}", outcome.stderr);
    let (header, rows) = table(&fs::read_to_string(folder.join("sweep.csv")).unwrap());
    assert_eq!(rows.len(), 41);
    let status = header.len() - 1;
    let failed: Vec<_> = rows.iter().filter(|row| row[status] != "ok").collect();
    // Half a second is long for springs that swing five times in it, and not for all of them.
    assert!(!failed.is_empty() && failed.len() < 41);
    assert!(failed.iter().all(|row| row[status].starts_with("step ")));
    let count = format!("{} of 41 trajectories failed", failed.len());
    assert!(outcome.stderr.contains(&count), "{}", outcome.stderr);
    // The last state that was reached, and it is one.
    for row in failed {
        assert!(numbers(row, 1, status).iter().all(|x| x.is_finite()));
    }
}

#[test]
fn data_that_no_body_has_are_counted() {
    let outcome = succeed("sweep planar_reduced --over J=0.1..1:10 --until 0.1 --out -");
    let expected = "warning: in 7 of 10 trajectories less inertia about the pivot";
    assert!(outcome.stderr.contains(expected), "{}", outcome.stderr);
}

#[test]
fn a_scene_is_swept_as_it_is_simulated() {
    let row = |line: &str| table(&succeed(line).stdout).1.pop().expect("a row");
    // Its own step and end, and the columns that it keeps.
    let swept = row("sweep paper_recursive --over start.ω.x=0..0.5:2");
    let simulated = row("simulate paper_recursive --start ω.x=0.5 --every 100000");
    let n = simulated.len();
    for (a, b) in numbers(&swept, 1, n + 1)
        .iter()
        .zip(numbers(&simulated, 0, n))
    {
        // Rounding, grown over the 100 s of a motion that magnifies it some ten thousand times.
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
}

#[test]
fn a_scene_refuses_starts_that_it_relies_on_not_to_be() {
    let outcome = residua("sweep paper_spatial --over start.ω.z=0..1:2 --until 1");
    assert_eq!(outcome.code, 1, "{}", outcome.stderr);
    let (_, rows) = table(&outcome.stdout);
    assert!(rows[0].iter().all(|cell| !cell.is_empty()));
    let status = rows[1].last().expect("a status");
    assert!(status.contains("ω.z is 1, and the scene relies on 0"));
    for (over, part) in [
        ("m=1..2:2", "fixed as `10`"),
        ("start.Γ1.x=0..1:2", "no kept quantity"),
    ] {
        let outcome = residua(&format!("sweep paper_spatial --over {over}"));
        assert_refused(&outcome, 2, &["does without", part]);
    }
}

#[test]
fn start_values_follow_swept_parameters() {
    let line = "sweep planar_reduced --over l=1..4:2 --start ω=sqrt(g/l) --every 1 --until 0.01";
    let (_, rows) = table(&succeed(line).stdout);
    let starts: Vec<_> = rows
        .iter()
        .step_by(2)
        .map(|row| numbers(row, 0, 3))
        .collect();
    assert_eq!(starts[0], [1.0, 0.0, 9.81_f64.sqrt()]);
    assert_eq!(starts[1], [4.0, 0.0, (9.81_f64 / 4.0).sqrt()]);
}

#[test]
fn a_bad_axis_is_one_clear_message() {
    let cases: [(&str, &[&str]); 16] = [
        (
            "mm=1..3:5",
            &["--over mm=1..3:5", "no parameter `mm`", "did you mean `m`"],
        ),
        ("start.m=1..3:5", &["--over start.m=1..3:5", "no state `m`"]),
        ("ω=1..3:5", &["no parameter `ω`"]),
        ("m=1..3:0", &["the number of values is 0"]),
        ("m=1..3:-1", &["`-1` is not a number of values"]),
        ("m=1..3", &["NAME=FROM..TO:COUNT"]),
        ("m=1:5", &["NAME=FROM..TO:COUNT"]),
        ("m", &["NAME=FROM..TO:COUNT"]),
        ("m=..3:5", &["NAME=FROM..TO:COUNT"]),
        ("m=1..1/0:5", &["--over m=1..1/0:5"]),
        ("m=0..NaN:5", &["--over m=0..NaN:5", "NaN"]),
        ("m=1..l:5", &["m=1..l:5", "`m` has the unit kg, found m"]),
        (
            "start.Γ=0..1:5",
            &["start.Γ=0..1:5", "`Γ` has 2 components", "Γ(2)"],
        ),
        ("start.Γ.z=0..1:5", &["no such component"]),
        (
            "m=1..2:5 --over m=2..3:5",
            &["m=2..3:5", "`m` is swept twice"],
        ),
        (
            "start.ω=1..2:5 --over start.omega=2..3:5",
            &["`start.ω` and `start.omega` are the same"],
        ),
    ];
    for (options, parts) in cases {
        let outcome = residua(&format!("sweep planar_reduced --over {options}"));
        assert_refused(&outcome, 2, parts);
    }
    let many = "m=1..2:100000 --over l=1..2:100000";
    let outcome = residua(&format!("sweep planar_reduced --over {many}"));
    assert_refused(&outcome, 2, &["1.0e10 rows", "--over l=1..2:100000"]);
    let endless = "m=1..2:18446744073709551615 --over l=1..2:18446744073709551615";
    let outcome = residua(&format!("sweep planar_reduced --over {endless}"));
    assert_refused(&outcome, 2, &["rows"]);
    assert_refused(&residua("sweep planar_reduced"), 2, &["--over"]);
    let outcome = residua("sweep planar_reduced --over m=1..2:2 --out no/folder");
    assert_refused(&outcome, 1, &["cannot write no/folder"]);
}
