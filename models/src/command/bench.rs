//! `residua bench`: what a step costs.

use crate::failure::Failure;
use crate::table::Table;
use crate::values;
use clap::{Args, Subcommand};
use rayon::{ThreadPool, ThreadPoolBuilder};
use residua::erased::{AnySolver, Run};
use residua::{Catalogued, Fleet, Settings, Strategy};
use residua_models::{SCENES, find};
use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

/// Trajectories of an ensemble: some groups.
const TRAJECTORIES: usize = 128;

/// How far the start of each is from that of the one before, relative: not the same, and not another motion.
const APART: f64 = 1e-6;

/// Largest difference of end states, relative to the largest component: nobody wins by doing less.
const AGREEMENT: f64 = 1e-6;

/// Time what Residua does
#[derive(Args)]
pub struct Bench {
    #[command(subcommand)]
    what: What,
}

#[derive(Subcommand)]
enum What {
    Steps(Steps),
}

/// Time a step of models and scenes: with all unknowns, with the core, and in an ensemble on one thread. For rivals see
/// `cargo bench -p residua-tests`
#[derive(Args)]
struct Steps {
    /// Models and scenes from `residua list` [default: all scenes]
    names: Vec<String>,
    /// Time step h
    #[arg(long, value_name = "H", default_value_t = 0.01)]
    step: f64,
    /// Steps per run
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u64).range(1..))]
    steps: u64,
    /// Runs of each kind, in turns; the medians are shown
    #[arg(long, value_name = "N", default_value_t = 21, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: u64,
}

impl Bench {
    /// Times them.
    pub fn run(self) -> Result<(), Failure> {
        let What::Steps(steps) = self.what;
        steps.run()
    }
}

/// One way to make the runs.
struct Lane<'a> {
    name: &'static str,
    /// Makes them and returns the end state of the first.
    run: Box<dyn Fn() -> Result<Vec<f64>, Failure> + 'a>,
    runs: usize,
    seconds: Vec<f64>,
}

impl Steps {
    fn run(self) -> Result<(), Failure> {
        if !(self.step.is_finite() && self.step > 0.0) {
            let message = format!("the step is {}, not a positive number", self.step);
            return Err(Failure::input(message));
        }
        let named = self.names.iter().map(|name| Ok(find(name)?.catalogued));
        let mut models = named.collect::<Result<Vec<_>, Failure>>()?;
        if models.is_empty() {
            models.extend(SCENES.iter().map(|scene| scene.catalogued));
        }
        let one = ThreadPoolBuilder::new().num_threads(1).build();
        let one = one.map_err(|error| Failure::Run(format!("cannot start a thread: {error}")))?;
        let mut table = Table::new(&["", "form", "", "times faster", "ns a step", "quartiles"]);
        for model in models {
            for solver in model.solvers {
                self.race(model, *solver, &one, &mut table)?;
            }
        }
        print!("{table}");
        Ok(())
    }

    fn race(
        &self,
        model: &'static Catalogued,
        solver: &'static dyn AnySolver,
        one: &ThreadPool,
        table: &mut Table,
    ) -> Result<(), Failure> {
        let parameters = values::defaults(model);
        let start = values::start(model, &parameters);
        let alone = |strategy| {
            let (parameters, start) = (&parameters, &start);
            move || self.alone(solver, parameters, start, strategy)
        };
        let mut lanes = [
            Lane::new("all unknowns", 1, alone(Strategy::Full)),
            Lane::new("core", 1, alone(Strategy::Core)),
            Lane::new("ensemble", TRAJECTORIES, || {
                one.install(|| self.together(solver, &parameters, &start))
            }),
        ];
        let first = (lanes[0].run)()?;
        let size = first.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        for lane in &lanes {
            let end = (lane.run)()?;
            // Written so that a NaN fails.
            let agrees = |(a, b): (&f64, &f64)| (a - b).abs() <= AGREEMENT * size;
            if !first.iter().zip(&end).all(agrees) {
                let (name, lane) = (model.description.name, lane.name);
                let message = format!("{name}: {lane} and {} end differently", lanes[0].name);
                return Err(Failure::Run(message));
            }
        }
        for _ in 0..self.rounds {
            lanes.iter_mut().try_for_each(Lane::time)?;
        }
        let slowest = lanes[0].quantile(0.5, self.steps);
        for lane in &lanes {
            let [low, median, high] = [0.25, 0.5, 0.75].map(|q| lane.quantile(q, self.steps));
            table.row([
                model.description.name.to_owned(),
                solver.solver().form.to_owned(),
                lane.name.to_owned(),
                format!("{:.2}", slowest / median),
                format!("{median:.1}"),
                format!("{low:.1} to {high:.1}"),
            ]);
        }
        Ok(())
    }

    fn alone(
        &self,
        solver: &dyn AnySolver,
        parameters: &[f64],
        start: &[f64],
        strategy: Strategy,
    ) -> Result<Vec<f64>, Failure> {
        let settings = Settings {
            strategy,
            ..Settings::default()
        };
        let run = Run {
            parameters,
            start,
            h: self.step,
            t0: 0.0,
            steps: self.steps,
            every: 0,
            settings,
        };
        let mut end = Vec::new();
        let outcome = solver.simulate(&run, &mut |sample| {
            end = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        outcome.map_err(|error| Failure::Run(error.to_string()))?;
        Ok(end)
    }

    fn together(
        &self,
        solver: &dyn AnySolver,
        parameters: &[f64],
        start: &[f64],
    ) -> Result<Vec<f64>, Failure> {
        let end = Mutex::new(Vec::new());
        let fill = |trajectory: usize, own: &mut [f64], state: &mut [f64]| {
            own.copy_from_slice(parameters);
            for (x, start) in state.iter_mut().zip(start) {
                *x = start * (1.0 + APART * trajectory as f64);
            }
        };
        let observer = |trajectory: usize, sample: residua::erased::Sample<'_>| {
            if trajectory == 0 {
                *end.lock().unwrap_or_else(|e| e.into_inner()) = sample.state.to_vec();
            }
        };
        let fleet = Fleet {
            trajectories: 0..TRAJECTORIES,
            fill: &fill,
            h: self.step,
            t0: 0.0,
            steps: self.steps,
            every: 0,
            settings: Settings::default(),
            observer: &observer,
        };
        let outcomes = solver.fly(&fleet);
        let outcomes = outcomes.map_err(|error| Failure::input(error.to_string()))?;
        match outcomes.iter().find_map(|outcome| outcome.error) {
            Some(error) => Err(Failure::Run(error.to_string())),
            None => Ok(end.into_inner().unwrap_or_else(|e| e.into_inner())),
        }
    }
}

impl<'a> Lane<'a> {
    fn new(
        name: &'static str,
        runs: usize,
        run: impl Fn() -> Result<Vec<f64>, Failure> + 'a,
    ) -> Self {
        Self {
            name,
            run: Box::new(run),
            runs,
            seconds: Vec::new(),
        }
    }

    fn time(&mut self) -> Result<(), Failure> {
        let clock = Instant::now();
        std::hint::black_box((self.run)()?);
        self.seconds.push(clock.elapsed().as_secs_f64());
        Ok(())
    }

    /// The `share`-th part of the sorted times, ns per step of one run.
    fn quantile(&self, share: f64, steps: u64) -> f64 {
        let mut sorted = self.seconds.clone();
        sorted.sort_by(f64::total_cmp);
        let at = (share * (sorted.len() - 1) as f64).round() as usize;
        sorted[at] / (self.runs as f64 * steps as f64) * 1e9
    }
}
