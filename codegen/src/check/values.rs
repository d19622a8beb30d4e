//! Parameters, states, unknowns and outputs: do their values fit their types?

use super::definitions::written_shape;
use super::statements::Block;
use super::symbols::Kind;
use super::symbols::Symbol;
use super::types::ComponentUnit;
use super::types::Type;
use super::typing::Meaning;
use super::typing::Typing;
use crate::ast::Assignment;
use crate::ast::ExprId;
use crate::ast::Name;
use crate::ast::OutputKind;
use crate::model::Output;
use crate::model::Parameter;
use crate::model::Shape;
use crate::model::Unknown;
use crate::model::Variable;
use crate::unit::Unit;

/// How strictly the unit of a value is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Strictness {
    /// Always.
    Strict,
    /// Only if the value contains a name with a unit: bare numbers carry the declared unit.
    Lax,
}

impl Typing<'_> {
    /// The parameters and their defaults.
    pub(super) fn parameters(&mut self) -> Vec<Parameter> {
        self.variables(Kind::Parameter)
            .into_iter()
            .filter_map(|(value, variable)| {
                let default = self.expression(value?);
                // Nothing with a unit can stand in a default.
                self.conform_shape(default, &variable);
                Some(Parameter { variable, default })
            })
            .collect()
    }

    /// The own unknowns and their first guesses.
    pub(super) fn unknowns(&mut self) -> Vec<Unknown> {
        self.variables(Kind::Unknown)
            .into_iter()
            .filter_map(|(value, variable)| {
                let guess = self.expression(value?);
                self.conform(guess, &variable, Strictness::Lax);
                Some(Unknown { variable, guess })
            })
            .collect()
    }

    /// The states, without their values.
    pub(super) fn states(&mut self) -> Vec<Variable> {
        let states = self.variables(Kind::State).into_iter();
        states.map(|(_, variable)| variable).collect()
    }

    /// The start values of the states, each of which needs one.
    pub(super) fn start(
        &mut self,
        states: &[Variable],
        block: Block<Assignment>,
    ) -> Vec<Option<ExprId>> {
        let Some((list, keyword)) = block else {
            return vec![None; states.len()];
        };
        let values = self.assigned(states, list, "start value", Strictness::Lax);
        for (state, _) in states
            .iter()
            .zip(&values)
            .filter(|(state, value)| value.is_none() && !self.symbols.is_contested(&state.name))
        {
            let name = &state.name.display;
            let message = format!("the state `{name}` has no start value");
            self.errors
                .push_with_help(keyword, message, format!("write `{name} = …;`"));
        }
        values
    }

    /// What `update` assigns to the states.
    pub(super) fn update(
        &mut self,
        states: &[Variable],
        block: Block<Assignment>,
    ) -> Vec<Option<ExprId>> {
        let list = block.map_or(&[][..], |(list, _)| list);
        self.assigned(states, list, "update", Strictness::Strict)
    }

    /// Invariants and observables. What their types leave out, their values decide.
    pub(super) fn outputs(
        &mut self,
        units: &[Option<ComponentUnit>],
        strictness: Strictness,
    ) -> Vec<Output> {
        let symbols = self.symbols;
        let mut outputs: Vec<Output> = Vec::new();
        for (index, symbol) in symbols.of_kind(Kind::Output(OutputKind::Observable)) {
            let (Kind::Output(kind), Some(value)) = (symbol.kind, symbol.value) else {
                continue;
            };
            let value = self.expression(value);
            let ty = self.ty(value).clone();
            let Some(shape) = symbol.ty.and_then(written_shape).or(ty.shape()) else {
                if matches!(ty, Type::Multiple(_)) {
                    self.sizeless(index);
                }
                continue;
            };
            let mut variable = Variable {
                name: symbol.name.clone(),
                shape,
                unit: units[index].flatten().unwrap_or(Unit::ONE),
                symbols: written_unit(symbol),
                doc: symbol.doc.to_vec(),
                offset: outputs.last().map_or(0, |last| end(&last.variable)),
            };
            if units[index].is_none() {
                let what = format!("the components of `{}`", variable.name.display);
                let range = self.range(value);
                let units = self.spread(&ty, shape);
                variable.unit = self.one_unit(&units, range, &what).unwrap_or(Unit::ONE);
                variable.symbols = variable.unit.to_string();
            }
            self.conform_shape(value, &variable);
            if let Some(unit) = units[index]
                && self.compares(value, strictness)
            {
                self.conform_unit(value, &variable, unit);
            }
            outputs.push(Output {
                variable,
                kind,
                value,
            });
        }
        outputs
    }

    /// The declarations of one kind, numbered through, each with its value.
    pub(super) fn variables(&self, kind: Kind) -> Vec<(Option<ExprId>, Variable)> {
        let mut list: Vec<(Option<ExprId>, Variable)> = Vec::new();
        for (index, symbol) in self.symbols.of_kind(kind) {
            let (shape, unit) = match &self.meanings[index] {
                Meaning::Variable(Type::Matrix(shape, units)) => (*shape, units[0]),
                _ => {
                    let written = symbol.ty.and_then(written_shape);
                    (written.unwrap_or(Shape::SCALAR), None)
                }
            };
            let variable = Variable {
                name: symbol.name.clone(),
                shape,
                unit: unit.unwrap_or(Unit::ONE),
                symbols: written_unit(symbol),
                doc: symbol.doc.to_vec(),
                offset: list.last().map_or(0, |(_, last)| end(last)),
            };
            list.push((symbol.value, variable));
        }
        list
    }

    /// The values that a block assigns to `states`.
    fn assigned(
        &mut self,
        states: &[Variable],
        list: &[Assignment],
        what: &str,
        strictness: Strictness,
    ) -> Vec<Option<ExprId>> {
        let mut values = vec![None; states.len()];
        for assignment in list {
            let name = &assignment.name;
            let value = self.expression(assignment.value);
            let Ok((index, _)) = self.state("expected a state", name, name.range) else {
                continue;
            };
            self.conform(value, &states[index], strictness);
            match &mut values[index] {
                Some(_) => {
                    let message = format!("a second {what} of `{}`", name.display);
                    self.errors.push(name.range, message);
                }
                first => *first = Some(value),
            }
        }
        values
    }

    /// Complains unless `value` can be the value of `variable`.
    fn conform(&mut self, value: ExprId, variable: &Variable, strictness: Strictness) {
        self.conform_shape(value, variable);
        if self.compares(value, strictness) {
            let unit = match self.meaning(&variable.name) {
                Some(Meaning::Variable(Type::Matrix(_, units))) => units[0],
                _ => None,
            };
            self.conform_unit(value, variable, unit);
        }
    }

    /// True if the unit of `value` is compared with the declared one.
    fn compares(&self, value: ExprId, strictness: Strictness) -> bool {
        strictness == Strictness::Strict || self.fact(value).dimensioned
    }

    fn conform_shape(&mut self, value: ExprId, variable: &Variable) {
        let in_doubt = matches!(self.meaning(&variable.name), Some(Meaning::Unclear));
        if !in_doubt && !self.takes_shape(value, variable.shape) {
            self.wrong_shape(value, &variable.name, variable.shape);
        }
    }

    /// What a name stands for in expressions; an output stands for nothing.
    fn meaning(&self, name: &Name) -> Option<&Meaning> {
        let index = self.symbols.find(name)?;
        let is_output = matches!(self.symbols.list[index].kind, Kind::Output(_));
        (!is_output).then(|| &self.meanings[index])
    }

    /// True if `value` has this shape or can take it.
    pub(super) fn takes_shape(&self, value: ExprId, shape: Shape) -> bool {
        match self.ty(value) {
            Type::Poison => true,
            Type::Multiple(_) => shape.rows == shape.cols && !shape.is_scalar(),
            Type::Matrix(own, _) => *own == shape || self.is_zero(value),
        }
    }

    pub(super) fn wrong_shape(&mut self, value: ExprId, name: &Name, shape: Shape) {
        let (shown, found) = (&name.display, self.ty(value).noun());
        let message = format!("`{shown}` is a {shape}, found {found}");
        self.errors.push(self.range(value), message);
    }

    fn conform_unit(&mut self, value: ExprId, variable: &Variable, expected: ComponentUnit) {
        let shape = variable.shape;
        let found = self.spread(self.ty(value), shape);
        let expected = vec![expected; found.len()];
        let (at, shown) = (self.range(value), &variable.name.display);
        self.equal_units(
            at,
            Some(shape),
            &found,
            &expected,
            |position, found, unit| {
                format!("`{shown}` has the unit {unit}, found {found}{position}")
            },
        );
    }
}

/// The unit in a declaration; `1` where it has none.
fn written_unit(symbol: &Symbol) -> String {
    let unit = symbol.ty.and_then(|ty| ty.unit.as_ref());
    unit.map_or_else(|| "1".to_owned(), ToString::to_string)
}

/// Where the next variable begins.
fn end(variable: &Variable) -> usize {
    variable.offset + variable.shape.len()
}
