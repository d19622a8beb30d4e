//! From residuals and their derivatives to a solvable system in block-triangular order.

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::pattern::Pattern;
use crate::rank::dependent_rows;
use crate::sample::Sample;
use crate::system::Block;
use crate::system::Entry;

/// Generic points at which a block must be singular before its equations are called dependent.
const POINTS: u64 = 4;

/// The block-triangular order of the solver whose Jacobian has `entries`.
///
/// # Errors
/// Unknowns that no equation determines, and equations that follow from others: the Jacobian is singular
/// whatever the numbers are.
pub fn structure(
    model: &Model,
    dag: &Dag,
    residual: &[NodeId],
    entries: &[Entry],
) -> Result<Vec<Block>, Errors> {
    let n = model.n_unknowns();
    let pairs = entries.iter().map(|e| (e.row, e.col));
    let matching = Pattern::new(n, pairs.clone()).matching();
    let equation_of: Vec<usize> = matching.iter().flatten().copied().collect();
    if equation_of.len() < n {
        return Err(undetermined(model, entries, &matching));
    }
    let (unknowns, curved) = (dag.unknowns(0), dag.curved());
    let curved: Vec<u128> = residual.iter().map(|root| curved[root.index()]).collect();
    // No equation is solved for an unknown that it does not change with, but for others after that is known.
    let all = (0..n).flat_map(|row| (0..n).map(move |col| (row, col)));
    let needs = all.filter(|(row, col)| unknowns[residual[*row].index()] & 1 << col != 0);
    let pattern = Pattern::new(n, pairs.chain(needs));
    let blocks = pattern.blocks(&equation_of).into_iter();
    let blocks: Vec<Block> = blocks
        .map(|(rows, cols)| block(&unknowns, &curved, entries, rows, cols))
        .collect();
    let mut errors = Errors::default();
    for rows in dependences(dag, &blocks, entries) {
        dependent(model, &rows, &mut errors);
    }
    errors.or(blocks)
}

/// For each block with one the rows of a vanishing combination of its equations. It vanishes at all points where the
/// entries of the block have a value.
fn dependences(dag: &Dag, blocks: &[Block], entries: &[Entry]) -> Vec<Vec<usize>> {
    let nodes: Vec<_> = entries.iter().map(|entry| entry.node).collect();
    let tape = dag.tape(&nodes);
    let mut doubtful: Vec<(&Block, Vec<usize>)> = blocks.iter().map(|b| (b, Vec::new())).collect();
    for number in 0..POINTS {
        if doubtful.is_empty() {
            break;
        }
        let point = Sample::generic(number);
        let values = tape.evaluate(|leaf| point.value(leaf));
        doubtful.retain_mut(|(block, found)| {
            let matrix = matrix(block, entries, &values);
            if !matrix.iter().flatten().all(|entry| entry.is_finite()) {
                return true;
            }
            let rows = dependent_rows(&matrix);
            let is_singular = rows.is_some();
            *found = rows.into_iter().flatten().map(|i| block.rows[i]).collect();
            is_singular
        });
    }
    let found = doubtful.into_iter().map(|(_, rows)| rows);
    found.filter(|rows| !rows.is_empty()).collect()
}

/// The Jacobian of a block from the values of all entries.
fn matrix(block: &Block, entries: &[Entry], values: &[f64]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; block.cols.len()]; block.rows.len()];
    for (entry, value) in entries.iter().zip(values) {
        let row = block.rows.binary_search(&entry.row);
        let col = block.cols.binary_search(&entry.col);
        if let (Ok(row), Ok(col)) = (row, col) {
            matrix[row][col] = *value;
        }
    }
    matrix
}

/// Says which equations follow from each other.
fn dependent(model: &Model, rows: &[usize], errors: &mut Errors) {
    let mut involved = Vec::new();
    let mut offset = 0;
    for equation in &model.residual {
        let own = offset..offset + equation.shape.len();
        offset = own.end;
        if rows.iter().any(|row| own.contains(row)) {
            involved.push(equation);
        }
    }
    let Some((last, others)) = involved.split_last() else {
        return;
    };
    let message = match others {
        [] => "the Jacobian is singular everywhere: this equation does not determine its unknowns"
            .to_owned(),
        _ => {
            let others = others
                .iter()
                .map(|e| format!("`{}` in line {}", e.text, e.range.line()));
            format!(
                "the Jacobian is singular everywhere: in its unknowns this equation says what {} says",
                others.collect::<Vec<_>>().join(" and ")
            )
        }
    };
    errors.push_with_help(
        last.range,
        message,
        "check that each equation says something new",
    );
}

/// A block and whether its equations are linear in its unknowns; `unknowns` are those that each node depends on, `curved` those that
/// stand in functions and powers in each equation.
fn block(
    unknowns: &[u128],
    curved: &[u128],
    entries: &[Entry],
    rows: Vec<usize>,
    cols: Vec<usize>,
) -> Block {
    let own = cols.iter().fold(0, |mask, col| mask | 1 << col);
    let inside = |e: &&Entry| rows.contains(&e.row) && cols.contains(&e.col);
    let linear = entries
        .iter()
        .filter(inside)
        .all(|e| unknowns[e.node.index()] & own == 0);
    let linear = linear && rows.iter().all(|row| curved[*row] & own == 0);
    Block { rows, cols, linear }
}

/// Says which unknowns are left over, and whether they occur at all.
fn undetermined(model: &Model, entries: &[Entry], matching: &[Option<usize>]) -> Errors {
    let mut errors = Errors::default();
    for (col, (solved, component)) in model.unknown_components().enumerate() {
        if matching[col].is_some() {
            continue;
        }
        let variable = model.solved_variable(solved);
        let name = &variable.name;
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
    errors
}
