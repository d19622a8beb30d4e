//! Operators on values of expressions.

use super::context::Context;
use super::context::Value;
use super::context::fit;
use super::context::scalar;
use super::functions;
use crate::ast::ExprId;
use crate::dag::Dag;
use crate::dag::NodeId;
use crate::function::Function;
use crate::matrix::Matrix;
use crate::model::Shape;
use crate::normal::rational;
use num_traits::Signed;
use num_traits::ToPrimitive;

/// Largest exponent a model may write.
const LARGEST_EXPONENT: i64 = 64;

impl Context<'_> {
    pub(super) fn map(
        &mut self,
        value: Value,
        mut f: impl FnMut(&mut Dag, NodeId) -> NodeId,
    ) -> Value {
        match value {
            Value::Matrix(matrix) => Value::Matrix(matrix.map(|e| f(&mut self.dag, e))),
            Value::Identity(factor) => Value::Identity(f(&mut self.dag, factor)),
        }
    }

    /// a ± b
    pub(super) fn combine(
        &mut self,
        id: ExprId,
        a: ExprId,
        b: ExprId,
        f: impl Fn(&mut Dag, NodeId, NodeId) -> NodeId,
    ) -> Value {
        let (a, b) = (self.computed(a), self.computed(b));
        let shape = match (&a, &b) {
            (Value::Identity(x), Value::Identity(y)) => {
                return Value::Identity(f(&mut self.dag, *x, *y));
            }
            (Value::Identity(_), Value::Matrix(m)) | (Value::Matrix(m), Value::Identity(_)) => {
                m.shape
            }
            (Value::Matrix(m), Value::Matrix(n)) if m.shape.is_scalar() => n.shape,
            (Value::Matrix(m), Value::Matrix(_)) => m.shape,
        };
        let fitted = (fit(&mut self.dag, &a, shape), fit(&mut self.dag, &b, shape));
        match fitted {
            (Some(a), Some(b)) => Value::Matrix(a.zip(&b, |x, y| f(&mut self.dag, x, y))),
            _ => self.misfit(id),
        }
    }

    pub(super) fn multiply(&mut self, a: ExprId, b: ExprId) -> Value {
        match (self.computed(a), self.computed(b)) {
            (Value::Matrix(m), other) | (other, Value::Matrix(m)) if m.shape.is_scalar() => {
                self.map(other, |dag, e| dag.mul(m.entries[0], e))
            }
            (Value::Matrix(m), Value::Matrix(n)) => Value::Matrix(m.product(&mut self.dag, &n)),
            (Value::Identity(factor), other) | (other, Value::Identity(factor)) => {
                self.map(other, |dag, e| dag.mul(factor, e))
            }
        }
    }

    pub(super) fn divide(&mut self, id: ExprId, a: ExprId, b: ExprId) -> Value {
        let Value::Matrix(divisor) = self.computed(b) else {
            return self.misfit(id);
        };
        let divisor = divisor.entries[0];
        if self.dag.is_zero(divisor) {
            self.errors
                .push(self.model.expr(b).range, "division by zero");
            return self.computed(a);
        }
        let value = self.computed(a);
        self.map(value, |dag, e| dag.div(e, divisor))
    }

    pub(super) fn raise(&mut self, id: ExprId, a: ExprId, b: ExprId) -> Value {
        let (Value::Matrix(base), Value::Matrix(exponent)) = (self.computed(a), self.computed(b))
        else {
            return self.misfit(id);
        };
        let (base, exponent) = (base.entries[0], exponent.entries[0]);
        let value = self.dag.as_constant(exponent).cloned();
        if value
            .as_ref()
            .is_some_and(|e| e.abs() > rational(LARGEST_EXPONENT))
        {
            let message =
                format!("the exponent must be between -{LARGEST_EXPONENT} and {LARGEST_EXPONENT}");
            self.errors.push(self.model.expr(b).range, message);
            return scalar(base);
        }
        if self.dag.is_zero(base) && value.is_some_and(|e| e.to_f64().is_none_or(|e| e <= 0.0)) {
            self.errors.push(
                self.model.expr(id).range,
                "zero to a power that is not positive",
            );
            return scalar(base);
        }
        scalar(self.dag.power(base, exponent))
    }

    pub(super) fn blocks(
        &mut self,
        id: ExprId,
        rows: &[Vec<ExprId>],
        heights: &[usize],
        widths: &[usize],
    ) -> Value {
        let shape = Shape {
            rows: heights.iter().sum(),
            cols: widths.iter().sum(),
        };
        let mut entries = Vec::with_capacity(shape.len());
        for (row, &height) in rows.iter().zip(heights) {
            let mut fitted = Vec::new();
            for (&block, &width) in row.iter().zip(widths) {
                let value = self.computed(block);
                match fit(
                    &mut self.dag,
                    &value,
                    Shape {
                        rows: height,
                        cols: width,
                    },
                ) {
                    Some(matrix) => fitted.push(matrix),
                    None => return self.misfit(id),
                }
            }
            for i in 0..height {
                for block in &fitted {
                    entries.extend((0..block.shape.cols).map(|j| block.at(i, j)));
                }
            }
        }
        Value::Matrix(Matrix { shape, entries })
    }

    pub(super) fn call(&mut self, id: ExprId, function: Function, arguments: &[ExprId]) -> Value {
        let mut matrices = Vec::with_capacity(arguments.len());
        for &argument in arguments {
            match self.computed(argument) {
                Value::Matrix(matrix) => matrices.push(matrix),
                Value::Identity(_) => return self.misfit(id),
            }
        }
        match functions::apply(&mut self.dag, function, &matrices) {
            Ok(matrix) => Value::Matrix(matrix),
            Err(message) => {
                self.errors.push(self.model.expr(id).range, message);
                let shape = self.model.expr(id).shape.unwrap_or(Shape::SCALAR);
                Value::Matrix(Matrix {
                    shape,
                    entries: vec![self.dag.integer(0); shape.len()],
                })
            }
        }
    }

    /// Where the size of an `I` cannot be told.
    pub(super) fn misfit(&mut self, id: ExprId) -> Value {
        self.errors.push_with_help(
            self.model.expr(id).range,
            "the size of `I` cannot be told here",
            "write the matrix out, for example diag(1, 1, 1)",
        );
        scalar(self.dag.integer(0))
    }
}
