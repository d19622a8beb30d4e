//! The implicit trapezoidal rule.

use super::gauss::Coefficients;
use super::gauss::Collocated;
use super::gauss::Core;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Model;
use crate::packed::Packed;
use crate::report::Report;
use crate::report::Statistics;

/// A run of the continuous equations by the trapezoidal rule, x ← x + h (f(t, x) + f(t + h, x'))/2 with the state x' after
/// the step: of order 2, symmetric and A-stable. Linear invariants are kept to rounding; quadratic ones are not, but it is
/// conjugate to the implicit midpoint rule, which keeps them, so that their errors do not grow.
///
/// Source: Hairer, Lubich and Wanner, *Geometric Numerical Integration*, II.1.1 and VI.8.
pub type Trapezoidal<M, T = f64> = Integration<Ends<M, T>, T>;

/// The method of a [`Trapezoidal`]: collocation at both ends of the step.
pub struct Ends<M: Collocated<T>, T: Packed> {
    core: Core<M, T>,
    h: T,
}

impl<M: Collocated<T>, T: Packed> Method<T> for Ends<M, T> {
    type Model = M;

    fn new(parameters: &<M as Model<T>>::Parameters, h: T) -> Self {
        let core = Core::new(parameters, Coefficients::trapezoidal());
        Self { core, h }
    }

    fn advance(
        &mut self,
        t: T,
        x: &mut FlatState<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        self.core.advance(t, x, self.h, statistics)
    }
}
