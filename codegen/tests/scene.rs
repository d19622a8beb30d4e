//! Scenes: what is left of a model, and what is gone.

use residua_codegen::Scene;
use residua_codegen::analyse_scene;
use residua_codegen::source::lex;
use std::fs;
use std::path::Path;

/// The text of a model of the catalogue.
fn read(model: &str) -> Result<String, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/dsl");
    fs::read_to_string(folder.join(format!("{model}.model"))).map_err(|error| error.to_string())
}

fn scene(text: &str) -> Scene {
    scene_of(text, &read)
}

fn scene_of(text: &str, read: &dyn Fn(&str) -> Result<String, String>) -> Scene {
    let tokens = lex(&format!("{text} step 0.1; until 100;")).expect("tokens");
    analyse_scene("scene", tokens, read).unwrap_or_else(|errors| panic!("{errors}"))
}

/// A scene of the model in `text`.
fn of(model: &str, text: &str) -> Scene {
    scene_of(&format!("model it; {text}"), &|_| {
        Ok(format!("model! {{ {model} }}"))
    })
}

/// Numbers of scalar states, unknowns, and unknowns iterated on.
fn sizes(scene: &Scene) -> (usize, usize, usize) {
    let unknowns = scene.system.residual.len();
    let core = scene.system.core.as_ref();
    let core = core.map_or(unknowns, |core| core.reduced.unknowns.len());
    (scene.model.n_states(), unknowns, core)
}

/// The states that are left.
fn states(scene: &Scene) -> Vec<&str> {
    let states = scene.model.states.iter();
    states.map(|s| s.variable.name.display.as_str()).collect()
}

/// Components that stay 0, by position in the state that is left.
fn zeros(scene: &Scene) -> Vec<usize> {
    scene.receipt.zeros.iter().map(|z| z.0).collect()
}

const FIXED: &str = "fix m = 10; fix J = diag(1, 1, 1); fix ρ = [0, 0, 0.7]; fix g = 9.81;";

#[test]
fn the_rows_that_nobody_asks_for_are_gone() {
    let scene = scene("model spatial_group; keep ω, Γ3;");
    assert_eq!(states(&scene), ["ω", "Γ3"]);
    assert_eq!(sizes(&scene), (6, 6, 3));
    assert_eq!(scene.model.parameters.len(), 4);
}

#[test]
fn a_symmetric_body_needs_two_unknowns_at_most() {
    let symmetric = scene(&format!("model spatial_group; {FIXED} keep ω, Γ3;"));
    assert_eq!(zeros(&symmetric), [2]);
    assert!(symmetric.model.parameters.is_empty());
    let (states, unknowns, iterated) = sizes(&symmetric);
    assert_eq!((states, unknowns), (6, 5));
    assert!(iterated <= 2, "{iterated}");
}

#[test]
fn what_hangs_on_an_open_parameter_proves_nothing() {
    for open in [
        "fix m = 10; fix J = diag(1, 1, 1);",
        "fix ρ = [0, 0, 0.7];",
        "",
    ] {
        let scene = scene(&format!("model spatial_group; {open} keep ω, Γ3;"));
        assert_eq!(zeros(&scene), [0; 0], "{open}");
    }
    // Neither m nor g decides whether the body is symmetric.
    let scene = scene("model spatial_group; fix J = diag(2, 2, 1); fix ρ = [0, 0, 1]; keep ω;");
    assert_eq!(zeros(&scene), [2]);
}

#[test]
fn what_breaks_the_symmetry_keeps_the_component() {
    for broken in [
        FIXED.replace("diag(1, 1, 1)", "diag(1, 2, 1)"),
        FIXED.replace("[0, 0, 0.7]", "[0, 0.1, 0.7]"),
        format!("{FIXED} start {{ ω = [0, 0, 1e-9]; }}"),
    ] {
        let scene = scene(&format!("model spatial_group; {broken} keep ω, Γ3;"));
        assert_eq!(zeros(&scene), [0; 0], "{broken}");
    }
}

#[test]
fn without_gravity_the_attitude_is_not_needed() {
    let scene = scene("model spatial_group; fix g = 0; start { ω = [1, 2, 3]; } keep ω;");
    assert_eq!(states(&scene), ["ω"]);
    assert_eq!(scene.system.residual.len(), 3);
}

#[test]
fn of_a_matrix_only_the_needed_entries_are_left() {
    let scene = scene("model spatial_recursive; keep ω;");
    assert_eq!(states(&scene), ["ω", "R(3,1)", "R(3,2)", "R(3,3)"]);
    let ascii = scene.model.states.iter();
    let ascii: Vec<&str> = ascii.map(|s| s.variable.name.ascii.as_str()).collect();
    assert_eq!(ascii[1..], ["R_3_1", "R_3_2", "R_3_3"]);
    assert!(scene.equations.flow.is_some());
}

#[test]
fn without_keep_all_is_there() {
    let scene = scene("model spatial_group;");
    assert_eq!(sizes(&scene), (12, 12, 3));
    assert_eq!(scene.model.outputs.len(), 4);
    assert!(scene.receipt.skipped.is_empty());
    assert_eq!(scene.receipt.keep.len(), 8);
}

#[test]
fn a_let_of_the_scene_hides_that_of_the_model_in_the_scene_only() {
    let model =
        "param a = 1; state x; let c = 2; residual { Δx = -h*c*a*x[k+1/2]; } start { x = c; }";
    let scene = of(model, "let c = 5; start { x = c; }");
    let values = scene.equations.dag.evaluate(|_| f64::NAN);
    assert_eq!(values[scene.equations.start[0].index()], 5.0);
    // The equation still has the 2 of the model.
    let plain = of(model, "start { x = 5; }");
    assert_eq!(scene.system.dag.to_string(), plain.system.dag.to_string());
}

/// x and y swing, z is pushed by t: it starts at 0 and does not stay there.
const PUSHED: &str = "state x; state y; state z;
    residual { Δx = h*y[k+1/2]; Δy = -h*x[k+1/2]; Δz = h*t; }
    start { x = 0; y = 0; z = 0; }";

#[test]
fn what_is_pushed_is_not_zero() {
    let scene = of(PUSHED, "");
    assert_eq!(states(&scene), ["x", "y", "z"]);
    assert_eq!(zeros(&scene), [0, 1]);
    assert_eq!(scene.system.residual.len(), 1);
}

#[test]
fn one_of_a_pair_brings_the_other_with_it() {
    let scene = of(PUSHED, "start { y = 1; }");
    assert_eq!(zeros(&scene), [0; 0]);
    assert_eq!(scene.system.residual.len(), 3);
}

/// Both equations vanish with x at 0, and say nothing of y: the model is singular there, which is told.
#[test]
fn equations_that_vanish_for_no_unknown_are_not_dropped() {
    let model = "state x; state y; residual { Δx*(1 + y[k+1]) = 0; Δx + x*Δy = 0; }
        start { x = 0; y = 1; }";
    let tokens = lex("model it; step 1; until 2;").expect("tokens");
    let read = |_: &str| Ok(format!("model! {{ {model} }}"));
    let errors = analyse_scene("scene", tokens, &read).expect_err("a singular scene");
    assert!(
        errors
            .to_string()
            .contains("no equation contains the unknown `y`"),
        "{errors}"
    );
}

/// The first guess of an own unknown is 1: Newton's method does not start at 0 for it.
#[test]
fn a_guess_that_is_not_zero_is_no_zero() {
    let model = "state x; unknown u = 1; residual { u^2 + u = x; Δx = h*u; } start { x = 0; }";
    assert_eq!(zeros(&of(model, "")), [0; 0]);
    let model = model.replace("u = 1", "u = x");
    let tokens = lex("model it; step 1; until 2;").expect("tokens");
    let read = |_: &str| Ok(format!("model! {{ {model} }}"));
    let errors = analyse_scene("scene", tokens, &read).expect_err("nothing moves");
    assert!(
        errors.to_string().contains("nothing that is kept"),
        "{errors}"
    );
}

/// At x = 0 this divides by 0, whatever else vanishes there.
#[test]
fn zeros_are_not_divided_by() {
    let model = "state x; state y; residual { Δx = h*x; Δy = h*y/x; } start { x = 0; y = 1; }";
    assert_eq!(zeros(&of(model, "")), [0; 0]);
}

#[test]
fn an_update_that_moves_a_state_keeps_it() {
    let model = "state x; state s; residual { Δx = -h*x[k+1/2]; } update { s = s + h*x[k+1]; }
        start { x = 1; s = 0; }";
    assert_eq!(zeros(&of(model, "")), [0; 0]);
    let guarded = format!("state r; {model}")
        .replace("residual {", "residual { Δr = h; ")
        .replace("start {", "start { r = 0; ");
    let resting = of(&guarded, "start { x = 0; }");
    assert_eq!(zeros(&resting), [1, 2]);
    let counted = of(model, "keep x;");
    assert_eq!(states(&counted), ["x"]);
}

/// s drives x, in the equation or in the first guess alone.
#[test]
fn what_an_equation_or_a_guess_contains_is_needed() {
    let driven = "state x; state s; residual { Δx = -h*s*x[k+1/2]; } update { s = s + h; }
        start { x = 1; s = 1; }";
    assert_eq!(states(&of(driven, "keep x;")), ["x", "s"]);
    let guessed = "state x; state s; unknown u = s; residual { u^3 + u = x; Δx = h*u; }
        update { s = s + h; } start { x = 1; s = 1; }";
    assert_eq!(states(&of(guessed, "keep x;")), ["x", "s"]);
}

#[test]
fn a_flow_that_needs_more_than_the_equations_is_left_out() {
    let model = "state x; state y; flow { der(x) = -x + y; der(y) = 0; }
        residual { Δx = -h*x[k+1/2]; Δy = 0; } start { x = 1; y = 0.5; }";
    let scene = of(model, "keep x;");
    assert_eq!(states(&scene), ["x"]);
    assert!(scene.equations.flow.is_none());
    assert!(scene.receipt.skipped.iter().any(|s| s.what == "flow"));
}

#[test]
fn everything_that_is_gone_is_told_with_its_line() {
    let scene = scene(&format!("model spatial_group;\n{FIXED} keep ω, Γ3;"));
    let told = |what: &str| scene.receipt.skipped.iter().find(|s| s.what == what);
    let text = read("spatial_group").expect("the model");
    let line = |start: &str| {
        1 + text
            .lines()
            .position(|l| l.trim().starts_with(start))
            .expect(start)
    };
    for (what, start, reason) in [
        (
            "J",
            "param J",
            "fixed as `diag(1, 1, 1)` in line 2 of the scene",
        ),
        ("Γ1", "state Γ1", "no kept quantity depends on it"),
        ("ω.z", "state ω", "row 3 of `T1*Δω"),
        ("energy", "invariant energy", "not kept"),
        (
            "(T4 + h*S(Δω))*ΔΓ1 - T10*Δω + T7 = 0",
            "(T4 + h*S(Δω))*ΔΓ1",
            "not needed",
        ),
    ] {
        let skipped = told(what).unwrap_or_else(|| panic!("{what}"));
        assert_eq!(skipped.line, line(start), "{what}");
        assert!(skipped.reason.contains(reason), "{}", skipped.reason);
    }
}
