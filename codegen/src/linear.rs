//! Linear equations between nodes, solved in closed form.
//!
//! The equations are taken block by block in block-triangular order. A block of one is a division,
//! blocks of two and three use Cramer's rule (no pivot can go wrong, and constant cofactors move to
//! the scene rate), larger ones are eliminated with pivots that fill up least and are large at a typical point.

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::matrix::Matrix;
use crate::matrix::add_all;
use crate::model::Shape;
use crate::normal::rational;
use crate::pattern::Pattern;
use crate::sample::Typical;
use num_traits::Signed;

/// Least size of a pivot in terms of the largest entry of its column. Larger rounds less, smaller leaves more choice of
/// pivots that keep the matrix sparse; 0.1 is the usual compromise (Duff, Erisman, Reid 1986).
const LEAST_PIVOT: f64 = 0.1;

/// The step at the point where pivots are chosen.
const STEP: f64 = 1.0 / 128.0;

/// The solution of A x = b.
#[derive(Clone, Debug)]
pub struct Solution {
    /// x
    pub x: Vec<NodeId>,
    /// What was divided by: the solution is good where none of them vanishes.
    pub divisors: Vec<Divisor>,
}

/// A determinant or pivot.
#[derive(Clone, Debug)]
pub struct Divisor {
    value: NodeId,
    /// The same sum of products with every entry replaced by its magnitude: its error is up to so many rounding errors.
    size: NodeId,
    /// Of a pivot, the factors by which its equation is taken from the others.
    factors: Vec<NodeId>,
    /// It is an entry of the matrix as it stands, and the only one.
    pub is_entry: bool,
}

/// How many times larger than rounding an error may get by the divisions: Σ size / |value| over the divisors that can
/// cancel, and Π (1 + Σ |factors|) over the pivots, which bounds how far the equations outgrow what they were. The number
/// 0 if nothing can cancel and there are no pivots.
///
/// A small pivot loses the equations that large multiples of its own are taken from, though nothing cancels in it
/// (Higham, *Accuracy and Stability of Numerical Algorithms*, section 9.3).
pub fn growth(dag: &mut Dag, divisors: &[Divisor]) -> NodeId {
    let one = dag.integer(1);
    let mut shares = Vec::new();
    let mut seen = Vec::new();
    let mut product = one;
    for divisor in divisors {
        let (_, sum) = dag.split_coefficient(divisor.value);
        let can_cancel = matches!(dag.node(sum), Node::Sum(_)) && !dag.is_positive(sum);
        if can_cancel && !seen.contains(&sum) {
            let reciprocal = dag.div(one, divisor.value);
            let reciprocal = magnitude(dag, reciprocal);
            shares.push(dag.mul(divisor.size, reciprocal));
        }
        seen.push(sum);
        let factors = divisor.factors.iter();
        let mut terms: Vec<NodeId> = factors.map(|&factor| magnitude(dag, factor)).collect();
        if !terms.is_empty() {
            terms.push(one);
            let sum = add_all(dag, &terms);
            product = dag.mul(product, sum);
        }
    }
    if product != one {
        shares.push(product);
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
pub fn solve(
    dag: &mut Dag,
    a: &[Vec<NodeId>],
    b: &[NodeId],
    typical: &Typical,
) -> Option<Solution> {
    let n = b.len();
    let pattern = pattern(dag, a);
    let equation_of: Option<Vec<usize>> = pattern.matching().into_iter().collect();
    let mut x = vec![dag.integer(0); n];
    let mut is_known = vec![false; n];
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
            let mut terms = vec![(rational(1), b[r])];
            for c in (0..n).filter(|&c| is_known[c]) {
                if !dag.is_zero(a[r][c]) {
                    terms.push((rational(-1), dag.mul(a[r][c], x[c])));
                }
            }
            dag.sum(terms)
        });
        let right = Matrix::vector(right.collect());
        let values = solve_block(dag, &block, &right, typical, &mut divisors)?;
        for (&col, value) in cols.iter().zip(values) {
            x[col] = value;
            is_known[col] = true;
        }
    }
    Some(Solution { x, divisors })
}

fn solve_block(
    dag: &mut Dag,
    a: &Matrix,
    b: &Matrix,
    typical: &Typical,
    divisors: &mut Vec<Divisor>,
) -> Option<Vec<NodeId>> {
    match a.shape.rows {
        1 => {
            let value = a.entries[0];
            let size = sum_of_magnitudes(dag, value);
            divisors.push(Divisor {
                value,
                size,
                factors: Vec::new(),
                is_entry: true,
            });
            Some(vec![dag.div(b.entries[0], value)])
        }
        2 | 3 => cramer(dag, a, b, divisors),
        n => {
            let rows = a.entries.chunks(n).map(<[NodeId]>::to_vec);
            let rows = rows.collect();
            Elimination::new(dag, rows, b.entries.clone(), typical).solve(dag, divisors)
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
fn cramer(
    dag: &mut Dag,
    a: &Matrix,
    b: &Matrix,
    divisors: &mut Vec<Divisor>,
) -> Option<Vec<NodeId>> {
    let determinant = a.determinant(dag);
    if dag.is_zero(determinant) {
        return None;
    }
    let size = a.map(|entry| magnitude(dag, entry)).permanent(dag);
    divisors.push(Divisor {
        value: determinant,
        size,
        factors: Vec::new(),
        is_entry: false,
    });
    let above = a.adjugate(dag).product(dag, b);
    Some(above.map(|e| dag.div(e, determinant)).entries)
}

/// Gaussian elimination under way, in symbols and beside them in numbers.
struct Elimination {
    a: Vec<Vec<NodeId>>,
    b: Vec<NodeId>,
    /// The entries at a typical point.
    values: Vec<Vec<f64>>,
    /// Equations and unknowns without a pivot so far.
    rows: Vec<usize>,
    cols: Vec<usize>,
}

impl Elimination {
    fn new(dag: &Dag, a: Vec<Vec<NodeId>>, b: Vec<NodeId>, typical: &Typical) -> Self {
        let n = b.len();
        let tape = dag.tape(&a.concat());
        let values = tape.evaluate(|leaf| typical.value(1, leaf, STEP));
        Self {
            a,
            b,
            values: values.chunks(n).map(<[f64]>::to_vec).collect(),
            rows: (0..n).collect(),
            cols: (0..n).collect(),
        }
    }

    /// x; `None` if the matrix turns out to be singular.
    fn solve(mut self, dag: &mut Dag, divisors: &mut Vec<Divisor>) -> Option<Vec<NodeId>> {
        let mut pivots = Vec::new();
        while !self.rows.is_empty() {
            let (row, col) = self.pivot(dag)?;
            self.rows.retain(|&i| i != row);
            self.cols.retain(|&j| j != col);
            let value = self.a[row][col];
            let size = sum_of_magnitudes(dag, value);
            pivots.push((row, col));
            divisors.push(Divisor {
                value,
                size,
                factors: self.take(dag, row, col),
                is_entry: false,
            });
        }
        let mut x = self.b.clone();
        for (k, &(row, col)) in pivots.iter().enumerate().rev() {
            let mut terms = vec![(rational(1), self.b[row])];
            for &(_, j) in &pivots[k + 1..] {
                if !dag.is_zero(self.a[row][j]) {
                    terms.push((rational(-1), dag.mul(self.a[row][j], x[j])));
                }
            }
            let right = dag.sum(terms);
            x[col] = dag.div(right, self.a[row][col]);
        }
        Some(x)
    }

    /// Among the entries that are large for their column the one whose row and column have the fewest others
    /// (Markowitz 1957); of equal ones the first column's largest.
    fn pivot(&self, dag: &Dag) -> Option<(usize, usize)> {
        let is_entry = |i: usize, j: usize| !dag.is_zero(self.a[i][j]);
        let in_row = |i: usize| self.cols.iter().filter(|&&j| is_entry(i, j)).count();
        let in_rows: Vec<usize> = self.rows.iter().map(|&i| in_row(i)).collect();
        let mut best: Option<(usize, f64, (usize, usize))> = None;
        for &j in &self.cols {
            let entries = self.rows.iter().zip(&in_rows);
            let entries: Vec<_> = entries.filter(|(i, _)| is_entry(**i, j)).collect();
            let size = |i: usize| {
                let size = self.values[i][j].abs();
                if size.is_finite() { size } else { 0.0 }
            };
            let largest = entries.iter().map(|(i, _)| size(**i)).fold(0.0, f64::max);
            for &(&i, in_row) in &entries {
                let cost = (*in_row - 1) * (entries.len() - 1);
                let is_better = best.is_none_or(|(least, best_size, (_, col))| {
                    cost < least || cost == least && j == col && size(i) >= best_size
                });
                if size(i) >= LEAST_PIVOT * largest && is_better {
                    best = Some((cost, size(i), (i, j)));
                }
            }
        }
        best.map(|(_, _, place)| place)
    }

    /// Takes the unknown `col` out of the remaining equations by means of `row`, and returns the factors.
    fn take(&mut self, dag: &mut Dag, row: usize, col: usize) -> Vec<NodeId> {
        let mut factors = Vec::new();
        let pivot_row = self.a[row].clone();
        for &i in &self.rows {
            if dag.is_zero(self.a[i][col]) {
                continue;
            }
            let factor = dag.div(self.a[i][col], pivot_row[col]);
            factors.push(factor);
            let value = self.values[i][col] / self.values[row][col];
            for &j in &self.cols {
                if dag.is_zero(pivot_row[j]) {
                    continue;
                }
                let product = dag.mul(factor, pivot_row[j]);
                self.a[i][j] = dag.sub(self.a[i][j], product);
                self.values[i][j] -= value * self.values[row][j];
            }
            let product = dag.mul(factor, self.b[row]);
            self.b[i] = dag.sub(self.b[i], product);
        }
        factors
    }
}
