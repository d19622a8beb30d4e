//! Exact motions to measure the models against.
//!
//! | motion | from | |
//! |---|---|---|
//! | planar pendulum | Jacobi's elliptic functions | [`PlanarPendulum`] |
//! | free body, angular velocity | Jacobi's elliptic functions | [`FreeBody`] |
//! | 3D pendulum | the model's own `flow`, extrapolated until it converges | [`SpatialPendulum`] |
//! | any model with a `flow` | the same | [`Extended`] |
//!
//! All compute in double-double numbers ([`Double`], 31 digits) and round once, at the end.

mod double;
mod elliptic;
mod error;
mod extrapolation;
mod flow;
mod free_body;
mod planar;
mod reference;
mod spatial;

pub use double::Double;
pub use double::NotDecimal;
pub use elliptic::Elliptic;
pub use elliptic::Jacobi;
pub use error::Invalid;
pub use flow::Extended;
pub use flow::Probe;
pub use flow::Reference;
pub use flow::WithoutFlow;
pub use free_body::FreeBody;
pub use planar::PlanarPendulum;
pub use planar::PlanarState;
pub use planar::Regime;
pub use reference::reference;
pub use spatial::Solution;
pub use spatial::SpatialPendulum;
pub use spatial::SpatialState;
pub use spatial::rotation;
