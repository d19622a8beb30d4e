//! Types of function calls.

use super::symbols::Builtin;
use super::types::ComponentUnit;
use super::types::Type;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::Name;
use crate::diagnostic::Range;
use crate::function::Function;
use crate::function::TABLE;
use crate::model::Op;
use crate::model::Shape;
use crate::unit::Unit;
use num_rational::Ratio;

/// Largest square matrix that `det` and `inv` take.
const LARGEST_INVERSE: usize = 3;

/// The call under inspection.
struct Call<'c> {
    function: Function,
    arguments: &'c [ExprId],
    range: Range,
}

/// A mistake is already reported.
struct Reported;

impl Typing<'_> {
    /// `f(a, b)`, or `x(i)` for a declared `x`.
    pub(super) fn call(&mut self, name: &Name, arguments: Vec<ExprId>, range: Range) -> ExprId {
        if let Some(function) = Function::named(&name.ascii) {
            return self.function(Call {
                function,
                arguments: &arguments,
                range,
            });
        }
        if self.symbols.find(name).is_some() || Builtin::named(&name.ascii).is_some() {
            let of = self.name(name, None, name.range);
            return self.component(of, &arguments, range);
        }
        self.unknown_function(name, range)
    }

    fn function(&mut self, call: Call) -> ExprId {
        let expected = TABLE
            .iter()
            .find(|row| row.1 == call.function)
            .map_or(0, |row| row.2);
        let found = call.arguments.len();
        if expected != found && (expected != usize::MAX || found == 0) {
            let name = call.function.name();
            let takes = match expected {
                1 => "one argument".to_owned(),
                usize::MAX => "at least one argument".to_owned(),
                n => format!("{n} arguments"),
            };
            return self.fail(call.range, format!("`{name}` takes {takes}, found {found}"));
        }
        if call
            .arguments
            .iter()
            .any(|&a| matches!(self.ty(a), Type::Poison))
        {
            return self.poison(call.range);
        }
        match self.type_of_call(&call) {
            Ok(ty) => self.push(
                Op::Call(call.function, call.arguments.to_vec()),
                ty,
                call.range,
            ),
            Err(Reported) => self.poison(call.range),
        }
    }

    fn type_of_call(&mut self, call: &Call) -> Result<Type, Reported> {
        let one = Type::scalar(Some(Unit::ONE));
        let first = call.arguments[0];
        match call.function {
            Function::Exp if !self.is_scalar(first) => self.rotation(call),
            Function::Cay => self.rotation(call),
            Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Asin
            | Function::Acos
            | Function::Atan
            | Function::Sinh
            | Function::Cosh
            | Function::Tanh
            | Function::Exp
            | Function::Log
            | Function::Sinc
            | Function::Cosc => self.number_argument(call, first).map(|()| one),
            Function::Stumpff => {
                self.number_argument(call, first)?;
                self.number_argument(call, call.arguments[1])?;
                Ok(one)
            }
            Function::Atan2 => {
                let units = [
                    self.scalar(call, first)?,
                    self.scalar(call, call.arguments[1])?,
                ];
                self.one_unit(&units, call.range, "the arguments of `atan2`");
                Ok(one)
            }
            Function::Sqrt => {
                let unit = self.scalar(call, first)?;
                Ok(Type::scalar(self.raised(unit, Ratio::new(1, 2))))
            }
            Function::Abs => Ok(Type::scalar(self.scalar(call, first)?)),
            Function::Sign => self.scalar(call, first).map(|_| one),
            Function::Norm => {
                let (_, units) = self.vector(call, first, None)?;
                let unit = self.one_unit(&units, call.range, "the components of this vector");
                Ok(Type::scalar(unit))
            }
            Function::Dot => {
                let (n, left) = self.vector(call, first, None)?;
                let (_, right) = self.vector(call, call.arguments[1], Some(n))?;
                let terms: Vec<_> = (0..n).map(|i| self.times(left[i], right[i])).collect();
                Ok(Type::scalar(self.one_unit(
                    &terms,
                    call.range,
                    "the terms of this product",
                )))
            }
            Function::Cross => self.cross(call),
            Function::Skew => self.skew(call),
            Function::Vee => self.vee(call),
            Function::Rx | Function::Ry | Function::Rz => {
                self.number_argument(call, first)?;
                Ok(Type::uniform(Shape { rows: 3, cols: 3 }, Some(Unit::ONE)))
            }
            Function::Diag => self.diag(call),
            Function::Trace => {
                let (n, units) = self.square(call, first, usize::MAX)?;
                let diagonal: Vec<_> = (0..n).map(|i| units[i * n + i]).collect();
                Ok(Type::scalar(self.one_unit(
                    &diagonal,
                    call.range,
                    "the terms of this trace",
                )))
            }
            Function::Det => self.determinant(call),
            Function::Inv => self.inverse(call),
        }
    }

    fn is_scalar(&self, id: ExprId) -> bool {
        self.ty(id).shape().is_some_and(Shape::is_scalar)
    }

    fn wrong_shape(&mut self, call: &Call, argument: ExprId, expected: &str) -> Reported {
        let found = self.ty(argument).noun();
        let message = format!("`{}` takes {expected}, found {found}", call.function.name());
        self.errors.push(self.range(argument), message);
        Reported
    }

    /// The unit of a scalar argument.
    fn scalar(&mut self, call: &Call, argument: ExprId) -> Result<ComponentUnit, Reported> {
        match self.ty(argument) {
            Type::Matrix(shape, units) if shape.is_scalar() => Ok(units[0]),
            _ => Err(self.wrong_shape(call, argument, "a scalar")),
        }
    }

    /// A scalar argument without a unit.
    fn number_argument(&mut self, call: &Call, argument: ExprId) -> Result<(), Reported> {
        if let Some(unit) = self.scalar(call, argument)?.filter(|unit| !unit.is_one()) {
            let name = call.function.name();
            let message = format!("`{name}` takes a number without a unit, found {unit}");
            self.unit_error(self.range(argument), message);
        }
        Ok(())
    }

    /// Length and units of a vector argument, of length `n` if one is asked for.
    fn vector(
        &mut self,
        call: &Call,
        argument: ExprId,
        n: Option<usize>,
    ) -> Result<(usize, Vec<ComponentUnit>), Reported> {
        match self.ty(argument) {
            Type::Matrix(shape, units) if shape.cols == 1 && n.is_none_or(|n| n == shape.rows) => {
                Ok((shape.rows, units.clone()))
            }
            _ => {
                let expected =
                    n.map_or("a vector".to_owned(), |n| format!("a {}", Shape::vector(n)));
                Err(self.wrong_shape(call, argument, &expected))
            }
        }
    }

    /// Rows and units of a square argument.
    fn square(
        &mut self,
        call: &Call,
        argument: ExprId,
        largest: usize,
    ) -> Result<(usize, Vec<ComponentUnit>), Reported> {
        match self.ty(argument) {
            Type::Matrix(shape, units) if shape.rows == shape.cols && shape.rows <= largest => {
                Ok((shape.rows, units.clone()))
            }
            _ if largest == usize::MAX => Err(self.wrong_shape(call, argument, "a square matrix")),
            _ => {
                let expected = format!("a square matrix up to {largest}×{largest}");
                Err(self.wrong_shape(call, argument, &expected))
            }
        }
    }

    /// `exp(A)` and `cay(A)`; that A is skew shows in `lower`.
    fn rotation(&mut self, call: &Call) -> Result<Type, Reported> {
        let argument = call.arguments[0];
        let shape = self.ty(argument).shape();
        let Some(shape) = shape.filter(|s| s.rows == s.cols && (2..=3).contains(&s.rows)) else {
            let name = call.function.name();
            let scalar = if call.function == Function::Exp {
                "a scalar or "
            } else {
                ""
            };
            let message = format!(
                "`{name}` takes {scalar}a skew 2×2 or 3×3 matrix, found {}",
                self.ty(argument).noun()
            );
            let help = format!("write {name}(S(v))");
            self.errors
                .push_with_help(self.range(argument), message, help);
            return Err(Reported);
        };
        if let Type::Matrix(_, units) = self.ty(argument).clone()
            && let Some(unit) = units.into_iter().flatten().find(|unit| !unit.is_one())
        {
            let name = call.function.name();
            let message = format!("`{name}` takes numbers without a unit, found {unit}");
            self.unit_error(self.range(argument), message);
        }
        Ok(Type::uniform(shape, Some(Unit::ONE)))
    }

    fn cross(&mut self, call: &Call) -> Result<Type, Reported> {
        let (_, a) = self.vector(call, call.arguments[0], Some(3))?;
        let (_, b) = self.vector(call, call.arguments[1], Some(3))?;
        let mut units = Vec::with_capacity(3);
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let terms = [self.times(a[j], b[k]), self.times(a[k], b[j])];
            units.push(self.one_unit(&terms, call.range, "the terms of this product"));
        }
        Ok(Type::Matrix(Shape::vector(3), units))
    }

    fn skew(&mut self, call: &Call) -> Result<Type, Reported> {
        let argument = call.arguments[0];
        match self.ty(argument) {
            Type::Matrix(shape, units) if shape.is_scalar() => {
                let units = vec![None, units[0], units[0], None];
                Ok(Type::Matrix(Shape { rows: 2, cols: 2 }, units))
            }
            Type::Matrix(shape, units) if *shape == Shape::vector(3) => {
                let (x, y, z) = (units[0], units[1], units[2]);
                let units = vec![None, z, y, z, None, x, y, x, None];
                Ok(Type::Matrix(Shape { rows: 3, cols: 3 }, units))
            }
            _ => Err(self.wrong_shape(call, argument, "a scalar or a 3-vector")),
        }
    }

    fn vee(&mut self, call: &Call) -> Result<Type, Reported> {
        let argument = call.arguments[0];
        let Some(n @ 2..=3) = self
            .ty(argument)
            .shape()
            .filter(|s| s.rows == s.cols)
            .map(|s| s.rows)
        else {
            return Err(self.wrong_shape(call, argument, "a 2×2 or 3×3 matrix"));
        };
        let (_, units) = self.square(call, argument, n)?;
        let mut pair = |i: usize, j: usize| {
            let opposite = [units[i * n + j], units[j * n + i]];
            self.one_unit(&opposite, call.range, "opposite entries of this matrix")
        };
        if n == 2 {
            return Ok(Type::scalar(pair(1, 0)));
        }
        let units = vec![pair(2, 1), pair(0, 2), pair(1, 0)];
        Ok(Type::Matrix(Shape::vector(3), units))
    }

    fn diag(&mut self, call: &Call) -> Result<Type, Reported> {
        let mut diagonal = Vec::new();
        for &argument in call.arguments {
            if call.arguments.len() == 1 && !self.is_scalar(argument) {
                diagonal = self.vector(call, argument, None)?.1;
            } else {
                diagonal.push(self.scalar(call, argument)?);
            }
        }
        let n = diagonal.len();
        let unit = |i: usize| {
            if i / n == i % n {
                diagonal[i / n]
            } else {
                None
            }
        };
        let shape = Shape { rows: n, cols: n };
        Ok(Type::Matrix(shape, (0..n * n).map(unit).collect()))
    }

    fn determinant(&mut self, call: &Call) -> Result<Type, Reported> {
        let (n, units) = self.square(call, call.arguments[0], LARGEST_INVERSE)?;
        let orders: &[&[usize]] = match n {
            1 => &[&[0]],
            2 => &[&[0, 1], &[1, 0]],
            _ => &[
                &[0, 1, 2],
                &[1, 2, 0],
                &[2, 0, 1],
                &[0, 2, 1],
                &[1, 0, 2],
                &[2, 1, 0],
            ],
        };
        let mut terms = Vec::with_capacity(orders.len());
        for order in orders {
            let start = Some(Unit::ONE);
            terms.push((0..n).fold(start, |unit, i| self.times(unit, units[i * n + order[i]])));
        }
        Ok(Type::scalar(self.one_unit(
            &terms,
            call.range,
            "the terms of this determinant",
        )))
    }

    /// Units of A⁻¹: those of a matrix whose entry (i, j) has the unit aᵢbⱼ are 1/(aⱼbᵢ). An exact
    /// zero takes the unit that its neighbours give it.
    fn inverse(&mut self, call: &Call) -> Result<Type, Reported> {
        let (n, units) = self.square(call, call.arguments[0], LARGEST_INVERSE)?;
        let mut inverse = Vec::with_capacity(n * n);
        for i in 0..n {
            for j in 0..n {
                let mut unit = units[j * n + i];
                for k in 0..n * n {
                    let (row, col) = (k / n, k % n);
                    let across = self.times(units[j * n + col], units[row * n + i]);
                    unit = unit.or(self.over(across, units[row * n + col]));
                }
                inverse.push(self.over(Some(Unit::ONE), unit));
            }
        }
        Ok(Type::Matrix(Shape { rows: n, cols: n }, inverse))
    }
}
