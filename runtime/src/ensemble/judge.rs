//! What corrections say about the iterations of a group, trajectory by trajectory: the rules of the thorough Newton's
//! method of one, on rows.

use std::vec::Vec;

use super::rows::Mask;
use super::rows::Row;
use super::rows::WIDTH;
use super::rows::all;
use crate::description::Unknown;
use crate::description::Variable;
use crate::settings::AT_ROUNDING;
use crate::settings::LEFTOVER;
use crate::settings::NOTHING;
use crate::settings::REACH;
use pulp::NullaryFnOnce;

/// What one correction says.
pub(crate) struct Progress {
    /// The largest correction relative to the scale of its block.
    pub(crate) size: Row,
    /// Every block is within the tolerance.
    pub(crate) converged: Mask,
}

/// Judges `correction`, that has led to `x`, block by block.
pub(crate) fn progress(
    blocks: &[Unknown],
    state: &[Row],
    x: &[Row],
    correction: &[Row],
    tolerance: f64,
) -> Progress {
    let mut size = all(0.0);
    let mut converged = [true; WIDTH];
    let mut offset = 0;
    for block in blocks {
        let unknowns = offset..offset + block.len;
        offset = unknowns.end;
        let scale = scale(block, state, &x[unknowns.clone()]);
        let length = largest(&correction[unknowns]);
        for i in 0..WIDTH {
            converged[i] &= length[i] <= tolerance * scale[i];
            let is_larger = length[i] > size[i] * scale[i];
            size[i] = if is_larger {
                length[i] / scale[i]
            } else {
                size[i]
            };
        }
    }
    Progress { size, converged }
}

/// The scale of each unknown: the largest |x| in its block and in the state that the block advances.
pub(crate) fn scales(blocks: &[Unknown], state: &[Row], x: &[Row]) -> Vec<Row> {
    let mut scales = Vec::with_capacity(x.len());
    for block in blocks {
        let offset = scales.len();
        let scale = scale(block, state, &x[offset..offset + block.len]);
        scales.resize(offset + block.len, scale);
    }
    scales
}

/// Limits for the first correction, as the second tells: Newton's method converges quadratically, and had all of the
/// first been smaller by a factor, the second would have been by its square. They are no larger a part of the scales than `most`.
pub(crate) fn limits(
    blocks: &[Unknown],
    scales: &[Row],
    first: &[Row],
    second: &[Row],
    most: f64,
) -> Vec<Row> {
    let least = LEFTOVER * f64::EPSILON;
    let mut square = all(LEFTOVER);
    let mut offset = 0;
    for block in blocks {
        let unknowns = offset..offset + block.len;
        offset = unknowns.end;
        let scale = scales[unknowns.start];
        let size = largest(&second[unknowns]);
        for i in 0..WIDTH {
            let is_seen = size[i] > AT_ROUNDING * f64::EPSILON * scale[i];
            let is_less = least * scale[i] < square[i] * size[i];
            square[i] = if is_seen & is_less {
                least * scale[i] / size[i]
            } else {
                square[i]
            };
        }
    }
    let mut limits = Vec::with_capacity(first.len());
    for block in blocks {
        let offset = limits.len();
        let mut limit = largest(&first[offset..offset + block.len]);
        let scale = scales[offset];
        for i in 0..WIDTH {
            limit[i] = f64::min(limit[i] * square[i].sqrt(), most * scale[i]);
        }
        limits.resize(offset + block.len, limit);
    }
    limits
}

/// Takes it back that a correction was enough, where it is a larger part of the scale of its unknown than ever was; true if it was
/// enough for all but the idle. For [`Arch::dispatch`](pulp::Arch::dispatch).
pub(crate) struct Parts<'a> {
    pub(crate) blocks: &'a [Unknown],
    pub(crate) state: &'a [Row],
    pub(crate) x: &'a [Row],
    pub(crate) correction: &'a [Row],
    pub(crate) part: &'a [Row],
    pub(crate) idle: &'a Row,
    pub(crate) within: &'a mut Row,
}

impl NullaryFnOnce for Parts<'_> {
    type Output = bool;

    #[inline(always)]
    fn call(self) -> bool {
        let mut excess = all(0.0);
        let mut offset = 0;
        for block in self.blocks {
            let unknowns = offset..offset + block.len;
            offset = unknowns.end;
            let scale = scale(block, self.state, &self.x[unknowns.clone()]);
            let pairs = self.correction[unknowns.clone()].iter();
            for (correction, part) in pairs.zip(&self.part[unknowns]) {
                for i in 0..WIDTH {
                    let more = correction[i].abs() - part[i] * scale[i];
                    excess[i] = if more > excess[i] { more } else { excess[i] };
                }
            }
        }
        let mut open = all(0.0);
        for i in 0..WIDTH {
            let within = if excess[i] > 0.0 { 0.0 } else { self.within[i] };
            self.within[i] = within;
            open[i] = (1.0 - within) * (1.0 - self.idle[i]);
        }
        open.iter().all(|open| *open == 0.0)
    }
}

/// Raises what the states of a trajectory are to be below, see [`reach`](crate::sensitivity::reach).
pub(crate) fn widen(variables: &[Variable], state: &[Row], lane: usize, reach: &mut [Row]) {
    let mut offset = 0;
    for variable in variables {
        let own = offset..offset + variable.rows * variable.cols;
        offset = own.end;
        let values = state[own.clone()].iter();
        let most = values.fold(0.0, |most, row| f64::max(most, row[lane].abs()));
        for row in &mut reach[own] {
            row[lane] = f64::max(row[lane], REACH * most + NOTHING);
        }
    }
}

#[inline(always)]
fn scale(block: &Unknown, state: &[Row], x: &[Row]) -> Row {
    let mut scale = largest(x);
    if let Some(measure) = &block.measure {
        let known = largest(&state[measure.clone()]);
        for i in 0..WIDTH {
            scale[i] = if known[i] > scale[i] {
                known[i]
            } else {
                scale[i]
            };
        }
    }
    scale
}

/// The largest magnitude among finite numbers of each column.
#[inline(always)]
fn largest(rows: &[Row]) -> Row {
    let mut largest = all(0.0);
    for row in rows {
        for i in 0..WIDTH {
            let size = row[i].abs();
            largest[i] = if size > largest[i] { size } else { largest[i] };
        }
    }
    largest
}
