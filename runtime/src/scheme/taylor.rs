//! Taylor series methods of any order up to 24: the recurrences are generated from the flow.

mod adaptive;
mod expansion;
mod root;

pub use adaptive::Adaptive;
pub use adaptive::AdaptiveTaylor;
pub use expansion::Expansion;

use crate::compensated::compensated_sums;
use crate::convolution::Convolved;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::integration::require_finite;
use crate::model::Record;
use crate::model::Series;
use crate::report::Report;
use crate::report::Statistics;

/// The highest order.
pub const MOST_ORDER: usize = 24;

/// The order of a run that asks for none: what is least work at errors of 10⁻⁹ to 10⁻¹².
pub const USUAL_ORDER: usize = 20;

/// A run of the continuous equations dx/dt = f(t, x) of the model `M` by their Taylor series of a fixed order p:
///
/// x ← x + Σ xₙ hⁿ, 1 ≤ n ≤ p, with x = Σ xₙ (t' − t)ⁿ on the motion, (n + 1) xₙ₊₁ the coefficient of order n of f.
///
/// Explicit and not symmetric: linear invariants are kept, all others to the error of order p, which high orders and short
/// steps make smaller than rounding.
///
/// Sources: Moore, *Interval Analysis* (1966), chapter 11; Jorba and Zou, *Experiment. Math.* 14 (2005).
pub type TaylorSeries<M, T = f64> = Integration<Taylor<M, T>, T>;

/// The method of a [`TaylorSeries`].
pub struct Taylor<M: Series<T>, T: Convolved> {
    expansion: Expansion<M, T>,
    h: T,
    /// What the sums of increments have lost to rounding, component by component.
    lost: FlatState<M, T>,
}

impl<M: Series<T>, T: Convolved> TaylorSeries<M, T> {
    /// The same run with another order, 1 to [`MOST_ORDER`].
    pub fn with_order(mut self, order: usize) -> Self {
        self.method.expansion.set_order(order);
        self
    }
}

impl<M: Series<T>, T: Convolved> Method<T> for Taylor<M, T> {
    type Model = M;

    fn new(parameters: &M::Parameters, h: T) -> Self {
        let mut lost = M::start(parameters).to_array();
        lost.as_mut().fill(T::constant(0.0));
        Self {
            expansion: Expansion::new(parameters, USUAL_ORDER),
            h,
            lost,
        }
    }

    fn advance(
        &mut self,
        t: T,
        x: &mut FlatState<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        self.expansion.expand(t, x, self.h);
        statistics.flows += 1;
        let change = self.expansion.increment();
        let (sum, lost) = compensated_sums(x, &change, &self.lost);
        if let Err(fault) = require_finite(&sum) {
            self.expansion.forget();
            return Err(fault);
        }
        (*x, self.lost) = (sum, lost);
        Ok(Report::converged(0))
    }
}
