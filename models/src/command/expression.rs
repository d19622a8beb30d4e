//! Values given on the command line, in the language of the model files.

use residua_codegen::model::Shape;

/// A name that an expression may use.
pub struct Symbol<'a> {
    /// As in the file: `ω`.
    pub name: &'a str,
    /// Rows and columns.
    pub shape: (usize, usize),
    /// Components row by row.
    pub values: Vec<f64>,
}

/// The components of `text`, which must have `shape`, row by row.
pub fn evaluate(
    text: &str,
    shape: (usize, usize),
    symbols: &[Symbol<'_>],
) -> Result<Vec<f64>, String> {
    let shaped = |(rows, cols)| Shape { rows, cols };
    let symbols: Vec<_> = symbols
        .iter()
        .map(|s| (s.name, shaped(s.shape), s.values.as_slice()))
        .collect();
    residua_codegen::evaluate(text, shaped(shape), &symbols)
}
