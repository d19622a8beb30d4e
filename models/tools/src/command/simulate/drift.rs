//! How far the invariants of a run move from where they start, and what has no value on the way.

use crate::notation::{number, unit};
use residua::description::Variable;
use residua_models::values::size;
use residua_tools::columns::Placed;
use std::fmt;
use std::ops::Range;

/// The drift of every invariant, and the outputs without a value.
pub struct Drift {
    invariants: Vec<Invariant>,
    outputs: Vec<Output>,
}

struct Output {
    name: &'static str,
    /// Its place in the row.
    own: Range<usize>,
    /// Rows in which it is infinite or NaN.
    holes: u64,
}

struct Invariant {
    variable: &'static Variable,
    /// Its place in the row.
    own: Range<usize>,
    start: Vec<f64>,
    last: f64,
    largest: f64,
}

impl Drift {
    /// For rows of `n_states` states and then these outputs.
    pub fn new(outputs: Vec<Placed>, n_states: usize) -> Self {
        let (mut invariants, mut listed) = (Vec::new(), Vec::new());
        let mut column = n_states;
        for Placed {
            variable,
            invariant,
            ..
        } in outputs
        {
            let own = column..column + size(variable);
            column = own.end;
            listed.push(Output {
                name: variable.name,
                own: own.clone(),
                holes: 0,
            });
            if invariant {
                invariants.push(Invariant {
                    variable,
                    own,
                    start: Vec::new(),
                    last: 0.0,
                    largest: 0.0,
                });
            }
        }
        Self {
            invariants,
            outputs: listed,
        }
    }

    /// Takes in one row.
    pub fn take(&mut self, row: &[f64]) {
        for invariant in &mut self.invariants {
            let values = &row[invariant.own.clone()];
            if invariant.start.is_empty() {
                invariant.start.extend_from_slice(values);
            }
            let drifts = values
                .iter()
                .zip(&invariant.start)
                .map(|(v, s)| (v - s).abs());
            invariant.last = drifts.fold(0.0, larger);
            invariant.largest = larger(invariant.largest, invariant.last);
        }
        for output in &mut self.outputs {
            let is_finite = row[output.own.clone()].iter().all(|v| v.is_finite());
            output.holes += u64::from(!is_finite);
        }
    }
}

/// The larger of two sizes; NaN is larger than any number.
fn larger(a: f64, b: f64) -> f64 {
    if b.is_nan() || b > a { b } else { a }
}

impl fmt::Display for Drift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for invariant in &self.invariants {
            let unit = match invariant.variable.unit {
                "1" => String::new(),
                symbols => format!(" {}", unit(symbols)),
            };
            write!(f, "{}", invariant.variable.name)?;
            if let [start] = invariant.start[..] {
                write!(f, " = {}{unit}", number(start))?;
            }
            let Invariant { last, largest, .. } = invariant;
            writeln!(
                f,
                ": drift {last:.1e}{unit} at the end, {largest:.1e} at most"
            )?;
        }
        for Output { name, holes, .. } in self.outputs.iter().filter(|o| o.holes > 0) {
            let plural = if *holes == 1 { "" } else { "s" };
            writeln!(
                f,
                "warning: {name} is no finite number in {holes} row{plural}"
            )?;
        }
        Ok(())
    }
}
