//! Runs the command.

use std::path::PathBuf;
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

/// `residua ARGUMENTS`
pub fn residua(arguments: &[&str]) -> Outcome {
    let output = Command::new(env!("CARGO_BIN_EXE_residua"))
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    Outcome {
        code: output.status.code().unwrap(),
        stdout: String::from_utf8(output.stdout).unwrap(),
        stderr: String::from_utf8(output.stderr).unwrap(),
    }
}

/// An empty folder for one test.
pub fn folder(test: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).unwrap();
    path
}

/// Asserts the exit code and that the one message holds all of `parts`.
pub fn assert_refused(arguments: &[&str], code: i32, parts: &[&str]) {
    let outcome = residua(arguments);
    let stderr = outcome.stderr;
    assert_eq!(outcome.code, code, "{arguments:?}\n{stderr}");
    assert_eq!(
        stderr.matches("error:").count(),
        1,
        "{arguments:?}\n{stderr}"
    );
    for part in parts {
        assert!(
            stderr.contains(part),
            "{arguments:?}: no `{part}` in\n{stderr}"
        );
    }
}
