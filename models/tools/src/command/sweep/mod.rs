//! `residua sweep`: many trajectories of a model, over a grid of parameters and start values.

mod grid;
mod over;
mod table;

use crate::failure::Failure;
use crate::motion::{Motion, Span};
use crate::output::{create, is_stdout};
use crate::requirements::Unmet;
use clap::Args;
use grid::Grid;
use indicatif::{ProgressBar, ProgressStyle};
use over::{Over, axes};
use residua::erased::{AnySolver, Sample};
use residua::{Fleet, Outcome, Settings, WIDTH};
use std::io::{self, BufWriter, Write};
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;
use table::{Finished, Shelf, Table};

/// More rows than this are taken for a mistake: the file would have tens of gigabytes.
const MAX_ROWS: f64 = 1e8;

/// Rows that are kept before they are written, in trajectories of one group at least.
const KEPT_ROWS: u64 = 1 << 16;

/// More threads than this are taken for a mistake: starting them takes longer than what they do.
const MOST_THREADS: i64 = 512;

/// Run a model for every combination of some parameters and start values
#[derive(Args)]
pub struct Sweep {
    /// What to vary: `--over m=1..3:100` for 100 masses from 1 to 3, `--over start.ω.x=-1..1:50` for a
    /// start value; of several, all combinations
    #[arg(long, value_name = "NAME=FROM..TO:COUNT", value_parser = over::parse, required = true)]
    over: Vec<Over>,
    #[command(flatten)]
    motion: Motion,
    /// Keep the start, every N-th step and the end [default: the end only]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    every: Option<u64>,
    /// Threads to run on [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=MOST_THREADS))]
    threads: Option<u16>,
    /// File for the rows, as CSV [default: standard output]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Do not print the summary
    #[arg(long, short)]
    quiet: bool,
}

impl Sweep {
    /// Runs the trajectories.
    pub fn run(self) -> Result<(), Failure> {
        let model = self.motion.entry()?.catalogued;
        let Span { step, steps, note } = self.motion.span(model)?;
        let solver = self.motion.solver(model)?;
        let parameters = self.motion.parameters(model)?;
        let axes = axes(&self.over, model.description, &parameters)?;
        let grid = Grid::new(model, axes, parameters, &self.motion.start)?;
        let per_trajectory = self.every.map_or(1, |every| steps.div_ceil(every) + 1);
        let count = self.count(&grid, per_trajectory)?;
        if let Some(note) = note.filter(|_| !self.quiet) {
            tell!("note: {note}");
        }
        let threads = rayon::ThreadPoolBuilder::new()
            .num_threads(self.threads.map_or(0, usize::from))
            .build()
            .map_err(|error| Failure::Run(format!("cannot start threads: {error}")))?;
        let mut table = Table::new(&grid, step, self.destination()?)?;
        let clock = Instant::now();
        let progress = self.bar(count);
        let groups = (KEPT_ROWS / per_trajectory) as usize / WIDTH;
        let chunk = WIDTH * groups.max(threads.current_num_threads());
        let mut failed = Failed::default();
        let mut unmet = Unmet::new(model);
        for first in (0..count).step_by(chunk) {
            let trajectories = first..count.min(first + chunk);
            for trajectory in trajectories.clone() {
                unmet.take(model, || grid.data(trajectory), step);
            }
            let shelf = Shelf::new(first, trajectories.len());
            let fly = || self.fly(&grid, solver, (step, steps), trajectories, &shelf);
            let outcomes = threads.install(fly)?;
            failed.take(&outcomes);
            progress.inc(outcomes.len() as u64);
            table.write(shelf, &outcomes)?;
        }
        progress.finish_and_clear();
        let Finished { rows, holes } = table.finish()?;
        if !self.quiet {
            let elapsed = clock.elapsed();
            tell!("{count} trajectories of {steps} steps in {elapsed:.1?}");
            if let Some(path) = self.out.as_deref().filter(|path| !is_stdout(path)) {
                tell!("{} ({rows} rows)", path.display());
            }
        }
        if !self.quiet {
            unmet.warn(model, count);
        }
        if holes > 0 {
            tell!("warning: {holes} outputs have no value");
        }
        failed.report(count)
    }

    /// The number of trajectories, if that many rows can be meant.
    fn count(&self, grid: &Grid<'_>, per_trajectory: u64) -> Result<usize, Failure> {
        let sizes = grid.axes.iter().map(|axis| axis.count as f64);
        let rows = sizes.product::<f64>() * per_trajectory as f64;
        match grid.len() {
            Some(count) if rows <= MAX_ROWS => Ok(count),
            _ => {
                let factors: Vec<_> = self.over.iter().map(ToString::to_string).collect();
                Err(Failure::input(format!(
                    "`{}` makes {rows:.1e} rows, more than {MAX_ROWS:e}",
                    factors.join(" ")
                )))
            }
        }
    }

    fn destination(&self) -> Result<Box<dyn Write>, Failure> {
        match &self.out {
            Some(path) if !is_stdout(path) => Ok(Box::new(BufWriter::new(create(path)?))),
            _ => Ok(Box::new(BufWriter::new(io::stdout()))),
        }
    }

    fn fly(
        &self,
        grid: &Grid<'_>,
        solver: &dyn AnySolver,
        (h, steps): (f64, u64),
        trajectories: Range<usize>,
        shelf: &Shelf,
    ) -> Result<Vec<Outcome>, Failure> {
        let fill = |i: usize, parameters: &mut [f64], state: &mut [f64]| {
            grid.fill(i, parameters, state);
        };
        let observer = |trajectory: usize, sample: Sample<'_>| shelf.put(trajectory, &sample);
        let fleet = Fleet {
            trajectories,
            fill: &fill,
            h,
            t0: 0.0,
            steps,
            every: self.every.unwrap_or(0),
            settings: Settings::default(),
            observer: &observer,
        };
        let outcomes = solver.fly(&fleet);
        outcomes.map_err(|error| Failure::input(error.to_string()))
    }

    /// Drawn on stderr, and only on a terminal.
    fn bar(&self, count: usize) -> ProgressBar {
        if self.quiet {
            return ProgressBar::hidden();
        }
        let style = ProgressStyle::with_template("{bar:40} {percent:>3} % {eta} left");
        let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
        ProgressBar::new(count as u64).with_style(style)
    }
}

/// Trajectories that did not reach their end.
#[derive(Default)]
struct Failed {
    count: usize,
    first: Option<String>,
}

impl Failed {
    fn take(&mut self, outcomes: &[Outcome]) {
        for error in outcomes.iter().filter_map(|outcome| outcome.error) {
            self.count += 1;
            self.first.get_or_insert_with(|| error.to_string());
        }
    }

    fn report(self, of: usize) -> Result<(), Failure> {
        match self.first {
            None => Ok(()),
            Some(first) => Err(Failure::Run(format!(
                "{} of {of} trajectories failed, the first at {first}",
                self.count
            ))),
        }
    }
}
