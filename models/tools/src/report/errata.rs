//! Misprints: what the models find in the paper, and what was read by eye.

mod data;

use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Section;
use super::page::Table;
use super::runs::RunError;
use crate::errata::Errata;
use crate::errata::FUNCTIONS;
use crate::errata::Misprint;
use crate::errata::Verdict;
use crate::errata::by_eye::SLIPS;
use crate::errata::errata;
use crate::errata::newton::Plan;
use crate::errata::newton::Run;
use crate::errata::title;
use crate::notation::rounded;
use indicatif::ProgressBar;
use residua_models::CATALOGUE;

/// Most characters of a formula in the summary.
const LONGEST: usize = 60;

/// The section.
///
/// # Errors
/// Models that do not compile, of which the catalogue has none.
pub fn section(progress: &ProgressBar) -> Result<Section, RunError> {
    progress.inc_length(CATALOGUE.len() as u64);
    let mut models = Vec::new();
    for entry in CATALOGUE {
        models.push(errata(entry, &Plan::default()).map_err(RunError::Claims)?);
        progress.inc(1);
    }
    let claims: usize = models.iter().map(|model| model.claims.len()).sum();
    let text = format!(
        "The model files state {claims} equations as the paper prints them. The generator compares each with what follows \
         from the model: a Jacobian with the derivative of the residual, a residual with the model’s, continuous \
         equations with its flow, an identity with itself, at generic points. Where somebody who codes the printed \
         version would run Newton’s method with it, so does this page."
    );
    Ok(Section {
        id: "errata".to_owned(),
        title: "Errata".to_owned(),
        blocks: vec![Block::Text(text)],
        parts: vec![wrong(&models), right(&models), data::section()?, by_eye()],
    })
}

fn part(id: &str, title: &str, blocks: Vec<Block>) -> Section {
    Section {
        id: format!("errata-{id}"),
        title: title.to_owned(),
        blocks,
        parts: Vec::new(),
    }
}

fn wrong(models: &[Errata]) -> Section {
    let mut summary = Data::new(&[
        "claim",
        "model",
        "wrong in",
        "the first",
        "printed",
        "right",
        "Newton as printed",
        "Newton",
        "states differ by",
    ]);
    let mut entries = Data::new(&["model", "claim", "entry", "printed", "right", "decided by"]);
    let mut newton_only = Vec::new();
    for (model, claim) in claims(models) {
        for misprint in &claim.differences {
            let (printed, right) = sides(claim, misprint);
            entries.row([
                Cell::Code(model.to_owned()),
                name(claim).into(),
                misprint.entry.as_str().into(),
                Cell::Code(printed),
                Cell::Code(right),
                claim.decided.as_str().into(),
            ]);
        }
        let newton = claim.newton.as_ref();
        if let Some(first) = claim.differences.first() {
            let runs = newton.map(|newton| (run(&newton.printed), run(&newton.right)));
            let (printed, right) = runs.unzip();
            let (as_printed, as_right) = sides(claim, first);
            summary.row([
                name(claim).into(),
                Cell::Code(model.to_owned()),
                Cell::Count(claim.differences.len() as u64),
                first.entry.as_str().into(),
                Cell::Code(shortened(&as_printed)),
                Cell::Code(shortened(&as_right)),
                printed.into(),
                right.into(),
                newton
                    .and_then(|n| n.difference)
                    .map(|d| Cell::number(d, 2))
                    .into(),
            ]);
        } else if let Some(newton) = newton {
            newton_only.push(format!(
                "{} is right, but with it and what it belongs to, Newton’s method in {model} {}; {}.",
                name(claim),
                match newton.printed.steps {
                    0 => run(&newton.printed),
                    _ => format!("takes {}", run(&newton.printed)),
                },
                match newton.difference {
                    Some(difference) => format!("states end {} apart", rounded(difference, 2)),
                    None => "no result".to_owned(),
                }
            ));
        }
    }
    let Plan { h, steps } = Plan::default();
    let mut blocks = vec![Block::Table(Table {
        csv: "errata-wrong".to_owned(),
        caption: format!(
            "Printed statements that are wrong, with the first entry of each. Newton’s method with the printed Jacobian or \
             residual and with the right one: {steps} steps of {h} s from the model’s start."
        ),
        data: summary,
    })];
    let mut notes: Vec<&str> = claims(models).filter_map(|(_, claim)| claim.note).collect();
    notes.dedup();
    blocks.extend(notes.into_iter().map(|note| Block::Text(note.to_owned())));
    blocks.push(Block::Text(format!(
        "In formulas {FUNCTIONS} Of an equation of rates or of variations, which has two sides, the tables show what is left \
         of left − right."
    )));
    if !newton_only.is_empty() {
        blocks.push(Block::List(newton_only));
    }
    blocks.push(Block::Folded(Table {
        csv: "errata-entries".to_owned(),
        caption: "Entry by entry.".to_owned(),
        data: entries,
    }));
    part("wrong", "Found wrong by the generator", blocks)
}

/// What is printed and what is right.
fn sides(claim: &Verdict, misprint: &Misprint) -> (String, String) {
    match claim.leaves_remainders() {
        true => (
            format!("left − right = {}", misprint.printed),
            "left − right = 0".to_owned(),
        ),
        false => (misprint.printed.clone(), misprint.right.clone()),
    }
}

/// The start of a formula that is too long for a table.
fn shortened(formula: &str) -> String {
    match formula.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{} …", &formula[..end]),
        None => formula.to_owned(),
    }
}

/// `7.9 iterations per step`, `fails in step 1`
fn run(run: &Run) -> String {
    let pace = format!("{} iterations per step", rounded(run.mean_iterations, 2));
    match (&run.failure, run.steps) {
        (None, _) => pace,
        (Some(failure), 0) => format!("fails in step 1: {failure}"),
        (Some(failure), steps) => format!("{pace}; fails in step {}: {failure}", steps + 1),
    }
}

fn right(models: &[Errata]) -> Section {
    let mut list = Vec::new();
    for model in models {
        let names = model.claims.iter().filter(|claim| claim.right).map(name);
        let names: Vec<String> = names.collect();
        if !names.is_empty() {
            list.push(format!("{}: {}", model.model, names.join(", ")));
        }
    }
    part(
        "right",
        "Found right by the generator",
        vec![Block::List(list)],
    )
}

fn claims(models: &[Errata]) -> impl Iterator<Item = (&str, &Verdict)> {
    models.iter().flat_map(|model| {
        model
            .claims
            .iter()
            .map(|claim| (model.model.as_str(), claim))
    })
}

fn name(claim: &Verdict) -> String {
    title(claim.kind, &claim.label, claim.of.as_deref())
}

fn by_eye() -> Section {
    let text = "What no tool can decide: labels, words, and what may be a fault of the extracted text only. These were \
                read by eye.";
    let mut data = Data::new(&["place", "printed", "right", "why", "sure"]);
    for slip in SLIPS {
        let sure = if slip.doubtful {
            "perhaps the extracted text only"
        } else {
            "yes"
        };
        data.row([slip.place, slip.printed, slip.right, slip.reason, sure].map(Cell::from));
    }
    let table = Table {
        csv: "errata-by-eye".to_owned(),
        caption: "Read by eye.".to_owned(),
        data,
    };
    part(
        "by-eye",
        "Read by eye",
        vec![Block::Text(text.to_owned()), Block::Table(table)],
    )
}
