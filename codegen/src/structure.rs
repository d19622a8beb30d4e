//! From residuals and their derivatives to a solvable system in block-triangular order.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::pattern::Pattern;
use crate::system::Block;
use crate::system::Entry;

/// The block-triangular order of the solver whose Jacobian has `entries`.
///
/// # Errors
/// Unknowns that no equation determines: the Jacobian is singular whatever the numbers are.
pub fn structure(model: &Model, dag: &Dag, entries: &[Entry]) -> Result<Vec<Block>, Errors> {
    let n = model.n_unknowns();
    let pattern = Pattern::new(n, entries.iter().map(|e| (e.row, e.col)));
    let matching = pattern.matching();
    let equation_of: Vec<usize> = matching.iter().flatten().copied().collect();
    if equation_of.len() < n {
        return Err(undetermined(model, entries, &matching));
    }
    let blocks = pattern.blocks(&equation_of).into_iter();
    Ok(blocks
        .map(|(rows, cols)| block(dag, entries, rows, cols))
        .collect())
}

/// A block and whether its equations are linear in its unknowns.
fn block(dag: &Dag, entries: &[Entry], rows: Vec<usize>, cols: Vec<usize>) -> Block {
    let depends = dag.dependence(|leaf| matches!(leaf, Leaf::Unknown(i) if cols.contains(&i)));
    let inside = |e: &&Entry| rows.contains(&e.row) && cols.contains(&e.col);
    let linear = entries
        .iter()
        .filter(inside)
        .all(|e| !depends[e.node.index()]);
    Block { rows, cols, linear }
}

/// Says which unknowns are left over, and whether they occur at all.
fn undetermined(model: &Model, entries: &[Entry], matching: &[Option<usize>]) -> Errors {
    let mut errors = Errors::default();
    let mut offset = 0;
    for &solved in &model.solved {
        let variable = model.solved_variable(solved);
        let name = &variable.name;
        for component in 0..variable.shape.len() {
            let col = offset + component;
            if matching[col].is_some() {
                continue;
            }
            let unknown = format!("{}{}", name.display, variable.component_suffix(component));
            if entries.iter().any(|e| e.col == col) {
                errors.push_with_help(
                    name.range,
                    format!(
                        "the equations are structurally singular: they do not determine `{unknown}`"
                    ),
                    "some equations share too few unknowns; check that each says something new",
                );
            } else {
                errors.push(
                    name.range,
                    format!("no equation contains the unknown `{unknown}`"),
                );
            }
        }
        offset += variable.shape.len();
    }
    errors
}
