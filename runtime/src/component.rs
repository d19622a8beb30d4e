//! Names of scalar components, for messages.

use core::fmt;

use crate::description::Equation;
use crate::description::Unknown;
use crate::description::Variable;

/// One scalar of a flat array of named variables. Displays as in the file: `ω`, `Γ.y`, `J(1,2)`.
#[derive(Debug, Clone, Copy)]
pub struct Component {
    /// The variables behind the array.
    pub variables: &'static [Variable],
    /// Position in the array.
    pub position: usize,
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = |variable: &Variable| variable.rows * variable.cols;
        match locate(self.variables, size, self.position) {
            Some((_, variable, i)) if variable.cols > 1 => {
                let (row, col) = (i / variable.cols + 1, i % variable.cols + 1);
                write!(f, "{}({row},{col})", variable.name)
            }
            Some((_, variable, i)) => {
                f.write_str(variable.name)?;
                write_pick(f, variable.rows, i)
            }
            None => write!(f, "component {}", self.position),
        }
    }
}

/// Writes a row of the residual as `equation 2, `4*(Γ[k+1] - Γ) = 0` (line 19)`.
pub(crate) fn write_equation(
    f: &mut fmt::Formatter<'_>,
    equations: &'static [Equation],
    row: usize,
) -> fmt::Result {
    let Some((number, equation, i)) = locate(equations, |equation| equation.len, row) else {
        return write!(f, "residual component {row}");
    };
    write!(f, "equation {}", number + 1)?;
    write_pick(f, equation.len, i)?;
    write!(f, ", `{}` (line {})", equation.text, equation.line)
}

/// Writes an unknown as `unknown ΔΓ.y`.
pub(crate) fn write_unknown(
    f: &mut fmt::Formatter<'_>,
    unknowns: &'static [Unknown],
    position: usize,
) -> fmt::Result {
    let Some((_, unknown, i)) = locate(unknowns, |unknown| unknown.len, position) else {
        return write!(f, "unknown component {position}");
    };
    write!(f, "unknown {}", unknown.name)?;
    write_pick(f, unknown.len, i)
}

/// The block that holds a flat position: its number, itself, and the offset in it.
fn locate<B>(
    blocks: &'static [B],
    size: impl Fn(&B) -> usize,
    position: usize,
) -> Option<(usize, &'static B, usize)> {
    let mut offset = position;
    for (number, block) in blocks.iter().enumerate() {
        if offset < size(block) {
            return Some((number, block, offset));
        }
        offset -= size(block);
    }
    None
}

/// Writes the pick of component `i` (from 0) of a vector with `len` components: nothing, `.y` or `(4)`.
fn write_pick(f: &mut fmt::Formatter<'_>, len: usize, i: usize) -> fmt::Result {
    match (len, i) {
        (1, _) => Ok(()),
        (2..=3, 0) => f.write_str(".x"),
        (2..=3, 1) => f.write_str(".y"),
        (2..=3, _) => f.write_str(".z"),
        (_, i) => write!(f, "({})", i + 1),
    }
}

#[cfg(test)]
mod tests;
