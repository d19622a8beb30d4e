//! `residua list`, `check`, `expand` and `new`, as users run them.

mod support;

use residua_models::CATALOGUE;
use serde_json::Value;
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};
use support::{assert_refused, folder, residua};

#[test]
fn list_names_every_model() {
    let outcome = residua(&["list"]);
    assert_eq!(outcome.code, 0);
    for entry in CATALOGUE {
        assert!(outcome.stdout.contains(entry.name()), "{}", entry.name());
    }
    assert_eq!(outcome.stdout.lines().count(), CATALOGUE.len() + 1);
}

#[test]
fn list_prints_json() {
    let models: Value = serde_json::from_str(&residua(&["list", "--json"]).stdout).unwrap();
    assert_eq!(models.as_array().unwrap().len(), CATALOGUE.len());
    let one: Value =
        serde_json::from_str(&residua(&["list", "planar_reduced", "--json"]).stdout).unwrap();
    assert_eq!(one["states"][1]["name"], "Γ");
    assert_eq!(one["states"][1]["value"], serde_json::json!([0.0, 1.0]));
}

#[test]
fn show_says_everything_about_a_model() {
    let outcome = residua(&["show", "planar_reduced"]);
    for part in [
        "parameters",
        "kg·m²",
        "Γ[2]",
        "form next",
        "form increment",
        "energy",
        "Eq. 50",
    ] {
        assert!(
            outcome.stdout.contains(part),
            "no `{part}` in\n{}",
            outcome.stdout
        );
    }
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    for arguments in [
        &["simulate", "planar_reduced", "--until", "1000"][..],
        &["list", "--json"],
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_residua"))
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut stderr = String::new();
        child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut stderr)
            .unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0), "{stderr}");
        assert_eq!(stderr, "");
    }
}

#[test]
fn check_prints_json() {
    let outcome = residua(&["check", "planar_reduced", "--json"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let reports: Value = serde_json::from_str(&outcome.stdout).unwrap();
    assert_eq!(reports[0]["passed"], true);
    assert_eq!(reports[0]["solvers"].as_array().unwrap().len(), 2);
}

#[test]
fn every_model_passes_its_check() {
    let outcome = residua(&["check", "--all"]);
    assert_eq!(outcome.code, 0, "{}\n{}", outcome.stdout, outcome.stderr);
}

#[test]
fn check_reports_wrong_claims_without_failing() {
    let outcome = residua(&["check", "spatial_group"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    for part in ["Eq. 83", "WRONG", "printed", "true"] {
        assert!(
            outcome.stdout.contains(part),
            "no `{part}` in\n{}",
            outcome.stdout
        );
    }
}

#[test]
fn expand_prints_rust() {
    let outcome = residua(&["expand", "planar_reduced"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert!(outcome.stdout.contains("pub struct Increment;"));
}

#[test]
fn mistakes_of_a_file_are_shown_in_it() {
    let path = folder("mistakes").join("wrong.model");
    let text =
        "model! {\n    state θ: rad;\n    residual { Δθ = h*omga; }\n    start { θ = 0; }\n}\n";
    fs::write(&path, text).unwrap();
    for verb in ["expand", "check"] {
        let shown = path.to_str().unwrap();
        assert_refused(&[verb, shown], 2, &["omga", &format!("{shown}:3:"), "^^^^"]);
    }
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = folder("unreadable");
    let (latin, nothing) = (folder.join("latin.model"), folder.join("nothing.model"));
    fs::write(&latin, b"model! {\n  // caf\xe9\n}\n").unwrap();
    assert_refused(
        &["expand", latin.to_str().unwrap()],
        2,
        &["UTF-8", "latin.model:2:"],
    );
    assert_refused(&["expand", nothing.to_str().unwrap()], 2, &["cannot read"]);
}

#[test]
fn new_writes_a_sound_model_once() {
    let folder = folder("new");
    let dir = folder.to_str().unwrap();
    let outcome = residua(&["new", "driven", "--dir", dir]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let path = folder.join("driven.model");
    assert_eq!(residua(&["check", path.to_str().unwrap()]).code, 0);
    let text = fs::read_to_string(&path).unwrap();
    assert_refused(&["new", "driven", "--dir", dir], 2, &["exists already"]);
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn new_refuses_names_that_are_no_modules() {
    for name in ["my-model", "Model", "2d", "fn", "a/b", "ω", ""] {
        assert_refused(&["new", name], 2, &["cannot name a model"]);
    }
    assert_refused(
        &["new", "fine", "--dir", "/no/such/folder"],
        2,
        &["no folder"],
    );
}

#[test]
fn bad_usage_exits_with_2() {
    assert_eq!(residua(&[]).code, 2);
    assert_eq!(residua(&["lst"]).code, 2);
    assert_eq!(residua(&["check"]).code, 2);
    assert_refused(
        &["check", "no_such_model"],
        2,
        &["no model `no_such_model`"],
    );
    assert_eq!(residua(&["--help"]).code, 0);
}
