//! Numbers of a group of trajectories: a row for each component, a column for each trajectory.

use core::ops::Deref;
use core::ops::DerefMut;
use std::vec;
use std::vec::Vec;

use crate::lanes::Lanes;

/// Trajectories of a group: as many as keep the working memory of a model with a dozen states in the first cache.
pub const WIDTH: usize = 32;

/// One component of all trajectories of a group, on the boundary that whole vectors are read from fastest.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Row(pub(crate) [f64; WIDTH]);

impl Deref for Row {
    type Target = [f64; WIDTH];

    #[inline(always)]
    fn deref(&self) -> &[f64; WIDTH] {
        &self.0
    }
}

impl DerefMut for Row {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [f64; WIDTH] {
        &mut self.0
    }
}

/// A row of the same number.
pub(crate) const fn all(value: f64) -> Row {
    Row([value; WIDTH])
}

/// A truth for each trajectory of a group.
pub(crate) type Mask = [bool; WIDTH];

/// As many rows of zeros.
pub(crate) fn zeros(rows: usize) -> Vec<Row> {
    vec![all(0.0); rows]
}

/// Writes a column.
pub(crate) fn put(rows: &mut [Row], lane: usize, values: &[f64]) {
    for (row, value) in rows.iter_mut().zip(values) {
        row[lane] = *value;
    }
}

/// Reads a column.
pub(crate) fn get(rows: &[Row], lane: usize, values: &mut [f64]) {
    for (row, value) in rows.iter().zip(values) {
        *value = row[lane];
    }
}

/// Copies the columns of the lanes that are `chosen`.
pub(crate) fn merge(rows: &mut [Row], from: &[Row], chosen: &Mask) {
    for (row, from) in rows.iter_mut().zip(from) {
        for i in 0..WIDTH {
            row[i] = if chosen[i] { from[i] } else { row[i] };
        }
    }
}

/// `N` columns, evenly spaced over the row, from column `i` on.
#[inline(always)]
pub(crate) fn lanes<const N: usize>(row: &Row, i: usize) -> Lanes<N> {
    Lanes(core::array::from_fn(|k| row[i + k * (WIDTH / N)]))
}

/// Overwrites `N` columns, evenly spaced over the row, from column `i` on.
#[inline(always)]
pub(crate) fn set_lanes<const N: usize>(row: &mut Row, i: usize, lanes: Lanes<N>) {
    for (k, lane) in lanes.0.into_iter().enumerate() {
        row[i + k * (WIDTH / N)] = lane;
    }
}
