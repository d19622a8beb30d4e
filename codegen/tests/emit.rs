//! What is emitted: compared with files under `golden/` that a person has read, and for any model the
//! same bytes each time.
//!
//! `RESIDUA_BLESS=1 cargo test -p residua-codegen --test emit` writes the files anew.

use proc_macro2::TokenStream;
use residua_codegen::expand;
use residua_codegen::expand_scene;
use residua_codegen::source::read_scene;
use residua_codegen::source::read_source;
use std::fs;
use std::path::Path;
use std::path::PathBuf;

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn expanded(name: &str) -> TokenStream {
    let path = golden().join(name).with_extension("model");
    if !path.exists() {
        let bytes = fs::read(path.with_extension("scene")).expect("a file beside its golden one");
        let text = |model: &str| {
            let path = golden().join(model).with_extension("model");
            fs::read_to_string(path).map_err(|error| error.to_string())
        };
        return expand_scene(name, read_scene(&bytes).expect("a scene"), &text);
    }
    let bytes = fs::read(path).expect("a model beside its golden file");
    expand(name, read_source(&bytes).expect("a model"))
}

fn formatted(tokens: TokenStream) -> String {
    prettyplease::unparse(&syn::parse2(tokens).expect("emitted code is Rust"))
}

fn assert_golden(name: &str) {
    let found = formatted(expanded(name));
    let path = golden().join(name).with_extension("rs");
    if std::env::var_os("RESIDUA_BLESS").is_some() {
        fs::write(&path, &found).expect("a writable golden file");
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    for (i, (found, expected)) in found.lines().zip(expected.lines()).enumerate() {
        assert_eq!(found, expected, "{name}.rs, line {}", i + 1);
    }
    assert_eq!(found.len(), expected.len(), "{name}.rs ends too early");
}

#[test]
fn pendulum_reads_as_a_person_would_write_it() {
    assert_golden("planar");
}

#[test]
fn awkward_names_become_legal_and_distinct() {
    assert_golden("names");
}

#[test]
fn a_scene_is_a_model_with_less_in_it() {
    assert_golden("swing");
}

#[test]
fn expanding_twice_gives_the_same_bytes() {
    for name in ["planar", "names", "swing"] {
        let [first, second] = [0, 1].map(|_| expanded(name).to_string());
        assert_eq!(first, second, "{name}");
    }
}
