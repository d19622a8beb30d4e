//! `residua list`, `check`, `explain`, `expand` and `new`, as users run them.

mod support;

use residua_models::{CATALOGUE, SCENES};
use serde_json::{Value, json};
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};
use support::{assert_refused, folder, residua, residua_in, succeed};

fn parsed(line: &str) -> Value {
    serde_json::from_str(&succeed(line).stdout).unwrap()
}

fn assert_shown(line: &str, parts: &[&str]) {
    let text = succeed(line).stdout;
    for part in parts {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn list_names_every_model_and_scene() {
    let all = CATALOGUE.iter().chain(SCENES);
    let names: Vec<&str> = all.map(|entry| entry.name()).collect();
    assert_shown("list", &names);
    // Two headings and a line between.
    assert_eq!(succeed("list").stdout.lines().count(), names.len() + 3);
}

#[test]
fn list_prints_json() {
    let models = parsed("list --json");
    let n = CATALOGUE.len() + SCENES.len();
    assert_eq!(models.as_array().unwrap().len(), n);
    let one = parsed("list planar_reduced --json");
    assert_eq!(one["states"][1]["name"], "Γ");
    assert_eq!(one["states"][1]["value"], json!([0.0, 1.0]));
}

#[test]
fn show_says_everything_about_a_model() {
    let parts = [
        "parameters",
        "kg·m²",
        "Γ[2]",
        "form next",
        "form increment",
        " rad/s ",
        "energy        J",
    ];
    assert_shown("show planar_reduced", &parts);
    assert_shown("show planar_reduced", &["energy", "Eq. 50", "operations"]);
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    for line in ["simulate spherical --until 1000", "list --json"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_residua"))
            .args(line.split(' '))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut stderr = String::new();
        let mut pipe = child.stderr.take().unwrap();
        pipe.read_to_string(&mut stderr).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0), "{stderr}");
        assert_eq!(stderr, "");
    }
}

#[test]
fn explain_says_what_a_scene_leaves_out() {
    let parts = [
        "a scene of spatial_group, step 0.1, until 100",
        "keeps ω, Γ3, energy",
        "states                     12",
        "equations and unknowns     12",
        "Γ1                                               line 18  no kept quantity depends on it",
        "stays 0",
        "folded in",
        "enter linearly",
    ];
    assert_shown("explain paper_spatial", &parts);
    let receipt = parsed("explain paper_spatial --json");
    let columns = &receipt["forms"][0]["columns"];
    assert_eq!(columns[0]["unknowns"], 12);
    assert_eq!(columns[1]["unknowns"], 5);
    let operations = |column: usize, rate: usize| {
        let operations = &columns[column]["operations"][rate];
        let count = |kind: &str| operations[kind].as_u64().unwrap();
        count("additions") + count("multiplications") + count("divisions") + count("calls")
    };
    for rate in 0..5 {
        assert!(2 * operations(1, rate) < operations(0, rate), "{receipt}");
    }
    let skipped = receipt["skipped"].as_array().unwrap();
    let kinds: Vec<&str> = skipped
        .iter()
        .map(|s| s["kind"].as_str().unwrap())
        .collect();
    for kind in ["parameter", "component", "state", "equation", "output"] {
        assert!(kinds.contains(&kind), "{kind}");
    }
}

#[test]
fn explain_compares_a_model_with_its_core() {
    let receipt = parsed("explain spatial_group --json");
    let columns = &receipt["forms"][0]["columns"];
    assert_eq!(
        (&columns[0]["iterated"], &columns[1]["iterated"]),
        (&json!(12), &json!(3))
    );
    assert_eq!(
        receipt["forms"][0]["eliminated"]["lines"],
        json!([49, 50, 51])
    );
    assert_shown("explain planar_angle", &["form next", "form increment"]);
    assert_refused(&residua("explain paper_spatail"), 2, &["paper_spatial"]);
}

#[test]
fn a_scene_is_shown_checked_and_expanded_like_a_model() {
    assert_shown("show paper_spatial", &["iterated on", "row 1 of T1*Δω"]);
    assert_shown("check paper_recursive", &["Jacobian     ok"]);
    assert_shown("expand paper_recursive", &["pub R_3_1: T"]);
    let folder = folder("scene");
    let text = "scene! {\n    model none;\n    step 1;\n    until 0;\n}\n";
    fs::write(folder.join("wrong.scene"), text).unwrap();
    let outcome = residua_in(&folder, "check wrong.scene");
    assert_refused(&outcome, 2, &["wrong.scene:2:11", "no model `none`"]);
}

#[test]
fn every_model_passes_its_check() {
    succeed("check --all");
}

#[test]
fn check_prints_json() {
    let reports = parsed("check planar_reduced --json");
    assert_eq!(reports[0]["passed"], true);
    assert_eq!(reports[0]["solvers"].as_array().unwrap().len(), 2);
}

#[test]
fn check_reports_wrong_claims_without_failing() {
    let parts = ["Eq. 56", "WRONG", "printed", "true"];
    assert_shown("check planar_recursive", &parts);
}

#[test]
fn errata_lists_verdicts_and_runs_what_is_printed() {
    let parts = [
        "residual Eq. 86",
        "WRONG",
        "jacobian Eq. 87 of Eq. 86 (line",
        "FAILED in step 1",
        "states differ by",
        "NO SUCH BODY",
    ];
    assert_shown("errata spatial_cardan", &parts);
    let report = parsed("errata planar_algebra planar_angle --json --step 0.01 --steps 10");
    assert_eq!(report["models"].as_array().unwrap().len(), 2);
    let claims = report["models"][0]["claims"].as_array().unwrap();
    let eq_64 = claims.iter().find(|c| c["label"] == "Eq. 64").unwrap();
    assert_eq!(eq_64["right"], false);
    assert_eq!(eq_64["newton"]["plan"]["steps"], 10);
    assert_eq!(report["read_by_eye"].as_array().unwrap().len(), 0);
    let everything = parsed("errata --json --steps 1");
    assert!(everything["read_by_eye"].as_array().unwrap().len() > 10);
}

#[test]
fn errata_refuses_what_cannot_be() {
    assert_refused(
        &residua("errata planar_angel"),
        2,
        &["planar_angel", "planar_angle"],
    );
    assert_refused(&residua("errata --step 0"), 2, &["step"]);
    let outcome = residua("errata paper_spatial");
    assert_refused(&outcome, 2, &["is a scene", "spatial_group"]);
}

#[test]
fn expand_prints_rust() {
    assert_shown("expand planar_reduced", &["pub struct Increment;"]);
}

#[test]
fn mistakes_of_a_file_are_shown_in_it() {
    let folder = folder("mistakes");
    let text =
        "model! {\n    state θ: rad;\n    residual { Δθ = h*omga; }\n    start { θ = 0; }\n}\n";
    fs::write(folder.join("wrong.model"), text).unwrap();
    for verb in ["expand", "check"] {
        let outcome = residua_in(&folder, &format!("{verb} wrong.model"));
        let parts = [
            "omga",
            "wrong.model:3:23",
            "^^^^",
            "wrong.model: 1 mistake\n",
        ];
        assert_refused(&outcome, 2, &parts);
    }
    let two = text.replace("= 0", "= 1 + [1, 2] + omg");
    fs::write(folder.join("wrong.model"), two).unwrap();
    let outcome = residua_in(&folder, "check wrong.model");
    assert_eq!(outcome.stderr.matches("error:").count(), 3);
    assert!(outcome.stderr.ends_with("wrong.model: 3 mistakes\n"));
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = folder("unreadable");
    fs::write(folder.join("latin.model"), b"model! {\n  // caf\xe9\n}\n").unwrap();
    let outcome = residua_in(&folder, "expand latin.model");
    assert_refused(&outcome, 2, &["UTF-8", "latin.model:2:9"]);
    let outcome = residua_in(&folder, "expand nothing.model");
    assert_refused(&outcome, 2, &["cannot read nothing.model"]);
}

#[test]
fn new_writes_a_sound_model_once() {
    let folder = folder("new");
    assert_eq!(residua_in(&folder, "new driven --dir .").code, 0);
    let checked = residua_in(&folder, "check driven.model");
    assert_eq!(checked.code, 0);
    let verdict = "no mistakes in names, shapes, units and structure";
    assert!(checked.stdout.contains(verdict), "{}", checked.stdout);
    let text = fs::read_to_string(folder.join("driven.model")).unwrap();
    let again = residua_in(&folder, "new driven --dir .");
    assert_refused(&again, 2, &["exists already"]);
    assert_eq!(
        fs::read_to_string(folder.join("driven.model")).unwrap(),
        text
    );
}

#[test]
fn new_refuses_names_that_are_no_modules() {
    for name in ["my-model", "Model", "2d", "fn", "a/b", "ω"] {
        let outcome = residua(&format!("new {name}"));
        assert_refused(&outcome, 2, &["cannot name a model"]);
    }
    let outcome = residua("new fine --dir no/such/folder");
    assert_refused(&outcome, 2, &["no folder"]);
}

#[test]
fn bad_usage_exits_with_2() {
    for line in [
        "",
        "lst",
        "check",
        "check --all planar_angle",
        "simulate planar_angle --every 0",
    ] {
        assert_eq!(residua(line).code, 2, "{line}");
    }
    let outcome = residua("check no_such_model");
    assert_refused(&outcome, 2, &["no model `no_such_model`"]);
    succeed("--help");
}
