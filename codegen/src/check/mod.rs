//! From [`Ast`] to [`Model`].
//!
//! In comes the list of statements, out goes a model in which every name is resolved, every shape and
//! unit is known and right, and the equations are as many as the unknowns; or every mistake in these.
//! From here on there are no `let`s, and the literal 0 and multiples of `I` are the only expressions
//! that take their shape from their surroundings.

mod advance;
mod blocks;
mod complaints;
mod components;
mod context;
mod definitions;
mod equations;
mod flow;
mod functions;
mod names;
mod operators;
mod scene;
mod stand_in;
mod statements;
mod symbols;
#[cfg(test)]
mod tests;
mod types;
mod typing;
mod value;
mod values;

pub use scene::Setting;
pub use scene::set;
pub use stand_in::stand_in;
pub use value::check_value;

use crate::ast::Ast;
use crate::ast::Form;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::model::Solved;
use crate::model::State;
use crate::unit::Unit;
use advance::Advance;
use statements::Statements;
use symbols::Kind;
use symbols::Symbol;
use symbols::Symbols;
use types::ComponentUnit;
use typing::Typing;
use values::Strictness;

/// Checks a model.
///
/// # Errors
/// Every mistake, one message for each.
pub fn check(ast: &Ast) -> Result<Model, Errors> {
    let mut errors = Errors::default();
    let statements = Statements::collect(ast, &mut errors);
    let symbols = Symbols::collect(ast, &mut errors);
    let units = definitions::units(&symbols, &mut errors);
    statements.complain_if_incomplete(ast, &symbols, &mut errors);

    let mut typing = Typing::new(&ast.exprs, &symbols, time_unit(&units), errors);
    context::check_all(&mut typing, &statements);
    typing.define(&units);
    let parameters = typing.parameters();
    let unknowns = typing.unknowns();
    let variables = typing.states();
    let start = typing.start(&variables, statements.start);
    let update = typing.update(&variables, statements.update);
    let outputs = typing.outputs(&units, Strictness::Strict);
    let flow = typing.flow(statements.flow, &variables);
    let residual = typing.residual(statements.residual);
    let claims = typing.claims(&statements.claims);
    let requirements = typing.requirements(&statements.requirements);

    let advance = Advance::new(&typing, &variables, &unknowns, &update);
    advance.check(&mut typing, statements.residual, &residual);
    let solved = solved(&symbols, &advance.explicit);
    let states = variables.iter().enumerate().filter_map(|(i, variable)| {
        Some(State {
            variable: variable.clone(),
            start: start[i]?,
            solved: !advance.explicit[i],
            update: update[i],
        })
    });
    let model = Model {
        name: ast.name.clone(),
        doc: ast.doc.clone(),
        parameters,
        states: states.collect(),
        forms: forms(&statements, &solved),
        unknowns,
        solved,
        absent: Vec::new(),
        exprs: std::mem::take(&mut typing.exprs),
        residual,
        flow,
        outputs,
        claims,
        requirements,
    };
    typing.into_errors().or(model)
}

/// The unit of t and h: seconds, unless the model is dimensionless throughout.
fn time_unit(units: &[Option<ComponentUnit>]) -> ComponentUnit {
    let written = || units.iter().flatten();
    if written().flatten().any(|unit| !unit.is_one()) {
        Some(Unit::SECOND)
    } else if written().any(Option::is_none) {
        None
    } else {
        Some(Unit::ONE)
    }
}

/// The blocks of the unknown vector, in file order of their declarations.
fn solved(symbols: &Symbols, explicit: &[bool]) -> Vec<Solved> {
    let block = |symbol: &Symbol| match symbol.kind {
        Kind::State if !explicit[symbol.index] => Some(Solved::State(symbol.index)),
        Kind::Unknown => Some(Solved::Own(symbol.index)),
        Kind::State | Kind::Parameter | Kind::Let | Kind::Output(_) => None,
    };
    symbols.list.iter().filter_map(block).collect()
}

/// The solvers to emit. Where no state is unknown all forms are the same, so there is one.
fn forms(statements: &Statements, solved: &[Solved]) -> Vec<Form> {
    let any_state = solved.iter().any(|s| matches!(s, Solved::State(_)));
    match statements.solve_for {
        Some((forms, _)) if any_state => forms.iter().map(|(form, _)| *form).collect(),
        Some(_) | None => vec![Form::Increment],
    }
}
