//! `residua bench precision`: time against error.

mod keep;
mod show;

use crate::assignment::{Assignment, parse};
use crate::failure::Failure;
use crate::motion::assigned;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use residua_models::find;
use residua_tools::precision::{
    Budget, Contestant, Given, Ladders, Problem, Row, Unsolvable, contestants, measure,
};
use residua_tools::study::Case;
use std::fs;
use std::path::PathBuf;

/// Coarsest and finest step where nobody says otherwise, as parts of the whole time.
const STEPS: (f64, f64) = (1.0 / 16.0, 1.0 / (1 << 20) as f64);

/// More rungs than the powers of ten of a tolerance can have, and finer ones than numbers are.
const FINEST: f64 = 1e-16;

/// Time against error of every scheme on every formulation of a motion: work–precision diagrams, and what to use for
/// which error. Other people's integrators take part in a build with `--features rivals`
#[derive(Args)]
pub struct Precision {
    /// Scenes and models from `residua list`, or a scene of the report such as planar-large
    #[arg(required = true)]
    scenes: Vec<String>,
    /// Set a parameter of a model, as in `simulate`
    #[arg(long, value_name = "NAME=EXPR", value_parser = parse)]
    set: Vec<Assignment>,
    /// Set a start value of a model, as in `simulate`
    #[arg(long, value_name = "NAME=EXPR", value_parser = parse)]
    start: Vec<Assignment>,
    /// Formulations to take part, separated by commas [default: all models of the same motion]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    models: Vec<String>,
    /// Schemes to take part, separated by commas [default: all]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    schemes: Vec<String>,
    /// End time [default: that of the scene, or 10]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    until: Option<f64>,
    /// Coarsest and finest step, of schemes with a fixed one: those of T/2ᵏ between them are taken
    /// [default: T/16 to T/2²⁰]
    #[arg(long, value_name = "FROM..TO", value_parser = range)]
    step: Option<(f64, f64)>,
    /// Coarsest and finest tolerance, of schemes that choose their steps: the powers of ten between them are taken
    #[arg(long, value_name = "FROM..TO", value_parser = range, default_value = "1e-2..1e-14")]
    tolerance: (f64, f64),
    /// Timed runs of each kind, after one that is not timed; fewer where they take longer than 0.2 s together
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..=10_000))]
    runs: u64,
    /// Time of a run, s, from which on no finer steps are tried
    #[arg(
        long,
        value_name = "SECONDS",
        default_value_t = 0.1,
        allow_negative_numbers = true
    )]
    limit: f64,
    /// Folder for NAME.csv, NAME.svg and NAME.json of each scene
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Do not show the progress
    #[arg(long, short)]
    quiet: bool,
}

/// Time for the runs of one kind together, s.
const TOGETHER: f64 = 0.2;

fn range(text: &str) -> Result<(f64, f64), String> {
    let expected = || "write FROM..TO, as in 1e-3..1e-12".to_owned();
    let (from, to) = text.split_once("..").ok_or_else(expected)?;
    let read = |text: &str| text.trim().parse::<f64>().map_err(|_| expected());
    let (from, to) = (read(from)?, read(to)?);
    match from >= to && to > 0.0 && from.is_finite() {
        true => Ok((from, to)),
        false => Err("the coarsest comes first, and both are positive numbers".to_owned()),
    }
}

impl Precision {
    /// Measures all scenes.
    pub fn run(self) -> Result<(), Failure> {
        self.refuse_invalid()?;
        let given = self
            .scenes
            .iter()
            .map(|scene| Ok((scene, self.given(scene)?)));
        // Names are checked before anything is measured.
        let given = given.collect::<Result<Vec<_>, Failure>>()?;
        if let Some(folder) = &self.out {
            let made = fs::create_dir_all(folder);
            made.map_err(|error| Failure::file("make", folder, &error))?;
        }
        for (scene, given) in given {
            let problem = Problem::new(scene, given, &self.models).map_err(in_words)?;
            let rows = self.measure(&problem)?;
            show::show(&problem, &rows);
            if let Some(folder) = &self.out {
                keep::keep(&problem, &rows, folder)?;
            }
        }
        Ok(())
    }

    fn given(&self, scene: &str) -> Result<Given, Failure> {
        let given = Given::named(scene, self.until).map_err(in_words)?;
        if self.set.is_empty() && self.start.is_empty() {
            return Ok(given);
        }
        let Ok(entry) = find(scene) else {
            return Err(Failure::input_with_help(
                format!("the scene `{scene}` has values of its own"),
                "give --set and --start with a model from `residua list`",
            ));
        };
        let model = entry.catalogued;
        let (parameters, start) = assigned(model, &self.set, &self.start)?;
        let case = Case {
            model,
            parameters,
            start,
        };
        Ok(Given::of_case(case, self.until))
    }

    fn refuse_invalid(&self) -> Result<(), Failure> {
        let positive = |what: &str, value: f64| match value.is_finite() && value > 0.0 {
            true => Ok(()),
            false => Err(Failure::input(format!(
                "the {what} is {value}, not a positive number"
            ))),
        };
        positive("time limit", self.limit)?;
        if let Some(until) = self.until {
            positive("end time", until)?;
        }
        let (from, to) = self.tolerance;
        if from >= 1.0 || to < FINEST {
            let message =
                format!("tolerances go from below 1 to {FINEST:e}, not from {from} to {to}");
            return Err(Failure::input(message));
        }
        Ok(())
    }

    fn measure(&self, problem: &Problem) -> Result<Vec<Row>, Failure> {
        let (coarse, fine) = STEPS;
        let default = (problem.until * coarse, problem.until * fine);
        let ladders = Ladders {
            steps: self.step.unwrap_or(default),
            tolerances: self.tolerance,
        };
        let mut all = contestants(problem, &ladders);
        self.refuse_unknown(&all)?;
        let takes_part = |of: &Contestant<'_>| {
            self.schemes.is_empty() || self.schemes.contains(&of.scheme.to_lowercase())
        };
        all.retain(|of| takes_part(of) && !of.rungs.is_empty());
        if all.is_empty() {
            let (from, to) = ladders.steps;
            let message = format!(
                "no T/2ᵏ of T = {} is between {from} and {to}",
                problem.until
            );
            return Err(Failure::input(message));
        }
        let budget = Budget {
            runs: self.runs as usize,
            together: TOGETHER,
            longest: self.limit,
        };
        let bar = self.bar(&problem.name);
        let rows = measure(problem, &all, &budget, &mut |done, of| {
            bar.set_length(of as u64);
            bar.set_position(done as u64);
        });
        bar.finish_and_clear();
        Ok(rows)
    }

    fn refuse_unknown(&self, all: &[Contestant<'_>]) -> Result<(), Failure> {
        let mut known: Vec<String> = all.iter().map(|of| of.scheme.to_lowercase()).collect();
        known.sort_unstable();
        known.dedup();
        match self.schemes.iter().find(|scheme| !known.contains(scheme)) {
            Some(scheme) => Err(Failure::input_with_help(
                format!("no formulation has a scheme `{scheme}`"),
                format!("there are {}", known.join(", ")),
            )),
            None => Ok(()),
        }
    }

    /// Drawn on stderr, and only on a terminal.
    fn bar(&self, scene: &str) -> ProgressBar {
        if self.quiet {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template("{prefix} {bar:40} {percent:>3} % {eta} left");
        let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
        ProgressBar::new(1)
            .with_style(style)
            .with_prefix(scene.to_owned())
    }
}

fn in_words(unsolvable: Unsolvable) -> Failure {
    let message = unsolvable.to_string();
    match unsolvable {
        Unsolvable::UnknownScene(unknown) => match unknown.nearest {
            Some(nearest) => {
                Failure::input_with_help(message, format!("did you mean `{nearest}`?"))
            }
            None => Failure::input_with_help(message, "`residua list` names all models and scenes"),
        },
        Unsolvable::UnknownModel(unknown) => Failure::from(unknown),
        Unsolvable::WithoutFlow(_) => {
            Failure::input_with_help(message, "give its model file a `flow { … }`")
        }
        _ => Failure::input(message),
    }
}
