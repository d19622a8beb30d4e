//! A position in the flat tokens, and what may be asked there.

use super::name;
use super::name::Spelling;
use super::tokens;
use super::tokens::Kind;
use super::tokens::Token;
use crate::ast::Name;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use proc_macro2::Delimiter;
use proc_macro2::Span;

/// What a parsing function gives: its part, or the first mistake in it.
pub(super) type Parsed<T> = Result<T, Diagnostic>;

/// A position inside one bracket.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    tokens: &'a [Token],
    /// The next token.
    position: usize,
    /// The end of the innermost open bracket, or of everything.
    end: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(tokens: &'a [Token]) -> Self {
        Self {
            tokens,
            position: 0,
            end: tokens.len(),
        }
    }

    pub(super) fn position(self) -> usize {
        self.position
    }

    pub(super) fn is_at_end(self) -> bool {
        self.position >= self.end
    }

    /// The kind of the next token; none at the end of the bracket.
    pub(super) fn peek(self) -> Option<&'a Kind> {
        self.peek_at(0)
    }

    /// The kind of the token `n` places ahead.
    pub(super) fn peek_at(self, n: usize) -> Option<&'a Kind> {
        let index = self.position + n;
        (index < self.end).then(|| &self.tokens[index].kind)
    }

    pub(super) fn peeks_punct(self, c: char) -> bool {
        matches!(self.peek(), Some(Kind::Punct(p)) if *p == c)
    }

    /// The kind of the token just passed.
    pub(super) fn passed(self) -> Option<&'a Kind> {
        Some(&self.tokens[self.position.checked_sub(1)?].kind)
    }

    /// True directly behind `c`.
    pub(super) fn follows_punct(self, c: char) -> bool {
        let before = self.position.checked_sub(1).map(|i| &self.tokens[i]);
        before.is_some_and(|t| t.joint && matches!(t.kind, Kind::Punct(p) if p == c))
    }

    pub(super) fn peeks_word(self, word: &str) -> bool {
        matches!(self.peek(), Some(Kind::Ident(text)) if text == word)
    }

    pub(super) fn peeks_open(self, delimiter: Delimiter) -> bool {
        matches!(self.peek(), Some(Kind::Open(d, _)) if *d == delimiter)
    }

    /// The range of the next token; at the end that of the closing bracket or of the last token.
    pub(super) fn here(self) -> Range {
        let index = self.position.min(self.tokens.len().saturating_sub(1));
        let span = self.tokens.get(index).map(|t| t.span);
        Range::of(span.unwrap_or_else(Span::call_site))
    }

    /// The range of the token just passed.
    pub(super) fn previous(self) -> Range {
        match self.position.checked_sub(1) {
            Some(index) => Range::of(self.tokens[index].span),
            None => self.here(),
        }
    }

    /// The text from `start` up to here.
    pub(super) fn text_since(self, start: usize) -> String {
        tokens::text(&self.tokens[start..self.position])
    }

    /// True if the next token stands on a later line than the last.
    pub(super) fn starts_a_line(self) -> bool {
        self.previous().end.end().line < self.here().line()
    }

    /// Passes one token, or a whole bracket.
    pub(super) fn skip(&mut self) {
        self.position = match self.peek() {
            Some(Kind::Open(_, close)) => close + 1,
            Some(_) => self.position + 1,
            None => self.position,
        };
    }

    pub(super) fn eat_punct(&mut self, c: char) -> bool {
        let found = self.peeks_punct(c);
        if found {
            self.position += 1;
        }
        found
    }

    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        let found = self.peeks_word(word);
        if found {
            self.position += 1;
        }
        found
    }

    pub(super) fn expect_punct(&mut self, c: char) -> Parsed<()> {
        if self.eat_punct(c) {
            Ok(())
        } else {
            Err(self.unexpected(&format!("`{c}`")))
        }
    }

    /// A cursor over the inside of the next bracket, which `self` passes.
    pub(super) fn enter(&mut self, delimiter: Delimiter) -> Parsed<Cursor<'a>> {
        match self.peek() {
            Some(&Kind::Open(d, close)) if d == delimiter => {
                let inside = Cursor {
                    position: self.position + 1,
                    end: close,
                    ..*self
                };
                self.position = close + 1;
                Ok(inside)
            }
            _ => Err(self.unexpected(&format!("`{}`", tokens::brackets(delimiter).0))),
        }
    }

    /// A plain name.
    pub(super) fn expect_name(&mut self) -> Parsed<Name> {
        let found = self.unexpected("a name");
        match self.eat_identifier()? {
            Some(Spelling::Plain(name)) => Ok(name),
            Some(Spelling::Rate(_) | Spelling::Increment(_)) | None => Err(found),
        }
    }

    /// An identifier of any spelling, if one comes next.
    pub(super) fn eat_identifier(&mut self) -> Parsed<Option<Spelling>> {
        let Some(Kind::Ident(text)) = self.peek() else {
            return Ok(None);
        };
        if text == "_" {
            return Ok(None);
        }
        let spelling = name::read(text, self.here())?;
        self.position += 1;
        Ok(Some(spelling))
    }

    /// `expected …, found …` at the next token.
    pub(super) fn unexpected(self, expected: &str) -> Diagnostic {
        Diagnostic {
            range: self.here(),
            message: format!("expected {expected}, found {}", self.found()),
            help: None,
        }
    }

    /// The next token as a message names it; operators of several characters in one piece.
    pub(super) fn found(self) -> String {
        if self.is_at_end() {
            return match self.tokens.get(self.position) {
                Some(token) => format!("`{}`", token.text()),
                None => "the end of the file".to_owned(),
            };
        }
        let mut text = self.tokens[self.position].text();
        let mut index = self.position;
        while self.tokens[index].joint && index + 1 < self.end {
            index += 1;
            if matches!(self.tokens[index].kind, Kind::Punct(';' | ',')) {
                break;
            }
            text.push_str(&self.tokens[index].text());
        }
        format!("`{text}`")
    }
}
