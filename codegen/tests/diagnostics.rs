//! What users read when a model is wrong, mistake by mistake and word by word.
//!
//! Each `diagnostics/NAME.model` and `diagnostics/NAME.scene` has its messages in `NAME.expected`. `BLESS=1 cargo test` writes them
//! anew; read them as a user would before you commit them.

use residua_codegen::analyse;
use residua_codegen::analyse_scene;
use residua_codegen::source::read_scene;
use residua_codegen::source::read_source;
use std::fs;
use std::path::Path;
use std::path::PathBuf;

#[test]
fn every_mistake_is_told_word_by_word() {
    let bless = std::env::var_os("BLESS").is_some();
    let mut wrong = Vec::new();
    for model in models() {
        let found = messages(&model);
        let expected = model.with_extension("expected");
        if bless {
            fs::write(&expected, &found).expect("a writable checkout");
        }
        if fs::read_to_string(&expected).ok().as_ref() != Some(&found) {
            wrong.push(format!("{}\n{found}", model.display()));
        }
    }
    assert!(wrong.is_empty(), "found instead:\n{}", wrong.join("\n"));
}

#[test]
fn every_message_is_lower_case_and_has_no_full_stop() {
    for model in models() {
        for line in messages(&model).lines() {
            let (_, message) = line.split_once(": ").expect("place: message");
            let first = message.chars().next().expect("some text");
            let symbol = message.starts_with(|c: char| !c.is_alphabetic());
            let function = message.starts_with(['S', 'R', 'Δ']);
            assert!(first.is_lowercase() || symbol || function, "{line}");
            assert!(!message.ends_with('.'), "{line}");
        }
    }
}

/// The model files and scene files, in order of their names.
fn models() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/diagnostics");
    let entries = fs::read_dir(folder).expect("the folder of mistakes");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let is_input = |path: &PathBuf| {
        path.extension()
            .is_some_and(|e| e == "model" || e == "scene")
    };
    let mut models: Vec<PathBuf> = paths.filter(is_input).collect();
    models.sort();
    models
}

/// `LINE:COLUMN: message`, each with its `  help: …` below.
fn messages(model: &Path) -> String {
    let name = model.file_stem().unwrap_or_default().to_string_lossy();
    let bytes = fs::read(model).expect("a readable file");
    if model.extension().is_some_and(|ending| ending == "scene") {
        return match read_scene(&bytes) {
            Err(error) => format!("{error}\n"),
            Ok(tokens) => match analyse_scene(&name, tokens, &read) {
                Err(errors) => errors.to_string(),
                Ok(_) => String::new(),
            },
        };
    }
    match read_source(&bytes) {
        Err(error) => format!("{error}\n"),
        Ok(tokens) => match analyse(&name, tokens) {
            Err(errors) => errors.to_string(),
            Ok(_) => String::new(),
        },
    }
}

/// A sound model, or one of those with mistakes.
fn read(model: &str) -> Result<String, String> {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let paths = ["golden", "diagnostics"].map(|folder| tests.join(folder).join(model));
    let mut texts = paths
        .iter()
        .map(|path| fs::read_to_string(path.with_extension("model")));
    let found = texts.find_map(Result::ok);
    found.ok_or_else(|| format!("no file {model}.model"))
}
