//! What came of a claim.

use crate::ast::ClaimKind;

/// A printed statement compared with what follows from the model.
#[derive(Clone, Debug)]
pub struct Finding {
    /// What it is about.
    pub kind: ClaimKind,
    /// What the author calls it.
    pub label: String,
    /// The label of the claimed residual that a Jacobian belongs to.
    pub of: Option<String>,
    /// Its line in the file.
    pub line: usize,
    /// What differs; empty if the claim is right.
    pub differences: Vec<Difference>,
}

/// An entry of a Jacobian, a component of an equation, or a block of the wrong shape, in which a claim is
/// wrong.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Row, or component of the equations, counted from 0.
    pub row: usize,
    /// Column, counted from 0; 0 in equations.
    pub col: usize,
    /// Which: `∂(equation 2.x)/∂(Δω)`, `equation 2.x`.
    pub entry: String,
    /// What is printed; the right side of an identity.
    pub printed: String,
    /// What it should be; the left side of an identity.
    pub derived: String,
    /// Both at a generic point; NaN where there is no number to give.
    pub values: (f64, f64),
}
