//! From the bytes of a model file to the tokens inside its `model! { … }`, and likewise of a scene file.
//!
//! For programs that read whole files: build scripts and the command. In a build the file is included
//! and rustc reads it; what this stage refuses beforehand is what rustc would choke on (bytes that are
//! not UTF-8, brackets nested without end) or report less well.

mod blocks;

use blocks::Blocks;
use proc_macro2::Delimiter;
use proc_macro2::TokenStream;
use proc_macro2::TokenTree;
use std::fmt;
use std::str::FromStr;

/// Largest file, in bytes. The largest model here has 4 kB.
const LARGEST: usize = 1 << 20;

/// Deepest nesting of brackets: what the parser admits inside the braces, and some room.
const DEEPEST: usize = 80;

/// Why a file holds no model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceError {
    /// Line, counted from 1.
    pub line: usize,
    /// Character in the line, counted from 1.
    pub column: usize,
    /// What was found and what was expected.
    pub message: String,
    /// rustc's lexer reports it too, with a caret.
    pub lexical: bool,
}

impl fmt::Display for SourceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl std::error::Error for SourceError {}

/// The tokens between the braces of the one `model! { … }` in a file.
///
/// # Errors
/// The first reason why there is none.
pub fn read_source(bytes: &[u8]) -> Result<TokenStream, SourceError> {
    read(bytes, "model")
}

/// The tokens between the braces of the one `scene! { … }` in a file.
///
/// # Errors
/// The first reason why there is none.
pub fn read_scene(bytes: &[u8]) -> Result<TokenStream, SourceError> {
    read(bytes, "scene")
}

fn read(bytes: &[u8], keyword: &str) -> Result<TokenStream, SourceError> {
    if bytes.len() > LARGEST {
        let message = format!(
            "the file has {} bytes, expected at most {LARGEST}",
            bytes.len()
        );
        return Err(at(1, 1, message));
    }
    let text = std::str::from_utf8(bytes).map_err(|error| not_utf8(bytes, error.valid_up_to()))?;
    invocation(lex(text)?, keyword)
}

/// The tokens of `text`, once its brackets are known to match and not to nest too deeply.
///
/// # Errors
/// The first bracket or character that is out of place.
pub fn lex(text: &str) -> Result<TokenStream, SourceError> {
    check_brackets(text)?;
    TokenStream::from_str(text).map_err(|error| {
        let start = error.span().start();
        let line = text.lines().nth(start.line - 1).unwrap_or_default();
        let message = match line.chars().nth(start.column) {
            Some(character) => foreign(character),
            None => "expected a number, a name or a sign".to_owned(),
        };
        SourceError {
            lexical: true,
            ..at(start.line, start.column + 1, message)
        }
    })
}

/// What to write for a character that no model contains.
fn foreign(character: char) -> String {
    let write = match character {
        '\'' => "expected x.T for the transpose or der(x) for the rate",
        '∆' => "expected the Greek letter `Δ`, U+0394",
        '−' | '–' => "expected the ASCII `-`",
        '×' | '⋅' | '∗' => "expected `*`",
        '÷' => "expected `/`",
        '²' => "expected `^2`",
        '³' => "expected `^3`",
        'ᵀ' | '⊤' => "expected `.T`",
        '½' => "expected `1/2`",
        '√' => "expected sqrt(x)",
        '∂' | '∇' => "derivatives are taken by the generator",
        '₀'..='₉' => "expected a plain digit, as in `Γ1`",
        _ => "expected a number, a name or a sign",
    };
    let shown = if character.is_control() {
        character.escape_unicode().to_string()
    } else {
        character.to_string()
    };
    format!("found `{shown}`, {write}")
}

fn at(line: usize, column: usize, message: String) -> SourceError {
    SourceError {
        line,
        column,
        message,
        lexical: false,
    }
}

fn not_utf8(bytes: &[u8], valid: usize) -> SourceError {
    let before = String::from_utf8_lossy(&bytes[..valid]);
    let line = before.lines().count().max(1);
    let column = before.lines().last().map_or(0, |line| line.chars().count()) + 1;
    let message = format!("byte {valid} (0x{:02x}) is not UTF-8", bytes[valid]);
    at(line, column, message)
}

/// Walks over the text outside comments and strings, keeping the brackets that are open.
fn check_brackets(text: &str) -> Result<(), SourceError> {
    let mut open: Vec<(char, usize, usize)> = Vec::new();
    let mut blocks = Blocks::default();
    let mut skip = Skip::Nothing;
    let mut skipped_from = (1, 1);
    let mut before = ' ';
    let (mut line, mut column) = (1, 0);
    for character in text.chars() {
        column += 1;
        let was = skip;
        skip = skip.after(before, character);
        if was == Skip::Nothing {
            skipped_from = (line, column);
        }
        if was == Skip::Nothing && skip == Skip::Nothing {
            blocks.take(character, (line, column), &open);
            match character {
                '(' | '[' | '{' => open.push((character, line, column)),
                ')' | ']' | '}' => {
                    let closed = close(&mut open, character, line, column);
                    closed.map_err(|error| match &blocks.unopened {
                        Some((keyword, place)) => unopened(keyword, *place),
                        None => error,
                    })?;
                }
                _ => {}
            }
            if open.len() > DEEPEST {
                let message = format!("brackets nest more than {DEEPEST} deep");
                return Err(at(line, column, message));
            }
        }
        // What has ended a comment or an escape does not begin another.
        before = if was != Skip::Nothing && (skip != was || before == '\\') {
            ' '
        } else {
            character
        };
        if character == '\n' {
            (line, column) = (line + 1, 0);
        }
    }
    let unclosed = match (skip, open.last()) {
        (Skip::String, _) => Some(("string".to_owned(), skipped_from)),
        (Skip::Block(_), _) => Some(("comment".to_owned(), skipped_from)),
        (Skip::Nothing | Skip::Line, Some(&(bracket, line, column))) => {
            let place = blocks.unclosed.filter(|_| bracket == '{');
            Some((format!("`{bracket}`"), place.unwrap_or((line, column))))
        }
        (Skip::Nothing | Skip::Line, None) => None,
    };
    unclosed.map_or(Ok(()), |(what, (line, column))| {
        Err(SourceError {
            lexical: true,
            ..at(line, column, format!("this {what} is never closed"))
        })
    })
}

fn unopened(keyword: &str, (line, column): (usize, usize)) -> SourceError {
    SourceError {
        lexical: true,
        ..at(line, column, format!("expected `{{` behind `{keyword}`"))
    }
}

fn close(
    open: &mut Vec<(char, usize, usize)>,
    bracket: char,
    line: usize,
    column: usize,
) -> Result<(), SourceError> {
    let message = match (open.pop(), bracket) {
        (Some(('(', ..)), ')') | (Some(('[', ..)), ']') | (Some(('{', ..)), '}') => return Ok(()),
        (Some((opened, line, _)), _) => {
            format!("this `{bracket}` does not close the `{opened}` of line {line}")
        }
        (None, _) => format!("this `{bracket}` closes nothing"),
    };
    Err(SourceError {
        lexical: true,
        ..at(line, column, message)
    })
}

/// Text in which brackets do not count.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Skip {
    Nothing,
    Line,
    /// Comments nest.
    Block(usize),
    String,
}

impl Skip {
    fn after(self, before: char, character: char) -> Self {
        match (self, before, character) {
            (Skip::Nothing, '/', '/') => Skip::Line,
            (Skip::Nothing, '/', '*') => Skip::Block(1),
            (Skip::Nothing, _, '"') => Skip::String,
            (Skip::Line, _, '\n') => Skip::Nothing,
            (Skip::Block(1), '*', '/') => Skip::Nothing,
            (Skip::Block(depth), '*', '/') => Skip::Block(depth - 1),
            (Skip::Block(depth), '/', '*') => Skip::Block(depth + 1),
            (Skip::String, '\\', _) => Skip::String,
            (Skip::String, _, '"') => Skip::Nothing,
            (same, ..) => same,
        }
    }
}

/// The tokens inside `model! { … }` or `residua::model! { … }`, which must be all there is; likewise of another
/// keyword.
fn invocation(tokens: TokenStream, keyword: &str) -> Result<TokenStream, SourceError> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let is_punct = |tree: &TokenTree, c| matches!(tree, TokenTree::Punct(p) if p.as_char() == c);
    let position = trees.windows(2).position(|pair| {
        matches!(&pair[0], TokenTree::Ident(name) if *name == keyword) && is_punct(&pair[1], '!')
    });
    let Some(start) = position else {
        return Err(at(1, 1, format!("expected `{keyword}! {{ … }}`")));
    };
    let is_path = |tree: &TokenTree| {
        is_punct(tree, ':') || matches!(tree, TokenTree::Ident(name) if *name == "residua")
    };
    if let Some(stray) = trees[..start].iter().find(|tree| !is_path(tree)) {
        return Err(stray_token(stray, keyword));
    }
    let body = match trees.get(start + 2) {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => group.stream(),
        _ => {
            let place = trees[start].span().start();
            return Err(at(
                place.line,
                place.column + 1,
                format!("expected `{keyword}! {{ … }}`"),
            ));
        }
    };
    match trees[start + 3..].iter().find(|tree| !is_punct(tree, ';')) {
        Some(stray) => Err(stray_token(stray, keyword)),
        None => Ok(body),
    }
}

fn stray_token(tree: &TokenTree, keyword: &str) -> SourceError {
    let place = tree.span().start();
    let message = format!("expected nothing but one `{keyword}! {{ … }}` in the file");
    at(place.line, place.column + 1, message)
}

#[cfg(test)]
mod tests;
