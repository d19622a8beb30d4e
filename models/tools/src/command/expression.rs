//! Values given on the command line, in the language of the model files.

use residua_codegen::Quantity;
use residua_codegen::model::Shape;

/// What is given a value, or may be named in one.
pub struct Symbol<'a> {
    /// As in the file: `ω`; for a component as in the argument.
    pub name: &'a str,
    /// Rows and columns.
    pub shape: (usize, usize),
    /// As in the description.
    pub unit: &'a str,
}

impl<'a> Symbol<'a> {
    fn quantity(&self) -> Quantity<'a> {
        let (rows, cols) = self.shape;
        Quantity {
            name: self.name,
            shape: Shape { rows, cols },
            unit: self.unit,
        }
    }
}

/// The components of `text`, a value of `target`, row by row. It may use `symbols`, each with its
/// components.
pub fn evaluate(
    text: &str,
    target: &Symbol<'_>,
    symbols: &[(Symbol<'_>, Vec<f64>)],
) -> Result<Vec<f64>, String> {
    let symbols: Vec<_> = symbols
        .iter()
        .map(|(symbol, values)| (symbol.quantity(), values.as_slice()))
        .collect();
    residua_codegen::evaluate(text, target.quantity(), &symbols)
}
