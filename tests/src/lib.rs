//! What the tests share: equations and Jacobians written by hand, and the arithmetic to judge them with.

pub mod measured;
pub mod number;
pub mod points;
pub mod reference;
