//! The documents say what is so: their model and scene files compile, and the reference leaves no function out.

use residua_codegen::function::TABLE;
use residua_codegen::source::{read_scene, read_source};
use residua_models::find;

const README: &str = include_str!("../../README.md");
const LANGUAGE: &str = include_str!("../../codegen/LANGUAGE.md");

/// The model files among the code blocks of a document.
fn models(document: &str) -> impl Iterator<Item = &str> {
    files(document, "model! {")
}

/// The files among the code blocks of a document that begin like this.
fn files<'d>(document: &'d str, begin: &'d str) -> impl Iterator<Item = &'d str> {
    document
        .split("```")
        .skip(1)
        .step_by(2)
        .filter_map(|block| block.strip_prefix("rust\n"))
        .filter(move |block| block.starts_with(begin))
}

fn assert_model_compiles(document: &str) {
    assert_ne!(models(document).count(), 0, "the document has a model file");
    for text in models(document) {
        let tokens = read_source(text.as_bytes()).expect("a model file");
        if let Err(errors) = residua_codegen::compile("documented", tokens) {
            panic!("{:#?}\nin\n{text}", errors.into_sorted());
        }
    }
}

#[test]
fn the_readme_shows_a_model_that_compiles() {
    assert_model_compiles(README);
}

#[test]
fn the_reference_shows_a_model_that_compiles() {
    assert_model_compiles(LANGUAGE);
}

/// Scenes of the catalogue's models.
fn assert_scene_compiles(document: &str) {
    assert_ne!(files(document, "scene! {").count(), 0);
    let read = |model: &str| match find(model) {
        Ok(model) => Ok(model.source.to_owned()),
        Err(unknown) => Err(unknown.to_string()),
    };
    for text in files(document, "scene! {") {
        let tokens = read_scene(text.as_bytes()).expect("a scene file");
        if let Err(errors) = residua_codegen::compile_scene("documented", tokens, &read) {
            panic!("{errors}\nin\n{text}");
        }
    }
}

#[test]
fn the_documents_show_scenes_that_compile() {
    assert_scene_compiles(README);
    assert_scene_compiles(LANGUAGE);
}

#[test]
fn the_reference_lists_every_function() {
    let table = LANGUAGE
        .split("## 9. Functions")
        .nth(1)
        .and_then(|rest| rest.split("\n## ").next())
        .expect("the section of the functions");
    let is_name = |c: char| c.is_ascii_alphanumeric();
    let mentioned: Vec<&str> = table
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split('`').next())
        .flat_map(|cell| cell.split(|c| !is_name(c)))
        .collect();
    for (name, _, _) in TABLE {
        assert!(mentioned.contains(name), "{name}");
    }
}
