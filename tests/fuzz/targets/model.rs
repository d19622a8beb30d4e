//! Bytes of a model file through the whole generator: what comes out is Rust, and twice the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use residua_codegen::source::read_source;
use residua_codegen::{compile, expand};

fuzz_target!(|bytes: &[u8]| {
    let Ok(tokens) = read_source(bytes) else {
        return;
    };
    let items = match compile("fuzz", tokens.clone()) {
        Ok(items) => {
            let again = compile("fuzz", tokens).expect("as before");
            assert_eq!(items.to_string(), again.to_string());
            items
        }
        // Errors, and items to keep callers quiet.
        Err(_) => expand("fuzz", tokens),
    };
    if let Err(error) = syn::parse2::<syn::File>(items.clone()) {
        panic!("{error}: {items}");
    }
});
