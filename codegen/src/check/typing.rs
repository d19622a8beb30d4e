//! Typed expressions under construction.
//!
//! [`Typing::expression`] turns an expression of the file into typed ones, operands first, in loops
//! over flat lists. Each expression is typed once: a `let` used twice is one expression.

use super::complaints::Repeated;
use super::symbols::Symbols;
use super::types::ComponentUnit;
use super::types::Type;
use crate::ast;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::model::Expr;
use crate::model::Op;
use crate::unit::Unit;
use num_rational::BigRational;
use num_rational::Ratio;
use num_traits::ToPrimitive;
use num_traits::Zero;
use std::collections::BTreeMap;

/// Most scalar operations in one model, counted before anything is simplified. A 3D pendulum has some
/// thousands; the bound keeps a slip of the pen from filling the memory.
const MOST_OPERATIONS: usize = 1 << 20;

/// Largest numerator and denominator of a [`Constant`]: products of two still fit `i64` with room.
const SMALL: u64 = 1_000_000;

/// A small constant, such as an index or an exponent.
pub(super) type Constant = Ratio<i64>;

/// What is known about a typed expression besides its operation.
#[derive(Clone, Debug)]
pub(super) struct Fact {
    pub(super) ty: Type,
    /// Its value, where it is a small constant.
    pub(super) constant: Option<Constant>,
    /// Some name in it has a unit.
    pub(super) dimensioned: bool,
}

/// What a declared name stands for in expressions.
#[derive(Clone, Debug)]
pub(super) enum Meaning {
    /// Not typed yet, or in doubt after a mistake.
    Unclear,
    /// A parameter, state or unknown.
    Variable(Type),
    /// The value of a `let`.
    Value(ExprId),
}

/// Typed expressions, and what it takes to make more.
pub(super) struct Typing<'a> {
    pub(super) source: &'a [ast::Expr],
    pub(super) symbols: &'a Symbols<'a>,
    /// Meaning of each of `symbols`.
    pub(super) meanings: Vec<Meaning>,
    pub(super) errors: Errors,
    pub(super) exprs: Vec<Expr>,
    facts: Vec<Fact>,
    /// The typed expression of each of `source`.
    typed: Vec<Option<ExprId>>,
    /// Unit of t and h.
    pub(super) second: ComponentUnit,
    /// Units are not compared, as inside claims.
    pub(super) lenient: bool,
    /// `δ(…)` may stand here: in a claimed differential.
    pub(super) varying: bool,
    /// A unit got an exponent that is too large.
    out_of_bounds: bool,
    operations: usize,
    pub(super) repeated: BTreeMap<String, Repeated>,
    /// The `let` that has a value.
    pub(super) lets: BTreeMap<ExprId, usize>,
}

impl<'a> Typing<'a> {
    pub(super) fn new(
        source: &'a [ast::Expr],
        symbols: &'a Symbols<'a>,
        second: ComponentUnit,
        errors: Errors,
    ) -> Self {
        Self {
            source,
            symbols,
            meanings: vec![Meaning::Unclear; symbols.list.len()],
            errors,
            exprs: Vec::new(),
            facts: Vec::new(),
            typed: vec![None; source.len()],
            second,
            lenient: false,
            varying: false,
            out_of_bounds: false,
            operations: 0,
            repeated: BTreeMap::new(),
            lets: BTreeMap::new(),
        }
    }

    /// Types `root` and all it is made of.
    pub(super) fn expression(&mut self, root: ExprId) -> ExprId {
        let mut pending = vec![root];
        let mut untyped = Vec::new();
        while let Some(id) = pending.pop() {
            if self.typed[id.index()].is_none() {
                untyped.push(id);
                pending.extend(self.source[id.index()].kind.operands());
            }
        }
        // Operands come before users in the file's list, so ascending order is a valid one.
        untyped.sort_unstable();
        for id in untyped {
            let typed = self.one(id);
            self.typed[id.index()] = Some(typed);
        }
        self.of(root)
    }

    /// Leaves an expression of the file in doubt; a mistake in it is already reported.
    pub(super) fn doubt(&mut self, id: ExprId) {
        let poison = self.poison(self.source[id.index()].range);
        self.typed[id.index()] = Some(poison);
    }

    /// Types one expression whose operands are typed.
    fn one(&mut self, id: ExprId) -> ExprId {
        let ast::Expr { kind, range } = &self.source[id.index()];
        let range = *range;
        match kind {
            ExprKind::Number(value) => self.number(value, range),
            ExprKind::Name(name, level) => self.name(name, *level, range),
            ExprKind::Increment(name) => self.increment(name, range),
            ExprKind::Rate(name) => self.rate(name, range),
            ExprKind::Neg(a) => self.neg(self.of(*a), range),
            ExprKind::Binary(operator, a, b) => {
                self.binary(*operator, self.of(*a), self.of(*b), range)
            }
            ExprKind::Transpose(a) => self.transpose(self.of(*a), range),
            ExprKind::Field(a, index) => self.field(self.of(*a), *index, range),
            ExprKind::Call(name, arguments) => self.call(name, self.all_of(arguments), range),
            ExprKind::Component(a, indices) => {
                self.component(self.of(*a), &self.all_of(indices), range)
            }
            ExprKind::Stack(entries) => {
                let rows = entries.iter().map(|&e| vec![self.of(e)]).collect();
                self.blocks(rows, range)
            }
            ExprKind::Blocks(rows) => {
                let rows = rows.iter().map(|row| self.all_of(row)).collect();
                self.blocks(rows, range)
            }
        }
    }

    /// The typed expression of one of the file.
    fn of(&self, id: ExprId) -> ExprId {
        self.typed[id.index()].expect("operands are typed before their users")
    }

    fn all_of(&self, ids: &[ExprId]) -> Vec<ExprId> {
        ids.iter().map(|&id| self.of(id)).collect()
    }

    fn number(&mut self, value: &BigRational, range: Range) -> ExprId {
        let unit = (!value.is_zero()).then_some(Unit::ONE);
        self.push(Op::Number(value.clone()), Type::scalar(unit), range)
    }

    /// Adds an expression.
    pub(super) fn push(&mut self, op: Op, ty: Type, range: Range) -> ExprId {
        if std::mem::take(&mut self.out_of_bounds) {
            self.errors
                .push(range, "the exponent of a unit is too large here");
        }
        let operands = op.operands();
        let fact = Fact {
            constant: self.constant_of(&op),
            dimensioned: match operands.as_slice() {
                [] => has_unit(&ty) && !matches!(op, Op::Number(_) | Op::Pi | Op::Identity),
                operands => operands.iter().any(|&id| self.fact(id).dimensioned),
            },
            ty,
        };
        self.count(fact.ty.shape().map_or(1, |s| s.len()), range);
        let id = ExprId(self.exprs.len() as u32);
        self.exprs.push(Expr {
            op,
            shape: fact.ty.shape(),
            range,
        });
        self.facts.push(fact);
        id
    }

    /// Counts scalar operations; complains once when there are too many.
    pub(super) fn count(&mut self, operations: usize, range: Range) {
        let within = self.operations <= MOST_OPERATIONS;
        self.operations = self.operations.saturating_add(operations);
        if within && self.operations > MOST_OPERATIONS {
            let message = format!("the model has more than {MOST_OPERATIONS} scalar operations");
            self.errors.push(range, message);
        }
    }

    /// False once there are too many operations: then nothing large is computed any more.
    pub(super) fn within_bounds(&self) -> bool {
        self.operations <= MOST_OPERATIONS
    }

    pub(super) fn fact(&self, id: ExprId) -> &Fact {
        &self.facts[id.index()]
    }

    pub(super) fn ty(&self, id: ExprId) -> &Type {
        &self.facts[id.index()].ty
    }

    pub(super) fn range(&self, id: ExprId) -> Range {
        self.exprs[id.index()].range
    }

    /// True for the literal 0, which has any shape and any unit.
    pub(super) fn is_zero(&self, id: ExprId) -> bool {
        let is_poison = matches!(self.ty(id), Type::Poison);
        matches!(&self.exprs[id.index()].op, Op::Number(n) if n.is_zero()) && !is_poison
    }

    /// `a·b`
    pub(super) fn times(&mut self, a: ComponentUnit, b: ComponentUnit) -> ComponentUnit {
        let product = a?.times(b?);
        self.out_of_bounds |= product.is_none();
        product
    }

    /// `a/b`
    pub(super) fn over(&mut self, a: ComponentUnit, b: ComponentUnit) -> ComponentUnit {
        let quotient = a?.over(b?);
        self.out_of_bounds |= quotient.is_none();
        quotient
    }

    /// `a^power`
    pub(super) fn raised(&mut self, a: ComponentUnit, power: Ratio<i32>) -> ComponentUnit {
        let result = a?.power(power);
        self.out_of_bounds |= result.is_none();
        result
    }

    /// The value of an operation on small constants, if it is small itself.
    fn constant_of(&self, op: &Op) -> Option<Constant> {
        let of = |id: &ExprId| self.fact(*id).constant;
        let value = match op {
            Op::Number(n) => bounded_ratio(n)?,
            Op::Neg(a) => -of(a)?,
            Op::Add(a, b) => of(a)? + of(b)?,
            Op::Sub(a, b) => of(a)? - of(b)?,
            Op::Mul(a, b) => of(a)? * of(b)?,
            Op::Div(a, b) => of(a)? / of(b).filter(|b| !b.is_zero())?,
            Op::Pi
            | Op::Identity
            | Op::Parameter(_)
            | Op::State(..)
            | Op::Increment(_)
            | Op::Rate(_)
            | Op::Unknown(_)
            | Op::Variation(_)
            | Op::Time(_)
            | Op::StepSize
            | Op::Pow(..)
            | Op::Transpose(_)
            | Op::Component(..)
            | Op::Blocks { .. }
            | Op::Call(..) => return None,
        };
        is_small(value).then_some(value)
    }
}

fn bounded_ratio(n: &BigRational) -> Option<Constant> {
    let (numerator, denominator) = (n.numer().to_i64()?, n.denom().to_i64()?);
    let small = numerator.unsigned_abs().max(denominator.unsigned_abs()) <= SMALL;
    small.then(|| Ratio::new_raw(numerator, denominator))
}

fn is_small(value: Constant) -> bool {
    value.numer().unsigned_abs() <= SMALL && value.denom().unsigned_abs() <= SMALL
}

fn has_unit(ty: &Type) -> bool {
    let named = |unit: &ComponentUnit| unit.is_some_and(|u| !u.is_one());
    match ty {
        Type::Poison => false,
        Type::Multiple(unit) => named(unit),
        Type::Matrix(_, units) => units.iter().any(named),
    }
}
