//! Types of operators.
//!
//! ```text
//! a ± b   equal shapes, equal units          0 and multiples of I adapt
//! a * b   scalar × anything, matrix product  (n×m)(m×p) = n×p
//! a / b   b scalar
//! a ^ b   both scalar, b dimensionless       a with a unit needs a constant b
//! ```

use super::types::ComponentUnit;
use super::types::Type;
use super::types::diagonal;
use super::types::position;
use super::typing::Typing;
use crate::ast::Binary;
use crate::ast::ExprId;
use crate::diagnostic::Range;
use crate::model::Op;
use crate::model::Shape;
use crate::unit::Unit;
use num_rational::Ratio;
use num_traits::One;
use num_traits::ToPrimitive;

impl Typing<'_> {
    /// `-a`
    pub(super) fn neg(&mut self, a: ExprId, range: Range) -> ExprId {
        let ty = self.ty(a).clone();
        self.push(Op::Neg(a), ty, range)
    }

    /// `a.T`
    pub(super) fn transpose(&mut self, a: ExprId, range: Range) -> ExprId {
        let ty = match self.ty(a) {
            Type::Matrix(shape, units) => {
                let (rows, cols) = (shape.cols, shape.rows);
                let unit = |i: usize| units[(i % cols) * rows + i / cols];
                Type::Matrix(Shape { rows, cols }, (0..shape.len()).map(unit).collect())
            }
            other => other.clone(),
        };
        self.push(Op::Transpose(a), ty, range)
    }

    /// `a + b` and its kin.
    pub(super) fn binary(
        &mut self,
        operator: Binary,
        a: ExprId,
        b: ExprId,
        range: Range,
    ) -> ExprId {
        if matches!(self.ty(a), Type::Poison) || matches!(self.ty(b), Type::Poison) {
            return self.poison(range);
        }
        match operator {
            Binary::Add => self.sum(Op::Add(a, b), a, b, range),
            Binary::Sub => self.sum(Op::Sub(a, b), a, b, range),
            Binary::Mul => self.product(a, b, range),
            Binary::Div => self.quotient(a, b, range),
            Binary::Pow => self.power(a, b, range),
        }
    }

    fn sum(&mut self, op: Op, a: ExprId, b: ExprId, range: Range) -> ExprId {
        let (verb, link) = match op {
            Op::Sub(..) => ("subtracting", "from"),
            _ => ("adding", "to"),
        };
        let Some((shape, left, right)) = self.align(a, b) else {
            let (added, to) = (self.ty(b).noun(), self.ty(a).noun());
            let message = format!("{verb} {added} {link} {to}");
            let help = self.identity_help(a, b);
            let operand = if self.is_abbreviation(a) { a } else { b };
            return self.fail_with(operand, range, message, help.as_deref());
        };
        let at = self.place(b, range);
        let units = self.equal_units(at, shape, &left, &right, |position, left, right| {
            format!("{verb} {right} {link} {left}{position}")
        });
        let ty = match shape {
            Some(shape) => Type::Matrix(shape, units),
            None => Type::Multiple(units[0]),
        };
        self.push(op, ty, range)
    }

    /// The common shape of `a` and `b` and the units of both in it; none if their shapes differ. The
    /// shape itself is absent for two multiples of `I`.
    pub(super) fn align(
        &self,
        a: ExprId,
        b: ExprId,
    ) -> Option<(Option<Shape>, Vec<ComponentUnit>, Vec<ComponentUnit>)> {
        match (self.ty(a), self.ty(b)) {
            (Type::Matrix(p, left), Type::Matrix(q, right)) if p == q => {
                Some((Some(*p), left.clone(), right.clone()))
            }
            (Type::Multiple(left), Type::Multiple(right)) => {
                Some((None, vec![*left], vec![*right]))
            }
            (Type::Multiple(left), _) if self.is_zero(b) => Some((None, vec![*left], vec![None])),
            (_, Type::Multiple(right)) if self.is_zero(a) => Some((None, vec![None], vec![*right])),
            (left, right) if self.is_zero(a) || self.is_zero(b) => {
                let shape = if self.is_zero(a) { right } else { left }.shape()?;
                let spread = |ty: &Type| self.spread(ty, shape);
                Some((Some(shape), spread(left), spread(right)))
            }
            (left @ Type::Matrix(shape, _), right @ Type::Multiple(_))
            | (left @ Type::Multiple(_), right @ Type::Matrix(shape, _)) => {
                let square = shape.rows == shape.cols && !shape.is_scalar();
                let spread = |ty: &Type| self.spread(ty, *shape);
                square.then(|| (Some(*shape), spread(left), spread(right)))
            }
            _ => None,
        }
    }

    /// Units of a value of type `ty` where it takes the shape `shape`.
    pub(super) fn spread(&self, ty: &Type, shape: Shape) -> Vec<ComponentUnit> {
        match ty {
            Type::Matrix(own, units) if *own == shape => units.clone(),
            Type::Multiple(unit) if shape.rows == shape.cols => diagonal(shape.rows, *unit),
            _ => vec![None; shape.len()],
        }
    }

    /// The common unit of each component. Reports the first pair that differs through `message`,
    /// which gets the position in words, the left and the right unit.
    pub(super) fn equal_units(
        &mut self,
        at: Range,
        shape: Option<Shape>,
        left: &[ComponentUnit],
        right: &[ComponentUnit],
        message: impl Fn(&str, Unit, Unit) -> String,
    ) -> Vec<ComponentUnit> {
        let differ = |i: &usize| matches!((left[*i], right[*i]), (Some(a), Some(b)) if a != b);
        let mismatches: Vec<usize> = (0..left.len()).filter(differ).collect();
        if let Some(&first) = mismatches.first()
            && let (Some(a), Some(b)) = (left[first], right[first])
        {
            // Where every component differs, naming one of them would mislead.
            let everywhere = mismatches.len() == left.len();
            let position = match shape {
                Some(shape) if !everywhere => position(shape, first),
                _ => String::new(),
            };
            self.unit_error(at, message(&position, a, b));
        }
        (0..left.len())
            .map(|i| {
                if differ(&i) {
                    None
                } else {
                    left[i].or(right[i])
                }
            })
            .collect()
    }

    /// For a number next to a square matrix: the multiple of `I` that was meant.
    fn identity_help(&self, a: ExprId, b: ExprId) -> Option<String> {
        let scalar = [a, b].into_iter().find(|&id| {
            let shape = self.ty(id).shape();
            shape.is_some_and(Shape::is_scalar)
        })?;
        let other = if scalar == a { b } else { a };
        let square = match self.ty(other) {
            Type::Multiple(_) => true,
            ty => ty
                .shape()
                .is_some_and(|s| s.rows == s.cols && !s.is_scalar()),
        };
        let factor = self.fact(scalar).constant.filter(|c| c.is_integer());
        let help = match factor {
            Some(c) if c.is_one() => "write I for the identity matrix".to_owned(),
            Some(c) => format!("write {c}*I for a multiple of the identity matrix"),
            None => "write c*I for a multiple of the identity matrix".to_owned(),
        };
        square.then_some(help)
    }

    fn product(&mut self, a: ExprId, b: ExprId, range: Range) -> ExprId {
        let ty = match (self.ty(a).clone(), self.ty(b).clone()) {
            (Type::Matrix(p, left), right) if p.is_scalar() => self.scaled(&right, left[0]),
            (left, Type::Matrix(q, right)) if q.is_scalar() => self.scaled(&left, right[0]),
            (Type::Multiple(unit), other) | (other, Type::Multiple(unit)) => {
                self.scaled(&other, unit)
            }
            (Type::Matrix(p, left), Type::Matrix(q, right)) if p.cols == q.rows => {
                self.count(p.rows * p.cols * q.cols, range);
                self.matrix_product(p, &left, q, &right, range)
            }
            (left, right) => {
                let message = format!("multiplying {} by {}", left.noun(), right.noun());
                let vectors = left.shape() == right.shape();
                let is_vector = left.shape().is_some_and(|s| s.cols == 1);
                let (message, help) = if vectors && is_vector {
                    let help = "write a.T*b for the scalar product, a*b.T for the matrix";
                    (message, Some(help))
                } else {
                    let (n, m) = (inner(left.shape(), false), inner(right.shape(), true));
                    (format!("{message}: {n} columns meet {m} rows"), None)
                };
                let operand = [a, b].into_iter().find(|&id| self.is_abbreviation(id));
                return match (operand, help) {
                    (Some(operand), _) => self.fail_with(operand, range, message, help),
                    (None, Some(help)) => self.fail_with_help(range, message, help),
                    (None, None) => self.fail(range, message),
                };
            }
        };
        self.push(Op::Mul(a, b), ty, range)
    }

    fn scaled(&mut self, ty: &Type, factor: ComponentUnit) -> Type {
        let mut ty = ty.clone();
        match &mut ty {
            Type::Poison => {}
            Type::Multiple(unit) => *unit = self.times(*unit, factor),
            Type::Matrix(_, units) => {
                for unit in units {
                    *unit = self.times(*unit, factor);
                }
            }
        }
        ty
    }

    fn matrix_product(
        &mut self,
        p: Shape,
        left: &[ComponentUnit],
        q: Shape,
        right: &[ComponentUnit],
        range: Range,
    ) -> Type {
        let shape = Shape {
            rows: p.rows,
            cols: q.cols,
        };
        if !self.within_bounds() {
            return Type::Poison;
        }
        let mut units = Vec::with_capacity(shape.len());
        for i in 0..shape.len() {
            let (row, col) = (i / q.cols, i % q.cols);
            let terms: Vec<_> = (0..p.cols)
                .map(|k| self.times(left[row * p.cols + k], right[k * q.cols + col]))
                .collect();
            units.push(self.one_unit(&terms, range, "the terms of this product"));
        }
        Type::Matrix(shape, units)
    }

    /// The unit that all of `units` share; complains if they do not.
    pub(super) fn one_unit(
        &mut self,
        units: &[ComponentUnit],
        range: Range,
        what: &str,
    ) -> ComponentUnit {
        let mut present = units.iter().flatten();
        let first = *present.next()?;
        match present.find(|&&unit| unit != first) {
            None => Some(first),
            Some(other) => {
                let message = format!("{what} have the units {first} and {other}");
                self.unit_error(range, message);
                None
            }
        }
    }

    fn quotient(&mut self, a: ExprId, b: ExprId, range: Range) -> ExprId {
        let divisor = match self.ty(b).clone() {
            Type::Matrix(shape, units) if shape.is_scalar() => units[0],
            other => {
                let message = format!("dividing by {}, expected a scalar", other.noun());
                let square = other.shape().is_some_and(|s| s.rows == s.cols);
                return if square {
                    let help = "write inv(A)*b for the solution of A*x = b";
                    self.fail_with_help(self.range(b), message, help)
                } else {
                    self.fail(self.range(b), message)
                };
            }
        };
        if self.is_zero(b) {
            return self.fail(self.range(b), "dividing by zero");
        }
        let mut ty = self.ty(a).clone();
        match &mut ty {
            Type::Poison => {}
            Type::Multiple(unit) => *unit = self.over(*unit, divisor),
            Type::Matrix(_, units) => {
                for unit in units {
                    *unit = self.over(*unit, divisor);
                }
            }
        }
        self.push(Op::Div(a, b), ty, range)
    }

    fn power(&mut self, a: ExprId, b: ExprId, range: Range) -> ExprId {
        let scalar = |ty: &Type| match ty {
            Type::Matrix(shape, units) if shape.is_scalar() => Some(units[0]),
            _ => None,
        };
        let Some(base) = scalar(self.ty(a)) else {
            let message = format!(
                "raising {} to a power, expected a scalar",
                self.ty(a).noun()
            );
            let help = match self.ty(a).shape() {
                Some(shape) if shape.rows != shape.cols => "write x.T*x for the square of a vector",
                _ => "write A*A for the square of a matrix",
            };
            return self.fail_with_help(self.range(a), message, help);
        };
        let Some(exponent) = scalar(self.ty(b)) else {
            let message = format!("the exponent is {}, expected a scalar", self.ty(b).noun());
            return self.fail(self.range(b), message);
        };
        if let Some(unit) = exponent.filter(|unit| !unit.is_one()) {
            let message = format!("the exponent has the unit {unit}, expected a number");
            self.unit_error(self.range(b), message);
        }
        let unit = match base {
            Some(unit) if !unit.is_one() => self.unit_of_power(unit, b),
            other => other,
        };
        self.push(Op::Pow(a, b), Type::scalar(unit), range)
    }

    fn unit_of_power(&mut self, unit: Unit, exponent: ExprId) -> ComponentUnit {
        let constant = self.fact(exponent).constant;
        let small =
            constant.and_then(|c| Some(Ratio::new_raw(c.numer().to_i32()?, c.denom().to_i32()?)));
        if small.is_none() {
            let message = format!("a base with the unit {unit} needs a constant exponent");
            self.unit_error(self.range(exponent), message);
        }
        small.and_then(|power| self.raised(Some(unit), power))
    }
}

/// Rows or columns of a shape.
fn inner(shape: Option<Shape>, rows: bool) -> usize {
    shape.map_or(0, |s| if rows { s.rows } else { s.cols })
}
