//! Starting values of Newton's method, extrapolated from earlier steps.

use crate::scalar::Real;

/// Highest order of extrapolation: the polynomial through the last ten solutions. At ordinary steps ten are enough in
/// space that the start is within rounding of the solution after one correction; more magnify rounding without
/// getting closer.
const HIGHEST: usize = 10;

/// The highest for one or two unknowns: six are enough in the plane, where a correction costs as much as four more.
const HIGHEST_OF_FEW: usize = 6;

/// An order that leaves enough for two corrections.
const SHORT: usize = 2;

/// How much worse than the order below an order may have been and still be used. Where a difference passes through
/// zero the order below looks better than it is, by up to 1; rounding and rough motions grow by 2 per order.
const SLACK: f64 = 1.5;

/// How far solutions lay from their guesses, s = x − guess, and the backward differences of that:
/// ∇⁰s = s, ∇ʲsₙ = ∇ʲ⁻¹sₙ − ∇ʲ⁻¹sₙ₋₁.
///
/// The guess of a step is crude (no increment, the known state), but what it misses changes smoothly. The
/// polynomial through the last p misses predicts Σ ∇ʲsₙ, j < p, and ∇ᵖsₙ₊₁ is what that misses: so the differences
/// tell which order would have been best in the last steps, and that one is taken.
#[derive(Clone, Copy)]
pub(crate) struct Shifts<X> {
    differences: [X; HIGHEST + 2],
    /// Steps seen, at most one more than differences are taken from.
    seen: usize,
}

impl<X: Copy> Shifts<X> {
    /// Nothing seen; `zeros` only fills the memory.
    pub(crate) fn new(zeros: X) -> Self {
        Self {
            differences: [zeros; HIGHEST + 2],
            seen: 0,
        }
    }

    /// The plain guess is all there is.
    pub(crate) fn are_zero(&self) -> bool {
        self.seen == 0
    }

    /// `guess` shifted by what the next solution is expected to lie from it, by extrapolation of a low order if it is to be
    /// `short`.
    #[inline]
    pub(crate) fn ahead<T: Real>(&self, guess: X, short: bool) -> X
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let mut x = guess;
        let highest = if short { SHORT } else { highest(&x) };
        for (i, x) in x.as_mut().iter_mut().enumerate() {
            let difference = |order: usize| self.differences[order].as_ref()[i];
            // What the prediction of this order missed in the last two steps, the larger.
            let missed = |order: usize| {
                let (last, before) = (difference(order), difference(order) - difference(order + 1));
                if last.abs() > before.abs() {
                    last.abs()
                } else {
                    before.abs()
                }
            };
            let mut last = T::constant(f64::INFINITY);
            for order in 1..=self.seen.min(highest) {
                *x = *x + difference(order - 1);
                if order + 2 <= self.seen {
                    let next = missed(order);
                    if next > T::constant(SLACK) * last {
                        break;
                    }
                    last = next;
                }
            }
        }
        x
    }

    /// Takes in the solution of a step and the guess it began with.
    #[inline]
    pub(crate) fn push<T: Real>(&mut self, solution: &X, guess: &X)
    where
        X: AsRef<[T]> + AsMut<[T]>,
    {
        let used = highest(solution) + 2;
        let pairs = solution.as_ref().iter().zip(guess.as_ref());
        for (i, (&solution, &guess)) in pairs.enumerate() {
            let mut difference = solution - guess;
            for older in &mut self.differences[..used] {
                let older = &mut older.as_mut()[i];
                let next = difference - *older;
                *older = difference;
                difference = next;
            }
        }
        self.seen = (self.seen + 1).min(HIGHEST + 2);
    }
}

/// The highest order for so many unknowns.
fn highest<T>(unknowns: &impl AsRef<[T]>) -> usize {
    if unknowns.as_ref().len() <= 2 {
        HIGHEST_OF_FEW
    } else {
        HIGHEST
    }
}
