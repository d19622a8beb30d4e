//! Equations in the docs of emitted functions.

use crate::model::Equation;

/// `, lines 19 to 20`
pub(super) fn lines(equations: &[Equation]) -> String {
    match equations {
        [] => String::new(),
        [only] => format!(", line {}", only.range.line()),
        [first, .., last] => format!(", lines {} to {}", first.range.line(), last.range.line()),
    }
}

/// Doc lines with the text of each equation and the rows it stands for.
pub(super) fn rows(equations: &[Equation]) -> Vec<String> {
    let mut docs = vec![String::new()];
    let mut first = 0;
    for equation in equations {
        let next = first + equation.shape.len();
        let rows = match next - first {
            1 => format!("row {first}"),
            _ => format!("rows {first} to {}", next - 1),
        };
        docs.push(format!(" - {rows}: `{}`", equation.text));
        first = next;
    }
    docs
}
