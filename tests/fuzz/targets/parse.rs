//! Bytes of a model file and of a scene file: read, parsed, or refused with a place that is in the file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use residua_codegen::diagnostic::Errors;
use residua_codegen::parse::{parse, parse_leniently, parse_scene, parse_scene_leniently};
use residua_codegen::source::{read_scene, read_source};

fuzz_target!(|bytes: &[u8]| {
    let lines = bytes.split(|byte| *byte == b'\n').count();
    match read_source(bytes) {
        Ok(tokens) => {
            let leniently = parse_leniently("fuzz", tokens.clone());
            match parse("fuzz", tokens) {
                Ok(ast) => assert_eq!(ast.items.len(), leniently.items.len()),
                Err(errors) => judge(errors, lines),
            }
        }
        Err(error) => assert!(error.line <= lines && !error.message.is_empty()),
    }
    if let Ok(tokens) = read_scene(bytes) {
        parse_scene_leniently("fuzz", tokens.clone());
        if let Err(errors) = parse_scene("fuzz", tokens) {
            judge(errors, lines);
        }
    }
});

/// There is one, and all are about a line of the file.
fn judge(errors: Errors, lines: usize) {
    let all = errors.into_sorted();
    assert!(!all.is_empty());
    for mistake in all {
        assert!(mistake.range.line() <= lines, "{}", mistake.message);
        assert!(!mistake.message.is_empty());
    }
}
