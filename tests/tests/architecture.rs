//! The shape of the generator: stages know data, never each other.

use std::fs;
use std::path::Path;

/// Modules that turn one data type into another, with what belongs to each.
const STAGES: [&str; 16] = [
    "parse",
    "check",
    "lower",
    "differentiate",
    "specialise",
    "explicit",
    "finite",
    "structure",
    "eliminate",
    "correct",
    "clear",
    "change",
    "claims",
    "stage",
    "emit",
    "source",
];

/// What runs stages: all of them in their order, and the first few of them to evaluate a model as written.
const DRIVERS: [&str; 2] = ["compile", "trace"];

/// Longest file by house style.
const LONGEST: usize = 500;

fn sources(folder: &Path) -> Vec<std::path::PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)
        .expect("a folder of the workspace")
        .flatten()
    {
        let path = entry.path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

#[test]
fn no_stage_imports_another_stage() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../codegen/src");
    let mut offences = Vec::new();
    for path in sources(&root) {
        let relative = path.strip_prefix(&root).expect("below the root").to_owned();
        let first = relative
            .iter()
            .next()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let own = first.trim_end_matches(".rs");
        let is_test = relative.ends_with("tests.rs");
        if DRIVERS.contains(&own) || first == "lib.rs" || is_test {
            continue;
        }
        for line in fs::read_to_string(&path).expect("a source file").lines() {
            let Some(used) = line
                .trim()
                .split("crate::")
                .nth(1)
                .filter(|_| !line.trim().starts_with("//"))
            else {
                continue;
            };
            let module = used.split([':', ';', ' ']).next().unwrap_or_default();
            if STAGES.contains(&module) && module != own {
                offences.push(format!("{}: {}", relative.display(), line.trim()));
            }
        }
    }
    assert!(offences.is_empty(), "{offences:#?}");
}

#[test]
fn no_source_file_outgrows_its_reader() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for package in ["codegen", "runtime", "models", "tests"] {
        for path in sources(&root.join(package)) {
            if path.iter().any(|part| part == "target" || part == "golden") {
                continue;
            }
            let lines = fs::read_to_string(&path)
                .expect("a source file")
                .lines()
                .count();
            assert!(lines <= LONGEST, "{} has {lines} lines", path.display());
        }
    }
}
