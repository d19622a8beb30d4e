//! From residuals and their derivatives to a solvable system in block-triangular order.

use crate::dag::Dag;
use crate::dag::Leaf;
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
pub fn structure(model: &Model, dag: &Dag, entries: &[Entry]) -> Result<Vec<Block>, Errors> {
    let n = model.n_unknowns();
    let pattern = Pattern::new(n, entries.iter().map(|e| (e.row, e.col)));
    let matching = pattern.matching();
    let equation_of: Vec<usize> = matching.iter().flatten().copied().collect();
    if equation_of.len() < n {
        return Err(undetermined(model, entries, &matching));
    }
    let blocks = pattern.blocks(&equation_of).into_iter();
    let blocks: Vec<Block> = blocks
        .map(|(rows, cols)| block(dag, entries, rows, cols))
        .collect();
    let mut errors = Errors::default();
    let points = (0..POINTS).map(|number| Sample::generic(number).evaluate(dag));
    let points: Vec<Vec<f64>> = points.collect();
    for block in &blocks {
        if let Some(rows) = dependence(block, entries, &points) {
            dependent(model, &rows, &mut errors);
        }
    }
    errors.or(blocks)
}

/// The rows of a vanishing combination of the block's equations, if there is one at all points where its
/// entries have a value.
fn dependence(block: &Block, entries: &[Entry], points: &[Vec<f64>]) -> Option<Vec<usize>> {
    let mut found = None;
    for values in points {
        let mut matrix = vec![vec![0.0; block.cols.len()]; block.rows.len()];
        for entry in entries {
            let row = block.rows.iter().position(|&row| row == entry.row);
            let col = block.cols.iter().position(|&col| col == entry.col);
            if let (Some(row), Some(col)) = (row, col) {
                matrix[row][col] = values[entry.node.index()];
            }
        }
        if matrix.iter().flatten().all(|entry| entry.is_finite()) {
            let rows = dependent_rows(&matrix)?;
            found = Some(rows.into_iter().map(|row| block.rows[row]).collect());
        }
    }
    found
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
