//! What is said of a step that failed.

use crate::diagnose;
use crate::notation;
use annotate_snippets::Level;
use residua::StepError;
use residua::description::Equation;
use residua::erased::{AnySolver, Run};
use residua_codegen::trace::Valued;
use residua_models::Entry;
use residua_tools::replay::{Correction, Replay, replay};
use std::fmt::Write;

/// A condition number beyond this leaves a correction without digits.
const SINGULAR: f64 = 1.0 / f64::EPSILON;

/// The error, and what is seen when the step is taken once more.
pub fn explain(entry: &Entry, solver: &dyn AnySolver, run: &Run, error: &StepError) -> String {
    let seen = replay(entry, solver, run, error.step);
    let seen = seen.map(|replay| text(entry, solver, run, &replay));
    format!("{error}{}", seen.unwrap_or_default())
}

fn text(entry: &Entry, solver: &dyn AnySolver, run: &Run, replay: &Replay) -> String {
    let mut text = String::new();
    let names = entry.catalogued.description.states.iter();
    let names: Vec<String> = names.flat_map(notation::components).collect();
    let state = names.iter().zip(&replay.state);
    let state: Vec<String> = state
        .map(|(name, value)| format!("{name} = {}", notation::number(*value)))
        .collect();
    // Writing to a string cannot fail.
    let _ = write!(text, "\n\nthe state before it: {}", state.join(", "));
    if !replay.corrections.is_empty() {
        text.push_str("\nNewton from the plain guess, all unknowns:");
        text.push_str("\n  correction  largest  condition  furthest from 0");
    }
    for (i, correction) in replay.corrections.iter().enumerate() {
        let Correction {
            size,
            row,
            residual,
            condition,
        } = correction;
        let line = line(solver.solver().equations, *row);
        let _ = write!(
            text,
            "\n  {:<10}  {size:<7.1e}  {condition:<9.1e}  line {line}, by {residual:.1e}",
            i + 1
        );
    }
    if let Some(culprit) = &replay.culprit {
        let file = format!("{}.model", entry.name());
        let found = format!("{} here", values(&culprit.whole));
        let parts: Vec<String> = culprit
            .operands
            .iter()
            .map(|part| {
                format!(
                    "{} = {}",
                    diagnose::excerpt(entry.source, part.range),
                    values(part)
                )
            })
            .collect();
        let help = (!parts.is_empty()).then(|| format!("where {}", parts.join(", ")));
        let shown = diagnose::snippet(
            Level::NOTE,
            &file,
            entry.source,
            &format!("not finite: {found}"),
            diagnose::place(entry.source, culprit.whole.range),
            help.as_deref(),
        );
        let _ = write!(text, "\n{shown}");
    } else if replay
        .corrections
        .last()
        .is_some_and(|last| last.condition.is_nan() || last.condition > SINGULAR)
    {
        text.push_str(
            "\nthe Jacobian is singular there: some unknown is not determined by the equations",
        );
    }
    let _ = match replay.possible {
        Some((h, halvings)) => write!(
            text,
            "\nhelp: from this state, --step {h} works; --halve {halvings} takes such steps where they are needed"
        ),
        None => write!(
            text,
            "\nhelp: no shorter step works either, down to {:.1e}",
            run.h / 4096.0
        ),
    };
    text
}

fn line(equations: &[Equation], mut row: usize) -> usize {
    for equation in equations {
        if row < equation.len {
            return equation.line;
        }
        row -= equation.len;
    }
    0
}

fn values(valued: &Valued) -> String {
    match valued.values.as_slice() {
        [value] => notation::number(*value),
        values => {
            let all: Vec<String> = values
                .iter()
                .map(|value| notation::number(*value))
                .collect();
            format!("[{}]", all.join(", "))
        }
    }
}
