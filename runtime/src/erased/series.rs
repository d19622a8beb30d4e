//! Taylor series over flat slices.

use core::marker::PhantomData;

use super::simulate::Observer;
use super::simulate::Run;
use crate::error::RunError;
use crate::model::Series;
use crate::report::Statistics;
use crate::scheme::Tolerance;
use crate::scheme::taylor::AdaptiveTaylor;
use crate::scheme::taylor::TaylorSeries;

/// A [`Series`] over flat slices.
pub trait AnySeries: Sync {
    /// Runs the continuous equations by [`TaylorSeries`] of the given order and shows states to `observer`, which may stop
    /// it.
    fn simulate(
        &self,
        run: &Run,
        order: usize,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError>;
    /// The same by [`AdaptiveTaylor`], with steps as long as `tolerance` allows; the step of `run` is that of its outputs.
    fn simulate_within(
        &self,
        run: &Run,
        tolerance: Tolerance,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError>;
}

/// `M` as an [`AnySeries`].
pub struct ErasedSeries<M>(PhantomData<fn() -> M>);

impl<M> ErasedSeries<M> {
    /// The only value.
    pub const NEW: Self = Self(PhantomData);
}

impl<M: Series<f64>> AnySeries for ErasedSeries<M> {
    fn simulate(
        &self,
        run: &Run,
        order: usize,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        let (parameters, start) = run.records::<M, f64>()?;
        let integration = TaylorSeries::<M>::new(parameters, start, run.h)?.at(run.t0)?;
        run.through(integration.with_order(order), observer)
    }

    fn simulate_within(
        &self,
        run: &Run,
        tolerance: Tolerance,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        let (parameters, start) = run.records::<M, f64>()?;
        let integration = AdaptiveTaylor::<M>::new(parameters, start, run.h)?.at(run.t0)?;
        run.through(integration.with_tolerance(tolerance), observer)
    }
}
