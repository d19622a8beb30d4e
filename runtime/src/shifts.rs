//! Starting values of Newton's method, extrapolated from the last two steps.

use crate::scalar::Real;

/// How far the last two solutions lay from their guesses: `x − guess`, latest first.
///
/// The guess of a step is crude (no increment, the known state), but what it misses changes slowly: the
/// line through the last two misses starts Newton's method at an error of O(h²) relative to the step.
#[derive(Clone, Copy)]
pub(crate) struct Shifts<X> {
    last: X,
    before: X,
    /// Steps seen, at most 2.
    seen: usize,
}

impl<X: Copy> Shifts<X> {
    /// Nothing seen; `zeros` only fills the memory.
    pub(crate) fn new(zeros: X) -> Self {
        Self {
            last: zeros,
            before: zeros,
            seen: 0,
        }
    }

    /// The plain guess is all there is.
    pub(crate) fn are_zero(&self) -> bool {
        self.seen == 0
    }

    /// `guess` shifted by what the next solution is expected to lie from it.
    pub(crate) fn ahead<T: Real>(&self, guess: X) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let mut x = guess;
        let shifts = self.last.as_ref().iter().zip(self.before.as_ref());
        for (x, (&last, &before)) in x.as_mut().iter_mut().zip(shifts) {
            *x = match self.seen {
                0 => *x,
                1 => *x + last,
                _ => *x + last + (last - before),
            };
        }
        x
    }

    /// Takes in the solution of a step and the guess it began with.
    pub(crate) fn push<T: Real>(&mut self, solution: &X, guess: &X)
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        self.before = self.last;
        let pairs = solution.as_ref().iter().zip(guess.as_ref());
        for (last, (&solution, &guess)) in self.last.as_mut().iter_mut().zip(pairs) {
            *last = solution - guess;
        }
        self.seen = (self.seen + 1).min(2);
    }
}
