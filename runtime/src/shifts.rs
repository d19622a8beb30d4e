//! Starting values of Newton's method, extrapolated from earlier steps.

use crate::scalar::Real;
use crate::scalar::Scalar;

/// Highest order of extrapolation: the polynomial through the last ten solutions. At ordinary steps ten are enough in
/// space that the start is within rounding of the solution after one correction; more magnify rounding without
/// getting closer.
pub(crate) const HIGHEST: usize = 10;

/// An order that leaves enough for two corrections.
pub(crate) const SHORT: usize = 2;

/// Steps that orders are compared over: more than one, for a difference may just pass through zero.
pub(crate) const COMPARED: usize = 4;

/// Solutions kept, a power of two: more than the differences of the highest order in the compared steps are made of.
pub(crate) const KEPT: usize = 16;

/// How far solutions lay from their guesses, s = x − guess, in the last steps.
///
/// The guess of a step is crude (no increment, the known state), but what it misses changes smoothly. The
/// polynomial of degree p − 1 through the last p misses predicts Σ (−1)ʲ⁺¹ (p over j) sₙ₊₁₋ⱼ, j = 1, …, p, and the
/// backward difference ∇ᵖsₙ₊₁ is what that misses: so the differences tell which order would have been best in the last
/// steps, and that one is taken until it is looked for again.
#[derive(Clone, Copy)]
pub(crate) struct Shifts<X> {
    /// The last ones, at [`Shifts::last`] and, round the end of the first half, before it; the second half repeats the
    /// first, so that any window of them lies in one piece.
    ring: [[X; KEPT]; 2],
    last: usize,
    /// Steps seen, at most as many as are kept.
    seen: usize,
    order: usize,
    /// What all but the last one add to the next prediction of the order.
    rest: X,
}

impl<X: Copy> Shifts<X> {
    /// Nothing seen; `zeros` only fills the memory.
    pub(crate) fn new(zeros: X) -> Self {
        Self {
            ring: [[zeros; KEPT]; 2],
            last: 0,
            seen: 0,
            order: 0,
            rest: zeros,
        }
    }

    /// The plain guess is all there is.
    pub(crate) fn are_zero(&self) -> bool {
        self.seen == 0
    }

    /// Enough has been seen for any order.
    pub(crate) fn are_many(&self) -> bool {
        self.seen == KEPT
    }

    /// The miss of `j` steps ago, j ≥ 1.
    #[inline]
    fn ago(&self, j: usize) -> &X {
        // What is there already, said so that nothing needs to be checked.
        let last = self.last % KEPT;
        &self.ring.as_flattened()[last + KEPT + 1 - j.clamp(1, KEPT)]
    }

    /// `guess` shifted by what the next solution is expected to lie from it.
    #[inline]
    pub(crate) fn ahead<T: Scalar>(&self, guess: X) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        self.ahead_by(guess, self.order)
    }

    /// The same by a low order.
    pub(crate) fn shortly_ahead<T: Scalar>(&self, guess: X) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        self.ahead_by(guess, self.order.min(SHORT))
    }

    fn ahead_by<T: Scalar>(&self, mut guess: X, order: usize) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let rest = self.all_but_last(order, 1);
        let last = self.ago(1).as_ref();
        let weight = T::constant(WEIGHTS[order.min(HIGHEST)][0]);
        let terms = rest.as_ref().iter().zip(last);
        for (x, (rest, last)) in guess.as_mut().iter_mut().zip(terms) {
            *x = *x + (*rest + weight * *last);
        }
        guess
    }

    /// The same as [`Shifts::ahead`] in a run of steps, where all but the last miss were summed up in the step before: while
    /// that was being solved there was nothing else to do.
    #[inline]
    pub(crate) fn ahead_in_run<T: Scalar>(&mut self, mut guess: X) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let last = self.ago(1).as_ref();
        let weight = T::constant(WEIGHTS[self.order.min(HIGHEST)][0]);
        let terms = self.rest.as_ref().iter().zip(last);
        for (x, (rest, last)) in guess.as_mut().iter_mut().zip(terms) {
            *x = *x + (*rest + weight * *last);
        }
        self.rest = self.all_but_last(self.order, 0);
        guess
    }

    /// Makes ready for a run of steps.
    pub(crate) fn set_out<T: Scalar>(&mut self)
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        self.rest = self.all_but_last(self.order, 1);
    }

    /// Σ (−1)ʲ⁺¹ (p over j) s over j = 2, …, p, where s is the miss of j − 1 + `since` steps ago. Weights beyond the order are 0, so
    /// that there is nothing to branch on.
    #[inline]
    fn all_but_last<T: Scalar>(&self, order: usize, since: usize) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let weights = WEIGHTS[order.min(HIGHEST)].map(T::constant);
        let mut sum = self.rest;
        for (i, sum) in sum.as_mut().iter_mut().enumerate() {
            *sum = weights[HIGHEST - 1] * self.ago(HIGHEST - 1 + since).as_ref()[i];
            for j in (2..HIGHEST).rev() {
                *sum = *sum + weights[j - 1] * self.ago(j - 1 + since).as_ref()[i];
            }
        }
        sum
    }

    /// Takes in the solution of a step and the guess it began with.
    #[inline]
    pub(crate) fn push<T: Scalar>(&mut self, solution: &X, guess: &X)
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        self.last = (self.last + 1) % KEPT;
        self.seen = (self.seen + 1).min(KEPT);
        let mut shift = *solution;
        for (shift, guess) in shift.as_mut().iter_mut().zip(guess.as_ref()) {
            *shift = *shift - *guess;
        }
        for half in &mut self.ring {
            half[self.last] = shift;
        }
    }

    /// Looks for the order that would have been best in the last steps: the one that missed least, over all unknowns,
    /// each measured by its scale.
    pub(crate) fn choose_order<T: Real>(&mut self, scales: &X)
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let zero = T::constant(0.0);
        let mut missed = [zero; HIGHEST + 1];
        for (i, &scale) in scales.as_ref().iter().enumerate() {
            if scale > zero {
                let reciprocal = T::constant(1.0) / scale;
                self.add_misses(i, reciprocal, &mut missed);
            }
        }
        self.order = self.seen.min(1);
        let mut least = missed[self.order];
        let highest = self.seen.saturating_sub(COMPARED);
        for (order, missed) in missed.into_iter().enumerate().take(highest + 1).skip(2) {
            if missed < least {
                (self.order, least) = (order, missed);
            }
        }
    }

    /// Raises `missed[p]` to the largest ∇ᵖ of unknown `i` in the compared steps.
    fn add_misses<T: Real>(&self, i: usize, reciprocal: T, missed: &mut [T; HIGHEST + 1])
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let mut differences: [T; HIGHEST + COMPARED] =
            core::array::from_fn(|j| self.ago(j + 1).as_ref()[i] * reciprocal);
        for (order, most) in missed.iter_mut().enumerate().skip(1) {
            for j in 0..HIGHEST + COMPARED - order {
                differences[j] = differences[j] - differences[j + 1];
            }
            for difference in &differences[..COMPARED] {
                let size = difference.abs();
                *most = if size > *most { size } else { *most };
            }
        }
    }
}

/// (−1)ʲ⁺¹ (p over j) in row p, column j − 1.
pub(crate) const WEIGHTS: [[f64; HIGHEST]; HIGHEST + 1] = weights();

const fn weights() -> [[f64; HIGHEST]; HIGHEST + 1] {
    let mut rows = [[0.0; HIGHEST]; HIGHEST + 1];
    let mut p = 1;
    while p <= HIGHEST {
        // (p over j) = (p − 1 over j) + (p − 1 over j − 1), and the signs alternate.
        rows[p][0] = rows[p - 1][0] + 1.0;
        let mut j = 1;
        while j < p {
            rows[p][j] = rows[p - 1][j] - rows[p - 1][j - 1];
            j += 1;
        }
        p += 1;
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::HIGHEST;
    use super::KEPT;
    use super::Shifts;

    #[test]
    fn a_polynomial_is_met_by_its_order() {
        for degree in 0..HIGHEST {
            let polynomial = |n: usize| (n as f64 / 8.0 - 0.7).powi(degree as i32);
            let mut shifts = Shifts::new([0.0]);
            for n in 0..KEPT + 3 {
                shifts.push(&[polynomial(n) + 3.0], &[3.0]);
            }
            shifts.order = degree + 1;
            let [ahead] = shifts.ahead([3.0]);
            let exact = 3.0 + polynomial(KEPT + 3);
            assert!((ahead - exact).abs() < 1e-11, "{degree}: {ahead} {exact}");
        }
    }

    #[test]
    fn in_a_run_the_same_is_expected() {
        let mut shifts = Shifts::new([0.0]);
        for n in 0..KEPT {
            shifts.push(&[f64::sin(0.3 * n as f64)], &[0.0]);
        }
        shifts.choose_order(&[1.0]);
        shifts.set_out();
        for n in KEPT..2 * KEPT {
            let alone = shifts.ahead([3.0]);
            assert_eq!(shifts.ahead_in_run([3.0]), alone);
            shifts.push(&[f64::sin(0.3 * n as f64)], &[0.0]);
        }
    }

    #[test]
    fn the_order_fits_the_motion() {
        let order = |motion: &dyn Fn(f64) -> f64| {
            let mut shifts = Shifts::new([0.0]);
            for n in 0..KEPT {
                shifts.push(&[motion(n as f64)], &[0.0]);
            }
            shifts.choose_order(&[1.0]);
            shifts.order
        };
        assert!(order(&|n| (0.05 * n).sin()) >= 8);
        assert!(order(&|n| (0.5 * n).sin()) >= 8);
        // From the next higher order the prediction gets worse.
        assert!(order(&|n| (2.5 * n).sin()) <= 2);
        assert!(order(&|n| (0.05 * n).sin() + 1e-9 * (n * n).sin()) <= 6);
    }
}
