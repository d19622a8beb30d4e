//! Scene files.

use super::Parser;
use super::cursor::Cursor;
use super::cursor::Parsed;
use super::recover;
use super::tokens;
use super::tokens::Kind;
use crate::ast::Assignment;
use crate::ast::ExprId;
use crate::ast::Form;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::scene::SceneAst;
use crate::scene::SceneItem;
use crate::similar::most_similar;
use proc_macro2::Delimiter;
use proc_macro2::Span;
use proc_macro2::TokenStream;

/// The words that begin a statement.
const KEYWORDS: [&str; 8] = [
    "model", "fix", "let", "start", "step", "until", "keep", "form",
];

/// Least Jaro-Winkler similarity of a word to the keyword it was meant to be.
const SIMILAR: f64 = 0.8;

/// Reads a scene; `name` is the stem of its file.
///
/// # Errors
/// Every mistake in the grammar.
pub fn parse_scene(name: &str, tokens: TokenStream) -> Result<SceneAst, Errors> {
    let (scene, errors) = read(name, tokens);
    errors.or(scene)
}

/// What can be read of a scene, whatever its mistakes.
pub fn parse_scene_leniently(name: &str, tokens: TokenStream) -> SceneAst {
    read(name, tokens).0
}

fn read(name: &str, tokens: TokenStream) -> (SceneAst, Errors) {
    let mut parser = Parser::default();
    let tokens = tokens::flatten(tokens).unwrap_or_else(|error| {
        parser.errors = Errors::from(error);
        Vec::new()
    });
    let mut cursor = Cursor::new(&tokens);
    let range = match (tokens.first(), tokens.last()) {
        (Some(first), Some(last)) => Range::of(first.span).to(Range::of(last.span)),
        _ => Range::of(Span::call_site()),
    };
    let (mut doc, mut items) = (Vec::new(), Vec::new());
    while !cursor.is_at_end() {
        let start = cursor.position();
        let read = parser.doc_lines(&mut cursor).and_then(|(inner, outer)| {
            // Statements of a scene have no doc of their own: `///` is for the scene too, at the top.
            if items.is_empty() {
                doc.extend(if inner.is_empty() { outer } else { inner });
            }
            if cursor.is_at_end() || cursor.eat_punct(';') {
                return Ok(None);
            }
            parser.scene_statement(&mut cursor).map(Some)
        });
        match read {
            Ok(item) => items.extend(item),
            Err(diagnostic) => {
                parser.errors.add(diagnostic);
                recover(&mut cursor, start, is_keyword);
            }
        }
    }
    let scene = SceneAst {
        name: name.to_owned(),
        doc,
        items,
        exprs: parser.exprs,
        range,
    };
    (scene, parser.errors)
}

impl Parser {
    fn scene_statement(&mut self, cursor: &mut Cursor) -> Parsed<SceneItem> {
        let keyword = cursor.here();
        let word = match cursor.peek() {
            Some(Kind::Ident(word)) if KEYWORDS.contains(&word.as_str()) => word.as_str(),
            _ => return Err(no_statement(*cursor)),
        };
        cursor.skip();
        match word {
            "model" => {
                let name = cursor.expect_name()?;
                self.scene_semicolon(cursor)?;
                Ok(SceneItem::Model(name))
            }
            "fix" => self.fix(cursor),
            "let" => {
                let Assignment { name, value } = self.scene_value(cursor)?;
                Ok(SceneItem::Let(name, value))
            }
            "start" if !cursor.peeks_open(Delimiter::Brace) => {
                Err(cursor.unexpected("`{` behind `start`"))
            }
            "start" => Ok(SceneItem::Start(self.assignments(cursor)?, keyword)),
            "step" => Ok(SceneItem::Step(self.lone_value(cursor)?, keyword)),
            "until" => Ok(SceneItem::Until(self.lone_value(cursor)?, keyword)),
            "keep" => self.keep(cursor, keyword),
            _ => {
                let form = [Form::Next, Form::Increment]
                    .into_iter()
                    .find(|form| cursor.eat_word(form.keyword()));
                let form = form.ok_or_else(|| cursor.unexpected("`next` or `increment`"))?;
                let range = cursor.previous();
                self.scene_semicolon(cursor)?;
                Ok(SceneItem::Form(form, range))
            }
        }
    }

    fn fix(&mut self, cursor: &mut Cursor) -> Parsed<SceneItem> {
        let name = cursor.expect_name()?;
        if !cursor.eat_punct('=') {
            let mut diagnostic = cursor.unexpected("`=` and a value");
            if cursor.peeks_open(Delimiter::Parenthesis) || cursor.peeks_punct('.') {
                diagnostic.help = Some("fix a parameter as a whole".to_owned());
            }
            return Err(diagnostic);
        }
        let first = cursor.position();
        let value = self.expression(cursor)?;
        let text = cursor.text_since(first);
        self.scene_semicolon(cursor)?;
        Ok(SceneItem::Fix(Assignment { name, value }, text))
    }

    /// `NAME = VALUE;`
    fn scene_value(&mut self, cursor: &mut Cursor) -> Parsed<Assignment> {
        let name = cursor.expect_name()?;
        cursor.expect_punct('=')?;
        let value = self.expression(cursor)?;
        self.scene_semicolon(cursor)?;
        Ok(Assignment { name, value })
    }

    /// `VALUE;`
    fn lone_value(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let value = self.expression(cursor)?;
        self.scene_semicolon(cursor)?;
        Ok(value)
    }

    fn keep(&mut self, cursor: &mut Cursor, keyword: Range) -> Parsed<SceneItem> {
        let mut names = vec![cursor.expect_name()?];
        while cursor.eat_punct(',') && !cursor.peeks_punct(';') {
            names.push(cursor.expect_name()?);
        }
        let is_name = matches!(cursor.peek(), Some(Kind::Ident(_)));
        let is_pick = cursor.peeks_open(Delimiter::Parenthesis) || cursor.peeks_punct('.');
        if is_pick || is_name && !is_keyword(cursor.peek()) && !cursor.starts_a_line() {
            let mut diagnostic = cursor.unexpected("`,` or `;`");
            let whole = "keep a state or an output as a whole";
            diagnostic.help = is_pick.then(|| whole.to_owned());
            return Err(diagnostic);
        }
        self.scene_semicolon(cursor)?;
        Ok(SceneItem::Keep(names, keyword))
    }

    /// The end of a statement; where the next one plainly begins, reading goes on.
    fn scene_semicolon(&mut self, cursor: &mut Cursor) -> Parsed<()> {
        if !is_keyword(cursor.peek()) || cursor.starts_a_line() {
            return self.semicolon(cursor);
        }
        let message = format!("expected `;` after this, found {}", cursor.found());
        self.errors.push(cursor.previous(), message);
        Ok(())
    }
}

fn is_keyword(kind: Option<&Kind>) -> bool {
    matches!(kind, Some(Kind::Ident(text)) if KEYWORDS.contains(&text.as_str()))
}

/// No keyword here.
fn no_statement(cursor: Cursor) -> Diagnostic {
    let mut diagnostic = cursor.unexpected("a statement");
    let Some(Kind::Ident(word)) = cursor.peek() else {
        return diagnostic;
    };
    let best = most_similar(word, KEYWORDS.iter().map(|k| (*k, k)), SIMILAR);
    diagnostic.help = Some(match (best, word.as_str(), cursor.peek_at(1)) {
        (_, "param" | "set", _) => "write `fix NAME = VALUE;`".to_owned(),
        (_, "state" | "residual" | "flow" | "update" | "invariant" | "observe", _) => {
            "that belongs in the model file".to_owned()
        }
        (Some(keyword), ..) => format!("did you mean `{keyword}`?"),
        (None, _, Some(Kind::Punct('='))) => format!("write `fix {word} = …;`"),
        (None, ..) => format!("a statement of a scene begins with {}", KEYWORDS.join(", ")),
    });
    diagnostic
}
