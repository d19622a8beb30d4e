//! What happens to each state that a run hands over.

use super::drift::Drift;
use super::plan::Plan;
use super::rows::Rows;
use super::trace::Trace;
use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use residua::Catalogued;
use residua::erased::Sample;
use residua_models::values::{size, total};
use residua_tools::columns::{kept_states, ordered_outputs};
use std::io;
use std::ops::ControlFlow;

/// Turns states into rows and passes them on.
pub struct Recorder {
    model: &'static Catalogued,
    parameters: Vec<f64>,
    step: f64,
    /// Flat, in file order.
    outputs: Vec<f64>,
    /// For each state column of a row, its position in the state.
    states: Vec<usize>,
    /// For each output column of a row, its position in `outputs`.
    order: Vec<usize>,
    /// States, then outputs in the order of the columns.
    row: Vec<f64>,
    rows: Option<Rows>,
    trace: Option<Trace>,
    drift: Drift,
    progress: ProgressBar,
    error: Option<io::Error>,
}

/// What is left of a run.
pub struct Recorded {
    /// Rows written, if any were to be.
    pub rows: Option<u64>,
    /// For the picture.
    pub trace: Option<Trace>,
    /// Of the invariants.
    pub drift: Drift,
}

impl Recorder {
    /// Writes to `rows`, `trace` and, if `progress_shown`, a bar on a terminal.
    pub fn new(
        model: &'static Catalogued,
        plan: &Plan,
        rows: Option<Rows>,
        trace: Option<Trace>,
        progress_shown: bool,
    ) -> Self {
        let placed = ordered_outputs(model.description);
        let range = |p: &residua_tools::columns::Placed| p.offset..p.offset + total([p.variable]);
        let order: Vec<usize> = placed.iter().flat_map(range).collect();
        let states = kept_states(model.description);
        let states: Vec<usize> = states.flat_map(|(at, s)| at..at + size(s)).collect();
        Self {
            model,
            parameters: plan.parameters.clone(),
            step: plan.step,
            outputs: vec![0.0; order.len()],
            row: Vec::with_capacity(states.len() + order.len()),
            order,
            rows,
            trace,
            drift: Drift::new(placed, states.len()),
            states,
            progress: if progress_shown {
                bar(plan.steps)
            } else {
                ProgressBar::hidden()
            },
            error: None,
        }
    }

    /// Takes in one state; stops the run if it cannot be written.
    pub fn take(&mut self, sample: &Sample<'_>) -> ControlFlow<()> {
        let (t, state) = (sample.t, sample.state);
        self.model
            .model
            .outputs(&self.parameters, self.step, t, state, &mut self.outputs);
        self.row.clear();
        self.row.extend(self.states.iter().map(|&i| state[i]));
        self.row.extend(self.order.iter().map(|&i| self.outputs[i]));
        self.drift.take(&self.row);
        if let Some(trace) = &mut self.trace {
            trace.push(t, &self.row);
        }
        self.progress.set_position(sample.step);
        match self.rows.as_mut().map(|rows| rows.push(t, &self.row)) {
            Some(Err(error)) => {
                self.error = Some(error);
                ControlFlow::Break(())
            }
            Some(Ok(())) | None => ControlFlow::Continue(()),
        }
    }

    /// Flushes the rows.
    pub fn finish(self) -> Result<Recorded, Failure> {
        self.progress.finish_and_clear();
        match self.error {
            Some(error) => Err(error.into()),
            None => Ok(Recorded {
                rows: self.rows.map(Rows::finish).transpose()?,
                trace: self.trace,
                drift: self.drift,
            }),
        }
    }
}

/// Drawn on stderr, and only on a terminal.
fn bar(steps: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} % {eta} left");
    ProgressBar::new(steps).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
