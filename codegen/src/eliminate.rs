//! The smallest system that Newton's method has to iterate on.
//!
//! In comes a solver in block-triangular order; out goes its core: unknowns that enter some equations linearly
//! are solved for in closed form and put into the others.
//!
//! ```text
//! A(y) z = b(y)    as many equations as there are z
//! f(y, z) = 0      the others
//!
//! core: f(y, A(y)⁻¹ b(y)) = 0
//! ```
//!
//! Being part of the graph, the solution is staged like everything else: what is constant in it is computed once.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::linear::Divisor;
use crate::linear::growth;
use crate::linear::solve;
use crate::rank::smallest_pivot;
use crate::sample::Sample;
use crate::system::Block;
use crate::system::Core;
use crate::system::Entry;

/// Most choices of unknowns to keep that are tried per block.
const MOST_CHOICES: usize = 20_000;

/// Most choices of equations to solve that are tried for each of them.
const MOST_ROWS: usize = 64;

/// Generic points at which they are compared.
const POINTS: u64 = 3;

/// The step at the points. In a discretised equation of motion it stands beside numbers of order one.
const SMALL_STEP: f64 = 1.0 / 8192.0;

/// Least pivot of the eliminated equations, each scaled by its largest entry: what only the step keeps from being
/// singular is far below.
const LEAST_PIVOT: f64 = 0.01;

/// The equations and unknowns of a block that are eliminated; as many of each.
struct Choice {
    rows: Vec<usize>,
    cols: Vec<usize>,
}

/// What of a solver the elimination works on.
pub struct Full<'a> {
    /// rᵢ
    pub residual: &'a [NodeId],
    /// Structural non-zeros.
    pub jacobian: &'a [Entry],
    /// First guesses.
    pub guess: &'a [NodeId],
    /// The state after the step.
    pub next: &'a [NodeId],
    /// Block-triangular order.
    pub blocks: &'a [Block],
}

/// The core; `None` if every unknown is needed.
pub fn eliminate(dag: &mut Dag, full: &Full) -> Option<Core> {
    let n = full.residual.len();
    let couplings = Couplings::new(dag, full.jacobian, n);
    let mut values: Vec<Option<NodeId>> = vec![None; n];
    let mut solved_rows = vec![false; n];
    let mut divisors = Vec::new();
    for block in full.blocks {
        let Some(choice) = choose(block, &couplings, full.jacobian, dag) else {
            continue;
        };
        let solution = closed_form(dag, full, &choice, &values);
        let (solution, own) = solution?;
        divisors.extend(own);
        choice.rows.iter().for_each(|&row| solved_rows[row] = true);
        for (&col, value) in choice.cols.iter().zip(solution) {
            values[col] = Some(value);
        }
    }
    if values.iter().all(Option::is_none) {
        return None;
    }
    let unknowns: Vec<usize> = (0..n).filter(|&col| values[col].is_none()).collect();
    let rows = (0..n).filter(|&row| !solved_rows[row]);
    let residual: Vec<NodeId> = rows.map(|row| full.residual[row]).collect();
    let residual = put_in(dag, &residual, &values);
    let next = put_in(dag, full.next, &values);
    Some(Core {
        residual,
        guess: unknowns.iter().map(|&col| full.guess[col]).collect(),
        next,
        change: None,
        growth: growth(dag, &divisors),
        unknowns,
    })
}

/// On which unknowns each entry of the Jacobian depends, as bits: at most 127 unknowns are allowed.
struct Couplings {
    entries: Vec<(usize, usize, u128)>,
}

impl Couplings {
    fn new(dag: &Dag, jacobian: &[Entry], n: usize) -> Self {
        let mut masks = vec![0; dag.nodes().len()];
        for (i, node) in dag.nodes().iter().enumerate() {
            masks[i] = match node {
                Node::Leaf(Leaf::Unknown(col)) if *col < n => 1 << col,
                _ => {
                    let operands = dag.operands(NodeId(i as u32)).into_iter();
                    operands.fold(0, |mask, operand| mask | masks[operand.index()])
                }
            };
        }
        let entry = |e: &Entry| (e.row, e.col, masks[e.node.index()]);
        Self {
            entries: jacobian.iter().map(entry).collect(),
        }
    }

    /// The equation is linear in all of `unknowns` together.
    fn is_linear(&self, row: usize, unknowns: u128) -> bool {
        let mut own = self.entries.iter().filter(|entry| entry.0 == row);
        own.all(|&(_, col, mask)| unknowns & (1 << col) == 0 || mask & unknowns == 0)
    }
}

/// What to eliminate of a block: as many unknowns as possible, and of as many those that depend least on h being
/// large.
fn choose(block: &Block, couplings: &Couplings, jacobian: &[Entry], dag: &Dag) -> Option<Choice> {
    let n = block.cols.len();
    let samples =
        (0..POINTS).map(|number| Sample::generic(number).evaluate_with_step(dag, SMALL_STEP));
    let matrices: Vec<_> = samples
        .map(|values| scaled(block, jacobian, &values))
        .collect();
    let mut tried = 0;
    for kept in 0..n {
        let mut best: Option<(f64, Choice)> = None;
        for choice in combinations(n, kept) {
            tried += 1;
            if tried > MOST_CHOICES {
                return None;
            }
            let cols: Vec<usize> = (0..n).filter(|i| !choice.contains(i)).collect();
            let mask = cols.iter().fold(0, |mask, &i| mask | 1 << block.cols[i]);
            let linear = (0..n).filter(|&i| couplings.is_linear(block.rows[i], mask));
            let linear: Vec<usize> = linear.collect();
            for rows in combinations(linear.len(), cols.len()).take(MOST_ROWS) {
                let rows: Vec<usize> = rows.iter().map(|&i| linear[i]).collect();
                let pivots = matrices.iter().map(|matrix| {
                    let part = rows
                        .iter()
                        .map(|&i| cols.iter().map(|&j| matrix[i][j]).collect());
                    smallest_pivot(&part.collect::<Vec<_>>())
                });
                let pivot = pivots.fold(f64::INFINITY, f64::min);
                if pivot > best.as_ref().map_or(LEAST_PIVOT, |(pivot, _)| *pivot) {
                    let choice = Choice {
                        rows: rows.iter().map(|&i| block.rows[i]).collect(),
                        cols: cols.iter().map(|&j| block.cols[j]).collect(),
                    };
                    best = Some((pivot, choice));
                }
            }
        }
        if let Some((_, choice)) = best {
            return Some(choice);
        }
    }
    None
}

/// The Jacobian of a block with the largest entry of each row scaled to 1.
fn scaled(block: &Block, jacobian: &[Entry], values: &[f64]) -> Vec<Vec<f64>> {
    let mut matrix = vec![vec![0.0; block.cols.len()]; block.rows.len()];
    for entry in jacobian {
        let row = block.rows.iter().position(|&row| row == entry.row);
        let col = block.cols.iter().position(|&col| col == entry.col);
        if let (Some(row), Some(col)) = (row, col) {
            matrix[row][col] = values[entry.node.index()];
        }
    }
    for row in &mut matrix {
        let size = row
            .iter()
            .fold(0.0, |size: f64, entry| size.max(entry.abs()));
        row.iter_mut().for_each(|entry| *entry /= size);
    }
    matrix
}

/// The unknowns of a choice from its equations, those of earlier choices put in, and what was divided by.
fn closed_form(
    dag: &mut Dag,
    full: &Full,
    choice: &Choice,
    values: &[Option<NodeId>],
) -> Option<(Vec<NodeId>, Vec<Divisor>)> {
    let zero = dag.integer(0);
    let mut a = vec![vec![zero; choice.cols.len()]; choice.rows.len()];
    for entry in full.jacobian {
        let row = choice.rows.iter().position(|&row| row == entry.row);
        let col = choice.cols.iter().position(|&col| col == entry.col);
        if let (Some(row), Some(col)) = (row, col) {
            a[row][col] = put_in(dag, &[entry.node], values)[0];
        }
    }
    let residual: Vec<NodeId> = choice.rows.iter().map(|&row| full.residual[row]).collect();
    let at_zero = dag.substitute(&residual, |leaf| match leaf {
        Leaf::Unknown(col) if choice.cols.contains(&col) => Some(zero),
        Leaf::Unknown(col) => values[col],
        _ => None,
    });
    let right: Vec<NodeId> = at_zero.iter().map(|&r| dag.neg(r)).collect();
    let solution = solve(dag, &a, &right)?;
    Some((solution.x, solution.divisors))
}

/// `roots` with the eliminated unknowns replaced by their values.
fn put_in(dag: &mut Dag, roots: &[NodeId], values: &[Option<NodeId>]) -> Vec<NodeId> {
    dag.substitute(roots, |leaf| match leaf {
        Leaf::Unknown(col) => values[col],
        _ => None,
    })
}

/// All choices of `k` of 0, …, n − 1 in lexicographic order.
fn combinations(n: usize, k: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next: Option<Vec<usize>> = (k <= n).then(|| (0..k).collect());
    std::iter::from_fn(move || {
        let current = next.clone()?;
        let last = (0..k).rev().find(|&i| current[i] < n - k + i);
        next = last.map(|i| {
            let mut following = current.clone();
            for (offset, place) in (i..k).enumerate() {
                following[place] = current[i] + 1 + offset;
            }
            following
        });
        Some(current)
    })
}

#[cfg(test)]
mod tests {
    use super::combinations;

    #[test]
    fn combinations_are_all_and_in_order() {
        let list: Vec<_> = combinations(4, 2).collect();
        let expected = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
        assert_eq!(list, expected);
        assert_eq!(combinations(3, 0).count(), 1);
        assert_eq!(combinations(2, 3).count(), 0);
    }
}
