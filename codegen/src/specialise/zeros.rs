//! Components that start at 0 and stay there.
//!
//! Let Z be components of the state that start at 0, with their unknowns. If with all of Z set to 0, whatever the
//! rest is,
//!
//! - as many equations vanish identically as there are unknowns in Z, and they determine these, and
//! - first guesses and next values of Z are 0,
//!
//! then Newton's method never leaves Z = 0: the vanishing rows of its Jacobian contain nothing but unknowns of Z.
//! The equations that are left determine the other unknowns.
//!
//! Of all such Z there is a greatest one. The search starts with everything that starts at 0 and takes away what
//! breaks a condition; what it takes away is in no such Z.

use super::Solver;
use super::fold::vanishing_divisors;
use super::needs::leaves;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::model::Model;
use crate::model::Solved;
use crate::system::Equations;

/// Components that are 0 throughout, and the equations that say no more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Zeros {
    /// For each component of the state.
    pub(super) states: Vec<bool>,
    /// For each unknown.
    pub(super) unknowns: Vec<bool>,
    /// For each unknown in Z the equation that vanishes for it.
    pub(super) rows: Vec<Option<usize>>,
}

impl Zeros {
    /// The leaf is taken for 0.
    pub(super) fn contain(&self, leaf: Leaf) -> bool {
        match leaf {
            Leaf::State(i) => self.states[i],
            Leaf::Unknown(i) => self.unknowns[i],
            _ => false,
        }
    }
}

/// For each unknown the component of the state that it advances, if it does.
pub(super) fn advanced(model: &Model) -> Vec<Option<usize>> {
    let component = |(solved, component)| match solved {
        Solved::State(i) => Some(model.states[i].variable.offset + component),
        Solved::Own(_) => None,
    };
    model.unknown_components().map(component).collect()
}

/// The greatest set of components that stay 0.
pub(super) fn zeros(model: &Model, equations: &Equations, solver: &Solver) -> Zeros {
    let advanced = advanced(model);
    let starts = equations.start.iter();
    let states: Vec<bool> = starts.map(|&s| equations.dag.is_zero(s)).collect();
    let in_z = |state: &Option<usize>| state.is_none_or(|i| states[i]);
    let mut zeros = Zeros {
        unknowns: advanced.iter().map(in_z).collect(),
        rows: vec![None; advanced.len()],
        states,
    };
    while !holds(&mut zeros, &advanced, solver) {}
    zeros
}

/// True if `zeros` stay; otherwise some are taken away.
fn holds(zeros: &mut Zeros, advanced: &[Option<usize>], solver: &Solver) -> bool {
    let mut dag = Dag::new();
    let zero = dag.integer(0);
    let entries: Vec<NodeId> = solver.jacobian.iter().map(|e| e.node).collect();
    let roots = [&solver.residual, &solver.guess, &solver.next, &entries].map(Vec::as_slice);
    let grafted = dag.graft(&solver.dag, &roots.concat(), |dag, leaf| {
        if zeros.contain(leaf) {
            zero
        } else {
            dag.leaf(leaf)
        }
    });
    let vanishes = |node: NodeId| grafted[node.index()].is_some_and(|n| dag.is_zero(n));

    let mut wrong: Vec<Leaf> = Vec::new();
    for divisor in vanishing_divisors(&dag, &solver.dag, &grafted) {
        let inputs = leaves(&solver.dag, &[divisor]).into_iter();
        wrong.extend(inputs.filter(|leaf| zeros.contain(*leaf)));
    }
    wrong.extend(members(zeros).filter(|leaf| match *leaf {
        Leaf::State(i) => !vanishes(solver.next[i]),
        Leaf::Unknown(i) => !vanishes(solver.guess[i]),
        _ => false,
    }));
    if wrong.is_empty() {
        let rows: Vec<bool> = solver.residual.iter().map(|&r| vanishes(r)).collect();
        let entries = solver.jacobian.iter();
        let edges = entries.filter(|e| rows[e.row] && zeros.unknowns[e.col] && !vanishes(e.node));
        let edges: Vec<(usize, usize)> = edges.map(|e| (e.row, e.col)).collect();
        let (matched, free) = matching(&edges, &zeros.unknowns);
        zeros.rows = matched;
        wrong.extend(free.into_iter().map(Leaf::Unknown));
    }
    for leaf in &wrong {
        take_away(zeros, advanced, *leaf);
    }
    wrong.is_empty()
}

fn members(zeros: &Zeros) -> impl Iterator<Item = Leaf> + '_ {
    let states = (0..zeros.states.len()).map(Leaf::State);
    let unknowns = (0..zeros.unknowns.len()).map(Leaf::Unknown);
    states.chain(unknowns).filter(|leaf| zeros.contain(*leaf))
}

/// A state goes with its unknown, and the unknown with its state.
fn take_away(zeros: &mut Zeros, advanced: &[Option<usize>], leaf: Leaf) {
    let (state, unknown) = match leaf {
        Leaf::Unknown(i) => (advanced[i], Some(i)),
        Leaf::State(i) => (Some(i), advanced.iter().position(|a| *a == Some(i))),
        _ => (None, None),
    };
    state.into_iter().for_each(|i| zeros.states[i] = false);
    unknown.into_iter().for_each(|i| zeros.unknowns[i] = false);
}

/// A maximum matching of the columns in `wanted` by augmenting paths: the row of each, and those columns that some
/// maximum matching leaves out.
fn matching(edges: &[(usize, usize)], wanted: &[bool]) -> (Vec<Option<usize>>, Vec<usize>) {
    let mut row_of: Vec<Option<usize>> = vec![None; wanted.len()];
    let columns = (0..wanted.len()).filter(|&col| wanted[col]);
    for start in columns.clone() {
        let (reached, free) = reach(edges, &row_of, &[start]);
        let Some(mut row) = free else { continue };
        // Back along the path, each column takes the row that it was left by.
        while let Some(col) = reached.iter().find(|r| r.0 == row).map(|r| r.1) {
            match row_of[col].replace(row) {
                Some(before) => row = before,
                None => break,
            }
        }
    }
    let unmatched: Vec<usize> = columns.filter(|&col| row_of[col].is_none()).collect();
    let (reached, _) = reach(edges, &row_of, &unmatched);
    let holder = |row: usize| row_of.iter().position(|r| *r == Some(row));
    let beyond = reached.iter().filter_map(|&(row, _)| holder(row));
    let mut left_out: Vec<usize> = beyond.chain(unmatched.iter().copied()).collect();
    left_out.sort_unstable();
    left_out.dedup();
    (row_of, left_out)
}

/// The rows reached by alternating paths from `start` columns, each with the column it was reached from, up to the
/// first row that is free.
fn reach(
    edges: &[(usize, usize)],
    row_of: &[Option<usize>],
    start: &[usize],
) -> (Vec<(usize, usize)>, Option<usize>) {
    let mut reached: Vec<(usize, usize)> = Vec::new();
    let mut open = start.to_vec();
    while let Some(col) = open.pop() {
        for &(row, _) in edges.iter().filter(|e| e.1 == col) {
            if reached.iter().any(|r| r.0 == row) {
                continue;
            }
            reached.push((row, col));
            match row_of.iter().position(|r| *r == Some(row)) {
                Some(holder) => open.push(holder),
                None => return (reached, Some(row)),
            }
        }
    }
    (reached, None)
}
