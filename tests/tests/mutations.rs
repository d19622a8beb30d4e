//! The ways to break the code are still there to be taken.

use residua_tests::mutations::{ALL, Mutation};
use std::fs;
use std::path::Path;

#[test]
fn every_mutation_has_its_place() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let table = fs::read_to_string(root.join("tests/MUTATIONS.md")).expect("the table");
    for Mutation {
        rule,
        file,
        from,
        to,
    } in ALL
    {
        let text = fs::read_to_string(root.join(file)).expect(file);
        assert_eq!(text.matches(from).count(), 1, "{file}: {from}");
        assert_ne!(from, to);
        let row = table
            .lines()
            .find(|line| line.starts_with(&format!("| {rule} |")));
        let row = row.unwrap_or_else(|| panic!("no row for: {rule}"));
        let is_noticed = !row.contains("| nothing |") && !row.contains("`the build alone`");
        assert!(is_noticed, "{row}");
    }
}
