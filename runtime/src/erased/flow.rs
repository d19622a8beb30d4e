//! The continuous equations over flat slices.

use core::marker::PhantomData;

use super::model;
use super::scheme::Scheme;
use super::simulate::Observer;
use super::simulate::Run;
use crate::error::RunError;
use crate::model::Flow;
use crate::model::Record;
use crate::report::Statistics;
use crate::scheme::Collocated;

/// A [`Flow`] over flat slices.
pub trait AnyFlow: Sync {
    /// Overwrites `out` with dx/dt at time `t` and state x.
    fn flow(&self, parameters: &[f64], t: f64, state: &[f64], out: &mut [f64]);
    /// Runs the continuous equations by `scheme` and shows states to `observer`, which may stop it.
    fn simulate(
        &self,
        scheme: Scheme,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError>;
}

/// `M` as an [`AnyFlow`].
pub struct ErasedFlow<M>(PhantomData<fn() -> M>);

impl<M> ErasedFlow<M> {
    /// The only value.
    pub const NEW: Self = Self(PhantomData);
}

impl<M: Collocated<f64>> AnyFlow for ErasedFlow<M> {
    fn flow(&self, parameters: &[f64], t: f64, state: &[f64], out: &mut [f64]) {
        let parameters = model::parameters::<M, f64>(parameters);
        let state = model::state::<M, f64>(&parameters, state);
        let scene = <M as Flow<f64>>::flow_scene(&parameters);
        let rates = <M as Flow<f64>>::flow(&scene, t, &state.to_array());
        out.copy_from_slice(rates.as_ref());
    }

    fn simulate(
        &self,
        scheme: Scheme,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        scheme.simulate::<M>(run, observer)
    }
}
