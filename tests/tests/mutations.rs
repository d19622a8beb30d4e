//! The ways to break the code are still there to be taken.

use residua_tests::mutations::{ALL, Mutation};
use std::fs;
use std::path::Path;

#[test]
fn every_mutation_has_its_place() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for Mutation { file, from, to, .. } in ALL {
        let text = fs::read_to_string(root.join(file)).expect(file);
        assert_eq!(text.matches(from).count(), 1, "{file}: {from}");
        assert_ne!(from, to);
    }
}
