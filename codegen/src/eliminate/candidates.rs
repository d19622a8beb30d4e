//! A block as what a choice of its unknowns is made from: numbers and dependences.

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::sample::Sample;
use crate::sample::Typical;
use crate::system::Block;
use crate::system::Entry;

/// Points at which choices are compared, of each kind: generic ones, where nothing vanishes by accident, and typical ones,
/// where a run will be.
const POINTS: u64 = 2;

/// The step at the points. In a discretised equation of motion it stands beside numbers of order one.
const SMALL_STEP: f64 = 1.0 / 8192.0;

/// What is asked of the entries of a Jacobian, for each of them.
pub(super) struct Survey {
    /// The unknowns that it depends on, as bits.
    unknowns: Vec<u128>,
    /// Of each equation, the unknowns in it, and those that stand in functions and powers.
    contents: Vec<[u128; 2]>,
    /// At each point the values of all.
    points: Vec<Vec<f64>>,
}

impl Survey {
    /// Asks all of `jacobian`, the derivatives of `residual`.
    pub(super) fn of(
        dag: &Dag,
        residual: &[NodeId],
        jacobian: &[Entry],
        typical: &Typical,
    ) -> Self {
        let (masks, curved) = (dag.unknowns(0), dag.curved());
        let nodes: Vec<_> = jacobian.iter().map(|entry| entry.node).collect();
        let tape = dag.tape(&nodes);
        let generic = (0..POINTS).map(|number| {
            let point = Sample::generic(number);
            tape.evaluate(|leaf| point.value_with_step(leaf, SMALL_STEP))
        });
        let typical =
            (0..POINTS).map(|number| tape.evaluate(|leaf| typical.value(number, leaf, SMALL_STEP)));
        Self {
            unknowns: nodes.iter().map(|node| masks[node.index()]).collect(),
            contents: residual
                .iter()
                .map(|root| [masks[root.index()], curved[root.index()]])
                .collect(),
            points: generic.chain(typical).collect(),
        }
    }
}

/// The Jacobian of a block at generic points, and which of its entries depend on which unknowns. Equations and unknowns
/// are positions in the block; sets of unknowns are bits, of which 127 are enough.
pub(super) struct Candidates {
    /// For each equation the unknowns in it.
    pub(super) patterns: Vec<u128>,
    /// For each equation and unknown, the unknowns that its coefficient depends on, and those whose coefficients depend
    /// on it.
    pub(super) couplings: Vec<Vec<u128>>,
    /// At each point the Jacobian with the largest entry of each row scaled to 1.
    pub(super) matrices: Vec<Vec<Vec<f64>>>,
}

impl Candidates {
    /// The candidates of `block`.
    pub(super) fn new(block: &Block, jacobian: &[Entry], survey: &Survey) -> Self {
        let n = block.cols.len();
        let all = jacobian.iter().map(|e| e.row.max(e.col) + 1).max();
        let place = |list: &[usize]| {
            let mut places = vec![None; all.unwrap_or(0)];
            for (place, &member) in list.iter().enumerate() {
                places[member] = Some(place);
            }
            places
        };
        let (rows, cols) = (place(&block.rows), place(&block.cols));
        let inside = |(i, e): (usize, &Entry)| Some((rows[e.row]?, cols[e.col]?, i));
        let entries: Vec<_> = jacobian.iter().enumerate().filter_map(inside).collect();
        let mut patterns = vec![0; n];
        let mut couplings = vec![vec![0; n]; n];
        for &(row, col, i) in &entries {
            patterns[row] |= 1 << col;
            for other in (0..n).filter(|&other| survey.unknowns[i] & 1 << block.cols[other] != 0) {
                couplings[row][col] |= 1 << other;
                couplings[row][other] |= 1 << col;
            }
        }
        for (row, &equation) in block.rows.iter().enumerate() {
            let [unknowns, curved] = survey.contents[equation];
            for (col, unknown) in block.cols.iter().enumerate() {
                patterns[row] |= (unknowns >> unknown & 1) << col;
                couplings[row][col] |= (curved >> unknown & 1) << col;
            }
        }
        let matrix = |values: &Vec<f64>| {
            let mut matrix = vec![vec![0.0; n]; n];
            for &(row, col, i) in &entries {
                matrix[row][col] = values[i];
            }
            matrix.iter_mut().for_each(|row| scale(row));
            matrix
        };
        Self {
            patterns,
            couplings,
            matrices: survey.points.iter().map(matrix).collect(),
        }
    }

    /// The number of equations and unknowns.
    pub(super) fn len(&self) -> usize {
        self.patterns.len()
    }

    /// The equation is linear in all of `unknowns` together.
    pub(super) fn is_linear(&self, row: usize, unknowns: u128) -> bool {
        let couplings = self.couplings[row].iter().enumerate();
        couplings
            .filter(|(col, _)| unknowns & 1 << col != 0)
            .all(|(_, coupling)| coupling & unknowns == 0)
    }
}

fn scale(row: &mut [f64]) {
    let size = row
        .iter()
        .fold(0.0, |size: f64, entry| size.max(entry.abs()));
    row.iter_mut().for_each(|entry| *entry /= size);
}
