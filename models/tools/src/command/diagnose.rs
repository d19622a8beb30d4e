//! Mistakes in a model file or a scene file, shown in the file.

use crate::failure::Failure;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use proc_macro2::{LineColumn, TokenStream};
use residua_codegen::diagnostic::{self, Diagnostic, Errors};
use residua_codegen::source::{SourceError, read_scene, read_source};
use residua_models::{Entry, find};
use std::fs;
use std::io::{self, IsTerminal};
use std::ops::Range;
use std::path::Path;

/// Compiles the model or scene file at `path`, or prints what is wrong with it on stderr.
pub fn compile_file(path: &Path) -> Result<TokenStream, Failure> {
    let bytes = fs::read(path)
        .map_err(|error| Failure::input(format!("cannot read {}: {error}", path.display())))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    crate::name::check(&name).map_err(Failure::input)?;
    let text = String::from_utf8_lossy(&bytes);
    let shown = path.display().to_string();
    if path.extension().is_none_or(|ending| ending != "scene") {
        return compile(&shown, &text, read_source(&bytes), &|tokens| {
            residua_codegen::compile(&name, tokens)
        });
    }
    let read = |model: &str| {
        let path = path.with_file_name(format!("{model}.model"));
        fs::read_to_string(&path)
            .map_err(|error| format!("cannot read `{}`: {error}", path.display()))
    };
    compile(&shown, &text, read_scene(&bytes), &|tokens| {
        residua_codegen::compile_scene(&name, tokens, &read)
    })
}

/// Compiles a model or a scene of the catalogue once more.
pub fn compile_entry(entry: &Entry) -> Result<TokenStream, Failure> {
    let (name, text) = (entry.name(), entry.source);
    if entry.catalogued.description.scene.is_none() {
        let tokens = read_source(text.as_bytes());
        return compile(&format!("{name}.model"), text, tokens, &|tokens| {
            residua_codegen::compile(name, tokens)
        });
    }
    let read = |model: &str| match find(model) {
        Ok(model) => Ok(model.source.to_owned()),
        Err(unknown) => Err(format!("{unknown} in the catalogue")),
    };
    let tokens = read_scene(text.as_bytes());
    compile(&format!("{name}.scene"), text, tokens, &|tokens| {
        residua_codegen::compile_scene(name, tokens, &read)
    })
}

/// Compiles the text of a file, or prints what is wrong with it on stderr.
fn compile(
    shown: &str,
    text: &str,
    tokens: Result<TokenStream, SourceError>,
    compiled: &dyn Fn(TokenStream) -> Result<TokenStream, Errors>,
) -> Result<TokenStream, Failure> {
    let tokens = tokens.map_err(|error| {
        let at = LineColumn {
            line: error.line,
            column: error.column.saturating_sub(1),
        };
        let start = offset(text, at);
        let end = start + text[start..].chars().next().map_or(0, char::len_utf8);
        print(shown, text, &error.message, start..end, None);
        tell!("{shown}: 1 mistake, and the rest is not read");
        Failure::Reported(2)
    })?;
    compiled(tokens).map_err(|errors| {
        let mistakes = errors.into_sorted();
        let count = match mistakes.len() {
            1 => "1 mistake".to_owned(),
            n => format!("{n} mistakes"),
        };
        for Diagnostic {
            range,
            message,
            help,
        } in mistakes
        {
            print(shown, text, &message, place(text, range), help.as_deref());
        }
        tell!("{shown}: {count}");
        Failure::Reported(2)
    })
}

fn print(path: &str, text: &str, message: &str, place: Range<usize>, help: Option<&str>) {
    tell!(
        "{}\n",
        snippet(Level::ERROR, path, text, message, place, help)
    );
}

/// A message, and the place in the text that it is about.
pub fn snippet(
    level: Level,
    path: &str,
    text: &str,
    message: &str,
    place: Range<usize>,
    help: Option<&str>,
) -> String {
    let place =
        place.start.min(text.len())..place.end.clamp(place.start, text.len().max(place.start));
    let snippet = Snippet::source(text)
        .path(path)
        .annotation(AnnotationKind::Primary.span(place));
    let mut group = level.primary_title(message).element(snippet);
    if let Some(help) = help {
        group = group.element(Level::HELP.message(help));
    }
    let renderer = match io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none() {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    renderer.render(&[group])
}

/// The bytes of `text` that an expression takes.
pub fn place(text: &str, range: diagnostic::Range) -> Range<usize> {
    offset(text, range.start.start())..offset(text, range.end.end())
}

/// What is written there, on one line.
pub fn excerpt(text: &str, range: diagnostic::Range) -> String {
    let written = text.get(place(text, range)).unwrap_or_default();
    let words: Vec<&str> = written.split_whitespace().collect();
    format!("`{}`", words.join(" "))
}

/// Byte position of a line, counted from 1, and a column, counted in characters from 0.
fn offset(text: &str, at: LineColumn) -> usize {
    let mut start = 0;
    for line in text.split_inclusive('\n').take(at.line.saturating_sub(1)) {
        start += line.len();
    }
    let line = &text[start..];
    let column = line.char_indices().nth(at.column);
    start + column.map_or(line.len(), |(byte, _)| byte)
}
