//! Schemes for the continuous equations.

pub mod taylor;
