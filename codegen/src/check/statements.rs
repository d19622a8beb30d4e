//! The statements of a model by what they say, each block at most once.

use super::symbols::Kind;
use super::symbols::Symbols;
use crate::ast::Assignment;
use crate::ast::Ast;
use crate::ast::Claim;
use crate::ast::Equation;
use crate::ast::Form;
use crate::ast::Item;
use crate::ast::Requirement;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;

/// A block and the keyword before it.
pub(super) type Block<'a, T> = Option<(&'a [T], Range)>;

/// The blocks of a model; declarations are in [`super::symbols::Symbols`].
#[derive(Debug, Default)]
pub(super) struct Statements<'a> {
    pub(super) flow: Block<'a, Equation>,
    pub(super) residual: Block<'a, Equation>,
    pub(super) update: Block<'a, Assignment>,
    pub(super) start: Block<'a, Assignment>,
    pub(super) solve_for: Block<'a, (Form, Range)>,
    pub(super) claims: Vec<&'a Claim>,
    pub(super) requirements: Vec<&'a Requirement>,
}

impl<'a> Statements<'a> {
    /// Collects the blocks; complains about a second one of a kind.
    pub(super) fn collect(ast: &'a Ast, errors: &mut Errors) -> Self {
        let mut statements = Statements::default();
        for item in &ast.items {
            match item {
                Item::Flow(list, at) => once(&mut statements.flow, list, *at, "flow", errors),
                Item::Residual(list, at) => {
                    once(&mut statements.residual, list, *at, "residual", errors);
                }
                Item::Update(list, at) => once(&mut statements.update, list, *at, "update", errors),
                Item::Start(list, at) => once(&mut statements.start, list, *at, "start", errors),
                Item::SolveFor(list, at) => {
                    once(&mut statements.solve_for, list, *at, "solve for", errors);
                }
                Item::Claim(claim) => statements.claims.push(claim),
                Item::Requirement(requirement) => statements.requirements.push(requirement),
                Item::Parameter(_)
                | Item::State(_)
                | Item::Unknown(_)
                | Item::Let(..)
                | Item::Output(_) => {}
            }
        }
        statements
    }

    /// Complains about what every model needs, and about forms named twice.
    pub(super) fn complain_if_incomplete(&self, ast: &Ast, symbols: &Symbols, errors: &mut Errors) {
        let states: Vec<_> = symbols
            .of_kind(Kind::State)
            .map(|(_, s)| s.name.display.as_str())
            .collect();
        if states.is_empty() && self.residual.is_none() {
            let help = "a model needs at least `state`, `residual` and `start`";
            errors.push_with_help(ast.range, "the model is empty", help);
            return;
        }
        if states.is_empty() {
            let help = "write `state x;` for what a step advances";
            errors.push_with_help(ast.range, "the model has no state", help);
        } else if self.start.is_none() {
            let help = format!("write `start {{ {} = …; }}`", states.join(" = …; "));
            errors.push_with_help(ast.range, "the model has no `start`", help);
        }
        match self.residual {
            None => {
                let help = "write `residual { … = 0; }` with the discrete equations";
                errors.push_with_help(ast.range, "the model has no `residual`", help);
            }
            Some(([], keyword)) => errors.push(keyword, "expected an equation in `residual`"),
            Some(_) => {}
        }
        if let Some((forms, _)) = self.solve_for {
            for (i, (form, range)) in forms.iter().enumerate() {
                if forms[..i].iter().any(|(earlier, _)| earlier == form) {
                    let message = format!("a second `{}` in `solve for`", form.keyword());
                    errors.push(*range, message);
                }
            }
        }
    }
}

fn once<'a, T>(
    block: &mut Block<'a, T>,
    list: &'a [T],
    keyword: Range,
    word: &str,
    errors: &mut Errors,
) {
    match block {
        None => *block = Some((list, keyword)),
        Some((_, first)) => {
            let line = first.line();
            let message = format!("a second `{word}`, the first is in line {line}");
            errors.push(keyword, message);
        }
    }
}
