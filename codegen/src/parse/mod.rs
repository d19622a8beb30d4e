//! From tokens to [`Ast`].
//!
//! In come the tokens between the braces of `model! { … }`, out goes the list of statements, or every
//! mistake in the grammar: after one, reading goes on behind the next `;` or block. From here on
//! expressions are flat lists and numbers are exact.

mod advice;
mod block;
mod cursor;
mod expression;
mod name;
mod number;
mod requirement;
mod scene;
mod statement;
#[cfg(test)]
mod tests;
mod tokens;
mod types;

pub use name::ascii_spelling;
pub use scene::parse_scene;
pub use scene::parse_scene_leniently;

use crate::ast::Ast;
use crate::ast::Expr;
use crate::ast::Expression;
use crate::ast::Item;
use crate::ast::UnitExpr;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use cursor::Cursor;
use cursor::Parsed;
use proc_macro2::Delimiter;
use proc_macro2::Literal;
use proc_macro2::Span;
use proc_macro2::TokenStream;
use tokens::Kind;

/// Reads a model; `name` is the stem of its file.
///
/// # Errors
/// Every mistake in the grammar.
pub fn parse(name: &str, tokens: TokenStream) -> Result<Ast, Errors> {
    let (ast, errors) = read(name, tokens, None);
    errors.or(ast)
}

/// Reads a model as if all of it stood at `place`, for a text that is not the one to point into.
///
/// # Errors
/// Every mistake in the grammar.
pub fn parse_at(name: &str, tokens: TokenStream, place: Span) -> Result<Ast, Errors> {
    let (ast, errors) = read(name, tokens, Some(place));
    errors.or(ast)
}

/// What can be read of a model, whatever its mistakes.
pub fn parse_leniently(name: &str, tokens: TokenStream) -> Ast {
    read(name, tokens, None).0
}

/// What could be read, and every mistake. Of a declaration with a mistake its name is kept, and its type if
/// that much is right.
fn read(name: &str, tokens: TokenStream, place: Option<Span>) -> (Ast, Errors) {
    let mut parser = Parser::default();
    let mut tokens = tokens::flatten(tokens).unwrap_or_else(|error| {
        parser.errors = Errors::from(error);
        Vec::new()
    });
    if let Some(place) = place {
        tokens.iter_mut().for_each(|token| token.span = place);
    }
    let mut cursor = Cursor::new(&tokens);
    let range = match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => Range::of(first.span).to(Range::of(last.span)),
        _ => Range::of(Span::call_site()),
    };
    let (doc, items) = parser.file(&mut cursor);
    let ast = Ast {
        name: name.to_owned(),
        doc,
        items,
        exprs: parser.exprs,
        range,
    };
    (ast, parser.errors)
}

/// Reads a lone expression, such as a value on the command line.
pub fn parse_expression(tokens: TokenStream) -> Result<Expression, Errors> {
    let tokens = tokens::flatten(tokens)?;
    let mut parser = Parser::default();
    let mut cursor = Cursor::new(&tokens);
    let root = parser.expression(&mut cursor)?;
    expression::finish(cursor, "an operator or the end")?;
    Ok(Expression {
        exprs: parser.exprs,
        root,
    })
}

/// Reads a lone unit, such as one that a description gives.
pub fn parse_unit(tokens: TokenStream) -> Result<UnitExpr, Errors> {
    let tokens = tokens::flatten(tokens)?;
    let mut cursor = Cursor::new(&tokens);
    let unit = types::unit(&mut cursor)?;
    expression::finish(cursor, "`*`, `/` or the end")?;
    Ok(unit)
}

/// What has been read so far.
#[derive(Default)]
struct Parser {
    exprs: Vec<Expr>,
    errors: Errors,
}

impl Parser {
    /// All statements, and the doc lines of the model.
    fn file(&mut self, cursor: &mut Cursor) -> (Vec<String>, Vec<Item>) {
        let (mut model_doc, mut items) = (Vec::new(), Vec::new());
        let mut is_first = true;
        while !cursor.is_at_end() {
            let start = cursor.position();
            let mut begun = *cursor;
            let read = self.doc_lines(cursor).and_then(|(inner, outer)| {
                if !is_first && !inner.is_empty() {
                    let message = "expected the `//!` lines of the model above its first statement";
                    self.errors.push(cursor.here(), message);
                }
                let own_doc = if is_first && inner.is_empty() {
                    model_doc = outer;
                    Vec::new()
                } else {
                    model_doc.extend(inner);
                    outer
                };
                is_first = false;
                if cursor.is_at_end() || cursor.eat_punct(';') {
                    return Ok(None);
                }
                begun = *cursor;
                self.statement(cursor, own_doc).map(Some)
            });
            match read {
                Ok(item) => items.extend(item),
                Err(diagnostic) => {
                    self.errors.add(diagnostic);
                    items.extend(self.remnant(begun));
                    recover(cursor, start, statement::is_keyword);
                }
            }
        }
        (model_doc, items)
    }

    /// The `//!` and the `///` lines here.
    fn doc_lines(&mut self, cursor: &mut Cursor) -> Parsed<(Vec<String>, Vec<String>)> {
        let (mut inner, mut outer) = (Vec::new(), Vec::new());
        while cursor.peeks_punct('#') {
            let attribute = cursor.here();
            cursor.skip();
            let lines = if cursor.eat_punct('!') {
                &mut inner
            } else {
                &mut outer
            };
            let mut inside = cursor.enter(Delimiter::Bracket)?;
            let is_doc = inside.eat_word("doc") && inside.eat_punct('=');
            let line = match inside.peek() {
                Some(Kind::Literal(literal)) if is_doc => string_value(literal),
                _ => None,
            };
            match line {
                Some(line) => {
                    lines.push(
                        line.strip_prefix(' ')
                            .unwrap_or(&line)
                            .trim_end()
                            .to_owned(),
                    );
                }
                None => self.errors.push(
                    attribute.to(cursor.previous()),
                    "expected a statement, found an attribute",
                ),
            }
        }
        Ok((inner, outer))
    }
}

/// Passes the rest of a statement with a mistake that began at token `start`: up to a `;` or the end
/// of a block, or up to the next keyword.
fn recover(cursor: &mut Cursor, start: usize, is_keyword: fn(Option<&Kind>) -> bool) {
    while !cursor.is_at_end() {
        if cursor.position() > start && is_keyword(cursor.peek()) {
            return;
        }
        let is_block = cursor.peeks_open(Delimiter::Brace);
        if cursor.eat_punct(';') {
            return;
        }
        cursor.skip();
        if is_block {
            return;
        }
    }
}

/// The characters of a string literal.
fn string_value(literal: &Literal) -> Option<String> {
    match syn::Lit::new(literal.clone()) {
        syn::Lit::Str(string) => Some(string.value()),
        _ => None,
    }
}
