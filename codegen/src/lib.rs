//! The Residua generator.
//!
//! One public function per stage, from one data type to the next:
//!
//! | stage | from | to | afterwards |
//! |---|---|---|---|
//! | [`parse`] | tokens | [`ast::Ast`] | the text is a list of statements |
//! | [`check`] | `Ast` | [`model::Model`] | names, shapes and units are right, `let`s are gone |
//! | [`lower`] | `Model` | [`system::Equations`] and residuals | scalars only, no time levels |
//! | [`specialise`] | `Equations`, residuals | the same | nothing in it that a scene does not need |
//! | [`differentiate`] | residuals | Jacobian entries | exact, structural non-zeros only |
//! | [`structure`] | residuals, entries | [`system::System`] | solvable, in block order |
//! | [`eliminate`] | `System` | [`system::Reduced`] | what is iterated on is as small as it can be |
//! | [`taylor`] | rates | [`system::Series`] | recurrences for Taylor coefficients |
//! | [`stage`] | `System` | [`schedule::Schedule`] | each value at its rate |
//! | [`emit`] | `Schedule` | Rust | |
//!
//! [`compile()`] runs them. Simplification is no pass: the constructors of [`normal`] keep every node of
//! the [`dag::Dag`] in normal form from the start, so derivatives never grow first and shrink later.

pub mod ast;
pub mod change;
pub mod check;
pub mod claims;
pub mod clear;
pub mod compile;
pub mod correct;
pub mod dag;
pub mod diagnostic;
pub mod differentiate;
pub mod eliminate;
pub mod emit;
pub mod explicit;
pub mod finding;
pub mod finite;
pub mod function;
pub mod index;
pub mod linear;
pub mod lower;
pub mod matrix;
pub mod model;
pub mod normal;
pub mod parse;
pub mod pattern;
pub mod rank;
pub mod sample;
pub mod scene;
pub mod schedule;
pub mod similar;
pub mod source;
pub mod specialise;
pub mod stage;
pub mod structure;
pub mod system;
pub mod taylor;
pub mod trace;
pub mod unit;

pub use compile::Analysis;
pub use compile::Quantity;
pub use compile::Scene;
pub use compile::analyse;
pub use compile::analyse_scene;
pub use compile::compile;
pub use compile::compile_scene;
pub use compile::evaluate;
pub use compile::expand;
pub use compile::expand_scene;
pub use compile::model_of_scene;
