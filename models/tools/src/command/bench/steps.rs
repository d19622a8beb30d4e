//! `residua bench steps`: what a step costs.

use crate::failure::Failure;
use crate::table::Table;
use clap::Args;
use rayon::{ThreadPool, ThreadPoolBuilder};
use residua::erased::{AnySolver, Run};
use residua::{Catalogued, Fleet, Settings, Strategy};
use residua_models::values;
use residua_models::{SCENES, find};
use residua_tools::race::{Lane, Unfair, race};
use std::ops::ControlFlow;
use std::sync::Mutex;

/// Trajectories of an ensemble: some groups.
const TRAJECTORIES: usize = 128;

/// How far the start of each is from that of the one before, relative: not the same, and not another motion.
const APART: f64 = 1e-6;

/// Largest difference of end states, relative to the largest component: nobody wins by doing less.
const AGREEMENT: f64 = 1e-6;

/// Time a step of models and scenes: with all unknowns, with the core, and in an ensemble on one thread. For rivals see
/// `cargo bench -p residua-tests`
#[derive(Args)]
pub struct Steps {
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

impl Steps {
    /// Times them.
    pub fn run(self) -> Result<(), Failure> {
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
        let steps = self.steps as f64;
        let mut lanes = [
            Lane::new("all unknowns", steps, alone(Strategy::Full)),
            Lane::new("core", steps, alone(Strategy::Core)),
            Lane::new("ensemble", steps * TRAJECTORIES as f64, || {
                one.install(|| self.together(solver, &parameters, &start))
            }),
        ];
        let name = model.description.name;
        let paces = race(&mut lanes, AGREEMENT, self.rounds).map_err(|unfair| match unfair {
            Unfair::Failed(failure) => failure,
            Unfair::Differs(lane) => {
                let lanes = ["all unknowns", "core", "ensemble"];
                let [first, lane] = [lanes[0], lanes[lane]];
                Failure::Run(format!("{name}: {lane} and {first} end differently"))
            }
        })?;
        for pace in &paces {
            let [low, median, high] = [pace.low, pace.median, pace.high].map(|time| time * 1e9);
            table.row([
                name.to_owned(),
                solver.solver().form.to_owned(),
                pace.name.clone(),
                format!("{:.2}", paces[0].median / pace.median),
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
