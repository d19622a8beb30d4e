//! Runs the command.

#![allow(
    dead_code,
    reason = "each test program includes this file and uses some of it"
)]

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// What a run of the command left behind.
pub struct Outcome {
    /// Exit code.
    pub code: i32,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// Runs `residua` with the words of `line`.
pub fn residua(line: &str) -> Outcome {
    residua_in(Path::new("."), line)
}

/// Runs `residua` with the words of `line` in a folder.
pub fn residua_in(folder: &Path, line: &str) -> Outcome {
    let output = Command::new(env!("CARGO_BIN_EXE_residua"))
        .args(line.split_whitespace())
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    Outcome {
        code: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs `residua`, which must succeed.
pub fn succeed(line: &str) -> Outcome {
    let outcome = residua(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    outcome
}

/// An empty folder for one test.
pub fn folder(test: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// Asserts that there is one message, which holds all of `parts`, and the exit code.
pub fn assert_refused(outcome: &Outcome, code: i32, parts: &[&str]) {
    let stderr = &outcome.stderr;
    assert_eq!(outcome.code, code, "{stderr}");
    assert_eq!(stderr.matches("error:").count(), 1, "{stderr}");
    for part in parts {
        assert!(stderr.contains(part), "no `{part}` in\n{stderr}");
    }
}
