//! A run thinned out for a picture.
//!
//! Rows are collected in bins of equal length. Of each bin and column only the lowest and the highest
//! point remain, so that oscillations keep their envelope however long the run is.

use super::plot::{Curve, MAX_CURVES, Panel};
use crate::columns::{Placed, ordered_outputs};
use crate::notation::{components, unit};
use residua::description::{Description, Variable};

/// Points that a curve may have: about two per pixel.
const MAX_POINTS: u64 = 1600;

/// The columns of a run, thinned out.
pub struct Trace {
    columns: Vec<Column>,
    rows_per_bin: u64,
    rows_in_bin: u64,
}

#[derive(Default)]
struct Column {
    points: Vec<(f64, f64)>,
    low: Option<(f64, f64)>,
    high: Option<(f64, f64)>,
}

impl Trace {
    /// For a run of `rows` rows of `width` columns.
    pub fn new(width: usize, rows: u64) -> Self {
        let rows_per_bin = if rows <= MAX_POINTS {
            1
        } else {
            rows.div_ceil(MAX_POINTS / 2)
        };
        Self {
            columns: std::iter::repeat_with(Column::default)
                .take(width)
                .collect(),
            rows_per_bin,
            // The first row has a bin of its own: drift is counted from it.
            rows_in_bin: rows_per_bin - 1,
        }
    }

    /// Takes in one row. Values that are not finite leave a gap.
    pub fn push(&mut self, t: f64, values: &[f64]) {
        for (column, &value) in self.columns.iter_mut().zip(values) {
            column.take(t, value);
        }
        self.rows_in_bin += 1;
        if self.rows_in_bin == self.rows_per_bin {
            self.close_bin();
        }
    }

    fn close_bin(&mut self) {
        self.columns.iter_mut().for_each(Column::close_bin);
        self.rows_in_bin = 0;
    }

    /// One panel per state and output; invariants as drift from their start. Scalars of one unit that
    /// follow each other share a panel.
    pub fn into_panels(mut self, description: &'static Description) -> Vec<Panel> {
        self.close_bin();
        let mut columns = self.columns.into_iter();
        let mut panels = Panels::default();
        for state in description.states {
            panels.add(state, false, &mut columns);
        }
        for Placed {
            variable,
            invariant,
            ..
        } in ordered_outputs(description)
        {
            panels.add(variable, invariant, &mut columns);
        }
        panels.list
    }
}

impl Column {
    fn take(&mut self, t: f64, value: f64) {
        if !value.is_finite() {
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

#[derive(Default)]
struct Panels {
    list: Vec<Panel>,
    /// The last panel is of scalars, of invariants or not, and may take another one.
    open: Option<bool>,
}

impl Panels {
    fn add(
        &mut self,
        variable: &Variable,
        drift: bool,
        columns: &mut impl Iterator<Item = Column>,
    ) {
        let labels = components(variable);
        let scalar = labels.len() == 1;
        let mut curves: Vec<Curve> = labels
            .into_iter()
            .zip(columns)
            .map(|(label, column)| Curve {
                label,
                points: column.points,
            })
            .collect();
        if drift {
            curves.iter_mut().for_each(from_start);
        }
        let unit = unit(variable.unit);
        let shared = self.list.last_mut().filter(|last| {
            scalar
                && self.open == Some(drift)
                && last.unit == unit
                && last.curves.len() < MAX_CURVES
        });
        if let Some(last) = shared {
            last.title = format!("{}, {}", last.title, variable.name);
            last.curves.append(&mut curves);
            return;
        }
        let mut title = if drift {
            format!("drift of {}", variable.name)
        } else {
            variable.name.to_owned()
        };
        if curves.len() > MAX_CURVES {
            title = format!("{title} (first {MAX_CURVES} of {})", curves.len());
            curves.truncate(MAX_CURVES);
        }
        self.list.push(Panel {
            title,
            unit,
            curves,
        });
        self.open = scalar.then_some(drift);
    }
}

fn from_start(curve: &mut Curve) {
    let start = curve.points.first().map_or(0.0, |point| point.1);
    for point in &mut curve.points {
        point.1 -= start;
    }
}

#[cfg(test)]
mod tests;
