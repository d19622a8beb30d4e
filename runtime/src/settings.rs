//! Every number that steers Newton's method.

use crate::scalar::Real;

/// When Newton's method stops. The defaults suit implicit steppers, whose guess is close.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings<T = f64> {
    /// Largest correction of a converged iterate, relative to the block of unknowns it belongs to and the
    /// state that the block advances. Default 1e-12, for `f32` 64 ε.
    ///
    /// A correction larger than that is the last one, too, if at the rate of the last two the next would be within
    /// a tenth of it. Larger saves at most one iteration a step. Smaller, 0 included, iterates down to the
    /// rounding floor, where corrections stop shrinking: below 64 ε none is taken for made that was not, and
    /// [`Statistics::at_floor`](crate::Statistics::at_floor) counts the steps that ended there.
    pub tolerance: T,
    /// Corrections before the step is given up as stalled. Default 50; a good guess takes 2 to 5.
    pub max_iterations: usize,
    /// Consecutive corrections that do not shrink before the step is given up as diverged. Default 4.
    ///
    /// Smaller gives up on iterations that wander before they converge; larger only delays the failure.
    pub max_growths: usize,
    /// Which unknowns are iterated on.
    pub strategy: Strategy,
    /// Whether what rounding takes from a state when its increment is added is kept and added to the next one, where the
    /// unknowns are increments. Default true: rounding of the state no longer adds up over steps.
    pub compensated: bool,
    /// How often a step that fails is halved: it is taken as 2, then 4, then 8 shorter ones and so on. Default 0; 20 at most.
    ///
    /// The scheme is another one over such a step: what it keeps only with equal steps, such as a bounded energy error of a
    /// symmetric scheme, is lost to it. [`Statistics::halved`](crate::Statistics::halved) counts them.
    pub halvings: u32,
}

impl<T: Real> Default for Settings<T> {
    fn default() -> Self {
        let epsilon = T::EPSILON.to_f64();
        Self {
            tolerance: T::constant(f64::max(1e-12, 64.0 * epsilon)),
            max_iterations: 50,
            max_growths: 4,
            strategy: Strategy::Core,
            compensated: true,
            halvings: 0,
        }
    }
}

impl<T: Real> Settings<T> {
    /// Whether the tolerance is so far above rounding that a correction can be told without being made. False for NaN.
    #[inline]
    pub(crate) fn is_above_rounding(&self) -> bool {
        self.tolerance >= T::constant(ROUNDING) * T::EPSILON
    }
}

/// Which unknowns Newton's method iterates on.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Strategy {
    /// Those of the core, and all where that fails.
    #[default]
    Core,
    /// All.
    Full,
}

/// Share of the tolerance that the estimated error may take before the last correction is spared. Larger
/// trusts the estimate more; 0 always waits for a correction within the tolerance.
pub(crate) const RATE_MARGIN: f64 = 0.1;

/// How many times larger than the one of the step before a first correction may be, if no second one is to be made. Starts are
/// extrapolated, and miss by more where motion changes: larger is surprised by it, smaller takes the zeros of a
/// correction that oscillates for that.
pub(crate) const USUAL: f64 = 16.0;

/// A first correction of this share of √ε is usual. What it leaves is its square times a curvature, which would have to be 1e6
/// to matter; larger trusts more, smaller takes rounding for news.
pub(crate) const HARMLESS: f64 = 1.0 / 16.0;

/// A correction that is a larger part of what it corrects does not tell how fast the next ones shrink. Larger accepts
/// iterates that pass a solution by, smaller takes one correction more.
pub(crate) const TELLING: f64 = 1.0 / 16.0;

/// A residual this many ε times the size of its own terms is rounding error: a sum of n terms loses up to
/// n ε/2 of them (Higham, *Accuracy and Stability of Numerical Algorithms*, section 4.2).
///
/// Larger takes unconverged iterates for solutions; smaller calls solutions stalled.
pub(crate) const ROUNDING: f64 = 64.0;

/// Growth of rounding in the eliminated unknowns from which the elimination is not trusted: they would keep ten
/// digits, two fewer than Newton's tolerance asks for.
pub(crate) const MOST_GROWTH: f64 = 1e6;

/// The same for numbers of fewer digits, of which rounding grown by [`MOST_GROWTH`] would leave none: five are to be left of the
/// seven of `f32`.
#[inline]
pub(crate) fn most_growth<T: Real>() -> T {
    T::constant(f64::min(MOST_GROWTH, 5e-5 / T::EPSILON.to_f64()))
}

/// A second correction of up to this many ε is rounding and says only that the true one is no larger.
pub(crate) const AT_ROUNDING: f64 = 4.0;

/// Share of ε that the second correction would have been, by the last measure of convergence, where it is spared:
/// 16 times less than a sixty-fourth, for convergence may be slower by then. What is left has a sign, and adds up over
/// steps where rounding does not. Larger drifts, smaller takes more corrections.
pub(crate) const LEFTOVER: f64 = 1.0 / 1024.0;

/// Share of the fall of a linear residual's squares that a shortened correction must bring. Larger shortens more than it needs to,
/// 0 may go back and forth.
pub(crate) const FALL: f64 = 1e-4;

/// Halvings of a correction before it is given up: stiffnesses on two sides of a kink may differ by 2³⁰.
pub(crate) const MOST_HALVED: usize = 30;

/// Parts of a distance that are tried where something is looked at within it: a rotation by whole turns looks like none, but not by
/// three that do not fit each other.
pub(crate) const MOVES: [f64; 3] = [1.0, -0.618_033_988_749_894_8, 0.414_213_562_373_095_1];

/// Share by which rounding of the unknowns may change an equation's dependence on them. Larger takes iterates among many solutions for one
/// of them; smaller refuses large angles whose digits still tell the attitude.
pub(crate) const BLURRED: f64 = 0.125;

/// How many times larger a move is that such a change must not grow with.
pub(crate) const FAR: f64 = 1024.0;

/// Growth of a state within which rounding of the unknowns is taken to grow no more on its way to it. Larger notices later what is then
/// refused; smaller looks more often while a motion sets out.
pub(crate) const REACH: f64 = 4.0;

/// Below any number that matters, and no denormal in `f32`.
pub(crate) const NOTHING: f64 = 1e-37;

/// Steps after which convergence is measured again: twice as many would save a hundredth of a step, half as many cost two.
pub(crate) const TRUSTED_STEPS: u32 = 63;

/// Corrections before a quick solution is given up. Four take an ordinary guess to rounding; more would only put off
/// the thorough solution of a step that needs it.
pub(crate) const MOST_QUICK: usize = 4;
