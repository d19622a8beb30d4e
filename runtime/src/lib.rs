//! Newton solvers for discrete equations of motion, generated from model files.
//!
//! A model file holds the equations as a paper prints them:
//!
//! ```text
//! model! {
//!     /// Pendulum by the implicit midpoint rule.
//!     param c: 1/s^2 = 9.81;
//!     state θ: rad;
//!     state ω: 1/s;
//!     residual {
//!         der(θ) - ω[k+1/2] = 0;
//!         der(ω) + c*sin(θ[k+1/2]) = 0;
//!     }
//!     solve for next;
//!     start { θ = 1; ω = 0.5; }
//! }
//! ```
//!
//! From it `model!` (feature `macros`) writes a module with `Parameters`, `State` and `Outputs`, with the
//! [`Model`] and its solvers, such as `Next`, each a [`System`]. This crate steps them:
//!
//! ```
//! # mod pendulum { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/src/specimens/pendulum.rs")); }
//! use pendulum::{Model, Next, Parameters};
//! use residua::{Model as _, Stepper};
//!
//! let parameters = Parameters { c: 4.0, ..Parameters::default() };
//! let start = Model::start(&parameters);
//! let mut stepper = Stepper::<Next>::new(parameters, start, 0.01)?;
//! for _ in 0..100 {
//!     stepper.step()?;
//! }
//! assert_eq!(stepper.t(), 1.0);
//! assert!((stepper.outputs().energy - (0.125 - 4.0 * 1.0_f64.cos())).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`Stepper`] solves the discrete equations by Newton's method. The continuous ones are integrated by [`Gauss`]
//!   collocation, a [`Composition`] of midpoint rules, the [`Trapezoidal`] rule, [`RungeKutta4`] or [`taylor`] series, and in
//!   steps that follow their error by an [`Adaptive`] run or [`DormandPrince5`]. All of them are an [`Integration`]. Time is
//!   t₀ + k h, never a sum of steps.
//! - A step allocates nothing, and neither does a failed one: the state stays as it was, and [`StepError`]
//!   says which equation, when, and by how much.
//! - Everything works on any [`Scalar`], Newton's method on any [`Real`]: `f64` and `f32`.
//! - `scene!` makes such a module for one run of a model, with nothing in it that the run does not need.
//! - [`Catalogued`] is the door for programs that pick models at run time.
//!
//! Features: `std` takes `sin` and its kin from the standard library, without it they come from `libm`, and
//! nothing here needs an operating system; `macros` re-exports `model!` and `scene!`; `dual` adds derivatives by dual
//! numbers, to check Jacobians with, and needs `std`; `ensemble` adds [`Ensemble`], many trajectories at a time, and
//! needs `std`.

#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate self as residua;
#[cfg(any(test, feature = "ensemble"))]
extern crate std;

mod compensated;
mod component;
pub mod convolution;
pub mod description;
#[cfg(feature = "ensemble")]
mod ensemble;
pub mod erased;
mod error;
mod integration;
mod lanes;
mod linear;
mod model;
mod newton;
mod packed;
mod report;
mod requirement;
mod resolution;
mod scalar;
mod scheme;
mod sensitivity;
mod settings;
mod shifts;
#[cfg(test)]
mod specimens;
mod stepper;
mod stumpff;

pub use component::Component;
pub use description::Description;
#[cfg(feature = "ensemble")]
pub use ensemble::Ensemble;
#[cfg(feature = "ensemble")]
pub use ensemble::Fill;
#[cfg(feature = "ensemble")]
pub use ensemble::Fleet;
#[cfg(feature = "ensemble")]
pub use ensemble::Given;
#[cfg(feature = "ensemble")]
pub use ensemble::Outcome;
#[cfg(feature = "ensemble")]
pub use ensemble::WIDTH;
#[cfg(feature = "ensemble")]
pub use ensemble::Wide;
pub use erased::Catalogued;
pub use error::Failure;
pub use error::Fault;
pub use error::InvalidRun;
pub use error::Place;
pub use error::RunError;
pub use error::StepError;
pub use integration::FlatState;
pub use integration::Integration;
pub use integration::Method;
pub use lanes::Lanes;
pub use linear::Correctable;
pub use linear::Solvable;
pub use linear::SquareMatrix;
pub use model::Cache;
pub use model::Flow;
pub use model::Model;
pub use model::Record;
pub use model::Series;
pub use model::StateArray;
pub use model::System;
pub use packed::Arithmetic;
pub use packed::Each;
pub use packed::Pack;
pub use packed::Packed;
pub use packed::Plain;
pub use packed::Work;
pub use report::History;
pub use report::Report;
pub use report::Statistics;
pub use report::Success;
pub use requirement::Relation;
pub use requirement::unmet;
#[cfg(feature = "macros")]
pub use residua_macros::*;
pub use resolution::rounding;
pub use scalar::Real;
pub use scalar::Rounded;
pub use scalar::Scalar;
pub use scheme::Adaptive;
pub use scheme::Attempt;
pub use scheme::Collocated;
pub use scheme::Collocation;
pub use scheme::Composed;
pub use scheme::Composition;
pub use scheme::Controlled;
pub use scheme::DormandPrince5;
pub use scheme::Ends;
pub use scheme::Explicit;
pub use scheme::Gauss;
pub use scheme::Pair;
pub use scheme::RungeKutta4;
pub use scheme::Tolerance;
pub use scheme::Trapezoidal;
pub use scheme::Variable;
pub use scheme::VariableGauss;
pub use scheme::taylor;
pub use settings::Settings;
pub use settings::Strategy;
pub use stepper::Implicit;
pub use stepper::Stepper;
