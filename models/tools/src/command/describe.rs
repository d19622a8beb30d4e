//! A model as data that prints as JSON.

use residua::Catalogued;
use residua::description::{Count, Solver, Unknown, Variable};
use residua_models::values;
use serde::Serialize;

/// What `list --json` says about a model.
#[derive(Serialize)]
pub struct Model {
    /// The stem of its file.
    pub name: &'static str,
    /// Its doc lines.
    pub doc: &'static str,
    /// With their defaults.
    pub parameters: Vec<Quantity>,
    /// With their start values for these defaults.
    pub states: Vec<Quantity>,
    /// Constant along solutions.
    pub invariants: Vec<Quantity>,
    /// What else it reports.
    pub observables: Vec<Quantity>,
    /// One per form.
    pub solvers: Vec<Form>,
    /// It has continuous equations.
    pub flow: bool,
    /// Operations of all functions.
    pub operations: usize,
    /// What data must be like.
    pub requirements: Vec<Requirement>,
    /// What papers print.
    pub claims: Vec<Claim>,
    /// The run that it was made for, if it is a scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<Scene>,
}

/// A model made for one run.
#[derive(Serialize)]
pub struct Scene {
    /// The model.
    pub model: &'static str,
    /// Time step.
    pub step: f64,
    /// End time.
    pub until: f64,
    /// States and outputs that were asked for.
    pub keep: &'static [&'static str],
}

/// A named quantity.
#[derive(Serialize)]
pub struct Quantity {
    /// As in the file.
    pub name: &'static str,
    /// As in Rust.
    pub ascii: &'static str,
    /// Rows and columns.
    pub shape: (usize, usize),
    /// As in the file; in base SI symbols where it is derived.
    pub unit: &'static str,
    /// Its doc lines.
    pub doc: &'static str,
    /// Components row by row, where it has a value of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Vec<f64>>,
}

/// A solver.
#[derive(Serialize)]
pub struct Form {
    /// `next` or `increment`.
    pub form: &'static str,
    /// Blocks of unknowns.
    pub unknowns: Vec<Block>,
    /// As in the file.
    pub equations: Vec<Block>,
    /// Entries of the Jacobian that can differ from zero.
    pub nonzeros: usize,
    /// Operations of each emitted function.
    pub operations: Vec<Operations>,
    /// What is iterated on, where that is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub core: Option<Core>,
}

/// A solver after elimination.
#[derive(Serialize)]
pub struct Core {
    /// Blocks of unknowns.
    pub unknowns: Vec<Block>,
    /// Entries of the Jacobian that can differ from zero.
    pub nonzeros: usize,
    /// Operations of each emitted function.
    pub operations: Vec<Operations>,
}

/// A block of unknowns or an equation.
#[derive(Serialize)]
pub struct Block {
    /// Its text.
    pub text: &'static str,
    /// Number of components.
    pub len: usize,
    /// Line in the file, for equations.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
}

/// Operations of one function.
#[derive(Serialize)]
pub struct Operations {
    /// Its name.
    pub function: &'static str,
    /// `+` and `-`
    pub additions: usize,
    /// `*`
    pub multiplications: usize,
    /// `/`
    pub divisions: usize,
    /// Elementary functions.
    pub calls: usize,
}

/// What data must be like.
#[derive(Serialize)]
pub struct Requirement {
    /// Its text.
    pub text: &'static str,
    /// What it means if that does not hold.
    pub otherwise: &'static str,
    /// Line in the file.
    pub line: usize,
}

/// A printed statement.
#[derive(Serialize)]
pub struct Claim {
    /// What it is about.
    pub kind: &'static str,
    /// What its author calls it.
    pub label: &'static str,
    /// The claimed residual that a Jacobian belongs to.
    pub of: Option<&'static str>,
    /// Line in the file.
    pub line: usize,
    /// Entries in which it is wrong.
    pub wrong_entries: usize,
}

/// Reads it off a compiled model.
pub fn describe(model: &Catalogued) -> Model {
    let description = model.description;
    let defaults = values::defaults(model);
    let start = values::start(model, &defaults);
    let outputs = |invariant: bool| {
        let kept = description
            .outputs
            .iter()
            .filter(move |o| o.invariant == invariant);
        kept.map(|output| quantity(&output.variable, None))
            .collect()
    };
    let claims = description.claims.iter().map(|claim| Claim {
        kind: claim.kind,
        label: claim.label,
        of: claim.of,
        line: claim.line,
        wrong_entries: claim.differences.len(),
    });
    let requirements = description.requirements.iter();
    let requirements = requirements.map(|requirement| Requirement {
        text: requirement.text,
        otherwise: requirement.otherwise,
        line: requirement.line,
    });
    Model {
        name: description.name,
        doc: description.doc,
        parameters: valued(description.parameters, &defaults),
        states: valued(description.states, &start),
        invariants: outputs(true),
        observables: outputs(false),
        solvers: description.solvers.iter().map(form).collect(),
        flow: description.has_flow,
        operations: description.operations,
        requirements: requirements.collect(),
        claims: claims.collect(),
        scene: description.scene.map(|scene| Scene {
            model: scene.model,
            step: scene.step,
            until: scene.until,
            keep: scene.keep,
        }),
    }
}

fn valued(variables: &'static [Variable], mut values: &[f64]) -> Vec<Quantity> {
    let next = |variable: &'static Variable| {
        let (own, rest) = values.split_at(variable.rows * variable.cols);
        values = rest;
        quantity(variable, Some(own.to_vec()))
    };
    variables.iter().map(next).collect()
}

fn quantity(variable: &'static Variable, value: Option<Vec<f64>>) -> Quantity {
    Quantity {
        name: variable.name,
        ascii: variable.ascii,
        shape: (variable.rows, variable.cols),
        unit: variable.unit,
        doc: variable.doc,
        value,
    }
}

fn form(solver: &'static Solver) -> Form {
    let equations = solver.equations.iter().map(|equation| Block {
        text: equation.text,
        len: equation.len,
        line: Some(equation.line),
    });
    Form {
        form: solver.form,
        unknowns: blocks(solver.unknowns),
        equations: equations.collect(),
        nonzeros: solver.pattern.len(),
        operations: solver.counts.iter().map(operations).collect(),
        core: solver.core.map(|core| Core {
            unknowns: blocks(core.unknowns),
            nonzeros: core.pattern.len(),
            operations: core.counts.iter().map(operations).collect(),
        }),
    }
}

fn blocks(unknowns: &'static [Unknown]) -> Vec<Block> {
    let block = |unknown: &'static Unknown| Block {
        text: unknown.name,
        len: unknown.len,
        line: None,
    };
    unknowns.iter().map(block).collect()
}

fn operations(&(function, count): &(&'static str, Count)) -> Operations {
    let Count {
        additions,
        multiplications,
        divisions,
        calls,
    } = count;
    Operations {
        function,
        additions,
        multiplications,
        divisions,
        calls,
    }
}
