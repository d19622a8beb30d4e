//! Expressions.
//!
//! ```text
//! sum     ::= product (('+' | '-') product)*
//! product ::= signed (('*' | '/') signed)*
//! signed  ::= ('-' | '+')* power
//! power   ::= postfix ('^' ('-' | '+')* postfix)*  from the right
//! postfix ::= primary ('.T' | '.x' | '.y' | '.z' | '(' list ')')*
//! primary ::= number | name | name '[' level ']' | 'Δ'name | name' | name '(' list ')'
//!           | '(' sum ')' | '[' list ']' | '[' '[' list ']' , … ']'
//! ```
//!
//! Chains are loops; only brackets recurse, and their depth is bounded.

use super::Parser;
use super::advice::double_star;
use super::advice::missing_operator;
use super::advice::no_operand;
use super::advice::unknown_field;
use super::cursor::Cursor;
use super::cursor::Parsed;
use super::name::Spelling;
use super::number;
use super::tokens::Kind;
use crate::ast::Binary;
use crate::ast::Expr;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::Level;
use crate::ast::Name;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use proc_macro2::Delimiter;

impl Parser {
    /// A whole expression.
    pub(super) fn expression(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let mut sum = self.product(cursor)?;
        loop {
            let operator = if cursor.eat_punct('+') {
                Binary::Add
            } else if cursor.eat_punct('-') {
                Binary::Sub
            } else {
                return Ok(sum);
            };
            let right = self.product(cursor)?;
            sum = self.binary(operator, sum, right);
        }
    }

    fn product(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let mut product = self.signed(cursor)?;
        loop {
            let operator = if cursor.eat_punct('*') {
                if cursor.peeks_punct('*') {
                    return Err(double_star(*cursor));
                }
                Binary::Mul
            } else if cursor.eat_punct('/') {
                Binary::Div
            } else {
                return Ok(product);
            };
            let right = self.signed(cursor)?;
            product = self.binary(operator, product, right);
        }
    }

    fn signed(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let signs = signs(cursor);
        let power = self.power(cursor)?;
        Ok(self.negate(power, &signs))
    }

    fn power(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let mut tower = vec![(Vec::new(), self.postfix(cursor)?)];
        while cursor.eat_punct('^') {
            let signs = signs(cursor);
            tower.push((signs, self.postfix(cursor)?));
        }
        let mut exponent = None;
        for (signs, base) in tower.into_iter().rev() {
            let power = match exponent {
                Some(exponent) => self.binary(Binary::Pow, base, exponent),
                None => base,
            };
            exponent = Some(self.negate(power, &signs));
        }
        exponent.ok_or_else(|| cursor.unexpected("an expression"))
    }

    fn postfix(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let mut operand = self.primary(cursor)?;
        loop {
            let range = self.exprs[operand.index()].range;
            if cursor.eat_punct('.') {
                let kind = match cursor.peek() {
                    Some(Kind::Ident(field)) => field_of(field, operand),
                    _ => None,
                };
                let kind = kind.ok_or_else(|| unknown_field(*cursor))?;
                cursor.skip();
                operand = self.push(kind, range.to(cursor.previous()));
            } else if cursor.peeks_open(Delimiter::Parenthesis) {
                let indices = self.list(cursor.enter(Delimiter::Parenthesis)?)?;
                let kind = ExprKind::Component(operand, indices);
                operand = self.push(kind, range.to(cursor.previous()));
            } else if cursor.peeks_open(Delimiter::Bracket) {
                return Err(Diagnostic {
                    range: cursor.here(),
                    message: "a time level belongs directly behind the name of a state".to_owned(),
                    help: Some("write x[k+1](1) for a component, x(1) at step k".to_owned()),
                });
            } else {
                return Ok(operand);
            }
        }
    }

    fn primary(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let start = cursor.here();
        match cursor.peek() {
            Some(Kind::Literal(literal)) => {
                let (range, text) = (start, literal.to_string());
                let number = number::read(&text).map_err(|(message, help)| Diagnostic {
                    range,
                    message,
                    help,
                })?;
                cursor.skip();
                Ok(self.push(ExprKind::Number(number), range))
            }
            Some(Kind::Open(Delimiter::Parenthesis, _)) => {
                let mut inside = cursor.enter(Delimiter::Parenthesis)?;
                let sum = self.expression(&mut inside)?;
                finish(inside, "an operator or `)`")?;
                // The brackets belong to the range, so that carets cover them.
                self.exprs[sum.index()].range = start.to(cursor.previous());
                Ok(sum)
            }
            Some(Kind::Open(Delimiter::Bracket, _)) => self.matrix(cursor),
            Some(Kind::Ident(_)) => self.named(cursor),
            _ => Err(no_operand(*cursor)),
        }
    }

    /// A name, with its level or its arguments.
    fn named(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let start = cursor.here();
        let missing = no_operand(*cursor);
        let kind = match cursor.eat_identifier()?.ok_or(missing)? {
            Spelling::Rate(name) => ExprKind::Rate(no_level(name, *cursor)?),
            Spelling::Increment(name) => ExprKind::Increment(no_level(name, *cursor)?),
            Spelling::Plain(name) if cursor.peeks_open(Delimiter::Parenthesis) => {
                match name.ascii.as_str() {
                    "der" => ExprKind::Rate(state_of(&name, cursor)?),
                    "Delta" => ExprKind::Increment(state_of(&name, cursor)?),
                    _ => ExprKind::Call(name, self.list(cursor.enter(Delimiter::Parenthesis)?)?),
                }
            }
            Spelling::Plain(name) if cursor.peeks_open(Delimiter::Bracket) => {
                let level = level(&name, cursor)?;
                ExprKind::Name(name, Some(level))
            }
            Spelling::Plain(name) => ExprKind::Name(name, None),
        };
        Ok(self.push(kind, start.to(cursor.previous())))
    }

    /// `[a, b]` or `[[a, b], [c, d]]`.
    fn matrix(&mut self, cursor: &mut Cursor) -> Parsed<ExprId> {
        let start = cursor.here();
        let inside = cursor.enter(Delimiter::Bracket)?;
        let range = start.to(cursor.previous());
        let kind = if is_list_of_brackets(inside) {
            ExprKind::Blocks(rows(inside, |row| self.list(row))?)
        } else {
            ExprKind::Stack(self.list(inside)?)
        };
        Ok(self.push(kind, range))
    }

    /// The expressions inside a bracket.
    fn list(&mut self, inside: Cursor) -> Parsed<Vec<ExprId>> {
        list(inside, |cursor| self.expression(cursor))
    }

    fn binary(&mut self, operator: Binary, left: ExprId, right: ExprId) -> ExprId {
        let range = |id: ExprId| self.exprs[id.index()].range;
        let range = range(left).to(range(right));
        self.push(ExprKind::Binary(operator, left, right), range)
    }

    /// Puts the minus signs that stand at `signs` in front of `operand`.
    fn negate(&mut self, operand: ExprId, signs: &[Range]) -> ExprId {
        signs.iter().rev().fold(operand, |operand, sign| {
            let range = sign.to(self.exprs[operand.index()].range);
            self.push(ExprKind::Neg(operand), range)
        })
    }

    pub(super) fn push(&mut self, kind: ExprKind, range: Range) -> ExprId {
        let id = ExprId(self.exprs.len() as u32);
        self.exprs.push(Expr { kind, range });
        id
    }
}

/// Fails unless the bracket ends here.
pub(super) fn finish(inside: Cursor, expected: &str) -> Parsed<()> {
    if inside.is_at_end() {
        Ok(())
    } else {
        Err(missing_operator(inside, expected))
    }
}

/// The minus signs here; a plus sign says nothing.
fn signs(cursor: &mut Cursor) -> Vec<Range> {
    let mut signs = Vec::new();
    loop {
        if cursor.eat_punct('-') {
            signs.push(cursor.previous());
        } else if !cursor.eat_punct('+') {
            return signs;
        }
    }
}

fn field_of(field: &str, operand: ExprId) -> Option<ExprKind> {
    match field {
        "T" => Some(ExprKind::Transpose(operand)),
        "x" => Some(ExprKind::Field(operand, 1)),
        "y" => Some(ExprKind::Field(operand, 2)),
        "z" => Some(ExprKind::Field(operand, 3)),
        _ => None,
    }
}

/// `[k]`, `[k+1/2]`, `[k+1]` or `[k-1]` behind `name`.
fn level(name: &Name, cursor: &mut Cursor) -> Parsed<Level> {
    let start = cursor.here();
    let mut inside = cursor.enter(Delimiter::Bracket)?;
    let first = inside.position();
    while !inside.is_at_end() {
        inside.skip();
    }
    let text = inside.text_since(first);
    let compact: String = text.split_whitespace().collect();
    match compact.as_str() {
        "k" => Ok(Level::Now),
        "k+1/2" => Ok(Level::Half),
        "k+1" => Ok(Level::Next),
        "k-1" => Ok(Level::Previous),
        _ => Err(Diagnostic {
            range: start.to(cursor.previous()),
            message: format!("expected a time level `[k]`, `[k+1/2]` or `[k+1]`, found `[{text}]`"),
            help: match text.chars().next() {
                Some('k') | None => None,
                Some(c) if c.is_ascii_digit() => {
                    let first = if text == "0" { "1" } else { &text };
                    Some(format!(
                        "write {}({first}) for a component, counted from 1",
                        name.display
                    ))
                }
                Some(_) => Some("the step counter is called `k`".to_owned()),
            },
        }),
    }
}

fn no_level(name: Name, cursor: Cursor) -> Parsed<Name> {
    if cursor.peeks_open(Delimiter::Bracket) {
        return Err(Diagnostic {
            range: cursor.here(),
            message: "a rate or an increment has no time level".to_owned(),
            help: None,
        });
    }
    Ok(name)
}

/// The `x` of `der(x)` and `Delta(x)`.
fn state_of(function: &Name, cursor: &mut Cursor) -> Parsed<Name> {
    let start = cursor.here();
    let mut inside = cursor.enter(Delimiter::Parenthesis)?;
    let name = inside.expect_name().ok().filter(|_| inside.is_at_end());
    name.ok_or_else(|| Diagnostic {
        range: start.to(cursor.previous()),
        message: format!("expected the name of one state in {}(…)", function.display),
        help: None,
    })
}

/// `a, b, …` up to the closing bracket.
pub(super) fn list<T>(
    mut inside: Cursor,
    mut element: impl FnMut(&mut Cursor) -> Parsed<T>,
) -> Parsed<Vec<T>> {
    if inside.is_at_end() {
        return Err(no_operand(inside));
    }
    let mut list = Vec::new();
    while !inside.is_at_end() {
        list.push(element(&mut inside)?);
        if !inside.eat_punct(',') {
            finish(inside, "an operator, `,` or the closing bracket")?;
        }
    }
    Ok(list)
}

/// `[…], […], …` up to the closing bracket, all of one length.
pub(super) fn rows<T>(
    inside: Cursor,
    mut row: impl FnMut(Cursor) -> Parsed<Vec<T>>,
) -> Parsed<Vec<Vec<T>>> {
    let mut width = None;
    list(inside, |cursor| {
        let start = cursor.here();
        let row = row(cursor.enter(Delimiter::Bracket)?)?;
        let width = *width.get_or_insert(row.len());
        if row.len() == width {
            return Ok(row);
        }
        Err(Diagnostic {
            range: start.to(cursor.previous()),
            message: format!(
                "expected {width} blocks as in the first row, found {}",
                row.len()
            ),
            help: None,
        })
    })
}

/// True for `[…], […], …`.
pub(super) fn is_list_of_brackets(mut inside: Cursor) -> bool {
    let mut any = false;
    while inside.peeks_open(Delimiter::Bracket) {
        any = true;
        inside.skip();
        if !inside.eat_punct(',') {
            break;
        }
    }
    any && inside.is_at_end()
}
