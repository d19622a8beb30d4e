//! Types of function calls.

use super::types::ComponentUnit;
use super::types::Type;
use super::types::diagonal;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::LARGEST_DIMENSION;
use crate::diagnostic::Range;
use crate::function::Function;
use crate::function::TABLE;
use crate::matrix::permutations;
use crate::model::Op;
use crate::model::Shape;
use crate::unit::Unit;
use num_rational::Ratio;

/// Largest order of `stumpff`. The equations of rigid bodies need up to 3, their derivatives a few more.
const LARGEST_STUMPFF: i64 = 20;

/// The call under inspection.
#[derive(Clone, Copy)]
struct Call {
    function: Function,
    range: Range,
}

const SKEW: &str = "a skew 2×2 or 3×3 matrix such as S(v)";
const SPATIAL_SKEW: &str = "a skew 3×3 matrix such as S(v)";
const ROTATION: &str = "a scalar or a 2×2 or 3×3 rotation";

/// 2×2
const PLANE: Shape = Shape { rows: 2, cols: 2 };

/// 3×3
const SPACE: Shape = Shape { rows: 3, cols: 3 };

impl Typing<'_> {
    /// `f(a, b)`
    pub(super) fn function(
        &mut self,
        function: Function,
        arguments: Vec<ExprId>,
        range: Range,
    ) -> ExprId {
        let takes = TABLE.iter().find(|row| row.1 == function).map(|row| row.2);
        let found = arguments.len();
        if let Some(n) = takes.filter(|&n| n != usize::MAX && n != found) {
            let name = function.name();
            let plural = if n == 1 { "" } else { "s" };
            let message = format!("`{name}` takes {n} argument{plural}, found {found}");
            return self.fail(range, message);
        }
        let poisoned = |id: &ExprId| matches!(self.ty(*id), Type::Poison);
        if arguments.iter().any(poisoned) {
            return self.poison(range);
        }
        let call = Call { function, range };
        match self.call_type(call, &arguments) {
            Some(ty) => self.push(Op::Call(function, arguments), ty, range),
            None => self.poison(range),
        }
    }

    /// The type of a call; none after a complaint.
    fn call_type(&mut self, call: Call, args: &[ExprId]) -> Option<Type> {
        let range = call.range;
        let one = Some(Unit::ONE);
        let is_matrix = self.ty(args[0]).shape().is_some_and(|s| !s.is_scalar());
        Some(match call.function {
            Function::Exp if is_matrix => self.rotation(call, args[0], &[PLANE, SPACE], SKEW)?,
            Function::Log if is_matrix => {
                self.rotation(call, args[0], &[PLANE, SPACE], ROTATION)?
            }
            Function::Cay => self.rotation(call, args[0], &[PLANE, SPACE], SKEW)?,
            // In the plane they are 1, and nobody needs them.
            Function::Dexp | Function::Dexpinv => {
                self.rotation(call, args[0], &[SPACE], SPATIAL_SKEW)?
            }
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
            | Function::Cosc => {
                self.dimensionless_scalar(call, args[0])?;
                Type::scalar(one)
            }
            Function::Atan2 => {
                let units = [self.scalar(call, args[0])?, self.scalar(call, args[1])?];
                self.one_unit(&units, range, "the arguments of atan2");
                Type::scalar(one)
            }
            Function::Sqrt => {
                let unit = self.scalar(call, args[0])?;
                Type::scalar(self.raised(unit, Ratio::new_raw(1, 2)))
            }
            Function::Abs => Type::scalar(self.scalar(call, args[0])?),
            Function::Max | Function::Min => {
                let units = [self.scalar(call, args[0])?, self.scalar(call, args[1])?];
                let what = format!("the arguments of {}", call.function.name());
                Type::scalar(self.one_unit(&units, range, &what))
            }
            Function::Sign => {
                self.scalar(call, args[0])?;
                Type::scalar(one)
            }
            Function::Stumpff => {
                self.stumpff_order(args[0])?;
                self.dimensionless_scalar(call, args[1])?;
                Type::scalar(one)
            }
            Function::Norm => {
                let (_, units) = self.vector(call, args[0])?;
                Type::scalar(self.one_unit(&units, range, "the components of this vector"))
            }
            Function::Dot => self.dot(call, args)?,
            Function::Cross => self.cross(call, args)?,
            Function::Skew => self.skew(call, args[0])?,
            Function::Vee => self.vee(call, args[0])?,
            Function::Rx | Function::Ry | Function::Rz => {
                self.dimensionless_scalar(call, args[0])?;
                Type::uniform(SPACE, one)
            }
            Function::Diag => self.diag(call, args)?,
            Function::Trace => {
                let (n, units) = self.square(call, args[0], usize::MAX)?;
                let diagonal: Vec<_> = (0..n).map(|i| units[i * (n + 1)]).collect();
                Type::scalar(self.one_unit(&diagonal, range, "the diagonal of this matrix"))
            }
            Function::Det => {
                let (n, units) = self.square(call, args[0], 3)?;
                Type::scalar(self.determinant(n, &units, call.range))
            }
            Function::Inv => self.inverse(call, args[0])?,
        })
    }

    fn wrong<T>(&mut self, call: Call, id: ExprId, expected: &str) -> Option<T> {
        let (name, found) = (call.function.name(), self.ty(id).noun());
        let message = format!("`{name}` takes {expected}, found {found}");
        self.fail_with(id, call.range, message, None);
        None
    }

    fn scalar(&mut self, call: Call, id: ExprId) -> Option<ComponentUnit> {
        match self.ty(id) {
            Type::Matrix(shape, units) if shape.is_scalar() => Some(units[0]),
            _ => self.wrong(call, id, "a scalar"),
        }
    }

    fn dimensionless_scalar(&mut self, call: Call, id: ExprId) -> Option<()> {
        let unit = self.scalar(call, id)?;
        self.dimensionless(call, id, &[unit]);
        Some(())
    }

    fn dimensionless(&mut self, call: Call, id: ExprId, units: &[ComponentUnit]) {
        let odd = units.iter().flatten().find(|unit| !unit.is_one());
        if let Some(unit) = odd {
            let name = call.function.name();
            let message = format!("`{name}` takes a number without a unit, found {unit}");
            self.unit_error(self.place(id, call.range), message);
        }
    }

    fn vector(&mut self, call: Call, id: ExprId) -> Option<(usize, Vec<ComponentUnit>)> {
        match self.ty(id) {
            Type::Matrix(shape, units) if shape.cols == 1 => Some((shape.rows, units.clone())),
            _ => self.wrong(call, id, "a vector"),
        }
    }

    /// A square matrix of at most `largest` rows.
    fn square(
        &mut self,
        call: Call,
        id: ExprId,
        largest: usize,
    ) -> Option<(usize, Vec<ComponentUnit>)> {
        match self.ty(id) {
            Type::Matrix(shape, units) if shape.rows == shape.cols && shape.rows <= largest => {
                Some((shape.rows, units.clone()))
            }
            _ if largest == usize::MAX => self.wrong(call, id, "a square matrix"),
            _ => self.wrong(
                call,
                id,
                &format!("a square matrix of at most {largest} rows"),
            ),
        }
    }

    /// A map between rotations and skew matrices of one of these shapes. That they are skew is seen later, in their
    /// components.
    fn rotation(
        &mut self,
        call: Call,
        id: ExprId,
        shapes: &[Shape],
        expected: &str,
    ) -> Option<Type> {
        match self.ty(id).clone() {
            Type::Matrix(shape, units) if shapes.contains(&shape) => {
                self.dimensionless(call, id, &units);
                Some(Type::uniform(shape, Some(Unit::ONE)))
            }
            _ => self.wrong(call, id, expected),
        }
    }

    fn stumpff_order(&mut self, id: ExprId) -> Option<()> {
        let order = self.fact(id).constant.filter(|c| c.is_integer());
        if order.is_some_and(|c| (0..=LARGEST_STUMPFF).contains(&c.to_integer())) {
            return Some(());
        }
        let message =
            format!("`stumpff` takes a constant integer from 0 to {LARGEST_STUMPFF} first");
        self.errors.push(self.range(id), message);
        None
    }

    fn dot(&mut self, call: Call, args: &[ExprId]) -> Option<Type> {
        let (n, left) = self.vector(call, args[0])?;
        let (m, right) = self.vector(call, args[1])?;
        if n != m {
            return self.wrong(call, args[1], &format!("a {}", Shape::vector(n)));
        }
        let terms: Vec<_> = (0..n).map(|i| self.times(left[i], right[i])).collect();
        let unit = self.one_unit(&terms, call.range, "the terms of this product");
        Some(Type::scalar(unit))
    }

    fn cross(&mut self, call: Call, args: &[ExprId]) -> Option<Type> {
        let mut units = Vec::new();
        for &id in args {
            match self.vector(call, id)? {
                (3, list) => units.push(list),
                _ => return self.wrong(call, id, "a 3-vector"),
            }
        }
        let component = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let terms = [
                self.times(units[0][j], units[1][k]),
                self.times(units[0][k], units[1][j]),
            ];
            self.one_unit(&terms, call.range, "the terms of this product")
        };
        let units = (0..3).map(component).collect();
        Some(Type::Matrix(Shape::vector(3), units))
    }

    fn skew(&mut self, call: Call, id: ExprId) -> Option<Type> {
        match self.ty(id) {
            Type::Matrix(shape, units) if shape.is_scalar() => {
                let a = units[0];
                Some(Type::Matrix(PLANE, vec![None, a, a, None]))
            }
            Type::Matrix(shape, units) if *shape == Shape::vector(3) => {
                let (x, y, z) = (units[0], units[1], units[2]);
                let units = vec![None, z, y, z, None, x, y, x, None];
                Some(Type::Matrix(SPACE, units))
            }
            _ => self.wrong(call, id, "a scalar or a 3-vector"),
        }
    }

    fn vee(&mut self, call: Call, id: ExprId) -> Option<Type> {
        let (shape, pairs): (_, &[(usize, usize)]) = match self.ty(id).shape() {
            Some(PLANE) => (Shape::SCALAR, &[(2, 1)]),
            Some(SPACE) => (Shape::vector(3), &[(7, 5), (2, 6), (3, 1)]),
            _ => return self.wrong(call, id, "a 2×2 or 3×3 matrix"),
        };
        let units = self.spread(self.ty(id), if pairs.len() == 1 { PLANE } else { SPACE });
        let mut component = |&(i, j): &(usize, usize)| {
            self.one_unit(&[units[i], units[j]], call.range, "opposite components")
        };
        let units = pairs.iter().map(&mut component).collect();
        Some(Type::Matrix(shape, units))
    }

    fn diag(&mut self, call: Call, args: &[ExprId]) -> Option<Type> {
        let entries = match args {
            [vector] if self.ty(*vector).shape().is_some_and(|s| !s.is_scalar()) => {
                self.vector(call, *vector)?.1
            }
            scalars => {
                let units = scalars.iter().map(|&id| self.scalar(call, id));
                units.collect::<Option<Vec<_>>>()?
            }
        };
        let n = entries.len();
        if n > LARGEST_DIMENSION {
            let message = format!("expected at most {LARGEST_DIMENSION} rows, found {n}");
            self.errors.push(call.range, message);
            return None;
        }
        let shape = Shape { rows: n, cols: n };
        let mut units = diagonal(n, None);
        for (i, &unit) in entries.iter().enumerate() {
            units[i * (n + 1)] = unit;
        }
        Some(Type::Matrix(shape, units))
    }

    fn inverse(&mut self, call: Call, id: ExprId) -> Option<Type> {
        if let Type::Multiple(unit) = *self.ty(id) {
            return Some(Type::Multiple(self.over(Some(Unit::ONE), unit)));
        }
        let (n, units) = self.square(call, id, 3)?;
        let determinant = self.determinant(n, &units, call.range);
        let mut inverse = Vec::with_capacity(n * n);
        for i in 0..n * n {
            // Component (r, c) of the inverse is the cofactor (c, r) over the determinant.
            let (row, col) = (i % n, i / n);
            let keep = |j: &usize| j / n != row && j % n != col;
            let minor: Vec<_> = (0..n * n).filter(keep).map(|j| units[j]).collect();
            let cofactor = self.determinant(n - 1, &minor, call.range);
            inverse.push(self.over(cofactor, determinant));
        }
        Some(Type::Matrix(Shape { rows: n, cols: n }, inverse))
    }

    /// The unit of a determinant of up to 3 rows, from the terms that are not zero.
    fn determinant(&mut self, n: usize, units: &[ComponentUnit], range: Range) -> ComponentUnit {
        let mut terms = Vec::new();
        for permutation in permutations(n) {
            let mut term = Some(Unit::ONE);
            for (row, &col) in permutation.iter().enumerate() {
                term = self.times(term, units[row * n + col]);
            }
            terms.push(term);
        }
        self.one_unit(&terms, range, "the terms of the determinant")
    }
}
