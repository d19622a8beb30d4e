//! Writes the catalogue: one module per file in `dsl/`, and the list of them.
//!
//! Mistakes in a model are left to the macro, whose carets point into the file. Only what rustc
//! cannot read or must not see (not UTF-8, huge, very deep) is reported from here.

use residua_codegen::source::{SourceError, read_source};
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use std::{env, fs};

#[path = "src/command/name.rs"]
mod name;

fn main() -> io::Result<()> {
    // A folder is scanned whole: new, removed and edited files run this script again.
    println!("cargo::rerun-if-changed=dsl");
    let mut modules = String::new();
    let mut entries = String::new();
    for path in model_files(Path::new("dsl"))? {
        add(&path, &fs::read(&path)?, &mut modules, &mut entries);
    }
    let catalogue = format!(
        "{modules}\n/// Every model, by name.\npub static CATALOGUE: &[crate::Entry] = &[\n{entries}];\n"
    );
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("catalogue.rs");
    fs::write(out, catalogue)
}

/// The `.model` files of a folder, sorted.
fn model_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let is_model = path
            .extension()
            .is_some_and(|extension| extension == "model");
        if is_model && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Adds the module of one file, and its entry where it has a model.
fn add(path: &Path, bytes: &[u8], modules: &mut String, entries: &mut String) {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let shown = format!("models/dsl/{stem}.model");
    if let Err(message) = name::check(&stem) {
        refuse(&format!("{shown}: {message}"), modules);
        return;
    }
    let file = format!("concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/dsl/{stem}.model\")");
    let include = format!(
        "#[doc = \"The model of `{stem}.model`.\"]\npub mod {stem} {{\n    use ::residua::model;\n    include!({file});\n}}\n"
    );
    match read_source(bytes) {
        Ok(_) => {
            modules.push_str(&include);
            let entry = format!(
                "crate::Entry {{ catalogued: &{stem}::MODEL, source: include_str!({file}) }}"
            );
            let _ = writeln!(entries, "    {entry},");
        }
        // rustc's own lexer shows these in the file; without an entry nothing follows from them.
        Err(error) if error.lexical => modules.push_str(&include),
        Err(SourceError {
            line,
            column,
            message,
            ..
        }) => {
            refuse(&format!("{shown}:{line}:{column}: {message}"), modules);
        }
    }
}

fn refuse(message: &str, modules: &mut String) {
    let _ = writeln!(modules, "compile_error!({message:?});");
}
