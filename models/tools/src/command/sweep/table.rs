//! The rows of a sweep: swept values, time, states, outputs, iterations, status.

use super::grid::Grid;
use residua::Outcome;
use residua::erased::Sample;
use residua_models::values::{size, total};
use residua_tools::columns::{header, kept_states, ordered_outputs};
use std::io::{self, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What a trajectory that reached its end has for a status.
const REACHED: &str = "ok";

/// One shown state.
struct Shown {
    step: u64,
    t: f64,
    iterations: u64,
    state: Vec<f64>,
}

/// The states of some trajectories, as they come.
pub struct Shelf {
    first: usize,
    rows: Vec<Mutex<Vec<Shown>>>,
}

impl Shelf {
    /// For trajectories from `first` on.
    pub fn new(first: usize, count: usize) -> Self {
        Self {
            first,
            rows: (0..count).map(|_| Mutex::default()).collect(),
        }
    }

    /// Takes in a state.
    pub fn put(&self, trajectory: usize, sample: &Sample<'_>) {
        let mut rows = lock(&self.rows[trajectory - self.first]);
        // The state before a step that failed may have been shown already.
        if rows.last().is_some_and(|last| last.step == sample.step) {
            return;
        }
        rows.push(Shown {
            step: sample.step,
            t: sample.t,
            iterations: sample.statistics.iterations,
            state: sample.state.to_vec(),
        });
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The CSV file.
pub struct Table<'a> {
    grid: &'a Grid<'a>,
    h: f64,
    out: csv::Writer<Box<dyn Write>>,
    /// For each state column, its position in the flat state.
    states: Vec<usize>,
    /// For each output column, its position in the flat outputs.
    order: Vec<usize>,
    n_states: usize,
    finished: Finished,
}

/// What has been written.
#[derive(Default)]
pub struct Finished {
    /// Rows.
    pub rows: u64,
    /// Outputs without a value among them.
    pub holes: u64,
}

impl<'a> Table<'a> {
    /// Writes the header.
    pub fn new(grid: &'a Grid<'a>, h: f64, out: Box<dyn Write>) -> io::Result<Self> {
        let description = grid.model.description;
        let placed = ordered_outputs(description);
        let range = |p: &residua_tools::columns::Placed| p.offset..p.offset + total([p.variable]);
        let mut out = csv::Writer::from_writer(out);
        let swept = grid.axes.iter().map(|axis| axis.name.clone());
        let last = ["iterations", "status"].map(str::to_owned);
        out.write_record(swept.chain(header(description)).chain(last))?;
        Ok(Self {
            grid,
            h,
            out,
            states: kept_states(description)
                .flat_map(|(at, state)| at..at + size(state))
                .collect(),
            order: placed.iter().flat_map(range).collect(),
            n_states: total(description.states),
            finished: Finished::default(),
        })
    }

    /// Writes the rows of some trajectories.
    pub fn write(&mut self, shelf: Shelf, outcomes: &[Outcome]) -> io::Result<()> {
        let first = shelf.first;
        for (i, (rows, outcome)) in shelf.rows.into_iter().zip(outcomes).enumerate() {
            let rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
            self.trajectory(first + i, &rows, outcome)?;
        }
        Ok(())
    }

    fn trajectory(&mut self, number: usize, rows: &[Shown], outcome: &Outcome) -> io::Result<()> {
        let point = self.grid.point(number);
        let mut parameters = vec![0.0; self.grid.parameters.len()];
        let mut state = vec![0.0; self.n_states];
        self.grid.fill(number, &mut parameters, &mut state);
        let status = outcome
            .error
            .map_or(REACHED.to_owned(), |error| error.to_string());
        let mut outputs = vec![0.0; self.order.len()];
        for (i, shown) in rows.iter().enumerate() {
            let model = self.grid.model.model;
            model.outputs(&parameters, self.h, shown.t, &shown.state, &mut outputs);
            let holes = outputs.iter().filter(|output| !output.is_finite());
            self.finished.holes += holes.count() as u64;
            let outputs = self.order.iter().map(|&i| outputs[i]);
            let states = self.states.iter().map(|&i| shown.state[i]);
            let numbers = point.iter().copied().chain([shown.t]);
            let numbers = numbers.chain(states).chain(outputs);
            let status = if i + 1 < rows.len() { REACHED } else { &status };
            let last = [shown.iterations.to_string(), status.to_owned()];
            self.out
                .write_record(numbers.map(|x| format!("{x:?}")).chain(last))?;
        }
        if rows.is_empty() {
            // It did not start.
            let nothing = vec![String::new(); 1 + self.states.len() + self.order.len()];
            let numbers = point.iter().map(|x| format!("{x:?}")).chain(nothing);
            self.out
                .write_record(numbers.chain(["0".to_owned(), status]))?;
        }
        self.finished.rows += rows.len().max(1) as u64;
        Ok(())
    }

    /// Passes on what is still buffered.
    pub fn finish(mut self) -> io::Result<Finished> {
        self.out.flush()?;
        Ok(self.finished)
    }
}
