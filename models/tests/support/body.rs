//! A motion to measure schemes on.

use residua::Model as _;
use residua::Scalar;
use residua_models::dsl;

/// An asymmetric body off its axis.
pub fn asymmetric<T: Scalar>() -> (
    dsl::spatial_reduced::Parameters<T>,
    dsl::spatial_reduced::State<T>,
) {
    let mut parameters = dsl::spatial_reduced::Parameters::<T>::default();
    let n = T::constant;
    parameters.J = [
        [n(1.0), n(0.1), n(0.0)],
        [n(0.1), n(2.8), n(0.2)],
        [n(0.0), n(0.2), n(2.0)],
    ];
    parameters.rho = [n(0.05), n(0.1), n(0.7)];
    let mut start = dsl::spatial_reduced::Model::start(&parameters);
    start.omega = [n(0.5), n(-0.5), n(0.4)];
    (parameters, start)
}
