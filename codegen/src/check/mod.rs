//! From [`Ast`] to [`Model`]: names, shapes, units, and what may stand where.
//!
//! In comes a list of statements, out goes a model in which every name is resolved, every expression
//! has a shape, every unit fits, and there are as many equations as unknowns; or every mistake found on
//! the way, one message for each. `let`s are gone: what one names is a shared expression.

mod blocks;
mod context;
mod declarations;
mod functions;
mod names;
mod operators;
mod parts;
mod statements;
mod states;
mod symbols;
#[cfg(test)]
mod tests;
mod types;
mod typing;
mod value;

pub use value::check_value;

use crate::ast::Ast;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::model::Solved;
use crate::model::Variable;
use context::Context;
use declarations::declared_second;
use statements::Statements;
use symbols::Kind;
use symbols::Symbols;
use typing::Typing;

/// Most scalar unknowns: the largest matrix that the runtime's linear solver has a size for.
const MOST_UNKNOWNS: usize = 127;

/// Checks a model.
///
/// # Errors
/// Every mistake, in file order.
pub fn check(ast: &Ast) -> Result<Model, Errors> {
    let mut errors = Errors::default();
    let symbols = Symbols::collect(ast, &mut errors);
    let statements = Statements::collect(ast, &symbols, &mut errors);
    let second = declared_second(&symbols);
    let mut typing = Typing::new(&ast.exprs, &symbols, second, errors);
    typing.declare();
    let model = Assembly {
        typing,
        symbols: &symbols,
        statements,
        ast,
    }
    .model();
    let (model, errors) = model;
    errors.or(model)
}

/// The last stretch: from typed names to the parts of the model.
struct Assembly<'a> {
    typing: Typing<'a>,
    symbols: &'a Symbols<'a>,
    statements: Statements<'a>,
    ast: &'a Ast,
}

impl Assembly<'_> {
    fn model(mut self) -> (Model, Errors) {
        let parameters = self.parameters();
        let unknowns = self.unknowns();
        let residual = self.equations(Context::Residual);
        let flow = self.equations(Context::Flow);
        let outputs = self.outputs();
        let claims = self.claims();
        let states = self.states(&residual);
        let mut model = Model {
            name: self.ast.name.clone(),
            doc: self.ast.doc.clone(),
            parameters,
            solved: self.solved(&states),
            states,
            unknowns,
            exprs: Vec::new(),
            residual,
            flow,
            outputs,
            forms: self.statements.forms.clone(),
            claims,
        };
        self.check_counts(&model);
        model.exprs = self.typing.exprs;
        (model, self.typing.errors)
    }

    /// The blocks of unknowns in file order.
    fn solved(&self, states: &[crate::model::State]) -> Vec<Solved> {
        let block = |symbol: &symbols::Symbol| match symbol.kind {
            Kind::State => {
                let solved = states.get(symbol.index).is_some_and(|s| s.solved);
                solved.then_some(Solved::State(symbol.index))
            }
            Kind::Unknown => Some(Solved::Own(symbol.index)),
            Kind::Parameter | Kind::Let | Kind::Output(_) => None,
        };
        self.symbols.list.iter().filter_map(block).collect()
    }

    /// As many equations as unknowns, and as many continuous equations as states.
    fn check_counts(&mut self, model: &Model) {
        if !self.typing.errors.is_empty() {
            return;
        }
        let list = |variables: &[&Variable]| {
            let name = |v: &&Variable| match v.shape.len() {
                1 => format!("`{}`", v.name.display),
                n => format!("`{}` ({n})", v.name.display),
            };
            variables.iter().map(name).collect::<Vec<_>>().join(", ")
        };
        let solved: Vec<_> = model
            .solved
            .iter()
            .map(|&s| model.solved_variable(s))
            .collect();
        let (found, n) = (total(&model.residual), model.n_unknowns());
        if found != n {
            let (have, want) = (
                counted(found, "scalar equation"),
                counted(n, "scalar unknown"),
            );
            let message = format!("{have} for {want}: {}", list(&solved));
            self.typing
                .errors
                .push(self.statements.residual_range(self.ast), message);
        }
        if n > MOST_UNKNOWNS {
            let message = format!("{n} scalar unknowns, at most {MOST_UNKNOWNS} can be solved for");
            self.typing
                .errors
                .push(self.statements.residual_range(self.ast), message);
        }
        let (found, n) = (total(&model.flow), model.n_states());
        if let (Some(range), true) = (self.statements.flow_range(), found != n) {
            let states: Vec<_> = model.states.iter().map(|s| &s.variable).collect();
            let (have, want) = (
                counted(found, "scalar equation"),
                counted(n, "scalar state"),
            );
            let message = format!("{have} in the flow for {want}: {}", list(&states));
            self.typing.errors.push(range, message);
        }
    }
}

fn total(equations: &[crate::model::Equation]) -> usize {
    equations.iter().map(|e| e.shape.len()).sum()
}

/// `1 state`, `2 states`
fn counted(n: usize, noun: &str) -> String {
    if n == 1 {
        format!("1 {noun}")
    } else {
        format!("{n} {noun}s")
    }
}
