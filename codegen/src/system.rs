//! The equations of one solver as a graph with its structure: the output of `structure`.

use crate::ast::Form;
use crate::dag::Dag;
use crate::dag::NodeId;

/// A structural non-zero of the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Equation.
    pub row: usize,
    /// Unknown.
    pub col: usize,
    /// ∂r/∂x
    pub node: NodeId,
}

/// A diagonal block of the block-triangular form: these equations determine these unknowns once the
/// blocks before it are solved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Equations, ascending.
    pub rows: Vec<usize>,
    /// Unknowns, ascending; as many.
    pub cols: Vec<usize>,
    /// The equations are linear in these unknowns.
    pub linear: bool,
}

/// One solver: r(x) = 0, its Jacobian and what follows from the solution.
#[derive(Clone, Debug)]
pub struct System {
    /// Which unknowns.
    pub form: Form,
    /// All nodes.
    pub dag: Dag,
    /// rᵢ, one per scalar equation.
    pub residual: Vec<NodeId>,
    /// Structural non-zeros, row by row.
    pub jacobian: Vec<Entry>,
    /// First guess of each unknown; of rate Step at most.
    pub guess: Vec<NodeId>,
    /// The state after the step.
    pub next: Vec<NodeId>,
    /// Block-triangular order.
    pub blocks: Vec<Block>,
}

/// What a model says apart from its residual: the roots of a graph of rate Step at most.
#[derive(Clone, Debug)]
pub struct Equations {
    /// All nodes.
    pub dag: Dag,
    /// Default of each parameter component; constant.
    pub defaults: Vec<NodeId>,
    /// Start value of each state component; of rate Scene.
    pub start: Vec<NodeId>,
    /// Each output component.
    pub outputs: Vec<NodeId>,
    /// dx/dt of each state component, if the model has a flow.
    pub flow: Option<Vec<NodeId>>,
}
