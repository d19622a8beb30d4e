//! Starting values of Newton's method for a group of trajectories, extrapolated from their earlier steps.

use std::vec::Vec;

use pulp::Arch;
use pulp::NullaryFnOnce;

use super::rows::Mask;
use super::rows::Row;
use super::rows::WIDTH;
use super::rows::all;
use super::rows::zeros;
use crate::shifts::COMPARED;
use crate::shifts::HIGHEST;
use crate::shifts::KEPT;
use crate::shifts::SHORT;
use crate::shifts::WEIGHTS;

/// What [`Shifts`](crate::shifts::Shifts) is for one trajectory: how far solutions lay from their guesses, and by which
/// order the next is extrapolated. Each trajectory has its own order.
pub(crate) struct Shifts {
    unknowns: usize,
    /// Of `KEPT` steps, one after the other, round the end.
    ring: Vec<Row>,
    last: usize,
    /// Steps taken in.
    steps: usize,
    /// Those among them that a trajectory has forgotten.
    forgotten: [usize; WIDTH],
    order: [usize; WIDTH],
    /// Row j − 1 has the weights of j steps ago; 0 beyond the order of a trajectory.
    weights: [Row; HIGHEST],
    /// The highest order in use.
    highest: usize,
}

impl Shifts {
    /// Nothing seen.
    pub(crate) fn new(unknowns: usize) -> Self {
        Self {
            unknowns,
            ring: zeros(KEPT * unknowns),
            last: 0,
            steps: 0,
            forgotten: [0; WIDTH],
            order: [0; WIDTH],
            weights: [all(0.0); HIGHEST],
            highest: 0,
        }
    }

    /// Enough has been seen of this trajectory for any order.
    pub(crate) fn are_many(&self, lane: usize) -> bool {
        self.seen(lane) == KEPT
    }

    /// Steps seen of this trajectory, at most as many as are kept.
    fn seen(&self, lane: usize) -> usize {
        (self.steps - self.forgotten[lane]).min(KEPT)
    }

    /// Drops what earlier steps of a trajectory told.
    pub(crate) fn forget(&mut self, lane: usize) {
        for row in &mut self.ring {
            row[lane] = 0.0;
        }
        (self.forgotten[lane], self.order[lane]) = (self.steps, 0);
    }

    /// Overwrites `start` with what the next shifts are expected to be.
    pub(crate) fn ahead(&self, arch: Arch, start: &mut [Row]) {
        arch.dispatch(Ahead {
            shifts: self,
            start,
        });
    }

    /// Where the shifts of the step go that is being taken.
    pub(crate) fn next(&mut self) -> &mut [Row] {
        let slot = (self.last + 1) % KEPT;
        &mut self.ring[slot * self.unknowns..][..self.unknowns]
    }

    /// Takes them in.
    pub(crate) fn push(&mut self) {
        self.last = (self.last + 1) % KEPT;
        self.steps += 1;
    }

    /// Looks for the orders of the `due` trajectories that would have been best in the last steps, unknowns being
    /// measured by `scales`, but sets out with a low order, so that convergence shows above rounding.
    pub(crate) fn set_out(&mut self, arch: Arch, due: &Mask, scales: &[Row]) {
        let missed = arch.dispatch(Missed {
            shifts: self,
            scales,
        });
        for lane in (0..WIDTH).filter(|lane| due[*lane]) {
            self.order[lane] = self.seen(lane).min(1);
            let mut least = f64::INFINITY;
            for order in 1..=HIGHEST.min(self.seen(lane).saturating_sub(COMPARED)) {
                let missed = missed[order - 1][lane];
                if missed < least {
                    (self.order[lane], least) = (order, missed);
                }
            }
        }
        self.weigh(due);
    }

    /// Sets the weights, by a low order for those that are `due`.
    pub(crate) fn weigh(&mut self, due: &Mask) {
        self.highest = 0;
        for lane in 0..WIDTH {
            let order = match due[lane] {
                true => self.order[lane].min(SHORT),
                false => self.order[lane],
            };
            self.highest = self.highest.max(order);
            for (row, weight) in self.weights.iter_mut().zip(&WEIGHTS[order]) {
                row[lane] = *weight;
            }
        }
    }

    /// The shifts of `j` steps ago, j ≥ 1.
    #[inline(always)]
    fn ago(&self, j: usize) -> &[Row] {
        let slot = (self.last + KEPT + 1 - j) % KEPT;
        &self.ring[slot * self.unknowns..][..self.unknowns]
    }
}

/// [`Shifts::ahead`] for [`Arch::dispatch`].
struct Ahead<'a> {
    shifts: &'a Shifts,
    start: &'a mut [Row],
}

impl NullaryFnOnce for Ahead<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let weights = &self.shifts.weights;
        for (u, start) in self.start.iter_mut().enumerate() {
            let shifts: [&Row; HIGHEST] = core::array::from_fn(|j| &self.shifts.ago(j + 1)[u]);
            let mut sum = all(0.0);
            // Whatever the orders of others: beyond its own, a trajectory adds zeros.
            for i in 0..WIDTH {
                for j in (0..HIGHEST).rev() {
                    sum[i] += weights[j][i] * shifts[j][i];
                }
            }
            *start = sum;
        }
    }
}

/// For each order the most that its prediction missed in the last steps, over all unknowns, for [`Arch::dispatch`].
struct Missed<'a> {
    shifts: &'a Shifts,
    scales: &'a [Row],
}

/// Rows that differences are taken of.
const DIFFERENCES: usize = HIGHEST + COMPARED;

impl NullaryFnOnce for Missed<'_> {
    type Output = [Row; HIGHEST];

    #[inline(always)]
    fn call(self) -> [Row; HIGHEST] {
        let mut most = [all(0.0); HIGHEST];
        for (u, scale) in self.scales.iter().enumerate() {
            let mut differences = [all(0.0); DIFFERENCES];
            for (j, row) in differences.iter_mut().enumerate() {
                // 0/0 for an unknown that has been nothing but 0, and no larger than anything.
                for i in 0..WIDTH {
                    row[i] = self.shifts.ago(j + 1)[u][i] / scale[i];
                }
            }
            for (order, most) in most.iter_mut().enumerate() {
                for j in 0..DIFFERENCES - order - 1 {
                    let (one, rest) = differences[j..].split_at_mut(1);
                    for i in 0..WIDTH {
                        one[0][i] -= rest[0][i];
                    }
                }
                for difference in &differences[..COMPARED] {
                    for i in 0..WIDTH {
                        let missed = difference[i].abs();
                        most[i] = if missed > most[i] { missed } else { most[i] };
                    }
                }
            }
        }
        most
    }
}
