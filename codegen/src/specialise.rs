//! A model made for one scene: the same solver with less in it.
//!
//! In come a model as scalars and what a scene wants of it; out goes a model in which
//!
//! 1. fixed parameters are numbers, and all that follows from them is folded (`fold`),
//! 2. components that start at 0 and provably stay there are 0 (`zeros`),
//! 3. only what wanted states and outputs depend on is left (`needs`),
//!
//! and a list of all that is gone, with reasons (`reasons`). The rest of the pipeline takes it for a model like
//! any other (`narrow`).

mod fold;
mod narrow;
mod needs;
mod reasons;
mod zeros;

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::model::Model;
use crate::scene::Skipped;
use crate::scene::Wishes;
use crate::system::Discrete;
use crate::system::Entry;
use crate::system::Equations;
use std::fmt;

/// A model made for a scene.
#[derive(Clone, Debug)]
pub struct Special {
    /// Names and texts of what is left. Its expressions are those of the whole model.
    pub model: Model,
    /// Defaults, start, outputs, flow.
    pub equations: Equations,
    /// The solver.
    pub discrete: Discrete,
    /// Positions in the flat state that stay 0, each with the reason.
    pub zeros: Vec<(usize, String)>,
    /// What is gone.
    pub skipped: Vec<Skipped>,
}

/// Why no solver can be made for a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// Something is divided by 0 with the values that are fixed.
    DivisionByZero,
    /// Nothing is left to be solved for.
    NothingToSolve,
}

impl fmt::Display for Unfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Unfit::DivisionByZero => "division by zero with the values that are fixed",
            Unfit::NothingToSolve => {
                "nothing that is kept needs an equation to be solved: it follows from 0 or from `update` alone"
            }
        })
    }
}

/// The graph of a solver and what is wanted from it, parameters folded in.
struct Solver {
    dag: Dag,
    residual: Vec<NodeId>,
    guess: Vec<NodeId>,
    next: Vec<NodeId>,
    jacobian: Vec<Entry>,
}

/// `model` with `equations` and one solver, the Jacobian of which has the entries `jacobian`, as `wishes` want it.
///
/// # Errors
/// Values that cannot be folded in, and scenes in which nothing moves.
pub fn specialise(
    model: &Model,
    equations: &Equations,
    discrete: &Discrete,
    jacobian: &[Entry],
    wishes: &Wishes,
) -> Result<Special, Unfit> {
    let is_fixed = fold::components(model, wishes);
    let equations = fold::equations(equations, &is_fixed)?;
    let solver = fold::solver(discrete, jacobian, &equations, &is_fixed)?;
    let zeros = zeros::zeros(model, &equations, &solver);
    let solver = fold::with_zeros(&solver, &zeros);
    let equations = fold::equations_with_zeros(&equations, &zeros);
    let needs = needs::needs(model, &equations, &solver, &zeros, wishes);
    if needs.unknowns.iter().all(|needed| !needed) {
        return Err(Unfit::NothingToSolve);
    }
    let left = narrow::narrow(model, &equations, &solver, &zeros, &needs, wishes);
    Ok(reasons::explained(model, left, &zeros, &needs, wishes))
}
