//! What a user sees when a build meets a bad model file: rustc's own carets in that file, and no errors
//! in code that uses the model.

use std::fs;
use std::path::Path;
use std::path::PathBuf;
use std::process::Command;

/// Code that names everything a model leaves in its module.
const USER: &str = "
#![allow(confusable_idents, mixed_script_confusables)]
pub mod pendulum {
    use residua::model;
    include!(\"pendulum.model\");
}
pub fn name() -> &'static str {
    pendulum::MODEL.description.name
}
pub type Both = (pendulum::Next, pendulum::Increment, pendulum::Parameters, pendulum::State);
";

/// Code that names the variables of the model below.
const FIELDS: &str = "
pub fn angular_velocity() -> f64 {
    use residua::Model as _;
    let parameters = pendulum::Parameters { m: 3.0, J: [[1.0, 0.0], [0.0, 1.0]], ..Default::default() };
    let state = pendulum::State { theta: 1.0, ..pendulum::Model::start(&parameters) };
    let outputs = pendulum::Model::outputs(&parameters, 0.1, 0.0, &state);
    state.omega + parameters.g + outputs.energy + outputs.arm[1]
}
";

/// What `cargo check` says about a crate whose one model file is `model`.
fn check(name: &str, user: &str, model: &str) -> (bool, String) {
    cargo_check(&write_crate(name, user, model))
}

/// A crate with one model file, and its folder.
fn write_crate(name: &str, user: &str, model: &str) -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(folder.join("src")).expect("a folder for the crate");
    let runtime = workspace.join("../runtime");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nresidua = {{ path = {runtime:?} }}\n\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("a manifest");
    fs::copy(
        workspace.join("own_crate/Cargo.lock"),
        folder.join("Cargo.lock"),
    )
    .expect("a lock file");
    fs::write(folder.join("src/lib.rs"), format!("{USER}{user}")).expect("a library");
    fs::write(folder.join("src/pendulum.model"), model).expect("a model");
    folder
}

/// What `cargo check` says about the crate in `folder`.
fn cargo_check(folder: &Path) -> (bool, String) {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO"))
        .args(["check", "--quiet", "--offline", "--color", "never"])
        .current_dir(folder)
        .env("CARGO_TARGET_DIR", workspace.join("own_crate/target"))
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo runs");
    (
        output.status.success(),
        String::from_utf8_lossy(&output.stderr).into_owned(),
    )
}

/// The first lines of all errors but cargo's own.
fn errors(stderr: &str) -> Vec<&str> {
    let is_error = |line: &&str| line.starts_with("error") && !line.contains("could not compile");
    stderr.lines().filter(is_error).collect()
}

#[test]
fn every_mistake_of_a_file_has_a_caret_there_and_nothing_follows() {
    let model = "model! {
    param m: kg = 2;
    param g: m/s^2 = 9.81;
    param J = [[1, 2], [3, 4]];
    state ω: 1/s;
    state θ: rad;
    residual {
        m*Δomga + h*g*sin(θ[k+1/2]) = 0;
        2*Δθ - h*(ω[k+1] + m) = 0;
    }
    start { ω = 1; }
    observe energy = omga*m;
    observe arm = [1, m];
}
";
    let (built, stderr) = check("several_mistakes", FIELDS, model);
    assert!(!built);
    let found = errors(&stderr);
    assert!(found.len() >= 3, "{stderr}");
    assert_eq!(
        stderr.matches("pendulum.model:").count(),
        found.len(),
        "{stderr}"
    );
    assert!(stderr.contains("pendulum.model:8:"), "{stderr}");
    assert!(stderr.contains("pendulum.model:9:"), "{stderr}");
    assert!(
        stderr.contains("help: did you mean `ω`?") || stderr.contains("omga"),
        "{stderr}"
    );
    assert!(!stderr.contains("error[E"), "{stderr}");
}

#[test]
fn a_declaration_with_a_mistake_still_declares() {
    let model = "model! {
    param m: kg = 2 +;
    param g: m/s^ = 9.81;
    param J: [2, 2] [[1, 2], [3, 4]];
    state ω: 1/s = 3;
    state θ: rad
    residual { Δω = 0; Δθ = 0; }
    start { ω = 1; θ = 2; }
    observe energy = omega*;
    observe arm: [2] = ;
}
";
    let (built, stderr) = check("bad_declarations", FIELDS, model);
    assert!(!built);
    assert_eq!(errors(&stderr).len(), 7, "{stderr}");
    assert!(!stderr.contains("error[E"), "{stderr}");
}

#[test]
fn an_unbalanced_bracket_is_one_error() {
    let (built, stderr) = check(
        "unbalanced_bracket",
        "",
        "model! {\n    state x;\n    residual { (Δx = 0; }\n}\n",
    );
    assert!(!built);
    assert_eq!(errors(&stderr).len(), 1, "{stderr}");
    assert!(stderr.contains("pendulum.model:3:"), "{stderr}");
}

#[test]
fn a_good_model_builds_without_a_warning() {
    let model = "model! {
    param ρ: kg = 2;
    param p = 1;
    state x;
    residual { ρ*Δx + p*ρ*x[k+1/2] = 0; }
    solve for next, increment;
    start { x = 1; }
}
";
    let (built, stderr) = check("good_model", "", model);
    assert!(built, "{stderr}");
    assert_eq!(stderr, "");
}

/// Code that runs a scene of the model.
const SCENE_USER: &str = "
pub mod swing {
    use residua::scene;
    include!(\"swing.scene\");
}
pub fn start() -> f64 {
    use residua::Model as _;
    let parameters = swing::Parameters::<f64>::default();
    swing::Model::start(&parameters).x + swing::MODEL.description.states.len() as f64
}
";

const MODEL: &str = "model! {
    param c = 2;
    state x;
    residual { Δx + c*h*x[k+1/2] = 0; }
    solve for next, increment;
    start { x = 1; }
}
";

/// Writes the crate and its scene, and checks it.
fn check_scene(name: &str, scene: &str) -> (bool, String) {
    let folder = write_crate(name, SCENE_USER, MODEL);
    fs::write(folder.join("src/swing.scene"), scene).expect("a scene");
    cargo_check(&folder)
}

#[test]
fn a_scene_stands_beside_its_model_and_is_rebuilt_with_it() {
    let name = "good_scene";
    let scene = "scene! {\n    model pendulum;\n    fix c = 3;\n    step 0.1;\n    until 1;\n}\n";
    let (built, stderr) = check_scene(name, scene);
    assert!(built, "{stderr}");
    assert_eq!(stderr, "");
    // Another model, the same scene: the mistake is found in it although it was not touched.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let other = MODEL.replace("param c", "param b").replace("c*h", "b*h");
    fs::write(folder.join("src/pendulum.model"), other).expect("a model");
    let (built, stderr) = cargo_check(&folder);
    assert!(!built);
    assert_eq!(errors(&stderr).len(), 1, "{stderr}");
    assert!(stderr.contains("swing.scene:3:"), "{stderr}");
    assert!(stderr.contains("has no parameter `c`"), "{stderr}");
}

#[test]
fn mistakes_of_a_scene_have_carets_in_it() {
    let scene = "scene! {
    model pendulum;
    fix c = [1, 2];
    start { x = cc; }
    step 0.1;
    until 1;
}
";
    let (built, stderr) = check_scene("bad_scene", scene);
    assert!(!built);
    assert_eq!(errors(&stderr).len(), 2, "{stderr}");
    assert!(stderr.contains("swing.scene:3:13"), "{stderr}");
    assert!(stderr.contains("swing.scene:4:17"), "{stderr}");
    assert!(!stderr.contains("error[E"), "{stderr}");

    let (built, stderr) = check_scene("scene_without_model", &scene.replace("pendulum", "nothing"));
    assert!(!built);
    assert!(stderr.contains("swing.scene:2:11"), "{stderr}");
    assert!(stderr.contains("there is no model `nothing`"), "{stderr}");
}

#[test]
fn mistakes_of_the_model_are_told_once_with_their_place() {
    let name = "scene_of_bad_model";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let scene = "scene! { model pendulum; step 0.1; until 1; }";
    check_scene(name, scene);
    fs::write(
        folder.join("src/pendulum.model"),
        MODEL.replace("c*h", "d*h"),
    )
    .expect("a model");
    let (built, stderr) = cargo_check(&folder);
    assert!(!built);
    assert_eq!(errors(&stderr).len(), 2, "{stderr}");
    assert!(stderr.contains("pendulum.model:4:21"), "{stderr}");
    let told = "the model `pendulum` has mistakes: 4:21: unknown name `d`";
    assert!(stderr.contains(told), "{stderr}");
}
