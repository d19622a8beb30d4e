//! What to say where an expression goes wrong.

use super::cursor::Cursor;
use super::number;
use super::tokens::Kind;
use crate::diagnostic::Diagnostic;
use crate::function::Function;
use crate::function::NO_CONDITIONALS;
use crate::unit::Unit;

/// Something follows an expression that cannot.
pub(super) fn missing_operator(cursor: Cursor, expected: &str) -> Diagnostic {
    let mut diagnostic = cursor.unexpected(expected);
    diagnostic.help = match (cursor.passed(), cursor.peek()) {
        (_, Some(Kind::Punct('\''))) => {
            Some("write x.T for the transpose and der(x) for the rate".to_owned())
        }
        (_, Some(Kind::Punct('<' | '>' | '?'))) => Some(NO_CONDITIONALS.to_owned()),
        (_, Some(Kind::Ident(_) | Kind::Literal(_))) if cursor.starts_a_line() => None,
        (Some(Kind::Ident(word)), Some(Kind::Ident(_))) if word == "if" => {
            Some(NO_CONDITIONALS.to_owned())
        }
        (Some(Kind::Ident(word)), Some(next @ (Kind::Ident(_) | Kind::Literal(_))))
            if Function::named(word).is_some() =>
        {
            Some(format!("write {word}({})", next.text()))
        }
        (Some(Kind::Literal(number)), Some(Kind::Ident(symbol))) => {
            let help = number::unit_help(&number.to_string(), symbol);
            Some(help.unwrap_or_else(|| match Unit::named(symbol) {
                Some(_) => "write `*` between factors; a number carries no unit".to_owned(),
                None => "write `*` between factors".to_owned(),
            }))
        }
        (_, Some(Kind::Ident(_))) => Some("write `*` between factors".to_owned()),
        (_, Some(_) | None) => None,
    };
    diagnostic
}

/// Something stands where an operand belongs.
pub(super) fn no_operand(cursor: Cursor) -> Diagnostic {
    if cursor.peeks_punct('=') && cursor.follows_punct('=') {
        return Diagnostic {
            range: cursor.previous().to(cursor.here()),
            message: "expected a single `=`, found `==`".to_owned(),
            help: None,
        };
    }
    let mut diagnostic = cursor.unexpected("a number, a name, `(` or `[`");
    if cursor.peeks_punct('|') {
        let shown = match (cursor.peek_at(1), cursor.peek_at(2)) {
            (Some(name @ Kind::Ident(_)), Some(Kind::Punct('|'))) => name.text(),
            _ => "x".to_owned(),
        };
        let help = format!("write abs({shown}) for a number and norm({shown}) for a vector");
        diagnostic.help = Some(help);
    }
    diagnostic
}

pub(super) fn double_star(cursor: Cursor) -> Diagnostic {
    Diagnostic {
        range: cursor.previous().to(cursor.here()),
        message: "expected an operator, found `**`".to_owned(),
        help: Some("write `^` for a power".to_owned()),
    }
}

pub(super) fn unknown_field(cursor: Cursor) -> Diagnostic {
    let mut diagnostic = cursor.unexpected("`T`, `x`, `y` or `z` behind the point");
    if let Some(Kind::Literal(_)) = cursor.peek() {
        diagnostic.help = Some("write v(1) for a component, counted from 1".to_owned());
    }
    diagnostic
}
