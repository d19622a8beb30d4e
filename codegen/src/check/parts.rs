//! Parameters, unknowns, equations, outputs and claims.

use super::Assembly;
use super::context::Context;
use super::declarations::shape_of;
use super::symbols::Kind;
use super::types::Type;
use super::types::position;
use super::typing::Meaning;
use crate::ast;
use crate::ast::ExprId;
use crate::ast::Item;
use crate::ast::OutputKind;
use crate::model::Claim;
use crate::model::Equation;
use crate::model::Output;
use crate::model::Parameter;
use crate::model::Shape;
use crate::model::Unknown;
use crate::model::Variable;
use crate::unit::Unit;

impl Assembly<'_> {
    /// The declared variables of one kind, with their offsets.
    pub(super) fn variables(&self, kind: Kind) -> Vec<Variable> {
        let mut offset = 0;
        let mut variables = Vec::new();
        for (index, symbol) in self.symbols.of_kind(kind) {
            let (shape, unit) = match &self.typing.meanings[index] {
                Meaning::Variable(Type::Matrix(shape, units)) => (*shape, units[0]),
                _ => (Shape::SCALAR, None),
            };
            variables.push(Variable {
                name: symbol.name.clone(),
                shape,
                unit: unit.unwrap_or(Unit::ONE),
                doc: symbol.doc.to_vec(),
                offset,
            });
            offset += shape.len();
        }
        variables
    }

    pub(super) fn parameters(&mut self) -> Vec<Parameter> {
        let values = self.values(Kind::Parameter);
        let mut parameters = Vec::new();
        for (variable, value) in self.variables(Kind::Parameter).into_iter().zip(values) {
            let default = self.typing.expression_in(value, Context::Default);
            self.fit(default, &variable, false);
            parameters.push(Parameter { variable, default });
        }
        parameters
    }

    pub(super) fn unknowns(&mut self) -> Vec<Unknown> {
        let values = self.values(Kind::Unknown);
        let mut unknowns = Vec::new();
        for (variable, value) in self.variables(Kind::Unknown).into_iter().zip(values) {
            let guess = self.typing.expression_in(value, Context::Guess);
            self.fit(guess, &variable, false);
            unknowns.push(Unknown { variable, guess });
        }
        unknowns
    }

    fn values(&self, kind: Kind) -> Vec<ExprId> {
        self.symbols
            .of_kind(kind)
            .filter_map(|(_, s)| s.value)
            .collect()
    }

    /// Complains unless `value` has the shape and unit of `variable`. Numbers in a default, a guess or a
    /// start value (`strict` off) carry the declared unit.
    pub(super) fn fit(&mut self, value: ExprId, variable: &Variable, strict: bool) {
        let ty = self.typing.ty(value).clone();
        let (shape, name) = (variable.shape, &variable.name.display);
        let fits = match &ty {
            Type::Poison => return,
            Type::Multiple(_) => shape.rows == shape.cols,
            Type::Matrix(own, _) => *own == shape || self.typing.is_zero(value),
        };
        let at = self.typing.range(value);
        if !fits {
            let message = format!("this is {}, `{name}` is a {shape}", ty.noun());
            self.typing.errors.push(at, message);
            return;
        }
        if !strict && !self.typing.fact(value).dimensioned {
            return;
        }
        let units = self.typing.spread(&ty, shape);
        let wrong = units
            .iter()
            .position(|unit| unit.is_some_and(|unit| unit != variable.unit));
        if let Some((i, Some(unit))) = wrong.map(|i| (i, units[i])) {
            let position = position(shape, i);
            let message = format!(
                "this has the unit {unit}{position}, `{name}` has {}",
                variable.unit
            );
            self.typing.unit_error(at, message);
        }
    }

    pub(super) fn equations(&mut self, context: Context) -> Vec<Equation> {
        let (list, flow_range) = match context {
            Context::Flow => (self.statements.flow(), self.statements.flow_range()),
            _ => (self.statements.residual(), None),
        };
        let equations: Vec<_> = list
            .iter()
            .filter_map(|e| self.equation(e, context))
            .collect();
        if let Some(range) = flow_range.filter(|_| equations.len() == list.len()) {
            self.check_rates(&equations, range);
        }
        equations
    }

    fn equation(&mut self, equation: &ast::Equation, context: Context) -> Option<Equation> {
        let lhs = self.typing.expression_in(equation.lhs, context);
        let rhs = self.typing.expression_in(equation.rhs, context);
        let (left, right) = (self.typing.ty(lhs).clone(), self.typing.ty(rhs).clone());
        if matches!(left, Type::Poison) || matches!(right, Type::Poison) {
            return None;
        }
        let range = equation.range;
        let Some((shape, left_units, right_units)) = self.typing.align(lhs, rhs) else {
            let message = format!("{} equated with {}", left.noun(), right.noun());
            self.typing.errors.push(range, message);
            return None;
        };
        let Some(shape) = shape else {
            self.typing
                .errors
                .push(range, "the size of `I` cannot be told here");
            return None;
        };
        self.typing.equal_units(
            range,
            Some(shape),
            &left_units,
            &right_units,
            |at, left, right| format!("equating {left} with {right}{at}"),
        );
        Some(Equation {
            lhs,
            rhs,
            shape,
            text: equation.text.clone(),
            range,
        })
    }

    pub(super) fn outputs(&mut self) -> Vec<Output> {
        let kind = Kind::Output(OutputKind::Observable);
        let symbols: Vec<_> = self
            .symbols
            .of_kind(kind)
            .map(|(_, symbol)| *symbol)
            .collect();
        let mut offset = 0;
        let mut outputs = Vec::new();
        for symbol in symbols {
            let (Some(value), Kind::Output(kind)) = (symbol.value, symbol.kind) else {
                continue;
            };
            let value = self.typing.expression_in(value, Context::Output);
            let ty = self.typing.ty(value).clone();
            let own = ty.shape();
            let Some(shape) = shape_of(symbol).or(own) else {
                if matches!(ty, Type::Multiple(_)) {
                    let message = "the size of `I` cannot be told here";
                    self.typing.errors.push(self.typing.range(value), message);
                }
                continue;
            };
            let written = symbol.ty.and_then(|ty| ty.unit.as_ref());
            let unit = match written {
                Some(unit) => self.typing.unit(unit),
                None => self.unit_of_output(&ty, value),
            };
            let variable = Variable {
                name: symbol.name.clone(),
                shape,
                unit: unit.unwrap_or(Unit::ONE),
                doc: symbol.doc.to_vec(),
                offset,
            };
            if unit.is_some() {
                self.fit(value, &variable, written.is_some());
            }
            offset += shape.len();
            outputs.push(Output {
                variable,
                kind,
                value,
            });
        }
        outputs
    }

    /// The common unit of all components.
    fn unit_of_output(&mut self, ty: &Type, value: ExprId) -> Option<Unit> {
        let Type::Matrix(_, units) = ty else {
            return Some(Unit::ONE);
        };
        let range = self.typing.range(value);
        let what = "the components of this output";
        Some(
            self.typing
                .one_unit(units, range, what)
                .unwrap_or(Unit::ONE),
        )
    }

    pub(super) fn claims(&mut self) -> Vec<Claim> {
        let ast = self.ast;
        let mut claims = Vec::new();
        self.typing.lenient = true;
        for item in &ast.items {
            let Item::Claim(claim) = item else {
                continue;
            };
            let block = |(id, text): &(ExprId, String)| {
                (self.typing.expression_in(*id, Context::Claim), text.clone())
            };
            let mut rows: Vec<Vec<(ExprId, String)>> = Vec::new();
            let mut block = block;
            for row in &claim.blocks {
                rows.push(row.iter().map(&mut block).collect());
            }
            claims.push(Claim {
                label: claim.label.clone(),
                required: claim.required,
                blocks: rows,
                range: claim.range,
            });
        }
        self.typing.lenient = false;
        claims
    }
}
