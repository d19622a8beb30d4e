//! What wanted states and outputs depend on.
//!
//! A state needs what its next value is made of; an unknown needs the equations of its block of the
//! block-triangular order, with all unknowns and states in them, and what its first guess is made of.

use super::Solver;
use super::zeros::Zeros;
use super::zeros::advanced;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::model::Model;
use crate::pattern::Pattern;
use crate::scene::Wishes;
use crate::system::Equations;

/// What is needed, component by component; what is 0 is not.
#[derive(Clone, Debug)]
pub(super) struct Needs {
    pub(super) states: Vec<bool>,
    pub(super) unknowns: Vec<bool>,
    pub(super) rows: Vec<bool>,
}

/// What the wanted states and outputs need.
pub(super) fn needs(
    model: &Model,
    equations: &Equations,
    solver: &Solver,
    zeros: &Zeros,
    wishes: &Wishes,
) -> Needs {
    let blocks = blocks(solver, zeros);
    let mut needs = Needs {
        states: vec![false; zeros.states.len()],
        unknowns: vec![false; zeros.unknowns.len()],
        rows: vec![false; zeros.unknowns.len()],
    };
    let mut open: Vec<Leaf> = Vec::new();
    for (state, _) in model.states.iter().zip(&wishes.states).filter(|s| *s.1) {
        let variable = &state.variable;
        let own = variable.offset..variable.offset + variable.shape.len();
        open.extend(own.map(Leaf::State));
    }
    for (output, _) in model.outputs.iter().zip(&wishes.outputs).filter(|o| *o.1) {
        let variable = &output.variable;
        let own = variable.offset..variable.offset + variable.shape.len();
        open.extend(leaves(&equations.dag, &equations.outputs[own]));
    }
    // An unknown that advances a state is no use without it.
    let advanced = advanced(model);
    while let Some(leaf) = open.pop() {
        if zeros.contain(leaf) {
            continue;
        }
        match leaf {
            Leaf::State(i) if !std::mem::replace(&mut needs.states[i], true) => {
                open.extend(leaves(&solver.dag, &[solver.next[i]]));
            }
            Leaf::Unknown(i) if !needs.unknowns[i] => {
                for (rows, cols) in blocks.iter().filter(|block| block.1.contains(&i)) {
                    for &col in cols {
                        needs.unknowns[col] = true;
                        open.extend(leaves(&solver.dag, &[solver.guess[col]]));
                        open.extend(advanced[col].map(Leaf::State));
                    }
                    for &row in rows {
                        needs.rows[row] = true;
                        open.extend(leaves(&solver.dag, &[solver.residual[row]]));
                    }
                }
            }
            _ => {}
        }
    }
    needs
}

/// The blocks of what is left without the zeros; one block of all if it is singular, which is found later.
fn blocks(solver: &Solver, zeros: &Zeros) -> Vec<(Vec<usize>, Vec<usize>)> {
    let n = zeros.unknowns.len();
    let cols: Vec<usize> = (0..n).filter(|&col| !zeros.unknowns[col]).collect();
    let is_gone = |row: &usize| zeros.rows.contains(&Some(*row));
    let rows: Vec<usize> = (0..n).filter(|row| !is_gone(row)).collect();
    let place = |list: &[usize], i: usize| list.iter().position(|&j| j == i);
    let entries = solver.jacobian.iter();
    let pairs = entries.filter_map(|e| Some((place(&rows, e.row)?, place(&cols, e.col)?)));
    let pattern = Pattern::new(cols.len(), pairs);
    let matching: Option<Vec<usize>> = pattern.matching().into_iter().collect();
    let Some(matching) = matching else {
        return vec![(rows, cols)];
    };
    let blocks = pattern.blocks(&matching).into_iter();
    blocks
        .map(|(own_rows, own_cols)| {
            let own_rows = own_rows.into_iter().map(|row| rows[row]);
            let own_cols = own_cols.into_iter().map(|col| cols[col]);
            (own_rows.collect(), own_cols.collect())
        })
        .collect()
}

/// The inputs that `roots` depend on.
pub(super) fn leaves(dag: &Dag, roots: &[NodeId]) -> Vec<Leaf> {
    let needed = dag.reachable(roots);
    let nodes = dag.nodes().iter().zip(needed).filter(|n| n.1);
    let leaf = |node: &Node| match node {
        Node::Leaf(leaf) => Some(*leaf),
        _ => None,
    };
    nodes.filter_map(|(node, _)| leaf(node)).collect()
}
