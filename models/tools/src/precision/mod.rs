//! Work–precision: how long every scheme takes on every formulation of a motion, and how far from the exact one it ends.
//!
//! | stage | from | to |
//! |---|---|---|
//! | [`Problem::new`] | the name of a scene | the exact end, and the models that take the same motion |
//! | [`contestants`] | a problem | schemes on its formulations, ours and with the feature `rivals` those of others |
//! | [`measure`] | contestants, their ladders of steps and tolerances | a [`Row`] per run |
//! | [`verdicts`], [`write()`], [`picture`] | rows | sentences, CSV, SVG |
//!
//! Steps are h = T/2ᵏ, tolerances powers of ten: nothing is tuned to an answer that is known. Times are the shortest of
//! some runs after one that is not timed. What fails is NaN, and NaN is never the best.

mod contest;
mod diagram;
mod given;
mod integrator;
mod measure;
mod meter;
mod problem;
mod row;
mod verdict;

pub use contest::Contestant;
pub use contest::Ladders;
pub use contest::Rung;
pub use contest::contestants;
pub use diagram::name;
pub use diagram::picture;
pub use given::Given;
pub use measure::Budget;
pub use measure::measure;
pub use meter::Errors;
pub use problem::Formulation;
pub use problem::Problem;
pub use problem::Unsolvable;
pub use row::Kind;
pub use row::OURS;
pub use row::Row;
pub use row::read;
pub use row::write;
pub use verdict::LEVELS;
pub use verdict::Verdict;
pub use verdict::verdicts;
