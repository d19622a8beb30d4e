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
    let tokens = lex(text).expect("tokens");
    analyse_scene("scene", tokens, &read).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Numbers of scalar states, unknowns, and unknowns iterated on.
fn sizes(scene: &Scene) -> (usize, usize, usize) {
    let unknowns = scene.system.residual.len();
    let core = scene.system.core.as_ref();
    let core = core.map_or(unknowns, |core| core.0.unknowns.len());
    (scene.model.n_states(), unknowns, core)
}

#[test]
fn the_paper_in_space() {
    let scene = scene(
        "model spatial_group;
         fix m = 10; fix J = diag(1, 1, 1); fix ρ = [0, 0, 0.7]; fix g = 9.81;
         step 0.1; until 100; keep ω, Γ3;",
    );
    eprintln!("{:#?}", scene.receipt);
    eprintln!("{}", scene.system.dag);
    assert_eq!(sizes(&scene), (6, 5, 2));
}
