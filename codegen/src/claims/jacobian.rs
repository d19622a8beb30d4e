//! Claimed Jacobians against derivatives.

use super::bounded::Bounded;
use super::misfit;
use super::names::Names;
use super::points::Points;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::finding::Difference;
use crate::model::Claim;
use crate::model::Equation;
use crate::model::Shape;
use crate::system::ClaimedBlock;

/// A derivative, to be laid out as claims are.
pub(super) struct Comparison<'a> {
    pub(super) names: &'a Names<'a>,
    pub(super) points: &'a Points<'a>,
    /// What is derived.
    pub(super) equations: &'a [Equation],
    /// All entries, zeros included, row by row.
    pub(super) derivative: &'a [NodeId],
    pub(super) n: usize,
    /// The number 0.
    pub(super) zero: NodeId,
}

impl Comparison<'_> {
    /// What differs, and all entries as claimed if the blocks fit.
    pub(super) fn compare(
        &self,
        claim: &Claim,
        blocks: &[Vec<ClaimedBlock>],
    ) -> (Vec<Difference>, Option<Vec<NodeId>>) {
        let Some([heights, widths]) = self.layout(blocks) else {
            return (vec![self.misfit(blocks)], None);
        };
        let mut differences = Vec::new();
        let mut entries = vec![Some(self.zero); self.n * self.n];
        let mut row = 0;
        for (i, &rows) in heights.iter().enumerate() {
            let mut col = 0;
            for (j, &cols) in widths.iter().enumerate() {
                let shape = Shape { rows, cols };
                let place = Place { row, col, shape };
                let (block, text) = (&blocks[i][j], &claim.blocks[i][j].1);
                let found = self.compare_block(block, text, &place, &mut entries);
                differences.extend(found);
                col += cols;
            }
            row += rows;
        }
        (differences, entries.into_iter().collect())
    }

    /// Heights and widths of the blocks.
    fn layout(&self, blocks: &[Vec<ClaimedBlock>]) -> Option<[Vec<usize>; 2]> {
        let model = self.names.model;
        let heights: Vec<usize> = self.equations.iter().map(|e| e.shape.len()).collect();
        let solved = model.solved.iter();
        let widths: Vec<usize> = solved
            .map(|&s| model.solved_variable(s).shape.len())
            .collect();
        let rows_fit = blocks.len() == heights.len();
        match blocks {
            [row] if row.len() == 1 && !(rows_fit && widths.len() == 1) => {
                Some([vec![self.n], vec![self.n]])
            }
            _ if rows_fit && blocks.iter().all(|r| r.len() == widths.len()) => {
                Some([heights, widths])
            }
            _ => grid(blocks, self.n),
        }
    }

    /// One block against its place in the derivative; what is printed goes to `entries`.
    fn compare_block(
        &self,
        block: &ClaimedBlock,
        text: &str,
        place: &Place,
        entries: &mut [Option<NodeId>],
    ) -> Vec<Difference> {
        let Place { row, col, shape } = *place;
        let at = |k: usize| (row + k / shape.cols, col + k % shape.cols);
        let Some(printed) = spread(self.names.dag, block, shape, self.zero) else {
            for (row, col) in (0..shape.len()).map(at) {
                entries[row * self.n + col] = None;
            }
            let is = block.shape.unwrap_or(Shape::SCALAR);
            return vec![Difference {
                row,
                col,
                entry: format!("block from {}", self.entry(row, col)),
                printed: format!("{text}, of shape [{}, {}]", is.rows, is.cols),
                derived: format!("a block of shape [{}, {}]", shape.rows, shape.cols),
                values: (f64::NAN, f64::NAN),
            }];
        };
        let mut differences = Vec::new();
        for (k, printed) in printed.into_iter().enumerate() {
            let (row, col) = at(k);
            entries[row * self.n + col] = Some(printed);
            let derived = self.derivative[row * self.n + col];
            let one = Bounded::exact(1.0);
            if let Some(values) = self.points.disagreement(printed, derived, one) {
                differences.push(Difference {
                    row,
                    col,
                    entry: self.entry(row, col),
                    printed: self.names.text(printed),
                    derived: self.names.text(derived),
                    values,
                });
            }
        }
        differences
    }

    /// A claim whose blocks cannot be laid over the Jacobian.
    fn misfit(&self, blocks: &[Vec<ClaimedBlock>]) -> Difference {
        let cols = blocks.first().map_or(0, Vec::len);
        let (equations, unknowns) = (self.equations.len(), self.names.model.solved.len());
        let n = self.n;
        misfit(
            format!("{} by {cols} blocks", blocks.len()),
            format!("{equations} equations by {unknowns} unknowns, {n} by {n} components"),
        )
    }

    /// `∂(equation 2.1)/∂(Δω)`
    fn entry(&self, row: usize, col: usize) -> String {
        let equation = self.names.row(self.equations, row);
        format!("∂({equation})/∂({})", self.names.leaf(Leaf::Unknown(col)))
    }
}

/// Where a block lies in the Jacobian.
struct Place {
    row: usize,
    col: usize,
    shape: Shape,
}

/// Heights and widths of a grid whose blocks say their own shapes, if they add up to n by n.
fn grid(blocks: &[Vec<ClaimedBlock>], n: usize) -> Option<[Vec<usize>; 2]> {
    let cols = blocks.first()?.len();
    if blocks.iter().any(|row| row.len() != cols) {
        return None;
    }
    let shape = |b: &ClaimedBlock| b.shape.unwrap_or(Shape::SCALAR);
    let height = |row: &Vec<ClaimedBlock>| row.iter().map(|b| shape(b).rows).max();
    let width = |j: usize| blocks.iter().map(|row| shape(&row[j]).cols).max();
    let heights: Vec<usize> = blocks.iter().map(height).collect::<Option<_>>()?;
    let widths: Vec<usize> = (0..cols).map(width).collect::<Option<_>>()?;
    let adds_up = heights.iter().sum::<usize>() == n && widths.iter().sum::<usize>() == n;
    adds_up.then_some([heights, widths])
}

/// The entries of a block in `shape`: as they are, a literal zero spread out, a multiple of I.
fn spread(dag: &Dag, block: &ClaimedBlock, shape: Shape, zero: NodeId) -> Option<Vec<NodeId>> {
    match block.shape {
        Some(own) if own == shape => Some(block.entries.clone()),
        Some(_) if block.entries.iter().all(|&e| dag.is_zero(e)) => Some(vec![zero; shape.len()]),
        Some(_) => None,
        None => {
            let diagonal = |k: usize| k / shape.cols == k % shape.cols;
            let entry = |k: usize| if diagonal(k) { block.entries[0] } else { zero };
            Some((0..shape.len()).map(entry).collect())
        }
    }
}
