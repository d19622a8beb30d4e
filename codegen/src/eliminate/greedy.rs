//! A good choice of unknowns of a large block: one after the other, the cheapest first.
//!
//! Each is solved for with one equation and put into those that contain it. With k other unknowns in that equation and
//! l other equations with that unknown this costs 2 k l operations (Markowitz 1957), and fills up at most k l places.

use super::Choice;
use super::LEAST_PIVOT;
use super::MOST_OPERATIONS;
use super::SMALL;
use super::candidates::Candidates;
use std::cmp::Reverse;

/// Most operations in all, per entry of the Jacobian: 2 or 3 suffice to put positions, of which each depends on its
/// velocity alone, into a dense force. Larger unrolls more of what a loop does as well.
const MOST_PER_ENTRY: usize = 4;

/// The better of two orders, by the number of unknowns, then by operations: first what is in equations with the fewest
/// products of unknowns (positions, of which the rate is a velocity), or first what is in the fewest products
/// (velocities and multipliers). `None` if every one is needed.
pub(super) fn greedy(candidates: &Candidates) -> Option<Choice> {
    let n = candidates.len();
    let couplings = &candidates.couplings;
    let row_products: Vec<usize> = couplings
        .iter()
        .map(|row| row.iter().filter(|coupling| **coupling != 0).count())
        .collect();
    let col_products: Vec<usize> = (0..n)
        .map(|col| couplings.iter().filter(|row| row[col] != 0).count())
        .collect();
    let by_row = Elimination::run(candidates, |row, _| row_products[row]);
    let by_col = Elimination::run(candidates, |_, col| col_products[col]);
    let worth = |choice: &Elimination| (choice.cols.len(), Reverse(choice.operations));
    let better = if worth(&by_col) > worth(&by_row) {
        by_col
    } else {
        by_row
    };
    (!better.cols.is_empty()).then(|| better.choice())
}

/// An equation and the unknown that it may be solved for.
#[derive(Clone, Copy)]
struct Pivot {
    row: usize,
    col: usize,
    /// Rank and operations.
    price: (usize, usize),
    /// Of the coefficient.
    size: f64,
}

impl Pivot {
    fn is_better(&self, other: &Pivot) -> bool {
        self.price < other.price || self.price == other.price && self.size > other.size
    }
}

/// An elimination under way.
struct Elimination {
    /// Equations and unknowns that are eliminated.
    rows: Vec<usize>,
    cols: Vec<usize>,
    operations: usize,
    /// The most of them.
    budget: usize,
    /// The equations that are left, linear in all of `cols` together.
    open: Vec<bool>,
    /// The equations that are left, whether linear or not.
    left: Vec<bool>,
    /// The eliminated unknowns as bits.
    eliminated: u128,
    /// For each unknown, those it must not be eliminated with since some equation of `rows` contains their product.
    excluded: Vec<u128>,
    /// For each equation that is left the unknowns in it.
    patterns: Vec<u128>,
    /// At each point the coefficients that are left.
    matrices: Vec<Vec<Vec<f64>>>,
}

impl Elimination {
    /// Takes unknowns as long as it can, those of the smallest `rank` first.
    fn run(candidates: &Candidates, rank: impl Fn(usize, usize) -> usize) -> Self {
        let n = candidates.len();
        let entries: u32 = candidates.patterns.iter().map(|row| row.count_ones()).sum();
        let mut elimination = Self {
            rows: Vec::new(),
            cols: Vec::new(),
            operations: 0,
            budget: MOST_OPERATIONS + MOST_PER_ENTRY * entries as usize,
            open: vec![true; n],
            left: vec![true; n],
            eliminated: 0,
            excluded: vec![0; n],
            patterns: candidates.patterns.clone(),
            matrices: candidates.matrices.clone(),
        };
        while let Some(pivot) = elimination.cheapest(candidates, &rank) {
            elimination.take(candidates, pivot);
        }
        elimination
    }

    /// The next pivot, if any is left.
    fn cheapest(
        &self,
        candidates: &Candidates,
        rank: impl Fn(usize, usize) -> usize,
    ) -> Option<Pivot> {
        let n = candidates.len();
        let users: Vec<usize> = (0..n).map(|col| self.left_with(col).count()).collect();
        let mut best: Option<Pivot> = None;
        for row in (0..n).filter(|&row| self.open[row]) {
            let others = self.patterns[row].count_ones() as usize - 1;
            for col in (0..n).filter(|col| self.patterns[row] & 1 << col != 0) {
                let with = self.eliminated | 1 << col;
                let others_with = users[col] - 1;
                let cost = 2 * others * others_with;
                let is_linear = (candidates.couplings[row][col] | self.excluded[col]) & with == 0;
                let is_sparse = others.min(others_with) < SMALL;
                let is_cheap = self.operations + cost <= self.budget;
                if !is_linear || !is_sparse || !is_cheap {
                    continue;
                }
                let pivot = Pivot {
                    row,
                    col,
                    price: (rank(row, col), cost),
                    size: self.size(row, col),
                };
                if pivot.size >= LEAST_PIVOT && best.is_none_or(|best| pivot.is_better(&best)) {
                    best = Some(pivot);
                }
            }
        }
        best
    }

    /// The size of a coefficient at the point where it is smallest; 0 if it has no finite value.
    fn size(&self, row: usize, col: usize) -> f64 {
        let sizes = self.matrices.iter().map(|matrix| matrix[row][col].abs());
        let finite = sizes.map(|size| if size.is_finite() { size } else { 0.0 });
        finite.fold(f64::INFINITY, f64::min)
    }

    fn left_with(&self, col: usize) -> impl Iterator<Item = usize> {
        let rows = 0..self.patterns.len();
        rows.filter(move |&row| self.left[row] && self.patterns[row] & 1 << col != 0)
    }

    fn take(&mut self, candidates: &Candidates, pivot: Pivot) {
        let Pivot { row, col, .. } = pivot;
        self.rows.push(row);
        self.cols.push(col);
        self.operations += pivot.price.1;
        self.eliminated |= 1 << col;
        self.left[row] = false;
        self.open[row] = false;
        let couplings = candidates.couplings.iter().zip(&mut self.open);
        for (couplings, open) in couplings {
            *open &= couplings[col] & self.eliminated == 0;
        }
        for (excluded, coupling) in self.excluded.iter_mut().zip(&candidates.couplings[row]) {
            *excluded |= coupling;
        }
        let others: Vec<usize> = self.left_with(col).collect();
        for matrix in &mut self.matrices {
            let pivot_row = matrix[row].clone();
            for &other in &others {
                let factor = matrix[other][col] / pivot_row[col];
                for (entry, above) in matrix[other].iter_mut().zip(&pivot_row) {
                    *entry -= factor * above;
                }
            }
        }
        for &other in &others {
            self.patterns[other] = (self.patterns[other] | self.patterns[row]) & !(1 << col);
        }
    }

    /// In ascending order, as the equations stand in the model.
    fn choice(mut self) -> Choice {
        self.rows.sort_unstable();
        self.cols.sort_unstable();
        Choice {
            rows: self.rows,
            cols: self.cols,
        }
    }
}
