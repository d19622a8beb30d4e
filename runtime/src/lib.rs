//! contract, see files
pub mod description;
pub mod model;
pub mod scalar;
