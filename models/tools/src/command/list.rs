//! `residua list`: the catalogue, or everything about one model.

use crate::describe::{Model, describe};
use crate::failure::Failure;
use crate::show::show;
use crate::table::Table;
use clap::Args;
use residua_models::{CATALOGUE, SCENES, find};
use std::io::{self, Write};

/// List the models and scenes, or show all about one
#[derive(Args)]
#[command(visible_alias = "show")]
pub struct List {
    /// Show this model or scene: parameters, states, equations, invariants, claims, operation counts
    model: Option<String>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl List {
    /// Prints the list or the model.
    pub fn run(self) -> Result<(), Failure> {
        let mut out = io::stdout().lock();
        if let Some(name) = &self.model {
            let model = describe(find(name)?.catalogued);
            return match self.json {
                true => print_json(&model, &mut out),
                false => Ok(show(&model, &mut out)?),
            };
        }
        let all = CATALOGUE.iter().chain(SCENES);
        let all: Vec<Model> = all.map(|entry| describe(entry.catalogued)).collect();
        if self.json {
            return print_json(&all, &mut out);
        }
        let (scenes, models): (Vec<Model>, _) = all.into_iter().partition(|m| m.scene.is_some());
        write!(out, "{}", overview(&models))?;
        match scenes.is_empty() {
            true => Ok(()),
            false => Ok(write!(out, "\n{}", of_scenes(&scenes))?),
        }
    }
}

/// Prints `value` as JSON, indented.
pub fn print_json(value: &impl serde::Serialize, out: &mut impl Write) -> Result<(), Failure> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(io::Error::from)?;
    Ok(writeln!(out)?)
}

fn overview(models: &[Model]) -> Table {
    let mut table = Table::new(&["model", "states", "unknowns", "forms", "about"]);
    for model in models {
        let states: Vec<&str> = model.states.iter().map(|state| state.name).collect();
        let forms: Vec<&str> = model.solvers.iter().map(|solver| solver.form).collect();
        let unknowns = n_unknowns(model);
        table.row([
            model.name.to_owned(),
            states.join(" "),
            unknowns.to_string(),
            forms.join(", "),
            first_paragraph(model.doc),
        ]);
    }
    table
}

fn of_scenes(scenes: &[Model]) -> Table {
    let mut table = Table::new(&[
        "scene", "model", "step", "until", "unknowns", "keeps", "about",
    ]);
    for model in scenes {
        let Some(scene) = &model.scene else { continue };
        table.row([
            model.name.to_owned(),
            scene.model.to_owned(),
            scene.step.to_string(),
            scene.until.to_string(),
            n_unknowns(model).to_string(),
            scene.keep.join(" "),
            first_paragraph(model.doc),
        ]);
    }
    table
}

fn n_unknowns(model: &Model) -> usize {
    model.solvers.first().map_or(0, |solver| {
        solver.unknowns.iter().map(|block| block.len).sum::<usize>()
    })
}

fn first_paragraph(doc: &str) -> String {
    let lines = doc.lines().map(str::trim);
    let lines: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}
