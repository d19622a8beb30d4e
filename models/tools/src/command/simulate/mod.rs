//! `residua simulate`: a run, its rows, its picture, and a summary.

mod drift;
mod failed;
mod plan;
mod recorder;
mod rows;
mod trace;

use crate::failure::Failure;
use crate::motion::Motion;
use crate::notation;
use crate::output::{create, create_picture, is_same, is_stdout};
use crate::plot;
use crate::plot::Figure;
use crate::requirements;
use clap::{Args, ValueEnum};
use plan::{Plan, Scheme, Terms, plan};
use recorder::Recorder;
use residua::description::Description;
use residua::erased::{Observer, Run, Sample};
use residua::{Catalogued, RunError, Settings, Statistics, Strategy};
use residua_models::Entry;
use residua_tools::columns::header;
use rows::Rows;
use std::fs::File;
use std::io::{self, BufWriter, IsTerminal, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use trace::Trace;

/// Run a model and write its states, observables and invariants
#[derive(Args)]
pub struct Simulate {
    #[command(flatten)]
    motion: Motion,
    /// newton on the discrete equations; or on the continuous ones rk4, midpoint, trapezoidal, gauss2 … gauss8 (of order
    /// 4 … 16), composition4, 6 or 8 (of midpoint rules), dopri5, taylor, taylor1 … taylor24
    #[arg(long, value_name = "NAME", default_value = plan::NEWTON)]
    scheme: String,
    /// Keep every N-th step, and the last one
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..))]
    every: u64,
    /// newton: largest correction, relative to the size of what it corrects [default: 1e-12]; gauss3 … gauss8, dopri5,
    /// taylor: largest error of a step, the length of which then follows it, with outputs every H [default: steps of H;
    /// dopri5, taylor: 1e-9]
    #[arg(long, value_name = "EPS", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Which unknowns Newton's method iterates on; those that enter linearly need not be [default: core]
    #[arg(long, value_enum)]
    strategy: Option<StrategyName>,
    /// Let the rounding of the sums of increments add up
    #[arg(long)]
    uncompensated: bool,
    /// Take a step that fails as 2, 4, … 2ᴺ shorter ones before giving up
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u32).range(..=20))]
    halve: u32,
    /// Compute in single precision (f32), as small processors do; tolerances below 7.7e-6 are out of its reach
    #[arg(long)]
    single: bool,
    /// File for the rows, as CSV [default: standard output, unless there is a --plot]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// File for a picture, as SVG
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Do not print the summary
    #[arg(long, short)]
    quiet: bool,
}

/// Newton's tolerance where nobody says otherwise.
const TOLERANCE: f64 = 1e-12;

#[derive(Clone, Copy, ValueEnum)]
enum StrategyName {
    /// Those that are left after elimination, and all where that fails
    Core,
    /// All
    Full,
}

impl From<StrategyName> for Strategy {
    fn from(name: StrategyName) -> Self {
        match name {
            StrategyName::Core => Strategy::Core,
            StrategyName::Full => Strategy::Full,
        }
    }
}

impl Simulate {
    /// Runs the model.
    pub fn run(self) -> Result<(), Failure> {
        let entry = self.motion.entry()?;
        let model = entry.catalogued;
        let plan = plan(&self, model)?;
        if !self.quiet {
            plan.notes.iter().for_each(|note| tell!("note: {note}"));
        }
        let files = self.out.as_deref().zip(self.plot.as_deref());
        if files.is_some_and(|(out, plot)| is_same(out, plot)) {
            return Err(Failure::input("--out and --plot name the same file"));
        }
        self.refuse_invalid(&plan)?;
        if !self.quiet {
            let unmet = requirements::unmet(model, &plan.parameters, plan.step, &plan.start);
            unmet.for_each(|i| tell!("warning: {}", requirements::text(model, i)));
        }
        // Before the run, so that a bad path does not cost one.
        let picture = self.plot.as_deref().map(create_picture).transpose()?;
        let mut recorder = self.recorder(model, &plan)?;
        let clock = Instant::now();
        let outcome = self.advance(entry, &plan, &mut recorder);
        let elapsed = clock.elapsed();
        let recorded = recorder.finish()?;
        // What was computed before a failure is as good as in any run, so it is shown as well.
        if let (Some(file), Some(trace)) = (picture, recorded.trace) {
            let subtitle = self.subtitle(&plan, outcome.as_ref().ok());
            draw(file, trace, model.description, subtitle)?;
        }
        if !self.quiet {
            if let Ok(statistics) = &outcome {
                tell!("{}", pace(&plan, statistics, elapsed));
                let drift = recorded.drift.to_string();
                if !drift.is_empty() {
                    tell!("{}", drift.trim_end());
                }
            }
            self.name_files(recorded.rows);
        }
        outcome.map(drop)
    }

    fn recorder(&self, model: &'static Catalogued, plan: &Plan) -> Result<Recorder, Failure> {
        let header = header(model.description);
        let to_stdout = self.out.as_deref().map_or(self.plot.is_none(), is_stdout);
        let out: Option<Box<dyn Write>> = match &self.out {
            _ if to_stdout => Some(Box::new(BufWriter::new(io::stdout()))),
            Some(path) => Some(Box::new(BufWriter::new(create(path)?))),
            None => None,
        };
        let kept = plan.steps / self.every + 2;
        let trace = self
            .plot
            .is_some()
            .then(|| Trace::new(model.description, kept));
        let rows = out.map(|out| Rows::new(out, &header)).transpose()?;
        let hidden = self.quiet || (to_stdout && io::stdout().is_terminal());
        Ok(Recorder::new(model, plan, rows, trace, !hidden))
    }

    /// Refuses what no run can start from, before anything is written.
    fn refuse_invalid(&self, plan: &Plan) -> Result<(), Failure> {
        let run = Run {
            steps: 0,
            ..self.planned(plan)
        };
        let outcome = self.simulate(plan, &run, &mut |_| ControlFlow::Break(()));
        outcome.map_err(|error| Failure::input(error.to_string()))?;
        Ok(())
    }

    fn advance(
        &self,
        entry: &Entry,
        plan: &Plan,
        recorder: &mut Recorder,
    ) -> Result<Statistics, Failure> {
        let mut observer = |sample: Sample<'_>| recorder.take(&sample);
        let run = self.planned(plan);
        let outcome = self.simulate(plan, &run, &mut observer);
        outcome.map_err(|error| match (&error, &plan.scheme) {
            (RunError::Step(step), Scheme::Newton(solver)) if !self.single => {
                Failure::Run(failed::explain(entry, *solver, &run, step))
            }
            _ => Failure::Run(error.to_string()),
        })
    }

    fn simulate(
        &self,
        plan: &Plan,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        match plan.scheme {
            Scheme::Newton(solver) if self.single => solver.simulate_in_single(run, observer),
            Scheme::Newton(solver) => solver.simulate(run, observer),
            Scheme::Flow(flow, scheme) => flow.simulate(scheme, run, observer),
            Scheme::Series(series, Terms::Order(order)) => series.simulate(run, order, observer),
            Scheme::Series(series, Terms::Within(tolerance)) => {
                series.simulate_within(run, tolerance, observer)
            }
        }
    }

    fn planned<'a>(&self, plan: &'a Plan) -> Run<'a> {
        Run {
            parameters: &plan.parameters,
            start: &plan.start,
            h: plan.step,
            t0: 0.0,
            steps: plan.steps,
            every: self.every,
            settings: Settings {
                tolerance: self.tolerance.unwrap_or(TOLERANCE),
                strategy: self.strategy.unwrap_or(StrategyName::Core).into(),
                compensated: !self.uncompensated,
                halvings: self.halve,
                ..Settings::default()
            },
        }
    }

    fn subtitle(&self, plan: &Plan, statistics: Option<&Statistics>) -> String {
        let scheme = match plan.scheme {
            Scheme::Newton(solver) => format!("{} form", solver.solver().form),
            Scheme::Flow(_, scheme) => scheme.name().to_owned(),
            Scheme::Series(..) => self.scheme.clone(),
        };
        let pace = statistics.and_then(iterations);
        let set = self.motion.assignments().map(ToString::to_string);
        let mut parts = vec![scheme, format!("h = {}", plan.step)];
        parts.extend(self.single.then(|| "single precision".to_owned()));
        parts.extend(pace);
        parts.extend(set);
        parts.join(" · ")
    }

    fn name_files(&self, rows: Option<u64>) {
        if let (Some(path), Some(rows)) = (self.out.as_deref().filter(|p| !is_stdout(p)), rows) {
            tell!("{} ({rows} rows)", path.display());
        }
        if let Some(path) = &self.plot {
            tell!("{}", path.display());
        }
    }
}

fn draw(
    mut file: File,
    trace: Trace,
    description: &'static Description,
    subtitle: String,
) -> Result<(), Failure> {
    let unit = if notation::has_units(description) {
        " [s]"
    } else {
        ""
    };
    let figure = Figure {
        title: description.name.to_owned(),
        subtitle,
        time: format!("t{unit}"),
        panels: trace.into_panels(),
        width: plot::WIDTH,
    };
    let text = plot::svg(&figure).map_err(Failure::Run)?;
    Ok(file.write_all(text.as_bytes())?)
}

/// `10000 steps of 0.01 to t = 100 in 12 ms, 3.02 iterations per step`
fn pace(plan: &Plan, statistics: &Statistics, elapsed: Duration) -> String {
    let Plan { steps, step, .. } = *plan;
    let end = notation::number(steps as f64 * step);
    let mut text = format!("{steps} steps of {step} to t = {end} in {elapsed:.1?}");
    if statistics.accepted > 0 {
        let (accepted, rejected) = (statistics.accepted, statistics.rejected);
        text = format!("{text}, {accepted} steps between of any length, {rejected} rejected");
    }
    if let Some(iterations) = iterations(statistics) {
        text = format!("{text}, {iterations}");
    }
    let notable = [
        (
            statistics.fallbacks,
            "with all unknowns, where the core could not be trusted",
        ),
        (statistics.halved, "taken as shorter ones"),
        (
            statistics.at_floor,
            "ended at the rounding floor, above the tolerance",
        ),
    ];
    for (count, what) in notable.iter().filter(|(count, _)| *count > 0) {
        let plural = if *count == 1 { "" } else { "s" };
        text = format!("{text}, {count} step{plural} {what}");
    }
    text
}

/// Of the steps of one length, or of those that a tolerance has chosen.
fn iterations(statistics: &Statistics) -> Option<String> {
    let (taken, which) = match statistics.accepted + statistics.rejected {
        0 => (statistics.steps, "per step"),
        tried => (tried, "each"),
    };
    let mean = statistics.iterations as f64 / taken.max(1) as f64;
    (statistics.iterations > 0).then(|| format!("{mean:.2} iterations {which}"))
}
