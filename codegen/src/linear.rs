//! Linear equations between nodes, solved in closed form.
//!
//! The equations are taken block by block in block-triangular order. A block of one is a division,
//! blocks of two and three use Cramer's rule (no pivot can go wrong, and constant cofactors move to
//! the scene rate), larger ones are eliminated with pivots that are largest at a generic point.

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::matrix::Matrix;
use crate::matrix::add_all;
use crate::model::Shape;
use crate::normal::rational;
use crate::pattern::Pattern;
use crate::sample::Sample;
use num_traits::Signed;

/// The solution of A x = b.
#[derive(Clone, Debug)]
pub struct Solution {
    /// x
    pub x: Vec<NodeId>,
    /// What was divided by: the solution is good where none of them vanishes.
    pub divisors: Vec<Divisor>,
}

/// A determinant or pivot.
#[derive(Clone, Copy, Debug)]
pub struct Divisor {
    value: NodeId,
    /// The same sum of products with every entry replaced by its magnitude: its error is up to so many rounding errors.
    size: NodeId,
    /// It is an entry of the matrix as it stands.
    pub is_entry: bool,
}

/// Σ size / |value| over the divisors that can cancel: how many times larger than rounding an error may get by the
/// divisions. The number 0 if none can.
pub fn growth(dag: &mut Dag, divisors: &[Divisor]) -> NodeId {
    let mut shares = Vec::new();
    let mut seen = Vec::new();
    for divisor in divisors {
        let (_, sum) = dag.split_coefficient(divisor.value);
        let can_cancel = matches!(dag.node(sum), Node::Sum(_)) && !dag.is_positive(sum);
        if can_cancel && !seen.contains(&sum) {
            let one = dag.integer(1);
            let reciprocal = dag.div(one, divisor.value);
            let reciprocal = magnitude(dag, reciprocal);
            shares.push(dag.mul(divisor.size, reciprocal));
        }
        seen.push(sum);
    }
    add_all(dag, &shares)
}

fn magnitude(dag: &mut Dag, node: NodeId) -> NodeId {
    dag.call(Elementary::Abs, vec![node])
}

/// The pattern of the entries of a square matrix that are not the number 0.
pub fn pattern(dag: &Dag, a: &[Vec<NodeId>]) -> Pattern {
    let n = a.len();
    let places = (0..n).flat_map(|row| (0..n).map(move |col| (row, col)));
    Pattern::new(n, places.filter(|&(row, col)| !dag.is_zero(a[row][col])))
}

/// x with A x = b; `None` if A is singular whatever its entries are.
pub fn solve(dag: &mut Dag, a: &[Vec<NodeId>], b: &[NodeId]) -> Option<Solution> {
    let n = b.len();
    let pattern = pattern(dag, a);
    let equation_of: Option<Vec<usize>> = pattern.matching().into_iter().collect();
    let mut x = vec![dag.integer(0); n];
    let mut divisors = Vec::new();
    for (rows, cols) in pattern.blocks(&equation_of?) {
        let block = rows.iter().flat_map(|&r| cols.iter().map(move |&c| (r, c)));
        let shape = Shape {
            rows: rows.len(),
            cols: cols.len(),
        };
        let block = Matrix {
            shape,
            entries: block.map(|(r, c)| a[r][c]).collect(),
        };
        let right = rows.iter().map(|&r| {
            let known = (0..n).filter(|c| !cols.contains(c));
            let mut terms = vec![(rational(1), b[r])];
            terms.extend(known.map(|c| (rational(-1), dag.mul(a[r][c], x[c]))));
            dag.sum(terms)
        });
        let right = Matrix::vector(right.collect());
        for (col, value) in cols
            .iter()
            .zip(solve_block(dag, &block, &right, &mut divisors))
        {
            x[*col] = value;
        }
    }
    Some(Solution { x, divisors })
}

fn solve_block(dag: &mut Dag, a: &Matrix, b: &Matrix, divisors: &mut Vec<Divisor>) -> Vec<NodeId> {
    match a.shape.rows {
        1 => {
            let value = a.entries[0];
            let size = sum_of_magnitudes(dag, value);
            divisors.push(Divisor {
                value,
                size,
                is_entry: true,
            });
            vec![dag.div(b.entries[0], a.entries[0])]
        }
        2 | 3 => cramer(dag, a, b, divisors),
        n => {
            let rows = (0..n)
                .map(|i| a.entries[i * n..(i + 1) * n].to_vec())
                .collect();
            eliminate(dag, rows, b.entries.clone(), divisors)
        }
    }
}

/// Σ |terms| of a sum.
fn sum_of_magnitudes(dag: &mut Dag, node: NodeId) -> NodeId {
    let Node::Sum(terms) = dag.node(node).clone() else {
        return magnitude(dag, node);
    };
    let terms = terms
        .into_iter()
        .map(|(c, node)| (c.abs(), magnitude(dag, node)));
    let terms: Vec<_> = terms.collect();
    dag.sum(terms)
}

/// Cramer's rule in the form x = adj(A) b / det A.
fn cramer(dag: &mut Dag, a: &Matrix, b: &Matrix, divisors: &mut Vec<Divisor>) -> Vec<NodeId> {
    let determinant = a.determinant(dag);
    let size = a.map(|entry| magnitude(dag, entry)).permanent(dag);
    divisors.push(Divisor {
        value: determinant,
        size,
        is_entry: false,
    });
    let above = a.adjugate(dag).product(dag, b);
    above.map(|e| dag.div(e, determinant)).entries
}

/// Gaussian elimination; each pivot is the entry of its column that is largest at a generic point.
fn eliminate(
    dag: &mut Dag,
    mut a: Vec<Vec<NodeId>>,
    mut b: Vec<NodeId>,
    divisors: &mut Vec<Divisor>,
) -> Vec<NodeId> {
    let n = a.len();
    for k in 0..n {
        let values = Sample::generic(1).evaluate(dag);
        let size = |row: &Vec<NodeId>| values[row[k].index()].abs();
        let pivot = (k..n)
            .max_by(|&i, &j| size(&a[i]).total_cmp(&size(&a[j])))
            .unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        let value = a[k][k];
        let size = sum_of_magnitudes(dag, value);
        divisors.push(Divisor {
            value,
            size,
            is_entry: false,
        });
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
