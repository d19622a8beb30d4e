//! Statements with a block: equations, assignments, claims.

use super::Parser;
use super::advice::missing_operator;
use super::cursor::Cursor;
use super::cursor::Parsed;
use super::expression::finish;
use super::expression::is_list_of_brackets;
use super::expression::list;
use super::expression::rows;
use super::name::Spelling;
use super::tokens::Kind;
use crate::ast::Assignment;
use crate::ast::Claim;
use crate::ast::ClaimKind;
use crate::ast::Equation;
use crate::ast::ExprId;
use crate::ast::Item;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use proc_macro2::Delimiter;

impl Parser {
    /// `{ lhs = rhs; … }`; a mistake stays inside its equation.
    pub(super) fn equations(
        &mut self,
        cursor: &mut Cursor,
        missing: &str,
    ) -> Parsed<Vec<Equation>> {
        let inside = cursor.enter(Delimiter::Brace)?;
        Ok(self.each(inside, |parser, cursor| parser.equation(cursor, missing)))
    }

    /// `lhs = rhs;`; `missing` is what to write where `= rhs` is not there.
    fn equation(&mut self, cursor: &mut Cursor, missing: &str) -> Parsed<Equation> {
        let (start, first) = (cursor.here(), cursor.position());
        let lhs = self.expression(cursor)?;
        if !cursor.eat_punct('=') {
            let mut diagnostic = missing_operator(*cursor, "an operator or `=`");
            if cursor.peeks_punct(';') || cursor.is_at_end() {
                diagnostic.help = Some(missing.to_owned());
            }
            return Err(diagnostic);
        }
        let rhs = self.expression(cursor)?;
        let text = cursor.text_since(first);
        let range = start.to(cursor.previous());
        self.semicolon(cursor)?;
        Ok(Equation {
            lhs,
            rhs,
            text,
            range,
        })
    }

    /// `{ name = value; … }`; a mistake stays inside its assignment.
    pub(super) fn assignments(&mut self, cursor: &mut Cursor) -> Parsed<Vec<Assignment>> {
        let inside = cursor.enter(Delimiter::Brace)?;
        Ok(self.each(inside, Self::assignment))
    }

    fn assignment(&mut self, cursor: &mut Cursor) -> Parsed<Assignment> {
        let start = *cursor;
        let name = match cursor.eat_identifier()? {
            Some(Spelling::Plain(name)) if !cursor.peeks_open(Delimiter::Bracket) => name,
            Some(_) => {
                return Err(Diagnostic {
                    range: start.here(),
                    message: "expected the plain name of a state left of `=`".to_owned(),
                    help: Some("the value on the right is the one the state takes".to_owned()),
                });
            }
            None => return Err(start.unexpected("the name of a state")),
        };
        cursor.expect_punct('=')?;
        let value = self.expression(cursor)?;
        self.semicolon(cursor)?;
        Ok(Assignment { name, value })
    }

    /// `claim jacobian "Eq. 50" { … }`, the word `claim` already passed unless it is `required`.
    pub(super) fn claim(
        &mut self,
        cursor: &mut Cursor,
        keyword: Range,
        required: bool,
    ) -> Parsed<Item> {
        if required {
            cursor.skip();
        }
        let kind = ClaimKind::ALL
            .into_iter()
            .find(|kind| cursor.eat_word(kind.keyword()));
        let kind = kind.ok_or_else(|| {
            let words = ClaimKind::ALL.map(|kind| format!("`{}`", kind.keyword()));
            cursor.unexpected(&words.join(", "))
        })?;
        let (label, _) = label(cursor)?;
        let of = if kind == ClaimKind::Jacobian && cursor.eat_word("of") {
            Some(self::label(cursor)?)
        } else {
            None
        };
        let (mut blocks, mut equations) = (Vec::new(), Vec::new());
        match kind {
            ClaimKind::Jacobian => {
                blocks = self.claimed_blocks(cursor.enter(Delimiter::Brace)?)?;
            }
            ClaimKind::Residual
            | ClaimKind::Flow
            | ClaimKind::Equation
            | ClaimKind::Differential => equations = self.equations(cursor, "write `… = …;`")?,
        }
        Ok(Item::Claim(Claim {
            kind,
            label,
            of,
            required,
            blocks,
            equations,
            range: keyword.to(cursor.previous()),
        }))
    }

    /// Block rows of a printed Jacobian. What is not written as blocks is one block.
    fn claimed_blocks(&mut self, mut inside: Cursor) -> Parsed<Vec<Vec<(ExprId, String)>>> {
        let mut after = inside;
        after.skip();
        if !inside.peeks_open(Delimiter::Bracket) || !after.is_at_end() {
            let block = self.claimed_block(&mut inside)?;
            finish(inside, "an operator or `}`")?;
            return Ok(vec![vec![block]]);
        }
        let matrix = inside.enter(Delimiter::Bracket)?;
        if is_list_of_brackets(matrix) {
            rows(matrix, |row| list(row, |cursor| self.claimed_block(cursor)))
        } else {
            list(matrix, |cursor| Ok(vec![self.claimed_block(cursor)?]))
        }
    }

    fn claimed_block(&mut self, cursor: &mut Cursor) -> Parsed<(ExprId, String)> {
        let first = cursor.position();
        let block = self.expression(cursor)?;
        Ok((block, cursor.text_since(first)))
    }

    /// Reads statements up to the end of a block; after a mistake it goes on behind the next `;`.
    fn each<T>(
        &mut self,
        mut inside: Cursor,
        statement: impl Fn(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Vec<T> {
        let mut list = Vec::new();
        while !inside.is_at_end() {
            match statement(self, &mut inside) {
                Ok(element) => list.push(element),
                Err(diagnostic) => {
                    self.errors.add(diagnostic);
                    while !inside.is_at_end() && !inside.eat_punct(';') {
                        inside.skip();
                    }
                }
            }
        }
        list
    }
}

/// `"Eq. 50"`
fn label(cursor: &mut Cursor) -> Parsed<(String, Range)> {
    let (range, missing) = (
        cursor.here(),
        cursor.unexpected("a label such as \"Eq. 50\""),
    );
    let text = match cursor.peek() {
        Some(Kind::Literal(literal)) => super::string_value(literal),
        _ => None,
    };
    let text = text.ok_or(missing)?;
    cursor.skip();
    Ok((text, range))
}
