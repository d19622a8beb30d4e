//! A run that is watched.

use super::case::Case;
use super::distance::largest_difference;
use super::method::Method;
use residua::RunError;
use residua::Statistics;
use residua::erased::Sample;
use residua_models::values::size;
use std::ops::ControlFlow;
use std::time::Instant;

/// Runs of which the fastest counts.
const TIMED_RUNS: usize = 3;

/// What an invariant does in a run.
#[derive(Clone, Debug)]
pub struct Watched {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Largest |I − I₀|.
    pub largest: f64,
    /// What the straight line through I − I₀ (for several components, through the largest |I − I₀|), fitted by
    /// least squares, changes by from start to end.
    pub trend: f64,
}

/// The course of a run.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The flat state at the end.
    pub end: Vec<f64>,
    /// What it cost.
    pub statistics: Statistics,
    /// In file order.
    pub invariants: Vec<Watched>,
}

impl Trial {
    /// Runs `case` and watches its invariants at every step.
    ///
    /// # Errors
    /// Where a step fails.
    pub fn new(case: &Case, method: Method, h: f64, steps: u64) -> Result<Self, RunError> {
        let mut end = Vec::new();
        let mut first: Vec<f64> = Vec::new();
        let mut lines: Vec<Line> = Vec::new();
        let outputs = case.model.description.outputs;
        let statistics = method.simulate(&case.run(h, steps), &mut |sample: Sample<'_>| {
            let values = case.outputs(h, sample.t, sample.state);
            if first.is_empty() {
                first.clone_from(&values);
                lines = vec![Line::default(); outputs.len()];
            }
            let mut offset = 0;
            for (output, line) in outputs.iter().zip(&mut lines) {
                let n = size(&output.variable);
                let own = offset..offset + n;
                offset += n;
                let drift = match n {
                    1 => values[own.start] - first[own.start],
                    _ => largest_difference(&values[own.clone()], &first[own]),
                };
                line.push(sample.t, drift);
            }
            if sample.step == steps {
                end = sample.state.to_vec();
            }
            ControlFlow::Continue(())
        })?;
        let invariants = outputs.iter().zip(lines).filter(|(o, _)| o.invariant);
        let invariants = invariants.map(|(output, line)| Watched {
            name: output.variable.name,
            unit: output.variable.unit,
            largest: line.largest,
            trend: line.rise(),
        });
        Ok(Self {
            end,
            statistics,
            invariants: invariants.collect(),
        })
    }

    /// Seconds per step, the fastest of a few runs that show nothing.
    ///
    /// # Errors
    /// Where a step fails.
    pub fn time(case: &Case, method: Method, h: f64, steps: u64) -> Result<f64, RunError> {
        let mut run = case.run(h, steps);
        run.every = 0;
        let mut fastest = f64::INFINITY;
        for _ in 0..TIMED_RUNS {
            let begin = Instant::now();
            method.simulate(&run, &mut |_| ControlFlow::Continue(()))?;
            fastest = fastest.min(begin.elapsed().as_secs_f64());
        }
        Ok(fastest / steps as f64)
    }
}

/// Sums for a straight line through (t, y).
#[derive(Clone, Copy, Default)]
struct Line {
    largest: f64,
    n: f64,
    t: f64,
    y: f64,
    tt: f64,
    ty: f64,
    last: f64,
}

impl Line {
    fn push(&mut self, t: f64, y: f64) {
        self.largest = match y.is_nan() {
            true => f64::INFINITY,
            false => self.largest.max(y.abs()),
        };
        self.n += 1.0;
        self.t += t;
        self.y += y;
        self.tt += t * t;
        self.ty += t * y;
        self.last = t;
    }

    /// Slope times length.
    fn rise(&self) -> f64 {
        let spread = self.n * self.tt - self.t * self.t;
        let slope = (self.n * self.ty - self.t * self.y) / spread;
        slope * self.last
    }
}
