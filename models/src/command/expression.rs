//! Values given on the command line, in the language of the model files.

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
    _symbols: &[Symbol<'_>],
) -> Result<Vec<f64>, String> {
    let v: Option<Vec<f64>> = text
        .trim_matches(['[', ']'])
        .split(',')
        .map(|x| x.trim().parse().ok())
        .collect();
    let v = v.ok_or("not a number")?;
    if v.len() == shape.0 * shape.1 {
        Ok(v)
    } else {
        Err("shape".into())
    }
}
