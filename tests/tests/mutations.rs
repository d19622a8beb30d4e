//! The ways to break the code are still there to be taken, and a test has noticed each.

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

#[test]
fn every_mutation_was_noticed() {
    let table = include_str!("../MUTATIONS.md");
    for Mutation { rule, file, .. } in ALL {
        let start = format!("| {rule} | `{file}` | `");
        let rows: Vec<&str> = table
            .lines()
            .filter(|row| row.starts_with(&start))
            .collect();
        assert!(!rows.is_empty(), "{rule} is not in the table");
        for row in rows {
            assert!(!row.contains("the build alone"), "{row}");
        }
    }
    assert_eq!(
        table.lines().filter(|row| row.starts_with("| ")).count(),
        ALL.len() + 1
    );
}
