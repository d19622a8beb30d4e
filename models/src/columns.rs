//! What a row of a run holds: `t`, states, observables, invariants.

use crate::notation::components;
use residua::description::{Description, Variable};

/// The columns of a run: `t`, states, observables, invariants.
pub fn header(description: &Description) -> Vec<String> {
    let states = description.states.iter();
    let outputs = ordered_outputs(description);
    let variables = states.chain(outputs.iter().map(|output| output.variable));
    std::iter::once("t".to_owned())
        .chain(variables.flat_map(components))
        .collect()
}

/// An output and where it stands in the flat list of outputs.
pub struct Placed {
    /// Name, shape, unit.
    pub variable: &'static Variable,
    /// Constant along solutions.
    pub invariant: bool,
    /// Position of its first component.
    pub offset: usize,
}

/// Observables, then invariants, each in file order.
pub fn ordered_outputs(description: &Description) -> Vec<Placed> {
    let mut offset = 0;
    let mut placed = Vec::new();
    for output in description.outputs {
        placed.push(Placed {
            variable: &output.variable,
            invariant: output.invariant,
            offset,
        });
        offset += size(&output.variable);
    }
    placed.sort_by_key(|output| output.invariant);
    placed
}

/// Number of components.
pub fn size(variable: &Variable) -> usize {
    variable.rows * variable.cols
}

/// Number of components of several variables.
pub fn total<'v>(variables: impl IntoIterator<Item = &'v Variable>) -> usize {
    variables.into_iter().map(size).sum()
}
