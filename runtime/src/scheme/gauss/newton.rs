//! The stage equations of stiff flows, where sweeps do not contract.

use super::Collocated;
use super::Flat;
use super::Stages;
use super::coefficients::LANES;
use super::coefficients::Row;
use super::sweeps::End;
use super::within_digits;
use super::zeros;
use crate::model::Flow;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::report::Statistics;
use crate::scheme::rates;
use crate::settings::ROUNDING;

/// Components of the largest state that is solved for; two rows of lanes hold a row of its Jacobian.
const MOST_COMPONENTS: usize = 2 * LANES;

/// Corrections before they are given up, in double precision.
const MOST_CORRECTIONS: u32 = 40;

/// Corrections with a Jacobian after which the next step gets a new one.
const SLOW: usize = 12;

/// ∂f/∂x, row by row, eight columns at a time.
pub(super) type Square<M, T> = [Stages<M, T>; 2];

/// Newton's method for X = x + h A f(X), simplified twice: the Jacobian J of f is that of the start of a step, and A is
/// replaced by the lower triangle L of its Crout decomposition L U, so that each correction takes one linear system of the
/// size of the state per stage, (I − h lᵢᵢ J) Δᵢ = rᵢ + h J Σⱼ lᵢⱼ Δⱼ, j < i. What that leaves of the stiff components is
/// multiplied by I − U, which is nilpotent: it is gone after as many corrections as there are stages.
///
/// J is found by differences with steps of √ε, eight columns in one evaluation of the flow.
///
/// Source: van der Houwen and de Swart, *Triangularly implicit iteration methods for ODE-IVP solvers*, SIAM J. Sci.
/// Comput. 18 (1997).
pub(super) struct Corrections<'a, M: Collocated<T>, T: Packed> {
    pub(super) scene: &'a <M as Flow<T::Pack<LANES>>>::FlowScene,
    pub(super) stages: usize,
    pub(super) t: T,
    pub(super) times: Row<T>,
    pub(super) hb: Row<T>,
    pub(super) mu: &'a [Row<T>; LANES],
    pub(super) x: &'a Flat<M, T>,
    pub(super) weights: &'a Flat<M, T>,
    pub(super) floor: T,
    /// Of the state in the last step: sizes of what is 0 now.
    pub(super) change: &'a Flat<M, T>,
    pub(super) jacobian: &'a mut Square<M, T>,
    /// The Jacobian is that of an earlier step.
    pub(super) is_known: &'a mut bool,
    pub(super) rates: &'a mut Stages<M, T>,
}

impl<M: Collocated<T>, T: Packed> Corrections<'_, M, T> {
    pub(super) fn run(&mut self, statistics: &mut Statistics) -> (End, u32) {
        if self.x.as_ref().len() > MOST_COMPONENTS {
            return (End::Slow, 0);
        }
        let was_known = *self.is_known;
        if !was_known {
            self.differentiate(statistics);
        }
        let (end, mut all) = self.correct(statistics);
        if end == End::Converged || !was_known {
            *self.is_known = end == End::Converged && all < SLOW;
            return (end, all as u32);
        }
        self.differentiate(statistics);
        let (end, more) = self.correct(statistics);
        all += more;
        *self.is_known = end == End::Converged && more < SLOW;
        (end, all as u32)
    }

    fn differentiate(&mut self, statistics: &mut Statistics) {
        let n = self.x.as_ref().len();
        let [zero, one] = [0.0, 1.0].map(T::constant);
        let root = T::EPSILON.sqrt();
        for (part, columns) in self.jacobian.iter_mut().enumerate() {
            let first = part * LANES;
            if first >= n {
                break;
            }
            let mut at = *self.rates;
            let mut steps = [one; LANES];
            for (i, (at, x)) in at.as_mut().iter_mut().zip(self.x.as_ref()).enumerate() {
                let mut row = [*x; LANES];
                if i >= first && i < first + LANES {
                    let size = super::larger(x.abs(), self.change.as_ref()[i].abs());
                    let size = if size > zero { size } else { one };
                    row[i - first] = *x + root * size;
                    steps[i - first] = row[i - first] - *x;
                }
                *at = T::Pack::pack(row);
            }
            let time = T::Pack::pack([self.t; LANES]);
            let moved = rates::<M, T::Pack<LANES>>(self.scene, time, &at);
            for (at, x) in at.as_mut().iter_mut().zip(self.x.as_ref()) {
                *at = T::Pack::pack([*x; LANES]);
            }
            let still = rates::<M, T::Pack<LANES>>(self.scene, time, &at);
            let rows = moved.as_ref().iter().zip(still.as_ref());
            for (column, (moved, still)) in columns.as_mut().iter_mut().zip(rows) {
                let mut row = *moved.numbers();
                for (k, value) in row.iter_mut().enumerate() {
                    *value = (*value - still.numbers()[k]) / steps[k];
                }
                *column = T::Pack::pack(row);
            }
            statistics.flows += 2 * LANES as u64;
        }
        statistics.jacobians += 1;
    }

    fn correct(&mut self, statistics: &mut Statistics) -> (End, usize) {
        let (n, s) = (self.x.as_ref().len(), self.stages);
        let [zero, half, one] = [0.0, 0.5, 1.0].map(T::constant);
        let lower = self.crout();
        let mut x = *self.rates;
        for (x, start) in x.as_mut().iter_mut().zip(self.x.as_ref()) {
            *x = T::Pack::pack([*start; LANES]);
        }
        let times = T::Pack::pack(self.times);
        let noise = self.noise();
        let mut before = None;
        let mut growths = 0;
        let most = within_digits::<T>(MOST_CORRECTIONS) as usize;
        for made in 0..most {
            let f = rates::<M, T::Pack<LANES>>(self.scene, times, &x);
            statistics.flows += s as u64;
            for (to, f) in self.rates.as_mut().iter_mut().zip(f.as_ref()) {
                let mut row = *f.numbers();
                for (l, hb) in row.iter_mut().zip(self.hb) {
                    *l = *l * hb;
                }
                *to = T::Pack::pack(row);
            }

            let mut corrections = [zeros::<M, T>(); LANES];
            let mut square = zero;
            let mut is_noise = true;
            for i in 0..s {
                // What the stages before move: h Σ lᵢⱼ Δⱼ.
                let mut moved = zeros::<M, T>();
                for (j, correction) in corrections.iter().enumerate().take(i) {
                    for (sum, d) in moved.as_mut().iter_mut().zip(correction.as_ref()) {
                        *sum = *sum + lower[i][j] * *d;
                    }
                }
                let mut right = zeros::<M, T>();
                for c in 0..n {
                    let increments = self.rates.as_ref()[c].numbers();
                    let terms = self.mu.iter().zip(increments);
                    let sum = terms.fold(zero, |sum, (mu, l)| sum + mu[i] * *l);
                    let stage = x.as_ref()[c].numbers()[i];
                    let driven =
                        (0..n).fold(zero, |sum, k| sum + self.entry(c, k) * moved.as_ref()[k]);
                    let missed = (self.x.as_ref()[c] - stage) + sum;
                    is_noise &= missed.abs() <= noise.as_ref()[c];
                    right.as_mut()[c] = missed + driven;
                }
                let Some(correction) = self.solve(lower[i][i], right) else {
                    return (End::Slow, made);
                };
                for (c, d) in correction.as_ref().iter().enumerate() {
                    let size = *d * self.weights.as_ref()[c];
                    square = square + size * size;
                    let stage = x.as_mut()[c].numbers_mut();
                    stage[i] = stage[i] + *d;
                }
                corrections[i] = correction;
            }
            // What pads the stages follows the last one.
            for row in x.as_mut() {
                let last = row.numbers()[s - 1];
                row.numbers_mut()[s..].fill(last);
            }
            statistics.iterations += 1;

            let change = square.sqrt();
            if !change.is_finite() {
                return (End::NotFinite, made);
            }
            let former = before.replace(change);
            let rate = former.map_or(one, |former| change / former);
            let is_rounding = (is_noise || change <= self.floor) && rate > half;
            let is_enough = rate < one && change * rate / (one - rate) <= one;
            if is_rounding || is_enough || change == zero {
                let f = rates::<M, T::Pack<LANES>>(self.scene, times, &x);
                for (to, f) in self.rates.as_mut().iter_mut().zip(f.as_ref()) {
                    let mut row = *f.numbers();
                    for (l, hb) in row.iter_mut().zip(self.hb) {
                        *l = *l * hb;
                    }
                    *to = T::Pack::pack(row);
                }
                return (End::Converged, made + 1);
            }
            growths += usize::from(former.is_some() && rate >= one);
            if growths > s + 2 {
                return (End::Slow, made);
            }
        }
        (End::Slow, most)
    }

    /// What rounding may make of the stage equations: 64 ε times the size of their terms, |xᵢ| + |h| Σₖ |Jᵢₖ| |xₖ|. A stiff force is
    /// the small difference of large terms, and what it drives no better known than that, however small.
    fn noise(&self) -> Flat<M, T> {
        let zero = T::constant(0.0);
        let h = self.hb.iter().fold(zero, |sum, hb| sum + *hb).abs();
        let rounding = T::constant(ROUNDING) * T::EPSILON;
        let sizes = self.x.as_ref().iter().zip(self.change.as_ref());
        let mut size = zeros::<M, T>();
        for (size, (x, change)) in size.as_mut().iter_mut().zip(sizes) {
            *size = super::larger(x.abs(), change.abs());
        }
        let size = size.as_ref();
        let mut noise = zeros::<M, T>();
        for (i, noise) in noise.as_mut().iter_mut().enumerate() {
            let terms = size.iter().enumerate();
            let terms = terms.fold(zero, |sum, (k, size)| sum + self.entry(i, k).abs() * *size);
            *noise = rounding * (size[i] + h * terms);
        }
        noise
    }

    /// h L of A = L U with ones on the diagonal of U.
    #[expect(clippy::needless_range_loop, reason = "indices as in the textbook")]
    fn crout(&self) -> [Row<T>; LANES] {
        let zero = T::constant(0.0);
        let s = self.stages;
        let mut lower = [[zero; LANES]; LANES];
        let mut upper = [[zero; LANES]; LANES];
        let a = |i: usize, j: usize| self.mu[j][i] * self.hb[j];
        for j in 0..s {
            for i in j..s {
                let known = (0..j).fold(zero, |sum, k| sum + lower[i][k] * upper[k][j]);
                lower[i][j] = a(i, j) - known;
            }
            for i in j + 1..s {
                let known = (0..j).fold(zero, |sum, k| sum + lower[j][k] * upper[k][i]);
                let rest = a(j, i) - known;
                upper[j][i] = if lower[j][j].abs() > zero {
                    rest / lower[j][j]
                } else {
                    zero
                };
            }
        }
        lower
    }

    fn entry(&self, row: usize, column: usize) -> T {
        self.jacobian[column / LANES].as_ref()[row].numbers()[column % LANES]
    }

    /// Δ with (I − l J) Δ = right, by elimination with row pivoting; `None` where a pivot is 0.
    #[expect(clippy::needless_range_loop, reason = "indices as in the textbook")]
    fn solve(&self, l: T, mut right: Flat<M, T>) -> Option<Flat<M, T>> {
        let [zero, one] = [0.0, 1.0].map(T::constant);
        let n = right.as_ref().len();
        let mut a = [[zero; MOST_COMPONENTS]; MOST_COMPONENTS];
        for (i, row) in a.iter_mut().enumerate().take(n) {
            for (k, value) in row.iter_mut().enumerate().take(n) {
                let unit = if i == k { one } else { zero };
                *value = unit - l * self.entry(i, k);
            }
        }
        let b = right.as_mut();
        for k in 0..n {
            let larger = |best: usize, i: usize| {
                if a[i][k].abs() > a[best][k].abs() {
                    i
                } else {
                    best
                }
            };
            let pivot = (k + 1..n).fold(k, larger);
            if a[pivot][k] == zero {
                return None;
            }
            a.swap(k, pivot);
            b.swap(k, pivot);
            for i in k + 1..n {
                let factor = a[i][k] / a[k][k];
                for j in k + 1..n {
                    a[i][j] = a[i][j] - factor * a[k][j];
                }
                b[i] = b[i] - factor * b[k];
            }
        }
        for k in (0..n).rev() {
            for j in k + 1..n {
                b[k] = b[k] - a[k][j] * b[j];
            }
            b[k] = b[k] / a[k][k];
        }
        Some(right)
    }
}
