//! Mistakes in a model file, shown in the file.

use crate::failure::Failure;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use proc_macro2::{LineColumn, TokenStream};
use residua_codegen::diagnostic::Diagnostic;
use residua_codegen::source::{SourceError, read_source};
use std::fs;
use std::io::{self, IsTerminal};
use std::ops::Range;
use std::path::Path;

/// Compiles the model file at `path`, or prints what is wrong with it on stderr.
pub fn compile_file(path: &Path) -> Result<TokenStream, Failure> {
    let bytes = fs::read(path)
        .map_err(|error| Failure::input(format!("cannot read {}: {error}", path.display())))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    crate::name::check(&name).map_err(Failure::input)?;
    let text = String::from_utf8_lossy(&bytes);
    let shown = path.display().to_string();
    compile(&name, &shown, &text, read_source(&bytes))
}

/// Compiles the text of a model file, or prints what is wrong with it on stderr.
pub fn compile(
    name: &str,
    shown: &str,
    text: &str,
    tokens: Result<TokenStream, SourceError>,
) -> Result<TokenStream, Failure> {
    let tokens = tokens.map_err(|error| {
        let at = LineColumn {
            line: error.line,
            column: error.column.saturating_sub(1),
        };
        let start = offset(text, at);
        let end = start + text[start..].chars().next().map_or(0, char::len_utf8);
        print(shown, text, &error.message, start..end, None);
        eprintln!("{shown}: 1 mistake, and the rest is not read");
        Failure::Reported(2)
    })?;
    residua_codegen::compile(name, tokens).map_err(|errors| {
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
            let place = offset(text, range.start.start())..offset(text, range.end.end());
            print(shown, text, &message, place, help.as_deref());
        }
        eprintln!("{shown}: {count}");
        Failure::Reported(2)
    })
}

fn print(path: &str, text: &str, message: &str, place: Range<usize>, help: Option<&str>) {
    let place =
        place.start.min(text.len())..place.end.clamp(place.start, text.len().max(place.start));
    let snippet = Snippet::source(text)
        .path(path)
        .annotation(AnnotationKind::Primary.span(place));
    let mut group = Level::ERROR.primary_title(message).element(snippet);
    if let Some(help) = help {
        group = group.element(Level::HELP.message(help));
    }
    let renderer = match io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none() {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    eprintln!("{}\n", renderer.render(&[group]));
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
