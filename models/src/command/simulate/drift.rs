//! How far the invariants of a run move from where they start.

use crate::columns::{Placed, size};
use crate::notation::{components, number, unit};
use std::fmt;

/// The drift of every invariant component.
pub struct Drift {
    invariants: Vec<Invariant>,
}

struct Invariant {
    name: String,
    unit: String,
    /// Position in the row.
    column: usize,
    start: Option<f64>,
    last: f64,
    largest: f64,
}

impl Drift {
    /// For rows of `n_states` states and then these outputs.
    pub fn new(outputs: Vec<Placed>, n_states: usize) -> Self {
        let mut invariants = Vec::new();
        let mut column = n_states;
        for output in outputs {
            if output.invariant {
                let named = components(output.variable).into_iter().enumerate();
                invariants.extend(named.map(|(i, name)| Invariant {
                    name,
                    unit: unit(output.variable.unit),
                    column: column + i,
                    start: None,
                    last: 0.0,
                    largest: 0.0,
                }));
            }
            column += size(output.variable);
        }
        Self { invariants }
    }

    /// Takes in one row.
    pub fn take(&mut self, row: &[f64]) {
        for invariant in &mut self.invariants {
            let value = row[invariant.column];
            let start = *invariant.start.get_or_insert(value);
            invariant.last = value - start;
            invariant.largest = invariant.largest.max(invariant.last.abs());
        }
    }
}

impl fmt::Display for Drift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Invariant {
            name,
            unit,
            start,
            last,
            largest,
            ..
        } in &self.invariants
        {
            let unit = if unit == "1" {
                String::new()
            } else {
                format!(" {unit}")
            };
            let start = number(start.unwrap_or_default());
            writeln!(
                f,
                "{name}: {start}{unit}, drift {last:.1e} at the end, {largest:.1e} at most",
            )?;
        }
        Ok(())
    }
}
