//! Bytes of a scene file, of a model that has every statement, through the whole generator.
#![no_main]

use libfuzzer_sys::fuzz_target;
use residua_codegen::source::read_scene;
use residua_codegen::{compile_scene, expand_scene};

const MODEL: &str = include_str!("../../../codegen/tests/complete.model.in");

fuzz_target!(|bytes: &[u8]| {
    let Ok(tokens) = read_scene(bytes) else {
        return;
    };
    let read = |_: &str| Ok(format!("model! {{ {MODEL} }}"));
    let items = match compile_scene("fuzz", tokens.clone(), &read) {
        Ok(items) => items,
        Err(_) => expand_scene("fuzz", tokens, &read),
    };
    if let Err(error) = syn::parse2::<syn::File>(items.clone()) {
        panic!("{error}: {items}");
    }
});
