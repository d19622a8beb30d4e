//! Schemes for the continuous equations of a model: all that a `flow` is integrated with.

mod composition;
mod controlled;
mod dormand_prince;
mod gauss;
mod runge_kutta;
pub mod taylor;
mod trapezoidal;

pub use composition::Composed;
pub use composition::Composition;
pub use controlled::Adaptive;
pub use controlled::Attempt;
pub use controlled::Controlled;
pub use controlled::Tolerance;
pub use controlled::Variable;
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
