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

mod candidates;
mod exhaustive;
mod greedy;

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::linear::Divisor;
use crate::linear::growth;
use crate::linear::solve;
use crate::sample::Typical;
use crate::system::Block;
use crate::system::Core;
use crate::system::Entry;
use crate::system::Reduced;
use candidates::Candidates;
use candidates::Survey;
use exhaustive::exhaustive;
use greedy::greedy;

/// Most unknowns of a block of which all choices are compared: 256, and up to 64 choices of equations for each. Each more
/// doubles them.
const FEW: usize = 8;

/// Most unknowns of a block that is solved in closed form however dense it is: 1500 operations.
const SMALL: usize = 12;

/// Most operations of the closed form of a larger block, besides those in proportion to its entries: what a dense one of
/// [`SMALL`] takes, 2n³/3 + 2n². Newton's method spends as much on the same unknowns in every iteration, but in a loop;
/// unrolled they take rustc longer than they are worth.
const MOST_OPERATIONS: usize = 2 * SMALL * SMALL * SMALL / 3 + 2 * SMALL * SMALL;

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
    /// Where choices are compared.
    pub typical: &'a Typical,
}

/// What is left; `None` if every unknown is needed.
pub fn eliminate(dag: &mut Dag, full: &Full) -> Option<Reduced> {
    let n = full.residual.len();
    let survey = Survey::of(dag, full.residual, full.jacobian, full.typical);
    let mut values: Vec<Option<NodeId>> = vec![None; n];
    let mut solved_rows = vec![false; n];
    let mut divisors = Vec::new();
    for block in full.blocks {
        let Some(choice) = choose(block, full.jacobian, &survey) else {
            continue;
        };
        let Some((solution, own)) = closed_form(dag, full, &choice, &values) else {
            continue;
        };
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
    Some(Reduced {
        solved: (0..n).filter(|&row| solved_rows[row]).collect(),
        residual,
        guess: unknowns.iter().map(|&col| full.guess[col]).collect(),
        next,
        growth: growth(dag, &divisors),
        unknowns,
    })
}

/// What to eliminate of a block.
fn choose(block: &Block, jacobian: &[Entry], survey: &Survey) -> Option<Choice> {
    let candidates = Candidates::new(block, jacobian, survey);
    let choice = if block.cols.len() <= FEW {
        exhaustive(&candidates)?
    } else {
        greedy(&candidates)?
    };
    Some(Choice {
        rows: choice.rows.iter().map(|&row| block.rows[row]).collect(),
        cols: choice.cols.iter().map(|&col| block.cols[col]).collect(),
    })
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
    let place = |e: &Entry| {
        let row = choice.rows.iter().position(|&row| row == e.row)?;
        let col = choice.cols.iter().position(|&col| col == e.col)?;
        Some((row, col, e.node))
    };
    let inside: Vec<_> = full.jacobian.iter().filter_map(place).collect();
    let nodes: Vec<NodeId> = inside.iter().map(|entry| entry.2).collect();
    let nodes = put_in(dag, &nodes, values);
    for (&(row, col, _), node) in inside.iter().zip(nodes) {
        a[row][col] = node;
    }
    let residual: Vec<NodeId> = choice.rows.iter().map(|&row| full.residual[row]).collect();
    let at_zero = dag.substitute(&residual, |leaf| match leaf {
        Leaf::Unknown(col) if choice.cols.contains(&col) => Some(zero),
        Leaf::Unknown(col) => values[col],
        _ => None,
    });
    let right: Vec<NodeId> = at_zero.iter().map(|&r| dag.neg(r)).collect();
    let solution = solve(dag, &a, &right, full.typical)?;
    Some((solution.x, solution.divisors))
}

/// `roots` with the eliminated unknowns replaced by their values.
fn put_in(dag: &mut Dag, roots: &[NodeId], values: &[Option<NodeId>]) -> Vec<NodeId> {
    dag.substitute(roots, |leaf| match leaf {
        Leaf::Unknown(col) => values[col],
        _ => None,
    })
}

/// How many times the operations of a solver its core may take. They are counted before they are staged and shared, which
/// halves them, and operations in the loops of a dense solve take longer than unrolled ones; above 2, a core is slower.
const FAR_MORE: usize = 2;

/// True if a step with the core does not take far more operations than one with all of the solver: what is computed in
/// every step and iteration, and a dense solve. What is computed once per run is not counted.
pub fn pays(dag: &Dag, core: &Core, full: &Full) -> bool {
    let reduced = &core.reduced;
    let growth = [reduced.growth];
    let own = [&reduced.residual, &reduced.next, growth.as_slice()];
    let own = operations(dag, &core.jacobian, &own) + dense_solve(reduced.residual.len());
    let all = operations(dag, full.jacobian, &[full.residual, full.next]);
    own <= FAR_MORE * (all + dense_solve(full.residual.len()))
}

/// Operations of rate Step and Iteration.
fn operations(dag: &Dag, jacobian: &[Entry], others: &[&[NodeId]]) -> usize {
    let entries = jacobian.iter().map(|entry| entry.node);
    let roots: Vec<NodeId> = others.concat().into_iter().chain(entries).collect();
    let operations = dag.operations(&roots);
    operations[Rate::Step as usize] + operations[Rate::Iteration as usize]
}

/// Operations of Gaussian elimination with n unknowns: 2n³/3 + 2n², rounded down.
fn dense_solve(n: usize) -> usize {
    2 * n * n * n / 3 + 2 * n * n
}
