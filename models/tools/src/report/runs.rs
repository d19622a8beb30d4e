//! The runs behind the figures: each is made once, whoever asks for it.

use super::reference::reference;
use crate::columns::header;
use crate::columns::ordered_outputs;
use indicatif::ProgressBar;
use residua::Catalogued;
use residua::Settings;
use residua::erased::Run;
use residua::erased::Sample;
use residua::erased::Scheme;
use residua_models::UnknownModel;
use residua_models::exact::Invalid;
use residua_models::find;
use residua_models::values;
use residua_models::values::total;
use std::fmt;
use std::ops::ControlFlow;
use std::thread;

/// A run of a model file with its own parameters and start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Stem of the model file.
    pub model: &'static str,
    /// What advances the state.
    pub method: Method,
    /// h, s.
    pub step: f64,
    /// End, s.
    pub until: f64,
}

/// What advances the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Newton on the discrete equations, in the form of this name.
    Newton(&'static str),
    /// Runge–Kutta 4 on the continuous ones.
    RungeKutta4,
}

/// What a run left: a row for each step.
pub struct Recording {
    /// Names of the columns: states, observables, invariants.
    pub columns: Vec<String>,
    /// s
    pub times: Vec<f64>,
    /// One per time.
    pub rows: Vec<Vec<f64>>,
    /// Newton iterations per step, 0 for explicit methods.
    pub iterations: f64,
    /// Why the run ended early, if it did.
    pub failure: Option<String>,
}

/// A run that cannot even start.
#[derive(Debug)]
pub enum RunError {
    /// There is no such model.
    Model(UnknownModel),
    /// The model has no such discrete equations.
    Form(Wanted),
    /// The model has no continuous equations.
    Flow(Wanted),
    /// There is no exact motion.
    Exact(Invalid),
    /// The recording has no such column.
    Column(String),
    /// The claims of a model could not be judged.
    Claims(String),
    /// A motion has no exact end to measure errors by.
    Precision(String),
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Model(unknown) => unknown.fmt(f),
            Self::Form(wanted) => write!(f, "`{}` has no {:?}", wanted.model, wanted.method),
            Self::Flow(wanted) => write!(f, "`{}` has no continuous equations", wanted.model),
            Self::Exact(invalid) => invalid.fmt(f),
            Self::Column(name) => write!(f, "no quantity `{name}` was recorded"),
            Self::Claims(why) | Self::Precision(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for RunError {}

impl From<UnknownModel> for RunError {
    fn from(unknown: UnknownModel) -> Self {
        Self::Model(unknown)
    }
}

impl From<Invalid> for RunError {
    fn from(invalid: Invalid) -> Self {
        Self::Exact(invalid)
    }
}

impl Wanted {
    /// Steps to its end.
    pub fn steps(&self) -> u64 {
        (self.until / self.step).round() as u64
    }

    /// A run of the same motion at the same times, the same for all models of a scene.
    fn scene(&self) -> Self {
        Self {
            model: match self.is_planar() {
                true => "planar_angle",
                false => "spatial_group",
            },
            method: Method::RungeKutta4,
            ..*self
        }
    }

    /// It moves in the plane.
    pub fn is_planar(&self) -> bool {
        self.model.starts_with("planar")
    }

    /// Makes the run.
    pub fn record(&self) -> Result<Recording, RunError> {
        let model = find(self.model)?.catalogued;
        self.record_from(&values::start(model, &values::defaults(model)))
    }

    /// Makes the run from another state.
    pub fn record_from(&self, start: &[f64]) -> Result<Recording, RunError> {
        let model = find(self.model)?.catalogued;
        let parameters = values::defaults(model);
        let run = Run {
            parameters: &parameters,
            start,
            h: self.step,
            t0: 0.0,
            steps: self.steps(),
            every: 1,
            settings: Settings::default(),
        };
        let mut recording = Recording::new(model, self.steps());
        let mut rows = Rows::new(model, &parameters, self.step);
        let mut observer = |sample: Sample<'_>| {
            recording.times.push(sample.t);
            recording.rows.push(rows.row(&sample));
            ControlFlow::Continue(())
        };
        let outcome = match self.method {
            Method::Newton(form) => {
                let solvers = model.solvers.iter();
                let solver = solvers.copied().find(|s| s.solver().form == form);
                let solver = solver.ok_or(RunError::Form(*self))?;
                solver.simulate(&run, &mut observer)
            }
            Method::RungeKutta4 => {
                let flow = model.flow.ok_or(RunError::Flow(*self))?;
                flow.simulate(Scheme::RungeKutta4, &run, &mut observer)
            }
        };
        match outcome {
            Ok(statistics) => {
                recording.iterations =
                    statistics.iterations as f64 / statistics.steps.max(1) as f64;
            }
            Err(error) => recording.failure = Some(error.to_string()),
        }
        Ok(recording)
    }
}

impl Recording {
    fn new(model: &Catalogued, steps: u64) -> Self {
        let columns = header(model.description);
        Self {
            // The time has a list of its own.
            columns: columns.into_iter().skip(1).collect(),
            times: Vec::with_capacity(steps as usize + 1),
            rows: Vec::with_capacity(steps as usize + 1),
            iterations: 0.0,
            failure: None,
        }
    }

    /// The values of a quantity.
    pub fn values(&self, quantity: &str) -> Result<Vec<f64>, RunError> {
        let position = self.columns.iter().position(|column| column == quantity);
        let i = position.ok_or_else(|| RunError::Column(quantity.to_owned()))?;
        Ok(self.rows.iter().map(|row| row[i]).collect())
    }
}

/// From states to rows.
struct Rows<'a> {
    model: &'a Catalogued,
    parameters: &'a [f64],
    step: f64,
    outputs: Vec<f64>,
    /// For each output column of a row, its position in `outputs`.
    order: Vec<usize>,
}

impl<'a> Rows<'a> {
    fn new(model: &'a Catalogued, parameters: &'a [f64], step: f64) -> Self {
        let placed = ordered_outputs(model.description);
        let range = |offset: usize, n: usize| offset..offset + n;
        let order: Vec<usize> = placed
            .iter()
            .flat_map(|output| range(output.offset, total([output.variable])))
            .collect();
        Self {
            model,
            parameters,
            step,
            outputs: vec![0.0; order.len()],
            order,
        }
    }

    fn row(&mut self, sample: &Sample<'_>) -> Vec<f64> {
        let Sample { t, state, .. } = *sample;
        let model = self.model.model;
        model.outputs(self.parameters, self.step, t, state, &mut self.outputs);
        let outputs = self.order.iter().map(|&i| self.outputs[i]);
        state.iter().copied().chain(outputs).collect()
    }
}

/// Runs that have been made, and the exact solutions at their times.
pub struct Runs {
    made: Vec<(Wanted, Recording)>,
    /// By scene and times, which many runs share.
    exact: Vec<(Wanted, Recording)>,
}

impl Runs {
    /// Makes the runs, each once, on two threads, and moves the bar by one for each.
    pub fn make(wanted: &[Wanted], progress: &ProgressBar) -> Result<Self, RunError> {
        let runs = distinct(wanted.iter().copied());
        let references = distinct(runs.iter().map(Wanted::scene));
        progress.inc_length((runs.len() + references.len()) as u64);
        Ok(Self {
            made: all(&runs, Wanted::record, progress)?,
            exact: all(&references, reference, progress)?,
        })
    }

    /// The recording of a run, which must be one of those made.
    pub fn get(&self, wanted: &Wanted) -> &Recording {
        found(&self.made, wanted)
    }

    /// The exact solution at the times of a run, which must be one of those made.
    pub fn exact(&self, wanted: &Wanted) -> &Recording {
        found(&self.exact, &wanted.scene())
    }
}

fn found<'r>(recordings: &'r [(Wanted, Recording)], wanted: &Wanted) -> &'r Recording {
    let found = recordings.iter().find(|(run, _)| run == wanted);
    &found.expect("the run is in the list of runs to make").1
}

fn distinct(wanted: impl Iterator<Item = Wanted>) -> Vec<Wanted> {
    let mut distinct = Vec::new();
    for run in wanted {
        if !distinct.contains(&run) {
            distinct.push(run);
        }
    }
    distinct
}

/// Threads that runs are shared among: the report is to be quick on a machine with two cores.
const THREADS: usize = 2;

fn all(
    runs: &[Wanted],
    record: impl Fn(&Wanted) -> Result<Recording, RunError> + Sync,
    progress: &ProgressBar,
) -> Result<Vec<(Wanted, Recording)>, RunError> {
    let share = |offset: usize| {
        let own = runs.iter().skip(offset).step_by(THREADS);
        let recorded = own.map(|run| {
            let recording = record(run)?;
            progress.inc(1);
            Ok((*run, recording))
        });
        recorded.collect::<Result<Vec<_>, RunError>>()
    };
    let shares: Vec<_> = thread::scope(|scope| {
        let share = &share;
        let started: Vec<_> = (0..THREADS)
            .map(|offset| scope.spawn(move || share(offset)))
            .collect();
        let joined = started.into_iter().map(|thread| thread.join());
        // A panic in a thread is a bug, and goes on as one.
        joined
            .map(|outcome| outcome.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    let mut recorded = Vec::new();
    for share in shares {
        recorded.extend(share?);
    }
    Ok(recorded)
}
