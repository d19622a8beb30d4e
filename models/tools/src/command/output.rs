//! Where results and remarks go.

use crate::failure::Failure;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

/// A line for people, on stderr; a run does not fail because nobody can read it.
macro_rules! tell {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($text)*);
    }};
}

/// `-`
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// A new file, or an old one emptied.
pub fn create(path: &Path) -> Result<File, Failure> {
    File::create(path).map_err(|error| Failure::file("write", path, &error))
}

/// Two names of one file.
pub fn is_same(a: &Path, b: &Path) -> bool {
    a == b || matches!((place(a), place(b)), (Some(a), Some(b)) if a == b)
}

/// Where a file is, or where a new one would be.
fn place(path: &Path) -> Option<PathBuf> {
    if let Ok(place) = fs::canonicalize(path) {
        return Some(place);
    }
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    Some(fs::canonicalize(folder).ok()?.join(path.file_name()?))
}
