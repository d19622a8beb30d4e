//! Schemes for the continuous equations of a model: all that a `flow` is integrated with.

mod gauss;
mod runge_kutta;

pub use gauss::Collocated;
pub use gauss::Collocation;
pub use gauss::Gauss;
pub use runge_kutta::Explicit;
pub use runge_kutta::RungeKutta4;
