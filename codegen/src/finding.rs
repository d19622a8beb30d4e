//! What came of a claim.

/// A printed Jacobian compared with the derivative.
#[derive(Clone, Debug)]
pub struct Finding {
    /// What the author calls it.
    pub label: String,
    /// Its line in the file.
    pub line: usize,
    /// What differs; empty if the claim is right.
    pub differences: Vec<Difference>,
}

/// An entry, or a block of the wrong shape, in which a claim differs from the derivative.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Row, counted from 0.
    pub row: usize,
    /// Column, counted from 0.
    pub col: usize,
    /// Which derivative: `∂(equation 2.x)/∂(Δω)`.
    pub entry: String,
    /// What is printed.
    pub printed: String,
    /// The derivative.
    pub derived: String,
    /// Both at a generic point; NaN where there is no number to give.
    pub values: (f64, f64),
}
