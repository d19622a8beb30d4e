//! What follows the colon of a declaration: shape and unit.

use super::cursor::Cursor;
use super::cursor::Parsed;
use super::statement::is_keyword;
use super::tokens::Kind;
use crate::ast::LARGEST_DIMENSION;
use crate::ast::Name;
use crate::ast::TypeExpr;
use crate::ast::UnitExpr;
use crate::diagnostic::Diagnostic;
use proc_macro2::Delimiter;

/// Largest numerator and denominator of an exponent.
const LARGEST_EXPONENT: i32 = 99;

/// `: [3, 3] kg*m^2`, or nothing.
pub(super) fn parse(cursor: &mut Cursor) -> Parsed<TypeExpr> {
    let mut ty = TypeExpr::default();
    if !cursor.eat_punct(':') {
        return Ok(ty);
    }
    if cursor.peeks_open(Delimiter::Bracket) {
        let start = cursor.here();
        let dimensions = shape(cursor)?;
        ty.shape = Some((dimensions, Some(start.to(cursor.previous()))));
    }
    let is_factor = matches!(cursor.peek(), Some(Kind::Ident(_) | Kind::Literal(_)))
        && !is_keyword(cursor.peek());
    if is_factor || ty.shape.is_none() {
        ty.unit = Some(unit(cursor)?);
    }
    Ok(ty)
}

fn shape(cursor: &mut Cursor) -> Parsed<Vec<usize>> {
    let start = cursor.here();
    let mut inside = cursor.enter(Delimiter::Bracket)?;
    let mut dimensions = vec![dimension(&mut inside)?];
    if inside.eat_punct(',') {
        dimensions.push(dimension(&mut inside)?);
    }
    if inside.is_at_end() {
        return Ok(dimensions);
    }
    Err(Diagnostic {
        range: start.to(cursor.previous()),
        message: "expected a shape `[n]` or `[n, m]`".to_owned(),
        help: None,
    })
}

fn dimension(cursor: &mut Cursor) -> Parsed<usize> {
    let expected = format!("a number of rows or columns from 1 to {LARGEST_DIMENSION}");
    let unexpected = cursor.unexpected(&expected);
    let value = match cursor.peek() {
        Some(Kind::Literal(literal)) => literal.to_string().parse().ok(),
        _ => None,
    };
    match value {
        Some(n @ 1..=LARGEST_DIMENSION) => {
            cursor.skip();
            Ok(n)
        }
        Some(_) | None => Err(unexpected),
    }
}

/// `kg*m^2/s`
pub(super) fn unit(cursor: &mut Cursor) -> Parsed<UnitExpr> {
    let start = cursor.here();
    let mut factors = Vec::new();
    let mut sign = 1;
    loop {
        if let Some((name, (p, q))) = factor(cursor)? {
            factors.push((name, (sign * p, q)));
        }
        sign = if cursor.eat_punct('*') {
            1
        } else if cursor.eat_punct('/') {
            -1
        } else {
            break;
        };
    }
    let range = start.to(cursor.previous());
    Ok(UnitExpr { factors, range })
}

/// `m`, `m^2` or `m^(1/2)`; none for `1`.
fn factor(cursor: &mut Cursor) -> Parsed<Option<(Name, (i32, i32))>> {
    match cursor.peek() {
        Some(Kind::Literal(literal)) if literal.to_string() == "1" => {
            cursor.skip();
            Ok(None)
        }
        Some(Kind::Ident(_)) => {
            let symbol = cursor.expect_name()?;
            let exponent = exponent(cursor)?;
            Ok(Some((symbol, exponent)))
        }
        _ => Err(cursor.unexpected("a unit such as `m/s^2`")),
    }
}

fn exponent(cursor: &mut Cursor) -> Parsed<(i32, i32)> {
    if !cursor.eat_punct('^') {
        return Ok((1, 1));
    }
    if !cursor.peeks_open(Delimiter::Parenthesis) {
        return Ok((signed_integer(cursor)?, 1));
    }
    let mut inside = cursor.enter(Delimiter::Parenthesis)?;
    let numerator = signed_integer(&mut inside)?;
    let denominator = if inside.eat_punct('/') {
        integer(&mut inside)?
    } else {
        1
    };
    if inside.is_at_end() {
        Ok((numerator, denominator))
    } else {
        Err(inside.unexpected("`)`"))
    }
}

fn signed_integer(cursor: &mut Cursor) -> Parsed<i32> {
    let sign = if cursor.eat_punct('-') { -1 } else { 1 };
    Ok(sign * integer(cursor)?)
}

fn integer(cursor: &mut Cursor) -> Parsed<i32> {
    let expected = format!("an exponent from 1 to {LARGEST_EXPONENT}");
    let unexpected = cursor.unexpected(&expected);
    let value = match cursor.peek() {
        Some(Kind::Literal(literal)) => literal.to_string().parse().ok(),
        _ => None,
    };
    match value {
        Some(n @ 1..=LARGEST_EXPONENT) => {
            cursor.skip();
            Ok(n)
        }
        Some(_) | None => Err(unexpected),
    }
}
