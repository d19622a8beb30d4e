//! `residua explain`: what a solver costs, and what a scene has left out of it.

mod text;

use crate::failure::Failure;
use crate::list::print_json;
use clap::Args;
use residua::Catalogued;
use residua::description::{Count, Description, Solver, Unknown};
use residua_models::find;
use residua_models::values::total;
use serde::Serialize;
use std::io::{self, Write};

/// Show what a scene computes of its model, what it leaves out, and why; or what a model computes
#[derive(Args)]
pub struct Explain {
    /// A scene or a model from `residua list`
    name: String,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// The receipt.
#[derive(Serialize)]
pub struct Receipt {
    /// The scene or model.
    pub name: &'static str,
    /// The model of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<&'static str>,
    /// Time step.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// End time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub until: Option<f64>,
    /// What is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub keep: Option<&'static [&'static str]>,
    /// Solver by solver, one of a scene.
    pub forms: Vec<Form>,
    /// What is gone.
    pub skipped: Vec<Skipped>,
}

/// One solver.
#[derive(Serialize)]
pub struct Form {
    /// `next` or `increment`.
    pub form: &'static str,
    /// Side by side: the model and the scene, or all unknowns of a model and what is iterated on.
    pub columns: Vec<Column>,
    /// What is solved in closed form, if something is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub eliminated: Option<Eliminated>,
}

/// The numbers of one solver.
#[derive(Serialize)]
pub struct Column {
    /// What it is about.
    pub title: &'static str,
    /// Components of the state.
    pub states: usize,
    /// Unknowns solved for, and so many equations.
    pub unknowns: usize,
    /// Unknowns that Newton's method iterates on.
    pub iterated: usize,
    /// Entries of its Jacobian that can differ from 0.
    pub nonzeros: usize,
    /// Operations by rate.
    pub operations: Vec<Operations>,
}

/// Operations of one function, as this column's solver calls it.
#[derive(Serialize)]
pub struct Operations {
    /// `per run`, `per step`, `per iteration`, `next state`, `outputs`.
    pub rate: &'static str,
    /// `+` and `-`
    pub additions: usize,
    /// `*`
    pub multiplications: usize,
    /// `/`
    pub divisions: usize,
    /// Elementary functions.
    pub calls: usize,
}

/// Unknowns that enter linearly.
#[derive(Serialize)]
pub struct Eliminated {
    /// Which, and how many components of each.
    pub unknowns: Vec<(&'static str, usize)>,
    /// The lines of the equations that are solved for them, in the model file.
    pub lines: &'static [usize],
}

/// Something that a scene does without.
#[derive(Serialize)]
pub struct Skipped {
    /// `parameter`, `state`, `component`, `unknown`, `equation`, `output` or `flow`.
    pub kind: &'static str,
    /// Its name or text.
    pub what: &'static str,
    /// Why.
    pub reason: &'static str,
    /// Its line in the model file.
    pub line: usize,
}

/// What is counted and under which name.
const RATES: [(&str, &str); 5] = [
    ("per run", "scene"),
    ("per step", "step"),
    ("per iteration", "residual_and_jacobian"),
    ("next state", "next"),
    ("outputs", "outputs"),
];

impl Explain {
    /// Prints the receipt.
    pub fn run(self) -> Result<(), Failure> {
        let receipt = explain(find(&self.name)?.catalogued)?;
        let mut out = io::stdout().lock();
        match self.json {
            true => print_json(&receipt, &mut out),
            false => Ok(write!(out, "{receipt}")?),
        }
    }
}

fn explain(found: &'static Catalogued) -> Result<Receipt, Failure> {
    let description = found.description;
    let forms = match description.scene {
        None => description
            .solvers
            .iter()
            .map(|s| own(description, s))
            .collect(),
        Some(scene) => {
            let model = find(scene.model)?.catalogued.description;
            description
                .solvers
                .iter()
                .filter_map(|solver| side_by_side(model, description, solver))
                .collect()
        }
    };
    let scene = description.scene;
    let skipped = scene.map_or(&[][..], |scene| scene.skipped).iter();
    Ok(Receipt {
        name: description.name,
        model: scene.map(|scene| scene.model),
        step: scene.map(|scene| scene.step),
        until: scene.map(|scene| scene.until),
        keep: scene.map(|scene| scene.keep),
        forms,
        skipped: skipped
            .map(|s| Skipped {
                kind: s.kind,
                what: s.what,
                reason: s.reason,
                line: s.line,
            })
            .collect(),
    })
}

/// A model: all unknowns against what is iterated on.
fn own(description: &'static Description, solver: &'static Solver) -> Form {
    let mut columns = vec![all(description, solver, "all unknowns")];
    if solver.core.is_some() {
        columns.push(core(description, solver, "iterated on"));
    }
    Form {
        form: solver.form,
        columns,
        eliminated: eliminated(solver),
    }
}

/// A scene against its model, each as it runs.
fn side_by_side(
    model: &'static Description,
    scene: &'static Description,
    solver: &'static Solver,
) -> Option<Form> {
    let before = model.solvers.iter().find(|s| s.form == solver.form)?;
    Some(Form {
        form: solver.form,
        columns: vec![core(model, before, "model"), core(scene, solver, "scene")],
        eliminated: eliminated(solver),
    })
}

fn all(description: &'static Description, solver: &'static Solver, title: &'static str) -> Column {
    let unknowns = size(solver.unknowns);
    Column {
        title,
        states: total(description.states),
        unknowns,
        iterated: unknowns,
        nonzeros: solver.pattern.len(),
        operations: operations(description, solver.counts),
    }
}

/// As it runs: with the core, where there is one.
fn core(description: &'static Description, solver: &'static Solver, title: &'static str) -> Column {
    let all = all(description, solver, title);
    match solver.core {
        None => all,
        Some(core) => Column {
            iterated: size(core.unknowns),
            nonzeros: core.pattern.len(),
            operations: operations(description, core.counts),
            ..all
        },
    }
}

fn size(unknowns: &[Unknown]) -> usize {
    unknowns.iter().map(|unknown| unknown.len).sum()
}

fn operations(
    description: &'static Description,
    counts: &'static [(&'static str, Count)],
) -> Vec<Operations> {
    let all = || counts.iter().chain(description.counts);
    let row = |&(rate, name): &(&'static str, &str)| {
        let found = all().find(|(function, _)| *function == name);
        let none = Count {
            additions: 0,
            multiplications: 0,
            divisions: 0,
            calls: 0,
        };
        let count = found.map_or(none, |(_, count)| *count);
        Operations {
            rate,
            additions: count.additions,
            multiplications: count.multiplications,
            divisions: count.divisions,
            calls: count.calls,
        }
    };
    RATES.iter().map(row).collect()
}

fn eliminated(solver: &'static Solver) -> Option<Eliminated> {
    let core = solver.core?;
    Some(Eliminated {
        unknowns: core.eliminated.iter().map(|u| (u.name, u.len)).collect(),
        lines: core.lines,
    })
}
