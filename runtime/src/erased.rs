//! Models behind one face: flat slices of `f64` in and out, for programs that pick models at run time.
//!
//! Generated code puts a [`Catalogued`] into a static; the command and generic tests work on that alone.
//! Slices are in file order, matrices row by row, and must have the lengths of the description: the
//! `simulate` functions check that, the others panic, as indexing does.

mod flow;
mod model;
mod scheme;
mod series;
mod simulate;
#[cfg(feature = "single")]
mod single;
mod solver;

pub use flow::AnyFlow;
pub use flow::ErasedFlow;
pub use model::AnyModel;
pub use model::ErasedModel;
pub use scheme::Embedded;
pub use scheme::Scheme;
pub use series::AnySeries;
pub use series::ErasedSeries;
pub use simulate::Observer;
pub use simulate::Run;
pub use simulate::Sample;
pub use solver::AnySolver;
pub use solver::Differentiable;
pub use solver::ErasedSolver;
pub use solver::Point;

#[cfg(feature = "ensemble")]
pub(crate) use model::parameters;
#[cfg(feature = "ensemble")]
pub(crate) use model::state;

use crate::description::Description;

/// A model with its solvers.
#[derive(Clone, Copy)]
pub struct Catalogued {
    /// What the model says about itself.
    pub description: &'static Description,
    /// Default values and outputs.
    pub model: &'static dyn AnyModel,
    /// In the order of [`Description::solvers`].
    pub solvers: &'static [&'static dyn AnySolver],
    /// The continuous equations, if the file has them.
    pub flow: Option<&'static dyn AnyFlow>,
    /// Their Taylor series, if the generator has found recurrences for all that is in them.
    pub series: Option<&'static dyn AnySeries>,
}

impl Catalogued {
    /// What a model with errors leaves behind, so that its errors are all that the compiler reports. The
    /// name only shows in the expansion: the program is never built.
    pub const fn stub(_name: &'static str) -> Self {
        Self {
            description: &NOTHING,
            model: &model::Stub,
            solvers: &[],
            flow: None,
            series: None,
        }
    }
}

static NOTHING: Description = Description {
    name: "",
    doc: "",
    parameters: &[],
    states: &[],
    outputs: &[],
    solvers: &[],
    claims: &[],
    requirements: &[],
    has_flow: false,
    no_series: None,
    counts: &[],
    operations: 0,
    scene: None,
};
