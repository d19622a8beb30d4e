//! What a row of a run holds: `t`, states, observables, invariants.

use crate::notation::components;
use residua::description::{Description, Variable};
use residua_models::values::size;

/// The columns of a run: `t`, states, observables, invariants.
pub fn header(description: &'static Description) -> Vec<String> {
    let states = kept_states(description).map(|(_, state)| state);
    let outputs = ordered_outputs(description);
    let variables = states.chain(outputs.iter().map(|output| output.variable));
    std::iter::once("t".to_owned())
        .chain(variables.flat_map(components))
        .collect()
}

/// The states that are shown, each with the position of its first component in the flat state: all of a model, and
/// of a scene those that it keeps for their own sake.
pub fn kept_states(
    description: &'static Description,
) -> impl Iterator<Item = (usize, &'static Variable)> {
    let mut offset = 0;
    let placed = description.states.iter().map(move |state| {
        offset += size(state);
        (offset - size(state), state)
    });
    let is_kept = |state: &Variable| {
        let scene = description.scene;
        scene.is_none_or(|scene| scene.keep.contains(&state.name))
    };
    placed.filter(move |(_, state)| is_kept(state))
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
pub fn ordered_outputs(description: &'static Description) -> Vec<Placed> {
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
