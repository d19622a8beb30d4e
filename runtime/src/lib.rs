//! Newton solvers for discrete equations of motion, generated from model files.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate self as residua;
#[cfg(test)]
extern crate std;

mod component;
pub mod description;
pub mod erased;
mod error;
mod integration;
mod linear;
mod model;
mod newton;
mod report;
mod runge_kutta;
mod scalar;
mod settings;
#[cfg(test)]
mod specimens;
mod stepper;
mod stumpff;

pub use component::Component;
pub use description::Description;
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
pub use linear::Solvable;
pub use linear::SquareMatrix;
pub use model::Flow;
pub use model::Model;
pub use model::Record;
pub use model::StateArray;
pub use model::System;
pub use report::History;
pub use report::Report;
pub use report::Statistics;
pub use report::Success;
pub use runge_kutta::Explicit;
pub use runge_kutta::RungeKutta4;
pub use scalar::Real;
pub use scalar::Scalar;
pub use settings::Settings;
pub use stepper::Implicit;
pub use stepper::Stepper;
