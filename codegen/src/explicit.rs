//! From continuous equations M(t, x) ẋ = f(t, x) to the rates ẋ.
//!
//! The equations are taken block by block in block-triangular order. A block of one is a division,
//! blocks of two and three use Cramer's rule (no pivot can go wrong, and constant cofactors move to
//! the scene rate), larger ones are eliminated with pivots that are largest at a generic point.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::matrix::Matrix;
use crate::model::Model;
use crate::model::Shape;
use crate::normal::rational;
use crate::pattern::Pattern;
use crate::sample::Sample;
use crate::system::Entry;

/// The rate of each state component, from `flow` (left − right) and its derivatives by the rates.
///
/// # Errors
/// Equations that are not linear in the rates, or do not determine all of them.
pub fn explicit(
    model: &Model,
    dag: &mut Dag,
    flow: &[NodeId],
    entries: &[Entry],
) -> Result<Vec<NodeId>, Errors> {
    check_linear(model, dag, entries)?;
    let n = flow.len();
    let pattern = Pattern::new(n, entries.iter().map(|e| (e.row, e.col)));
    let equation_of: Vec<usize> = pattern.matching().iter().flatten().copied().collect();
    if equation_of.len() < n {
        return Err(undetermined(model, &pattern.matching()));
    }
    let zero = dag.integer(0);
    let at_rest = dag.substitute(flow, |leaf| {
        matches!(leaf, Leaf::Unknown(_)).then_some(zero)
    });
    let mut matrix = vec![vec![zero; n]; n];
    for entry in entries {
        matrix[entry.row][entry.col] = entry.node;
    }
    let mut rates = vec![zero; n];
    for (rows, cols) in pattern.blocks(&equation_of) {
        let block = rows.iter().flat_map(|&r| cols.iter().map(move |&c| (r, c)));
        let shape = Shape {
            rows: rows.len(),
            cols: cols.len(),
        };
        let block = Matrix {
            shape,
            entries: block.map(|(r, c)| matrix[r][c]).collect(),
        };
        let right = rows.iter().map(|&r| {
            let known = (0..n).filter(|c| !cols.contains(c));
            let mut terms = vec![at_rest[r]];
            terms.extend(known.map(|c| dag.mul(matrix[r][c], rates[c])));
            dag.sum(terms.into_iter().map(|t| (rational(-1), t)))
        });
        let right = Matrix::vector(right.collect());
        for (col, rate) in cols.iter().zip(solve(dag, &block, &right)) {
            rates[*col] = rate;
        }
    }
    Ok(rates)
}

/// The first equation whose coefficient of a rate contains a rate.
fn check_linear(model: &Model, dag: &Dag, entries: &[Entry]) -> Result<(), Errors> {
    let depends = dag.dependence(|leaf| matches!(leaf, Leaf::Unknown(_)));
    let mut errors = Errors::default();
    let mut offset = 0;
    for equation in &model.flow {
        let rows = offset..offset + equation.shape.len();
        offset = rows.end;
        if entries
            .iter()
            .any(|e| rows.contains(&e.row) && depends[e.node.index()])
        {
            errors.push(
                equation.range,
                "the flow must be linear in the rates der(x)",
            );
        }
    }
    errors.or(())
}

fn undetermined(model: &Model, matching: &[Option<usize>]) -> Errors {
    let mut errors = Errors::default();
    for state in &model.states {
        let variable = &state.variable;
        for component in 0..variable.shape.len() {
            if matching[variable.offset + component].is_none() {
                let suffix = variable.component_suffix(component);
                let rate = format!("der({}){suffix}", variable.name.display);
                let message = format!("the flow does not determine `{rate}`");
                errors.push(variable.name.range, message);
            }
        }
    }
    errors
}

/// x where A x = b.
fn solve(dag: &mut Dag, a: &Matrix, b: &Matrix) -> Vec<NodeId> {
    match a.shape.rows {
        1 => vec![dag.div(b.entries[0], a.entries[0])],
        2 | 3 => cramer(dag, a, b),
        n => {
            let rows = (0..n)
                .map(|i| a.entries[i * n..(i + 1) * n].to_vec())
                .collect();
            eliminate(dag, rows, b.entries.clone())
        }
    }
}

/// Cramer's rule in the form x = adj(A) b / det A.
fn cramer(dag: &mut Dag, a: &Matrix, b: &Matrix) -> Vec<NodeId> {
    let determinant = a.determinant(dag);
    let above = a.adjugate(dag).product(dag, b);
    above.map(|e| dag.div(e, determinant)).entries
}

/// Gaussian elimination; each pivot is the entry of its column that is largest at a generic point.
fn eliminate(dag: &mut Dag, mut a: Vec<Vec<NodeId>>, mut b: Vec<NodeId>) -> Vec<NodeId> {
    let n = a.len();
    for k in 0..n {
        let values = Sample::generic(1).evaluate(dag);
        let size = |row: &Vec<NodeId>| values[row[k].index()].abs();
        let pivot = (k..n)
            .max_by(|&i, &j| size(&a[i]).total_cmp(&size(&a[j])))
            .unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = dag.div(a[i][k], a[k][k]);
            let pivot_row = a[k].clone();
            for (entry, above) in a[i].iter_mut().zip(pivot_row).skip(k) {
                let product = dag.mul(factor, above);
                *entry = dag.sub(*entry, product);
            }
            let product = dag.mul(factor, b[k]);
            b[i] = dag.sub(b[i], product);
        }
    }
    let mut x = b.clone();
    for k in (0..n).rev() {
        let mut terms = vec![(rational(1), b[k])];
        for j in k + 1..n {
            terms.push((rational(-1), dag.mul(a[k][j], x[j])));
        }
        let right = dag.sum(terms);
        x[k] = dag.div(right, a[k][k]);
    }
    x
}
