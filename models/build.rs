//! Writes the catalogue: one module per file in `dsl/`, and the lists of models and scenes.
//!
//! Mistakes in a model or a scene are left to the macro, whose carets point into the file. Only what rustc
//! cannot read or must not see (not UTF-8, huge, very deep) is reported from here.

use residua_codegen::source::{SourceError, read_scene, read_source};
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};
use std::{env, fs};

#[path = "tools/src/command/name.rs"]
mod name;

/// A kind of file.
struct Kind {
    ending: &'static str,
    list: &'static str,
    doc: &'static str,
}

static MODELS: Kind = Kind {
    ending: "model",
    list: "CATALOGUE",
    doc: "Every model, by name.",
};

static SCENES: Kind = Kind {
    ending: "scene",
    list: "SCENES",
    doc: "Every scene, by name.",
};

fn main() -> io::Result<()> {
    // A folder is scanned whole: new, removed and edited files run this script again.
    println!("cargo::rerun-if-changed=dsl");
    let mut modules = String::new();
    let mut lists = String::new();
    for kind in [&MODELS, &SCENES] {
        let mut entries = String::new();
        for path in files(Path::new("dsl"), kind.ending)? {
            add(kind, &path, &fs::read(&path)?, &mut modules, &mut entries);
        }
        let Kind { list, doc, .. } = kind;
        let _ = writeln!(
            lists,
            "\n/// {doc}\npub static {list}: &[crate::Entry] = &[\n{entries}];"
        );
    }
    // Of what has continuous equations and what has none, so it may be that one of them is not used.
    let probes = "#[allow(unused_imports)]\nuse crate::exact::WithoutFlow as _;\n#[cfg(feature = \"rivals\")]\n#[allow(unused_imports)]\nuse crate::rivals::WithoutFlow as _;\n";
    let catalogue = modules + probes + &lists;
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("catalogue.rs");
    fs::write(out, catalogue)
}

/// The files of a folder with this ending, sorted.
fn files(folder: &Path, ending: &str) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|e| e == ending) && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Adds the module of one file, and its entry where it has a model.
fn add(kind: &Kind, path: &Path, bytes: &[u8], modules: &mut String, entries: &mut String) {
    let ending = kind.ending;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let shown = format!("models/dsl/{stem}.{ending}");
    if let Err(message) = name::check(&stem) {
        refuse(&format!("{shown}: {message}"), modules);
        return;
    }
    if ending == "scene" && path.with_extension("model").exists() {
        refuse(
            &format!(
                "{shown}: there is a model `{stem}` too, and both would be the module `{stem}`"
            ),
            modules,
        );
        return;
    }
    let file = format!("concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/dsl/{stem}.{ending}\")");
    let include = format!(
        "#[doc = \"The {ending} of `{stem}.{ending}`.\"]\npub mod {stem} {{\n    use ::residua::{ending};\n    include!({file});\n}}\n"
    );
    let read = match ending {
        "scene" => read_scene(bytes),
        _ => read_source(bytes),
    };
    match read {
        Ok(_) => {
            modules.push_str(&include);
            let entry = format!(
                "crate::Entry {{ catalogued: &{stem}::MODEL, source: include_str!({file}), extended: crate::exact::Probe::<{stem}::Model>::EXTENDED, #[cfg(feature = \"rivals\")] rivals: crate::rivals::Probe::<{stem}::Model>::RIVALS }}"
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
