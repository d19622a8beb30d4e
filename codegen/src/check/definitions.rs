//! Shapes and units of what is declared, and the values of `let`s.
//!
//! A `let` may stand before or after its use, and a parameter may take its shape from its default, so
//! values are typed in the order in which they need each other.

use super::symbols::Kind;
use super::symbols::Symbol;
use super::symbols::Symbols;
use super::types::ComponentUnit;
use super::types::Type;
use super::typing::Meaning;
use super::typing::Typing;
use crate::ast;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::TypeExpr;
use crate::ast::UnitExpr;
use crate::diagnostic::Errors;
use crate::model::Shape;
use crate::unit;
use crate::unit::Unit;
use num_rational::Ratio;

/// The declared unit of each symbol, where one is written; in doubt after a complaint.
pub(super) fn units(symbols: &Symbols, errors: &mut Errors) -> Vec<Option<ComponentUnit>> {
    let written = |symbol: &Symbol| symbol.ty.and_then(|ty| ty.unit.as_ref()).cloned();
    let list = symbols.list.iter().map(written);
    list.map(|unit| unit.map(|unit| evaluate(&unit, errors)))
        .collect()
}

/// The value of a unit as written; none after a complaint.
fn evaluate(written: &UnitExpr, errors: &mut Errors) -> ComponentUnit {
    let mut product = Some(Unit::ONE);
    for (symbol, (p, q)) in &written.factors {
        let shown = &symbol.display;
        let Some(unit) = Unit::named(&symbol.ascii) else {
            let (message, help) = match unit::coherent(&symbol.ascii) {
                Some((coherent, factor)) => (
                    format!("`{shown}` is not a coherent SI unit"),
                    format!("write {coherent} and {factor} times the value"),
                ),
                None => (
                    format!("unknown unit `{shown}`"),
                    similar_unit(&symbol.ascii),
                ),
            };
            errors.push_with_help(symbol.range, message, help);
            return None;
        };
        let power = unit.power(Ratio::new(*p, *q));
        product = product.and_then(|product| product.times(power?));
    }
    if product.is_none() {
        errors.push(written.range, "the exponent of a unit is too large here");
    }
    product
}

/// What to write for an unknown unit.
fn similar_unit(symbol: &str) -> String {
    match unit::symbols().find(|known| known.eq_ignore_ascii_case(symbol)) {
        Some(known) => format!("did you mean `{known}`?"),
        None if ["vec", "mat", "Vec", "Mat"]
            .iter()
            .any(|word| symbol.starts_with(word)) =>
        {
            "a shape stands in brackets: [3], [3, 3]".to_owned()
        }
        None => {
            let known: Vec<_> = unit::symbols().collect();
            format!("known are {} and 1", known.join(", "))
        }
    }
}

/// The shape as written.
pub(super) fn written_shape(ty: &TypeExpr) -> Option<Shape> {
    let (dimensions, _) = ty.shape.as_ref()?;
    Some(match dimensions.as_slice() {
        [rows, cols] => Shape {
            rows: *rows,
            cols: *cols,
        },
        [rows] => Shape::vector(*rows),
        _ => Shape::SCALAR,
    })
}

impl Typing<'_> {
    /// Gives every parameter, state, unknown and `let` its meaning.
    pub(super) fn define(&mut self, units: &[Option<ComponentUnit>]) {
        let symbols = self.symbols;
        let unit = |index: usize| units[index].unwrap_or(Some(Unit::ONE));
        let declared = symbols.list.iter().enumerate();
        for (index, symbol) in declared.filter(|(_, symbol)| !symbol.contested) {
            let shape = match symbol.kind {
                Kind::State => symbol.ty.and_then(written_shape).or(Some(Shape::SCALAR)),
                Kind::Parameter | Kind::Unknown => symbol.ty.and_then(written_shape),
                Kind::Let | Kind::Output(_) => None,
            };
            if let Some(shape) = shape {
                self.meanings[index] = Meaning::Variable(Type::uniform(shape, unit(index)));
            }
        }
        for index in self.order() {
            let symbol = &symbols.list[index];
            let Some(value) = symbol.value else {
                continue;
            };
            let value = self.expression(value);
            if symbol.contested {
                continue;
            }
            let is_let = symbol.kind == Kind::Let;
            self.meanings[index] = match (self.ty(value), symbol.ty.and_then(written_shape)) {
                // Which of the two is meant cannot be told.
                (_, Some(shape)) if !self.takes_shape(value, shape) => {
                    self.wrong_shape(value, symbol.name, shape);
                    Meaning::Unclear
                }
                (_, Some(_)) => continue,
                (Type::Poison, None) => Meaning::Unclear,
                (_, None) if is_let => {
                    self.lets.entry(value).or_insert(index);
                    Meaning::Value(value)
                }
                (Type::Matrix(shape, _), None) => {
                    Meaning::Variable(Type::uniform(*shape, unit(index)))
                }
                (Type::Multiple(_), None) => {
                    self.sizeless(index);
                    Meaning::Unclear
                }
            };
        }
    }

    pub(super) fn sizeless(&mut self, index: usize) {
        let name = self.symbols.list[index].name;
        let message = format!("`{}` is a multiple of `I` of unknown size", name.display);
        let help = format!("write its shape, such as `{}: [3, 3]`", name.display);
        self.errors.push_with_help(name.range, message, help);
    }

    /// The symbols whose value must be typed to know them, each behind those that it needs.
    /// Complains about `let`s in a circle.
    fn order(&mut self) -> Vec<usize> {
        let symbols = self.symbols;
        let n = symbols.list.len();
        let is_open = |symbol: &Symbol| match symbol.kind {
            Kind::Parameter | Kind::Unknown | Kind::Let => true,
            Kind::State | Kind::Output(_) => false,
        };
        let open: Vec<bool> = symbols.list.iter().map(is_open).collect();
        let needs: Vec<Vec<usize>> = (0..n)
            .map(|i| match symbols.list[i].value.filter(|_| open[i]) {
                Some(value) => mentioned(self.source, symbols, value),
                None => Vec::new(),
            })
            .collect();
        let (mut order, mut done, mut on_path) = (Vec::new(), vec![false; n], vec![false; n]);
        for root in (0..n).filter(|&i| open[i]) {
            // (symbol, how many of its needs are looked at)
            let mut path = vec![(root, 0)];
            on_path[root] = !done[root];
            while let Some((symbol, next)) = path.last_mut() {
                let symbol = *symbol;
                let need = needs[symbol].get(*next).copied();
                *next += 1;
                match need {
                    _ if done[symbol] => {
                        path.pop();
                    }
                    None => {
                        path.pop();
                        (done[symbol], on_path[symbol]) = (true, false);
                        order.push(symbol);
                    }
                    Some(need) if on_path[need] => {
                        let start = path.iter().position(|(s, _)| *s == need).unwrap_or(0);
                        let circle: Vec<_> = path[start..].iter().map(|(s, _)| *s).collect();
                        self.circle(&circle);
                    }
                    Some(need) if open[need] && !done[need] => {
                        on_path[need] = true;
                        path.push((need, 0));
                    }
                    Some(_) => {}
                }
            }
        }
        order
    }

    /// Complains about `let`s in a circle. A circle through a parameter or an unknown needs no word
    /// here: its value must not contain the name in the first place.
    fn circle(&mut self, circle: &[usize]) {
        let list = &self.symbols.list;
        if circle.iter().any(|&i| list[i].kind != Kind::Let) {
            return;
        }
        let first = list[circle[0]].name;
        let names = circle.iter().chain(&circle[..1]);
        let names: Vec<_> = names.map(|&i| list[i].name.display.as_str()).collect();
        let message = format!(
            "`{}` is defined through itself: {}",
            first.display,
            names.join(" → ")
        );
        self.errors.push(first.range, message);
    }
}

/// The symbols that an expression names, left to right.
fn mentioned(source: &[ast::Expr], symbols: &Symbols, root: ExprId) -> Vec<usize> {
    let mut pending = vec![root];
    let mut names = Vec::new();
    while let Some(id) = pending.pop() {
        let kind = &source[id.index()].kind;
        pending.extend(kind.operands().into_iter().rev());
        if let ExprKind::Name(name, _) | ExprKind::Call(name, _) = kind {
            names.extend(symbols.find(name));
        }
    }
    names.dedup();
    names
}
