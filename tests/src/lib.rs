//! What the tests share: equations and Jacobians written by hand, and the arithmetic to judge them with.

pub mod case;
pub mod measured;
pub mod mutations;
pub mod number;
pub mod points;
pub mod printed;
pub mod race;
pub mod reference;
pub mod reference_data;
pub mod rivals;
