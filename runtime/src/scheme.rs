//! Schemes for the continuous equations of a model: all that a `flow` is integrated with.

mod composition;
mod controlled;
mod dormand_prince;
mod extended;
mod gauss;
mod runge_kutta;
pub mod taylor;
mod trapezoidal;
mod variable;

pub use composition::Composed;
pub use composition::Composition;
pub use controlled::Adaptive;
pub use controlled::Controlled;
pub use dormand_prince::DormandPrince5;
pub use dormand_prince::Pair;
pub use gauss::Collocated;
pub use gauss::Collocation;
pub use gauss::Gauss;
pub use gauss::VariableGauss;
pub use runge_kutta::Explicit;
pub use runge_kutta::RungeKutta4;
pub use trapezoidal::Ends;
pub use trapezoidal::Trapezoidal;
pub use variable::Attempt;
pub use variable::Tolerance;
pub use variable::Variable;

use crate::integration::FlatState;
use crate::model::Flow;
use crate::scalar::Scalar;

/// dx/dt, compiled once: flows are inlined where all stages are computed at a time, and that is where it pays.
#[inline(never)]
pub(crate) fn rates<M: Flow<T>, T: Scalar>(
    scene: &M::FlowScene,
    t: T,
    x: &FlatState<M, T>,
) -> FlatState<M, T> {
    M::flow(scene, t, x)
}
