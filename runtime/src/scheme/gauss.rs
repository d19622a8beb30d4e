//! Gauss–Legendre collocation, the stages side by side in vectors.

mod coefficients;
mod newton;
mod sweeps;
mod tableau;
mod variable;
mod workspace;

use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Flow;
use crate::model::Model;
use crate::model::Record;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;

pub(crate) use coefficients::Coefficients;
pub(crate) use coefficients::LANES;
pub(crate) use workspace::Core;

pub use variable::VariableGauss;

/// A flow that Gauss methods can evaluate at all stages at a time. Nothing implements it by hand: generated flows have
/// it.
pub trait Collocated<T: Packed>: Flow<T> + Flow<T::Pack<LANES>> {}

impl<T: Packed, M: Flow<T> + Flow<T::Pack<LANES>>> Collocated<T> for M {}

/// A flat state of eight stages.
pub(crate) type Stages<M, T> =
    <<M as Model<<T as Packed>::Pack<LANES>>>::State as Record<<T as Packed>::Pack<LANES>>>::Array;

/// The flat state of `M`.
pub(crate) type Flat<M, T> = FlatState<M, T>;

/// A run of the continuous equations dx/dt = f(t, x) of the model `M` by Gauss–Legendre collocation with `S` stages,
/// 1 ≤ S ≤ 8:
///
/// Xᵢ = x + h Σⱼ aᵢⱼ f(t + cⱼ h, Xⱼ), x ← x + h Σᵢ bᵢ f(t + cᵢ h, Xᵢ),
///
/// of order 2 S, symmetric, symplectic and A-stable; S = 1 is the implicit midpoint rule. Linear and quadratic invariants
/// are kept to rounding (Cooper 1987), unless the flow is stiff and Newton's method leaves more of them; the energy of
/// Hamiltonian models up to oscillations of order 2 S.
///
/// Source: Kuntzmann (1961), Butcher (1964); Hairer, Lubich and Wanner, *Geometric Numerical Integration*, II.1.3, VI.4.
pub type Gauss<M, const S: usize, T = f64> = Integration<Collocation<M, S, T>, T>;

/// The method of a [`Gauss`].
pub struct Collocation<M: Collocated<T>, const S: usize, T: Packed> {
    core: Core<M, T>,
    pub(super) h: T,
}

impl<M: Collocated<T>, T: Packed> Gauss<M, LANES, T> {
    /// The same run with so many stages: one compiled function for all.
    pub(crate) fn with_stages(mut self, stages: usize) -> Self {
        self.method.core.coefficients = Coefficients::new(stages);
        self
    }
}

impl<M: Collocated<T>, const S: usize, T: Packed> Method<T> for Collocation<M, S, T> {
    type Model = M;

    fn new(parameters: &<M as Model<T>>::Parameters, h: T) -> Self {
        const { assert!(S >= 1 && S <= LANES, "1 to 8 stages") };
        let core = Core::new(parameters, Coefficients::new(S));
        Self { core, h }
    }

    #[inline]
    fn advance(
        &mut self,
        t: T,
        x: &mut Flat<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        self.core.advance(t, x, self.h, statistics)
    }
}

#[inline]
fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// How many linear corrections take what so many take in double precision: twice the digits take twice as many.
fn within_digits<T: Real>(corrections: u32) -> u32 {
    if T::EPSILON.to_f64() < f64::EPSILON {
        2 * corrections
    } else {
        corrections
    }
}

/// The same parameters for all stages.
fn packed_parameters<M: Collocated<T>, T: Packed>(
    parameters: &<M as Model<T>>::Parameters,
) -> <M as Model<T::Pack<LANES>>>::Parameters {
    let mut many = <M as Model<T::Pack<LANES>>>::Parameters::default().to_array();
    let one = parameters.to_array();
    for (many, one) in many.as_mut().iter_mut().zip(one.as_ref()) {
        *many = T::Pack::pack([*one; LANES]);
    }
    Record::from_array(many)
}

/// A state of zeros.
pub(crate) fn zeros<M: Model<T>, T: Real>() -> Flat<M, T> {
    let mut zeros = M::start(&M::Parameters::default()).to_array();
    zeros.as_mut().fill(T::constant(0.0));
    zeros
}

#[cfg(test)]
mod tests;
