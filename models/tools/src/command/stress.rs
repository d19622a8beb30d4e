//! `residua stress`: models at their limits.

use crate::failure::Failure;
use crate::notation;
use crate::table::Table;
use clap::Args;
use indicatif::{ParallelProgressIterator, ProgressBar};
use rayon::prelude::*;
use residua::erased::AnySolver;
use residua_models::{CATALOGUE, Entry, SCENES, find};
use residua_tools::stress::{
    Case, Endurance, Kind, Twin, Verdict, Wrong, cases, endure, in_other_frames, in_other_units,
    judge, judge_in_single, on_their_way_back, twins,
};
use std::io::{self, IsTerminal};

/// Steps of a run.
const STEPS: u64 = 20;

/// Runs at random, of each solver, and in short.
const RANDOM: usize = 400;
const FEW_RANDOM: usize = 40;

/// Steps of the long run of each solver, and in short.
const LONG: u64 = 10_000_000;
const NOT_SO_LONG: u64 = 20_000;

/// Of the runs that are not at random, one in so many is made in short.
const SHORT_SHARE: usize = 7;

/// Wrong steps that are shown.
const SHOWN: usize = 20;

/// Put models to extreme parameters, states and steps, and compare every accepted step with double-double numbers
#[derive(Args)]
pub struct Stress {
    /// Models and scenes from `residua list` [default: all]
    names: Vec<String>,
    /// Make a seventh of the runs
    #[arg(long)]
    short: bool,
}

/// Columns of the table: a kind in `f64` each, and all kinds in `f32`.
const COLUMNS: usize = Kind::ALL.len() + 1;

/// What came of the runs of one kind.
#[derive(Clone, Copy, Default)]
struct Tally {
    right: usize,
    refused: usize,
    open: usize,
    wrong: usize,
}

impl Stress {
    /// Makes the runs and shows a table.
    pub fn run(self) -> Result<(), Failure> {
        let named = self.names.iter().map(|name| Ok(find(name)?));
        let mut entries = named.collect::<Result<Vec<&Entry>, Failure>>()?;
        if entries.is_empty() {
            entries.extend(CATALOGUE.iter().chain(SCENES));
        }
        let mut headings = vec!["model", "runs"];
        let mut long = Table::new(&[
            "model",
            "form",
            "steps",
            "",
            "largest drift of an invariant",
        ]);
        headings.extend(Kind::ALL.map(Kind::name));
        headings.extend(["f32", "wrong"]);
        let mut table = Table::new(&headings);
        let bar = match io::stderr().is_terminal() {
            true => ProgressBar::new(entries.len() as u64),
            false => ProgressBar::hidden(),
        };
        let judged: Vec<Judged> = entries
            .par_iter()
            .progress_with(bar)
            .map(|entry| self.judge(entry))
            .collect();
        let mut wrong = 0;
        for Judged {
            entry,
            tallies,
            found,
            endured,
        } in &judged
        {
            let all = tallies.iter().fold(Tally::default(), Tally::plus);
            let mut row = vec![entry.name().to_owned(), all.runs().to_string()];
            row.extend(tallies.iter().map(Tally::cell));
            row.push(all.wrong.to_string());
            table.row(row);
            wrong += all.wrong;
            for (form, endurance) in endured {
                let (row, is_wrong) = self::long(entry, form, endurance);
                long.row(row);
                wrong += usize::from(is_wrong);
            }
            for text in found.iter().take(SHOWN) {
                tell!("{text}");
            }
        }
        println!("{table}\n{long}");
        let all = judged.iter().flat_map(|judged| &judged.tallies);
        let all = all.fold(Tally::default(), Tally::plus);
        println!(
            "{} runs of up to {STEPS} steps: {} right (r), {} refused (x), {} that 31 digits cannot tell (?), {} wrong (!)",
            all.runs(),
            all.right,
            all.refused,
            all.open,
            all.wrong
        );
        match wrong {
            0 => Ok(()),
            n => Err(Failure::Run(format!(
                "{n} runs with a step that is not right"
            ))),
        }
    }

    fn judge<'e>(&self, entry: &'e Entry) -> Judged<'e> {
        let mut judged = Judged {
            entry,
            tallies: [Tally::default(); COLUMNS],
            found: Vec::new(),
            endured: Vec::new(),
        };
        let random = if self.short { FEW_RANDOM } else { RANDOM };
        let share = if self.short { SHORT_SHARE } else { 1 };
        for (solver, twin) in &twins(entry) {
            let mut cases = cases(entry.catalogued, random);
            let mut kept = 0..;
            cases.retain(|case| {
                case.kind == Kind::Random || kept.next().is_some_and(|i| i % share == 0)
            });
            let at_random = || cases.iter().filter(|case| case.kind == Kind::Random);
            let elsewhere = [
                on_their_way_back(*solver, at_random(), STEPS),
                in_other_units(entry, at_random()),
                in_other_frames(entry, at_random()),
            ];
            for case in cases.iter().chain(elsewhere.iter().flatten()) {
                judged.take(*solver, twin, case);
            }
            let steps = if self.short { NOT_SO_LONG } else { LONG };
            let endurance = endure(entry, *solver, twin, steps);
            judged.endured.push((solver.solver().form, endurance));
        }
        judged
    }
}

struct Judged<'e> {
    entry: &'e Entry,
    tallies: [Tally; COLUMNS],
    /// The wrong steps.
    found: Vec<String>,
    /// The long run of each form.
    endured: Vec<(&'static str, Endurance)>,
}

impl Judged<'_> {
    /// Makes a run in `f64` and in `f32`.
    fn take(&mut self, solver: &dyn AnySolver, twin: &Twin, case: &Case) {
        let column = Kind::ALL.iter().position(|kind| *kind == case.kind);
        let verdict = judge(solver, twin, case, STEPS);
        self.count(column.unwrap_or_default(), solver, case, verdict);
        let verdict = judge_in_single(solver, twin, case, STEPS);
        self.count(COLUMNS - 1, solver, case, verdict);
    }

    fn count(&mut self, column: usize, solver: &dyn AnySolver, case: &Case, verdict: Verdict) {
        let tally = &mut self.tallies[column];
        match verdict {
            Verdict::Right => tally.right += 1,
            Verdict::Refused => tally.refused += 1,
            Verdict::Open => tally.open += 1,
            Verdict::Wrong(wrong) => {
                tally.wrong += 1;
                let text = describe(self.entry, solver.solver().form, case, &wrong);
                self.found.push(text);
            }
        }
    }
}

/// A row of the second table, and whether the run was wrong.
fn long(entry: &Entry, form: &str, endurance: &Endurance) -> (Vec<String>, bool) {
    let (word, is_wrong) = match endurance.verdict {
        Verdict::Right => ("right", false),
        Verdict::Refused => ("refused", false),
        Verdict::Open => ("?", false),
        Verdict::Wrong(_) => ("wrong", true),
    };
    let drift = endurance
        .drift
        .map_or(String::new(), |(name, drift)| format!("{drift:.1e} {name}"));
    let row = vec![
        entry.name().to_owned(),
        form.to_owned(),
        endurance.steps.to_string(),
        word.to_owned(),
        drift,
    ];
    (row, is_wrong)
}

/// The run as options of `residua simulate`, and what is wrong with it.
fn describe(entry: &Entry, form: &str, case: &Case, wrong: &Wrong) -> String {
    let description = entry.catalogued.description;
    let states: Vec<String> = description
        .states
        .iter()
        .flat_map(notation::components)
        .collect();
    let assigned = |names: Vec<String>, values: &[f64]| -> String {
        let pairs = names.iter().zip(values);
        let pairs: Vec<String> = pairs
            .map(|(name, value)| format!("{name}={value:e}"))
            .collect();
        pairs.join(" ")
    };
    let parameters = description.parameters.iter().flat_map(notation::components);
    format!(
        "{} {form}, h = {:e}, {}; {}: step {}, {} is {:e}, not {:e} ± {:.0e}",
        entry.name(),
        case.h,
        assigned(parameters.collect(), &case.parameters),
        assigned(states.clone(), &case.start),
        wrong.step,
        states.get(wrong.component).map_or("?", String::as_str),
        wrong.found,
        wrong.expected,
        wrong.bound
    )
}

impl Tally {
    fn plus(self, other: &Self) -> Self {
        Self {
            right: self.right + other.right,
            refused: self.refused + other.refused,
            open: self.open + other.open,
            wrong: self.wrong + other.wrong,
        }
    }

    fn runs(&self) -> usize {
        self.right + self.refused + self.open + self.wrong
    }

    /// `120r 3x`
    fn cell(&self) -> String {
        let parts = [
            (self.right, 'r'),
            (self.refused, 'x'),
            (self.open, '?'),
            (self.wrong, '!'),
        ];
        let parts = parts.iter().filter(|(count, _)| *count > 0);
        let parts: Vec<String> = parts
            .map(|(count, letter)| format!("{count}{letter}"))
            .collect();
        parts.join(" ")
    }
}
