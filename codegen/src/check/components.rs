//! Components, and calls, which look the same: `v(2)` and `sin(x)`.

use super::symbols::Builtin;
use super::types::Type;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::Level;
use crate::ast::Name;
use crate::diagnostic::Range;
use crate::function::Function;
use crate::model::Op;
use crate::model::Shape;
use crate::model::Solved;

/// `δ(x)` or `delta(x)`, unless the model declares the name.
const VARIATION: &str = "delta";

impl Typing<'_> {
    /// `f(a, b)`, or `v(i)` of a declared name.
    pub(super) fn call(&mut self, name: &Name, arguments: Vec<ExprId>, range: Range) -> ExprId {
        if let Some(function) = Function::named(&name.ascii) {
            return self.function(function, arguments, range);
        }
        if name.ascii == VARIATION && self.symbols.find(name).is_none() {
            return self.variation(&arguments, range);
        }
        if Builtin::named(&name.ascii).is_none() && self.symbols.find(name).is_none() {
            return self.unknown_function(name, range);
        }
        let variable = self.name(name, None, name.range);
        self.component(variable, &arguments, range)
    }

    /// `δ(Δx)`, `δ(x[k+1])` or `δ(F)`: the variation of an unknown.
    fn variation(&mut self, arguments: &[ExprId], range: Range) -> ExprId {
        if !self.varying {
            let message =
                "a variation stands only in `claim differential`, itself and not in a `let`";
            return self.fail(range, message);
        }
        let solved = match arguments {
            [a] => match self.exprs[a.index()].op {
                _ if matches!(self.ty(*a), Type::Poison) => return self.poison(range),
                Op::Increment(i) | Op::State(i, Level::Next) => Some((Solved::State(i), *a)),
                Op::Unknown(i) => Some((Solved::Own(i), *a)),
                _ => None,
            },
            _ => None,
        };
        let Some((solved, unknown)) = solved else {
            let message = "expected one unknown in the brackets of δ";
            return self.fail_with_help(range, message, "write δ(Δx), δ(x[k+1]) or δ(F)");
        };
        let ty = self.ty(unknown).clone();
        self.push(Op::Variation(solved), ty, range)
    }

    /// `a.x`, `a.y`, `a.z`: component `number` of a vector.
    pub(super) fn field(&mut self, a: ExprId, number: usize, range: Range) -> ExprId {
        let shape = match self.vector_shape(a, range, "write the name alone") {
            Ok(shape) => shape,
            Err(poison) => return poison,
        };
        if shape.rows != 1 && shape.cols != 1 {
            let message = format!("expected a vector in front of the point, found a {shape}");
            return self.fail_with_help(range, message, "write A(i, j)");
        }
        if number > shape.len() {
            let letter = ["x", "y", "z"][number - 1];
            let message = format!("`.{letter}` is component {number} of a {shape}");
            return self.fail(range, message);
        }
        self.pick(a, shape, number - 1, range)
    }

    /// `a(i)` or `a(i, j)`, counted from 1.
    pub(super) fn component(&mut self, a: ExprId, indices: &[ExprId], range: Range) -> ExprId {
        let product = "write `*` in front of the bracket for a product";
        let shape = match self.vector_shape(a, range, product) {
            Ok(shape) => shape,
            Err(poison) => return poison,
        };
        let (limits, usage) = if shape.rows == 1 || shape.cols == 1 {
            (vec![shape.len()], "one index (i)")
        } else {
            (vec![shape.rows, shape.cols], "two indices (i, j)")
        };
        let found = indices.len();
        if found != limits.len() {
            return self.fail(range, format!("a {shape} takes {usage}, found {found}"));
        }
        let mut position = 0;
        for (&index, limit) in indices.iter().zip(limits) {
            match self.index(index, limit) {
                Ok(i) => position = position * limit + i,
                Err(poison) => return poison,
            }
        }
        self.pick(a, shape, position, range)
    }

    /// An index from 1 to `limit`, less 1.
    fn index(&mut self, id: ExprId, limit: usize) -> Result<usize, ExprId> {
        let range = self.range(id);
        if matches!(self.ty(id), Type::Poison) {
            return Err(self.poison(range));
        }
        let Some(value) = self.fact(id).constant else {
            let message = "expected a constant integer as the index of a component";
            let help = "write `*` in front of the bracket for a product";
            return Err(self.fail_with_help(range, message, help));
        };
        let position = usize::try_from(value.to_integer()).ok();
        match position.filter(|i| value.is_integer() && (1..=limit).contains(i)) {
            Some(i) => Ok(i - 1),
            None => {
                let message = format!("expected an index from 1 to {limit}, found {value}");
                Err(self.fail(range, message))
            }
        }
    }

    /// The shape of something that has components; `help` is for scalars.
    fn vector_shape(&mut self, a: ExprId, range: Range, help: &str) -> Result<Shape, ExprId> {
        match self.ty(a) {
            Type::Poison => Err(self.poison(range)),
            Type::Multiple(_) => Err(self.fail(range, "the size of `I` is not known here")),
            Type::Matrix(shape, _) if shape.is_scalar() => {
                Err(self.fail_with_help(range, "a scalar has no components", help))
            }
            Type::Matrix(shape, _) => Ok(*shape),
        }
    }

    fn pick(&mut self, a: ExprId, shape: Shape, position: usize, range: Range) -> ExprId {
        let unit = match self.ty(a) {
            Type::Matrix(_, units) => units[position],
            Type::Poison | Type::Multiple(_) => None,
        };
        let (row, col) = (position / shape.cols, position % shape.cols);
        self.push(Op::Component(a, row, col), Type::scalar(unit), range)
    }
}
