//! Statements that stand once or belong together: blocks, forms, assignments.

use super::symbols::Kind;
use super::symbols::Symbols;
use crate::ast::Assignment;
use crate::ast::Ast;
use crate::ast::Equation;
use crate::ast::Form;
use crate::ast::Item;
use crate::ast::Name;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;

/// The blocks of a model; the second of a kind is a mistake and left out.
#[derive(Debug, Default)]
pub(super) struct Statements<'a> {
    residual: Option<(&'a [Equation], Range)>,
    flow: Option<(&'a [Equation], Range)>,
    update: Option<(&'a [Assignment], Range)>,
    start: Option<(&'a [Assignment], Range)>,
    /// The forms asked for, in order; increment if none is.
    pub(super) forms: Vec<Form>,
}

impl<'a> Statements<'a> {
    /// Collects the blocks; complains about what is missing or there twice.
    pub(super) fn collect(ast: &'a Ast, symbols: &Symbols, errors: &mut Errors) -> Self {
        let mut statements = Self::default();
        let mut solve_for = None;
        for item in &ast.items {
            match item {
                Item::Residual(list, range) => {
                    once(&mut statements.residual, list, *range, "residual", errors);
                }
                Item::Flow(list, range) => {
                    once(&mut statements.flow, list, *range, "flow", errors);
                }
                Item::Update(list, range) => {
                    once(&mut statements.update, list, *range, "update", errors);
                }
                Item::Start(list, range) => {
                    once(&mut statements.start, list, *range, "start", errors);
                }
                Item::SolveFor(list, range) => {
                    once(&mut solve_for, list, *range, "solve for", errors);
                }
                Item::Parameter(_)
                | Item::State(_)
                | Item::Unknown(_)
                | Item::Let(..)
                | Item::Output(_)
                | Item::Claim(_) => {}
            }
        }
        statements.forms = solve_for.map_or(vec![Form::Increment], |(list, _)| forms(list, errors));
        if symbols.of_kind(Kind::State).next().is_none() {
            let help = "declare one, for example `state θ: rad;`";
            errors.push_with_help(ast.range, "a model needs at least one state", help);
        } else if statements.residual.is_none() {
            let help = "write the discrete equations in `residual { … = 0; }`";
            errors.push_with_help(ast.range, "a model needs a residual", help);
        }
        statements
    }

    pub(super) fn residual(&self) -> &'a [Equation] {
        self.residual.map_or(&[], |block| block.0)
    }

    pub(super) fn flow(&self) -> &'a [Equation] {
        self.flow.map_or(&[], |block| block.0)
    }

    pub(super) fn update(&self) -> &'a [Assignment] {
        self.update.map_or(&[], |block| block.0)
    }

    pub(super) fn start(&self) -> &'a [Assignment] {
        self.start.map_or(&[], |block| block.0)
    }

    /// Where the residual begins, or the model if there is none.
    pub(super) fn residual_range(&self, ast: &Ast) -> Range {
        self.residual.map_or(ast.range, |block| block.1)
    }

    /// Where the flow begins.
    pub(super) fn flow_range(&self) -> Option<Range> {
        self.flow.map(|block| block.1)
    }

    /// Where the start values begin.
    pub(super) fn start_range(&self) -> Option<Range> {
        self.start.map(|block| block.1)
    }
}

fn once<'a, T>(
    slot: &mut Option<(&'a [T], Range)>,
    list: &'a [T],
    range: Range,
    name: &str,
    errors: &mut Errors,
) {
    match slot {
        Some((_, first)) => {
            let message = format!(
                "a second `{name}`, the first one is in line {}",
                first.line()
            );
            errors.push(range, message);
        }
        None => *slot = Some((list, range)),
    }
}

fn forms(list: &[(Form, Range)], errors: &mut Errors) -> Vec<Form> {
    let mut forms = Vec::new();
    for &(form, range) in list {
        if forms.contains(&form) {
            errors.push(range, format!("`{}` is already asked for", form.keyword()));
        } else {
            forms.push(form);
        }
    }
    forms
}

/// For each state the value that `assignments` give it; complains about other names and about a state
/// that gets two values.
pub(super) fn values<'a>(
    assignments: &'a [Assignment],
    symbols: &Symbols,
    errors: &mut Errors,
) -> Vec<Option<&'a Assignment>> {
    let mut values: Vec<Option<&Assignment>> = vec![None; symbols.of_kind(Kind::State).count()];
    for assignment in assignments {
        let Some(index) = state_called(&assignment.name, symbols, errors) else {
            continue;
        };
        match values[index] {
            Some(first) => {
                let (name, line) = (&assignment.name.display, first.name.range.line());
                let message = format!("`{name}` already has a value in line {line}");
                errors.push(assignment.name.range, message);
            }
            None => values[index] = Some(assignment),
        }
    }
    values
}

fn state_called(name: &Name, symbols: &Symbols, errors: &mut Errors) -> Option<usize> {
    let shown = &name.display;
    let Some(index) = symbols.find(name) else {
        let message = format!("unknown state `{shown}`");
        match symbols.similar(name) {
            Some(similar) => {
                errors.push_with_help(name.range, message, format!("did you mean `{similar}`?"))
            }
            None => errors.push(name.range, message),
        }
        return None;
    };
    let symbol = symbols.list[index];
    if symbol.kind == Kind::State {
        return Some(symbol.index);
    }
    let message = format!("`{shown}` is {}, expected a state", symbol.kind.noun());
    errors.push(name.range, message);
    None
}
