//! `residua simulate`, as users run it.

mod support;

use std::f64::consts::FRAC_PI_4;
use std::fs;
use support::{assert_refused, folder, residua, residua_in, succeed};

fn rows(csv: &str) -> Vec<Vec<f64>> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let numbers = |record: csv::StringRecord| record.iter().map(|x| x.parse().unwrap()).collect();
    let records = reader.records().map(Result::unwrap);
    records.map(numbers).collect()
}

#[test]
fn rows_are_time_states_observables_invariants() {
    let csv = succeed("simulate planar_reduced --step 0.1 --until 1").stdout;
    let header = csv.lines().next();
    assert_eq!(header, Some("t,ω,Γ.x,Γ.y,θ,energy,norm_squared"));
    let rows = rows(&csv);
    assert_eq!(rows.len(), 11);
    assert_eq!(rows[0][..4], [0.0, 1.0, 0.0, 1.0]);
    assert!((rows[10][0] - 1.0).abs() < 1e-12);
}

#[test]
fn every_nth_step_and_the_last_are_kept() {
    let csv = succeed("simulate planar_reduced --step 0.125 --until 1.25 --every 4").stdout;
    let times: Vec<f64> = rows(&csv).iter().map(|row| row[0]).collect();
    assert_eq!(times, [0.0, 0.5, 1.0, 1.25]);
}

#[test]
fn numbers_come_back_as_they_were() {
    let csv = succeed("simulate planar_reduced --until 0.5").stdout;
    for field in csv.lines().skip(1).flat_map(|line| line.split(',')) {
        let value: f64 = field.parse().unwrap();
        assert_eq!(format!("{value:?}"), field);
    }
}

#[test]
fn values_are_expressions_in_either_spelling() {
    for options in ["--set J=0.4+0.08 --start ω=2", "--start omega=sqrt(4)"] {
        let csv = succeed(&format!("simulate planar_reduced --until 0.1 {options}")).stdout;
        assert_eq!(rows(&csv)[0][1], 2.0);
    }
    let csv = succeed(
        "simulate spatial_group --until 0.1 --set J=diag(1,2.8,2) --set J(3,3)=2.5 \
         --start ω=[0.5,-0.5,0.4] --start omega.x=pi/4",
    )
    .stdout;
    assert_eq!(rows(&csv)[0][1..4], [FRAC_PI_4, -0.5, 0.4]);
}

#[test]
fn what_a_scene_cannot_start_from_is_bad_input() {
    let outcome = residua("simulate paper_spatial --start ω.z=1 --until 1");
    assert_refused(&outcome, 2, &["ω.z is 1, and the scene relies on 0"]);
    assert!(outcome.stdout.is_empty());
}

#[test]
fn all_unknowns_give_the_same_run_as_the_core() {
    let run = |options: &str| {
        let line = "simulate spatial_group --until 5 --every 500 --strategy";
        rows(&succeed(&format!("{line} {options}")).stdout)
    };
    let (core, full) = (run("core"), run("full"));
    for (a, b) in core[1].iter().zip(&full[1]) {
        // Rounding, grown over 5 s of a regular motion; the states are up to 7.
        assert!((a - b).abs() < 1e-11, "{a} {b}");
    }
}

#[test]
fn taylor_series_run_as_other_schemes_do() {
    let run = |options: &str| {
        let line = "simulate spatial_group --until 1 --every 100 --scheme";
        rows(&succeed(&format!("{line} {options}")).stdout)
    };
    let gauss = run("gauss8");
    for options in ["taylor20", "taylor --tolerance 1e-12"] {
        let taylor = run(options);
        assert_eq!(taylor.len(), gauss.len());
        for (a, b) in taylor[1].iter().zip(&gauss[1]) {
            // The tolerance of some twenty steps.
            assert!((a - b).abs() < 1e-10, "{options}: {a} {b}");
        }
    }
}

#[test]
fn taylor_series_that_are_none_say_why() {
    for (options, message) in [
        ("planar_reduced --scheme taylor25", "orders 1 to 24"),
        ("planar_reduced --scheme taylor0", "orders 1 to 24"),
        (
            "planar_reduced --scheme tailor",
            "there is no scheme `tailor`",
        ),
        (
            "planar_reduced --scheme taylor9 --tolerance 1e-9",
            "steps of one length",
        ),
        ("planar_reduced --scheme taylor --form next", "--form"),
    ] {
        let outcome = residua(&format!("simulate {options}"));
        assert_refused(&outcome, 2, &[message]);
    }
}

#[test]
fn rk4_has_no_strategy() {
    for option in ["--strategy full", "--uncompensated"] {
        let outcome = residua(&format!("simulate planar_reduced --scheme rk4 {option}"));
        assert_refused(&outcome, 2, &["of Newton's method"]);
    }
}

#[test]
fn uncompensated_sums_drift_further() {
    let line = "simulate planar_reduced --form increment --until 1000 --every 100000";
    let drift = |options: &str| {
        let rows = rows(&succeed(&format!("{line} {options}")).stdout);
        let energy = rows[0].len() - 2;
        (rows[1][energy] - rows[0][energy]).abs()
    };
    // Rounding of the energy, −11.5 J, and what a hundred thousand roundings of the state leave.
    let (kept, lost) = (drift(""), drift("--uncompensated"));
    assert!(kept <= 4e-15 && lost > 8e-15, "{kept:e} {lost:e}");
}

#[test]
fn start_expressions_know_the_parameters() {
    let csv = succeed("simulate planar_reduced --set l=2.4525 --start ω=sqrt(g/l)").stdout;
    assert_eq!(rows(&csv)[0][1], 2.0);
}

#[test]
fn bad_input_is_one_clear_message() {
    let cases: [(&str, &[&str]); 24] = [
        ("--set mm=3", &["no parameter `mm`", "did you mean `m`"]),
        ("--set zzz=3", &["no parameter `zzz`"]),
        ("--start Γ.z=3", &["no such component", "Γ(1) to Γ(2)"]),
        ("--start Γ(3)=3", &["no such component"]),
        ("--start ω.x=3", &["scalar"]),
        ("--set m=1/0", &["m = 1/0"]),
        ("--set m=NaN", &["m = NaN"]),
        ("--set m=sqrt(0-1)", &["the value is NaN"]),
        ("--set m", &["NAME=EXPR"]),
        ("--set m=[1,2]", &["m = [1,2]", "`m` is a scalar"]),
        ("--set m=l", &["m = l", "`m` has the unit kg, found m"]),
        ("--set l=0.5*l+g", &["adding m/s^2 to m"]),
        ("--start ω=l", &["`ω` has the unit 1/s, found m"]),
        (
            "--start Γ(1)=sqrt(m)",
            &["`Γ(1)` has the unit 1, found kg^(1/2)"],
        ),
        ("--set m=(1", &["never closed"]),
        ("--step 0", &["the step is 0"]),
        ("--step -0.1", &["the step is -0.1"]),
        ("--step NaN", &["the step is NaN"]),
        ("--until inf", &["the end time is inf"]),
        ("--step 0.1 --until 0.01", &["before its first step"]),
        ("--step 1e-9 --until 1e9", &["1.0e18 steps"]),
        ("--form nxt", &["no form `nxt`", "next and increment"]),
        ("--scheme rk4 --form next", &["--form"]),
        ("--tolerance -1", &["tolerance"]),
    ];
    for (options, parts) in cases {
        let outcome = residua(&format!("simulate planar_reduced {options}"));
        assert_refused(&outcome, 2, parts);
    }
    let outcome = residua("simulate models/dsl/planar_reduced.model");
    assert_refused(&outcome, 2, &["give its name alone"]);
    let parts = ["no model `planar_reducd`", "did you mean `planar_reduced`"];
    assert_refused(&residua("simulate planar_reducd"), 2, &parts);
}

#[test]
fn a_run_that_ends_early_says_so() {
    let outcome = succeed("simulate planar_reduced --step 0.3 --until 1");
    assert!(outcome.stderr.contains("the run ends at t = 0.9"));
    assert_eq!(rows(&outcome.stdout).len(), 4);
}

#[test]
fn decimal_steps_reach_the_end() {
    let outcome = succeed("simulate planar_reduced --step 0.1 --until 0.3");
    assert!(!outcome.stderr.contains("note:"), "{}", outcome.stderr);
    assert_eq!(rows(&outcome.stdout).len(), 4);
}

#[test]
fn a_failed_step_leaves_the_rows_before_it() {
    let folder = folder("failed_step");
    // Half a second is long for a spring that swings five times in it: sooner or later a step has no solution near.
    let line = "simulate elastic --step 0.5 --until 300 --out run.csv";
    let outcome = residua_in(&folder, line);
    assert_refused(&outcome, 1, &["error: step "]);
    let (_, message) = outcome.stderr.split_once("error: step ").unwrap();
    let step: usize = message.split(' ').next().unwrap().parse().unwrap();
    let rows = rows(&fs::read_to_string(folder.join("run.csv")).unwrap());
    assert!(step > 0);
    assert_eq!(rows.len(), step + 1);
    assert!(rows.iter().flatten().all(|value| value.is_finite()));
}

#[test]
fn files_are_named_and_hold_the_run() {
    let folder = folder("files");
    let line = "simulate spatial_group --until 2 --out run.csv --plot run.svg";
    let outcome = residua_in(&folder, line);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(outcome.stdout, "");
    for part in ["200 steps", "run.csv (201 rows)", "run.svg"] {
        assert!(outcome.stderr.contains(part), "{}", outcome.stderr);
    }
    let csv = fs::read_to_string(folder.join("run.csv")).unwrap();
    assert_eq!(csv.lines().count(), 202);
    let picture = fs::read_to_string(folder.join("run.svg")).unwrap();
    assert!(picture.starts_with("<svg width=\"960\"") && picture.contains("Γ3.z"));
}

#[test]
fn output_that_cannot_be_written_fails() {
    let folder = folder("unwritable");
    for option in ["--out", "--plot"] {
        let outcome = residua_in(&folder, &format!("simulate elastic {option} no/folder"));
        assert_refused(&outcome, 1, &["cannot write no/folder"]);
    }
}

#[test]
fn runge_kutta_runs_the_continuous_equations() {
    let run = |scheme| {
        succeed(&format!(
            "simulate planar_reduced --until 1 --scheme {scheme}"
        ))
    };
    let (newton, rk4) = (rows(&run("newton").stdout), rows(&run("rk4").stdout));
    let difference = (newton[100][4] - rk4[100][4]).abs();
    assert!(difference > 0.0 && difference < 1e-3, "{difference}");
}

#[test]
fn outputs_without_a_value_are_counted() {
    let outcome = succeed("simulate elastic --until 0.1 --set m=1e-300 --out -");
    let warning = "warning: speed is no finite number in 11 rows";
    assert!(outcome.stderr.contains(warning), "{}", outcome.stderr);
}

#[test]
fn data_that_no_body_has_are_warned_of() {
    let outcome = succeed("simulate planar_reduced --until 0.1 --out -");
    let expected = "warning: less inertia about the pivot than a point mass at the centre has: J >= m*l^2 (line 38 of \
                    planar_reduced.model)";
    assert!(outcome.stderr.contains(expected), "{}", outcome.stderr);
    let quiet = succeed("simulate planar_reduced --until 0.1 --out - --quiet");
    assert_eq!(quiet.stderr, "");
    // 0.72 = m l² is a point mass, and no less than it has.
    let outcome = succeed("simulate planar_reduced --until 0.1 --out - --set J=0.72");
    assert!(!outcome.stderr.contains("warning"), "{}", outcome.stderr);
    // A plate has J₁ + J₂ = J₃, and nothing has more.
    let run = |j: &str| {
        succeed(&format!(
            "simulate spatial_reduced --until 0.1 --out - --set m=0.1 --set J={j}"
        ))
    };
    assert_eq!(run("diag(1,2,3)").stderr.matches("warning").count(), 0);
    let warned = run("diag(1,2,3.1)").stderr;
    assert!(
        warned.contains("exceeds the sum of the other two: trace(J)/2*I >= J"),
        "{warned}"
    );
    let indefinite = run("[[1,2,0],[2,1,0],[0,0,1]]").stderr;
    assert!(
        indefinite.contains("not positive definite: J > 0"),
        "{indefinite}"
    );
    let long = succeed("simulate spatial_reduced --until 0.1 --out - --start Γ=[0,0,2]").stderr;
    assert!(
        long.contains("Γ is not a unit vector: abs(norm(Γ) - 1) < 1e-9"),
        "{long}"
    );
}

#[test]
fn a_scene_warns_in_the_words_of_its_model() {
    let outcome = succeed("simulate paper_spatial --until 0.1 --out -");
    let expected = "J >= m*S(ρ)*S(ρ).T (line 62 of spatial_group.model)";
    assert!(outcome.stderr.contains(expected), "{}", outcome.stderr);
}

#[test]
fn rows_and_picture_need_two_files() {
    let line = "simulate elastic --until 0.1 --out one --plot one";
    let folder = folder("one_file");
    let outcome = residua_in(&folder, line);
    assert_refused(&outcome, 2, &["--out and --plot name the same file"]);
    let outcome = residua_in(&folder, "simulate elastic --until 0.1 --plot one.png");
    let said = ["one.png would hold SVG, not png", "help: write to one.svg"];
    assert_refused(&outcome, 2, &said);
    assert!(!folder.join("one.png").exists());
}

#[test]
fn a_scene_has_its_own_step_end_and_columns() {
    let outcome = succeed("simulate paper_spatial");
    let header = outcome.stdout.lines().next();
    assert_eq!(header, Some("t,ω.x,ω.y,ω.z,Γ3.x,Γ3.y,Γ3.z,energy"));
    let found = rows(&outcome.stdout);
    assert_eq!(found.len(), 1001);
    assert!((found[1][0] - 0.1).abs() < 1e-15);
    let run = "simulate spatial_group --step 0.1 --until 1";
    let expected = rows(&succeed(run).stdout);
    for (found, expected) in found.iter().zip(&expected) {
        // t and ω come first, then Γ1 and Γ2, which the scene has not.
        for (a, b) in found[..4].iter().zip(&expected[..4]) {
            assert!((a - b).abs() < 1e-11, "{a} {b}");
        }
    }
    let csv = succeed("simulate paper_spatial --step 0.5 --until 1").stdout;
    assert_eq!(rows(&csv).len(), 3);
    // R(3,1) and its kin are in the state and nobody asked for them.
    let header = succeed("simulate paper_recursive --until 1").stdout;
    let header = header.lines().next();
    assert_eq!(
        header,
        Some("t,ω.x,ω.y,ω.z,vertical.x,vertical.y,vertical.z,energy")
    );
    let start = "simulate paper_recursive --until 1 --start R(3,1)=0.5";
    assert_eq!(rows(&succeed(start).stdout)[0][4], 0.5);
}

#[test]
fn a_scene_refuses_what_it_has_left_out() {
    let outcome = residua("simulate paper_spatial --set m=3");
    assert_refused(&outcome, 2, &["does without `m`", "fixed as `10`"]);
    let outcome = residua("simulate paper_spatial --start Γ1=[1,0,0]");
    assert_refused(&outcome, 2, &["does without `Γ1`", "no kept quantity"]);
}
