//! Requirements: what data must be like for a model to make sense.

use super::Parser;
use super::advice::missing_operator;
use super::cursor::Cursor;
use super::cursor::Parsed;
use super::tokens::Kind;
use crate::ast::Item;
use crate::ast::Relation;
use crate::ast::Requirement;
use crate::diagnostic::Diagnostic;

/// What a message says behind what it expected.
const EXAMPLE: &str = "write `require m > 0 else \"the mass must be positive\";`";

impl Parser {
    /// `lhs < rhs else "…";`, the word `require` already passed.
    pub(super) fn requirement(&mut self, cursor: &mut Cursor) -> Parsed<Item> {
        let (start, first) = (cursor.here(), cursor.position());
        let lhs = self.expression(cursor)?;
        let relation = relation(cursor)?;
        let rhs = self.expression(cursor)?;
        let text = cursor.text_since(first);
        let range = start.to(cursor.previous());
        if matches!(cursor.peek(), Some(Kind::Punct('<' | '>' | '='))) {
            return Err(Diagnostic {
                help: Some("write one `require` for each comparison".to_owned()),
                ..cursor.unexpected("`else`")
            });
        }
        if !cursor.eat_word("else") {
            return Err(Diagnostic {
                help: Some(EXAMPLE.to_owned()),
                ..missing_operator(*cursor, "an operator or `else` and a message")
            });
        }
        let missing = cursor.unexpected("a message in quotes");
        let otherwise = match cursor.peek() {
            Some(Kind::Literal(literal)) => super::string_value(literal),
            _ => None,
        };
        let otherwise = otherwise.ok_or(missing)?;
        cursor.skip();
        self.semicolon(cursor)?;
        Ok(Item::Requirement(Requirement {
            lhs,
            relation,
            rhs,
            otherwise,
            text,
            range,
        }))
    }
}

/// `<`, `<=`, `>` or `>=`
fn relation(cursor: &mut Cursor) -> Parsed<Relation> {
    let (strict, loose) = match cursor.peek() {
        Some(Kind::Punct('<')) => (Relation::Less, Relation::LessOrEqual),
        Some(Kind::Punct('>')) => (Relation::Greater, Relation::GreaterOrEqual),
        Some(Kind::Punct('=' | '!')) => {
            let help = "numbers are seldom equal to the last digit: require abs(a - b) < …";
            return Err(Diagnostic {
                help: Some(help.to_owned()),
                ..cursor.unexpected("`<`, `<=`, `>` or `>=`")
            });
        }
        _ => {
            return Err(Diagnostic {
                help: Some(EXAMPLE.to_owned()),
                ..missing_operator(*cursor, "an operator, `<`, `<=`, `>` or `>=`")
            });
        }
    };
    cursor.skip();
    let is_loose = cursor.eat_punct('=');
    Ok(if is_loose { loose } else { strict })
}
