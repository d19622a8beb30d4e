//! Types of declared names, `let`s included, in an order in which each needs only those before it.

use super::symbols::Kind;
use super::symbols::Symbol;
use super::symbols::Symbols;
use super::types::Type;
use super::typing::Meaning;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::TypeExpr;
use crate::ast::UnitExpr;
use crate::model::Shape;
use crate::unit::Unit;
use crate::unit::coherent;
use crate::unit::symbols as unit_symbols;
use num_rational::Ratio;

/// The unit of t and h: the second as soon as one declaration writes a unit, 1 in a model without.
pub(super) fn declared_second(symbols: &Symbols) -> Unit {
    let units = symbols
        .list
        .iter()
        .filter_map(|s| s.ty.and_then(|ty| ty.unit.as_ref()));
    let plain = |unit: &UnitExpr| {
        unit.factors
            .iter()
            .all(|(name, _)| Unit::named(&name.ascii).is_some_and(Unit::is_one))
    };
    if units.into_iter().all(plain) {
        Unit::ONE
    } else {
        Unit::SECOND
    }
}

/// How far the search for an order has come with a symbol.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mark {
    New,
    Open,
    Done,
}

impl Typing<'_> {
    /// Gives every declared name its type, operands first.
    pub(super) fn declare(&mut self) {
        let n = self.symbols.list.len();
        let mut marks = vec![Mark::New; n];
        for start in 0..n {
            let mut path = vec![start];
            while let Some(&top) = path.last() {
                if marks[top] == Mark::Done {
                    path.pop();
                    continue;
                }
                marks[top] = Mark::Open;
                let needs = self.needs(top);
                if let Some(&back) = needs.iter().find(|&&i| marks[i] == Mark::Open) {
                    self.complain_of_cycle(&path, back);
                    marks[top] = Mark::Done;
                } else if let Some(&next) = needs.iter().find(|&&i| marks[i] == Mark::New) {
                    path.push(next);
                } else {
                    self.declare_one(top);
                    marks[top] = Mark::Done;
                }
            }
        }
    }

    /// The names whose types must be known before that of symbol `index`.
    fn needs(&self, index: usize) -> Vec<usize> {
        let symbol = self.symbols.list[index];
        match (symbol.kind, symbol.value) {
            (Kind::Let, Some(value)) => self.names_in(value),
            (Kind::Parameter | Kind::Unknown, Some(value)) if shape_of(symbol).is_none() => {
                self.names_in(value)
            }
            _ => Vec::new(),
        }
    }

    /// The declared names in an expression of the file.
    fn names_in(&self, root: ExprId) -> Vec<usize> {
        let mut names = Vec::new();
        let mut seen = std::collections::BTreeSet::new();
        let mut open = vec![root];
        while let Some(id) = open.pop() {
            if !seen.insert(id) {
                continue;
            }
            let kind = &self.source[id.index()].kind;
            if let ExprKind::Name(name, _)
            | ExprKind::Increment(name)
            | ExprKind::Rate(name)
            | ExprKind::Call(name, _) = kind
            {
                names.extend(self.symbols.find(name));
            }
            open.extend(kind.operands());
        }
        names.reverse();
        names
    }

    fn complain_of_cycle(&mut self, path: &[usize], back: usize) {
        let start = path.iter().position(|&i| i == back).unwrap_or(0);
        let name = |i: usize| &self.symbols.list[i].name.display;
        let names: Vec<_> = path[start..]
            .iter()
            .map(|&i| format!("`{}`", name(i)))
            .collect();
        let message = match names.as_slice() {
            [one] => format!("{one} is defined by itself"),
            _ => format!(
                "names defined by each other: {} → {}",
                names.join(" → "),
                names[0]
            ),
        };
        self.errors
            .push(self.symbols.list[back].name.range, message);
    }

    fn declare_one(&mut self, index: usize) {
        let symbol = self.symbols.list[index];
        let meaning = match (symbol.kind, symbol.value) {
            (Kind::Let, Some(value)) => Meaning::Value(self.expression(value)),
            (Kind::Parameter | Kind::Unknown, Some(value)) => {
                let shape = match shape_of(symbol) {
                    Some(shape) => Some(shape),
                    None => {
                        let value = self.expression(value);
                        self.shape_of_value(symbol, value)
                    }
                };
                self.variable(symbol, shape)
            }
            (Kind::State, _) => {
                self.variable(symbol, Some(shape_of(symbol).unwrap_or(Shape::SCALAR)))
            }
            _ => self.variable(symbol, shape_of(symbol)),
        };
        self.meanings[index] = meaning;
    }

    fn shape_of_value(&mut self, symbol: Symbol, value: ExprId) -> Option<Shape> {
        if let Type::Multiple(_) = self.ty(value) {
            let name = &symbol.name.display;
            let message = format!("the size of `I` cannot be told here, give `{name}` a shape");
            let help = format!("write `{name}: [n, n]`");
            self.errors.push_with_help(self.range(value), message, help);
        }
        self.ty(value).shape()
    }

    fn variable(&mut self, symbol: Symbol, shape: Option<Shape>) -> Meaning {
        let unit = symbol
            .ty
            .and_then(|ty| ty.unit.as_ref())
            .map(|unit| self.unit(unit));
        let unit = unit.unwrap_or(Some(Unit::ONE));
        match shape {
            Some(shape) => Meaning::Variable(Type::uniform(shape, unit)),
            None => Meaning::Unclear,
        }
    }

    /// A unit as written; absent after a mistake.
    pub(super) fn unit(&mut self, written: &UnitExpr) -> Option<Unit> {
        let mut unit = Some(Unit::ONE);
        for (name, (numerator, denominator)) in &written.factors {
            let Some(factor) = Unit::named(&name.ascii) else {
                self.unknown_unit(name);
                unit = None;
                continue;
            };
            let power = factor.power(Ratio::new(*numerator, *denominator));
            unit = unit.and_then(|unit| unit.times(power?));
        }
        unit
    }

    fn unknown_unit(&mut self, name: &crate::ast::Name) {
        let message = format!(
            "unknown unit `{}`, expected coherent SI units",
            name.display
        );
        let close = |symbol: &&str| symbol.eq_ignore_ascii_case(&name.ascii);
        let help = match coherent(&name.ascii) {
            Some((unit, factor)) => format!("write {unit} and multiply the number by {factor}"),
            None => match unit_symbols().find(close) {
                Some(symbol) => format!("did you mean `{symbol}`?"),
                None => format!("known are {}", unit_symbols().collect::<Vec<_>>().join(" ")),
            },
        };
        self.errors.push_with_help(name.range, message, help);
    }
}

/// The shape written behind the name of `symbol`.
pub(super) fn shape_of(symbol: Symbol) -> Option<Shape> {
    let TypeExpr { shape, .. } = symbol.ty?;
    match shape.as_ref()?.0.as_slice() {
        [rows] => Some(Shape::vector(*rows)),
        [rows, cols, ..] => Some(Shape {
            rows: *rows,
            cols: *cols,
        }),
        [] => None,
    }
}
