//! Where results and remarks go.

use crate::failure::Failure;
use std::ffi::OsStr;
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

/// A new file for a picture, which is SVG whatever it is called.
pub fn create_picture(path: &Path) -> Result<File, Failure> {
    let extension = path.extension().and_then(OsStr::to_str);
    match extension {
        Some(other) if !other.eq_ignore_ascii_case("svg") => Err(Failure::input_with_help(
            format!("{} would hold SVG, not {other}", path.display()),
            format!("write to {}", path.with_extension("svg").display()),
        )),
        _ => create(path),
    }
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
