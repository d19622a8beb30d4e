//! Default values and outputs over flat slices.

use core::marker::PhantomData;

use crate::model::Model;
use crate::model::Record;
use crate::scalar::Scalar;

/// A [`Model`] over flat slices.
pub trait AnyModel: Sync {
    /// Overwrites `out` with the parameters of the file.
    fn defaults(&self, out: &mut [f64]);
    /// Overwrites `out` with the start values of the file for these parameters.
    fn start(&self, parameters: &[f64], out: &mut [f64]);
    /// Overwrites `out` with the invariants and observables at `t` and `state` of a run with step `h`.
    fn outputs(&self, parameters: &[f64], h: f64, t: f64, state: &[f64], out: &mut [f64]);
    /// Whether they meet a requirement of the file, by its position in the description.
    fn meets(&self, requirement: usize, parameters: &[f64], h: f64, state: &[f64]) -> bool;
}

/// `M` as an [`AnyModel`].
pub struct ErasedModel<M>(PhantomData<fn() -> M>);

impl<M> ErasedModel<M> {
    /// The only value.
    pub const NEW: Self = Self(PhantomData);
}

impl<M: Model<f64>> AnyModel for ErasedModel<M> {
    fn defaults(&self, out: &mut [f64]) {
        write(&M::Parameters::default(), out);
    }

    fn start(&self, parameters: &[f64], out: &mut [f64]) {
        write(&M::start(&self::parameters::<M, f64>(parameters)), out);
    }

    fn outputs(&self, parameters: &[f64], h: f64, t: f64, state: &[f64], out: &mut [f64]) {
        let parameters = self::parameters::<M, f64>(parameters);
        let state = self::state::<M, f64>(&parameters, state);
        write(&M::outputs(&parameters, h, t, &state), out);
    }

    fn meets(&self, requirement: usize, parameters: &[f64], h: f64, state: &[f64]) -> bool {
        let parameters = self::parameters::<M, f64>(parameters);
        let state = self::state::<M, f64>(&parameters, state);
        M::meets(requirement, &parameters, h, &state)
    }
}

/// What a model with errors leaves behind.
pub(super) struct Stub;

impl AnyModel for Stub {
    fn defaults(&self, _out: &mut [f64]) {}

    fn start(&self, _parameters: &[f64], _out: &mut [f64]) {}

    fn outputs(&self, _parameters: &[f64], _h: f64, _t: f64, _state: &[f64], _out: &mut [f64]) {}

    fn meets(&self, _requirement: usize, _parameters: &[f64], _h: f64, _state: &[f64]) -> bool {
        true
    }
}

/// The parameters of `M` with these values.
pub(crate) fn parameters<M: Model<T>, T: Scalar>(values: &[f64]) -> M::Parameters {
    filled(&M::Parameters::default(), values)
}

/// The state of `M` with these values.
pub(crate) fn state<M: Model<T>, T: Scalar>(
    parameters: &M::Parameters,
    values: &[f64],
) -> M::State {
    filled(&M::start(parameters), values)
}

/// A record like `shape`, which only serves to make its array, with other values.
fn filled<R: Record<T>, T: Scalar>(shape: &R, values: &[f64]) -> R {
    let mut array = shape.to_array();
    fill(&mut array, values);
    R::from_array(array)
}

/// Overwrites all components of `array`.
pub(super) fn fill<T: Scalar>(array: &mut impl AsMut<[T]>, values: &[f64]) {
    let components = array.as_mut();
    let (expected, found) = (components.len(), values.len());
    assert!(
        expected == found,
        "expected {expected} values, found {found}"
    );
    for (component, value) in components.iter_mut().zip(values) {
        *component = T::constant(*value);
    }
}

fn write<R: Record<f64>>(record: &R, out: &mut [f64]) {
    out.copy_from_slice(record.to_array().as_ref());
}
