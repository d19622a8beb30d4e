//! A run thinned out for a picture.
//!
//! Rows are collected in bins of equal length. Of each bin and curve only the lowest and the highest
//! point remain, so that oscillations keep their envelope however long the run is.

use crate::notation::{components, unit};
use crate::plot::{Curve, MAX_CURVES, Panel};
use residua::description::{Description, Variable};
use residua_models::values::size;
use residua_tools::columns::{kept_states, ordered_outputs};
use std::ops::Range;

/// Points that a curve may have: about two per pixel.
const MAX_POINTS: u64 = 1600;

/// Values beyond this are not drawn: differences of two of them would overflow.
const LARGEST: f64 = 1e300;

/// Entries that are drawn one by one as drift; of more, the largest drift is drawn.
const MAX_DRIFTS: usize = 3;

/// The panels of a run, filled row by row.
pub struct Trace {
    panels: Vec<Filling>,
    rows_per_bin: u64,
    rows_in_bin: u64,
}

struct Filling {
    title: String,
    unit: String,
    /// Another scalar of this kind, drift or not, may join.
    open: Option<bool>,
    columns: Vec<Column>,
}

struct Column {
    label: String,
    shown: Shown,
    points: Vec<(f64, f64)>,
    low: Option<(f64, f64)>,
    high: Option<(f64, f64)>,
}

/// What a curve shows of a row.
enum Shown {
    Value(usize),
    /// A scalar less its start, or how far the entries of a matrix are from theirs at most. The first row
    /// sets the start.
    Drift(Range<usize>, Vec<f64>),
}

impl Trace {
    /// For a run of `rows` rows: one panel per state and output, invariants as drift from their start.
    /// Scalars of one unit that follow each other share a panel.
    pub fn new(description: &'static Description, rows: u64) -> Self {
        let rows_per_bin = if rows <= MAX_POINTS {
            1
        } else {
            rows.div_ceil(MAX_POINTS / 2)
        };
        let mut trace = Self {
            panels: Vec::new(),
            rows_per_bin,
            // The first row has a bin of its own: drift is counted from it.
            rows_in_bin: rows_per_bin - 1,
        };
        let mut at = 0;
        for (_, state) in kept_states(description) {
            trace.add(state, false, &mut at);
        }
        for output in ordered_outputs(description) {
            trace.add(output.variable, output.invariant, &mut at);
        }
        trace
    }

    fn add(&mut self, variable: &Variable, drift: bool, at: &mut usize) {
        let own = *at..*at + size(variable);
        *at = own.end;
        let filling = filling(variable, drift, own);
        let shared = self.panels.last_mut().filter(|last| {
            filling.open.is_some()
                && last.open == filling.open
                && last.unit == filling.unit
                && last.columns.len() < MAX_CURVES
        });
        match shared {
            Some(last) => {
                last.title = format!("{}, {}", last.title, variable.name);
                last.columns.extend(filling.columns);
            }
            None => self.panels.push(filling),
        }
    }

    /// Takes in one row. Values that are not finite leave a gap.
    pub fn push(&mut self, t: f64, row: &[f64]) {
        for column in self.panels.iter_mut().flat_map(|panel| &mut panel.columns) {
            let value = column.shown.of(row);
            column.take(t, value);
        }
        self.rows_in_bin += 1;
        if self.rows_in_bin == self.rows_per_bin {
            self.close_bin();
        }
    }

    fn close_bin(&mut self) {
        let columns = self.panels.iter_mut().flat_map(|panel| &mut panel.columns);
        columns.for_each(Column::close_bin);
        self.rows_in_bin = 0;
    }

    /// What has been taken in.
    pub fn into_panels(mut self) -> Vec<Panel> {
        self.close_bin();
        let curve = |Column { label, points, .. }| Curve {
            label,
            reference: false,
            points,
        };
        let panel = |filling: Filling| Panel {
            title: filling.title,
            unit: filling.unit,
            curves: filling.columns.into_iter().map(curve).collect(),
            least_range: 0.0,
        };
        self.panels.into_iter().map(panel).collect()
    }
}

fn filling(variable: &Variable, drift: bool, own: Range<usize>) -> Filling {
    let name = variable.name;
    let n = own.len();
    let title = match drift {
        false if n > MAX_CURVES => format!("{name} (first {MAX_CURVES} of {n})"),
        false => name.to_owned(),
        true if n > MAX_DRIFTS => format!("largest drift in {name}"),
        true => format!("drift of {name}"),
    };
    let shown: Vec<Shown> = match drift {
        false => own.map(Shown::Value).take(MAX_CURVES).collect(),
        true if n > MAX_DRIFTS => vec![Shown::Drift(own, Vec::new())],
        true => own.map(|i| Shown::Drift(i..i + 1, Vec::new())).collect(),
    };
    let column = |(label, shown)| Column {
        label,
        shown,
        points: Vec::new(),
        low: None,
        high: None,
    };
    Filling {
        title,
        unit: unit(variable.unit),
        open: (n == 1).then_some(drift),
        columns: components(variable)
            .into_iter()
            .zip(shown)
            .map(column)
            .collect(),
    }
}

impl Shown {
    fn of(&mut self, row: &[f64]) -> f64 {
        match self {
            Self::Value(i) => row[*i],
            Self::Drift(own, start) => {
                let values = &row[own.clone()];
                if start.is_empty() {
                    start.extend_from_slice(values);
                }
                match (values, &start[..]) {
                    ([value], [start]) => value - start,
                    (values, start) => largest_distance(values, start),
                }
            }
        }
    }
}

fn largest_distance(a: &[f64], b: &[f64]) -> f64 {
    let distances = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    // NaN is larger than any number, so that it leaves a gap.
    distances.fold(0.0, |most, d| if d.is_nan() || d > most { d } else { most })
}

impl Column {
    fn take(&mut self, t: f64, value: f64) {
        if value.is_nan() || value.abs() > LARGEST {
            return;
        }
        if self.low.is_none_or(|(_, low)| value < low) {
            self.low = Some((t, value));
        }
        if self.high.is_none_or(|(_, high)| value > high) {
            self.high = Some((t, value));
        }
    }

    fn close_bin(&mut self) {
        match (self.low.take(), self.high.take()) {
            (Some(low), Some(high)) if low.0 < high.0 => self.points.extend([low, high]),
            (Some(low), Some(high)) if low.0 > high.0 => self.points.extend([high, low]),
            (point, _) => self.points.extend(point),
        }
    }
}

#[cfg(test)]
mod tests;
