//! Breaks the code in every way of [`residua_tests::mutations`], one at a time, in a copy of the workspace, and sees which test
//! notices: `cargo run --release -p residua-tests --example mutate [WORD...]` for all, or those whose rule or file has one of the words.
//!
//! It takes a quarter of an hour. The table goes to `tests/MUTATIONS.md`; with words, to the screen only.

use residua_tests::mutations::{ALL, Mutation};
use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What the workspace consists of.
const PARTS: [&str; 7] = [
    "Cargo.toml",
    "Cargo.lock",
    "README.md",
    "codegen",
    "models",
    "runtime",
    "tests",
];

/// Tests, quickest first: what a package gets wrong is for its own to notice.
const ATTEMPTS: [&[&str]; 3] = [
    &["-p", "residua", "--lib"],
    &["-p", "residua-codegen", "--lib"],
    &["-p", "residua-codegen"],
];

fn main() -> io::Result<()> {
    let words: Vec<String> = env::args().skip(1).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .canonicalize()?;
    let copy = root.join("target/mutations/workspace");
    if copy.exists() {
        fs::remove_dir_all(&copy)?;
    }
    fs::create_dir_all(&copy)?;
    for part in PARTS {
        copy_all(&root.join(part), &copy.join(part))?;
    }
    let mut proved = [false; ATTEMPTS.len()];
    let mut table = String::from(
        "# Ways to break the code, and the test that notices first\n\n\
         Written by `cargo run --release -p residua-tests --example mutate`. Each row is one change of the code, by itself.\n\n\
         | broken | in | noticed by |\n|---|---|---|\n",
    );
    for Mutation {
        rule,
        file,
        from,
        to,
    } in ALL.iter().filter(|m| {
        words.is_empty()
            || words
                .iter()
                .any(|word| m.rule.contains(word) || m.file.contains(word))
    }) {
        let path = copy.join(file);
        let text = fs::read_to_string(&path)?;
        fs::write(&path, text.replacen(from, to, 1))?;
        let noticed = noticing(&copy, file, (&path, &text), &mut proved)?;
        fs::write(&path, text)?;
        let noticed = noticed.map_or("nothing".to_owned(), |test| format!("`{test}`"));
        let row = format!("| {rule} | `{file}` | {noticed} |\n");
        print!("{row}");
        table.push_str(&row);
    }
    if words.is_empty() {
        fs::write(root.join("tests/MUTATIONS.md"), table)?;
    }
    Ok(())
}

/// The first test that fails of the package that `file` is of. An attempt counts once it is proved that it
/// passes with the `whole` file.
fn noticing(
    workspace: &Path,
    file: &str,
    whole: (&Path, &str),
    proved: &mut [bool],
) -> io::Result<Option<String>> {
    for (attempt, is_proved) in ATTEMPTS.into_iter().zip(proved) {
        let own = if attempt[1] == "residua" {
            "runtime"
        } else {
            "codegen"
        };
        if !file.starts_with(own) {
            continue;
        }
        let Some(failed) = failing(workspace, attempt)? else {
            *is_proved = true;
            continue;
        };
        if !*is_proved {
            let broken = fs::read_to_string(whole.0)?;
            fs::write(whole.0, whole.1)?;
            if let Some(test) = failing(workspace, attempt)? {
                return Err(io::Error::other(format!("unbroken code fails {test}")));
            }
            fs::write(whole.0, broken)?;
            *is_proved = true;
        }
        return Ok(Some(failed));
    }
    Ok(None)
}

/// The first test that fails.
fn failing(workspace: &Path, attempt: &[&str]) -> io::Result<Option<String>> {
    let output = Command::new(env!("CARGO"))
        .arg("test")
        .args(attempt)
        .args(["--", "--skip", "every_mutation_has_its_place"])
        .current_dir(workspace)
        .env("CARGO_TARGET_DIR", workspace.join("../target"))
        .env("CARGO_PROFILE_DEV_OPT_LEVEL", "1")
        .output()?;
    if output.status.success() {
        return Ok(None);
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let is_failed = |line: &&str| line.starts_with("test ") && line.contains("FAILED");
    let name = text
        .lines()
        .find(is_failed)
        .and_then(|line| line.split_whitespace().nth(1));
    // Code that does not compile, or a test that never ends, is noticed as well, but proves nothing about tests.
    Ok(Some(name.unwrap_or("the build alone").to_owned()))
}

/// Copies a file or a folder, without what is built.
fn copy_all(from: &Path, to: &Path) -> io::Result<()> {
    let mut open: Vec<(PathBuf, PathBuf)> = vec![(from.to_owned(), to.to_owned())];
    while let Some((from, to)) = open.pop() {
        if from.is_dir() {
            if from.file_name().is_some_and(|name| name == "target") {
                continue;
            }
            fs::create_dir_all(&to)?;
            for entry in fs::read_dir(from)? {
                let entry = entry?;
                open.push((entry.path(), to.join(entry.file_name())));
            }
        } else {
            fs::copy(from, to)?;
        }
    }
    Ok(())
}
