//! Equations as graphs: as `lower` leaves them, and with their derivatives and structure.

use crate::ast::Form;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::model::Shape;

/// A solver as scalars, before its derivative is known.
#[derive(Clone, Debug)]
pub struct Discrete {
    /// Which unknowns.
    pub form: Form,
    /// All nodes.
    pub dag: Dag,
    /// rᵢ = left − right, one per scalar equation.
    pub residual: Vec<NodeId>,
    /// First guess of each unknown.
    pub guess: Vec<NodeId>,
    /// The state after the step.
    pub next: Vec<NodeId>,
    /// Each claim of the model; nothing for one about the continuous equations.
    pub claims: Vec<Claimed>,
}

/// A claim as scalars.
#[derive(Clone, Debug, Default)]
pub struct Claimed {
    /// Block rows of a Jacobian.
    pub blocks: Vec<Vec<ClaimedBlock>>,
    /// Left and right of every component of the equations of any other kind.
    pub sides: Vec<(NodeId, NodeId)>,
    /// Left − right of the same.
    pub differences: Vec<NodeId>,
}

impl Claimed {
    /// Everything that may be compared.
    pub fn nodes(&self) -> impl Iterator<Item = NodeId> {
        let blocks = self.blocks.iter().flatten().flat_map(|b| &b.entries);
        let sides = self.sides.iter().flat_map(|s| [&s.0, &s.1]);
        blocks.chain(sides).chain(&self.differences).copied()
    }
}

/// A block of a claim as written.
#[derive(Clone, Debug)]
pub struct ClaimedBlock {
    /// Its shape; `None` for a multiple of `I` without a size.
    pub shape: Option<Shape>,
    /// Row by row; the factor alone for a multiple of `I`.
    pub entries: Vec<NodeId>,
}

/// Everything but the solvers, before the flow is solved for the rates.
#[derive(Clone, Debug)]
pub struct Continuous {
    /// All nodes.
    pub dag: Dag,
    /// Default of each parameter component.
    pub defaults: Vec<NodeId>,
    /// Start value of each state component.
    pub start: Vec<NodeId>,
    /// Each output component.
    pub outputs: Vec<NodeId>,
    /// The components of the left and then of the right side of each requirement.
    pub requirements: Vec<Vec<NodeId>>,
    /// Left − right of each continuous equation; the rates are its unknowns, in state order.
    pub flow: Vec<NodeId>,
    /// Each claim of the model; nothing for one about the discrete equations.
    pub claims: Vec<Claimed>,
}

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
    /// What it adds to the state, where that is all it does and the unknowns are increments.
    pub change: Option<Vec<NodeId>>,
    /// Block-triangular order.
    pub blocks: Vec<Block>,
    /// What is left to iterate on, if that is less.
    pub core: Option<Core>,
    /// Newton's correction of what is iterated on, the core or else all, where it is short.
    pub correction: Option<Correction>,
    /// What Newton's method would be given by each claim of the model, if it gives anything that fits.
    pub printed: Vec<Option<Printed>>,
}

impl System {
    /// The roots that are emitted besides the residual.
    pub fn derived(&self) -> Vec<NodeId> {
        let mut roots: Vec<NodeId> = self.jacobian.iter().map(|entry| entry.node).collect();
        roots.extend(self.guess.iter().chain(&self.next));
        roots.extend(self.change.iter().flatten());
        if let Some(core) = &self.core {
            let reduced = &core.reduced;
            roots.extend(core.jacobian.iter().map(|entry| entry.node));
            roots.extend(reduced.residual.iter().chain(&reduced.next));
            roots.extend(core.change.iter().flatten());
            roots.push(reduced.growth);
        }
        if let Some(correction) = &self.correction {
            roots.extend(&correction.x);
            roots.push(correction.growth);
        }
        roots
    }
}

/// What is left of a solver, with its derivative.
#[derive(Clone, Debug)]
pub struct Core {
    /// Equations and unknowns.
    pub reduced: Reduced,
    /// Structural non-zeros, row by row; columns are positions in [`Reduced::unknowns`].
    pub jacobian: Vec<Entry>,
    /// What a step adds to the state, as for the whole solver.
    pub change: Option<Vec<NodeId>>,
}

/// A solver after unknowns that enter linearly are eliminated, before its derivative is known.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The unknowns that are left, ascending.
    pub unknowns: Vec<usize>,
    /// The equations that are solved for the others, ascending.
    pub solved: Vec<usize>,
    /// As many equations.
    pub residual: Vec<NodeId>,
    /// First guess of each unknown that is left.
    pub guess: Vec<NodeId>,
    /// The state after the step.
    pub next: Vec<NodeId>,
    /// How many times larger than rounding the error of the eliminated unknowns may be; the number 0 if no
    /// divisor can cancel.
    pub growth: NodeId,
}

/// J⁻¹ r in closed form.
#[derive(Clone, Debug)]
pub struct Correction {
    /// One per unknown.
    pub x: Vec<NodeId>,
    /// How many times larger than rounding its error may be; the number 0 if no divisor can cancel.
    pub growth: NodeId,
}

/// Newton's equations as somebody who trusts a claim would code them.
#[derive(Clone, Debug)]
pub struct Printed {
    /// rᵢ: as claimed, or the model's own under a claimed Jacobian.
    pub residual: Vec<NodeId>,
    /// All entries row by row: as claimed, or the derivative of a claimed residual.
    pub jacobian: Vec<NodeId>,
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
    /// The components of the left and then of the right side of each requirement.
    pub requirements: Vec<Vec<NodeId>>,
    /// dx/dt of each state component, if the model has a flow.
    pub flow: Option<Vec<NodeId>>,
}

/// Recurrences for the Taylor coefficients of a motion.
///
/// The unknowns of its graph are, in this order: the coefficients of order n of the state, those of t, n itself, 1/n, and
/// in turns an inner sum Σ aⱼ bₙ₋ⱼ, 0 < j < n, and a product Σ aⱼ bₙ₋ⱼ, 0 ≤ j ≤ n, of quantities that need none of both.
#[derive(Clone, Debug)]
pub struct Series {
    /// All nodes.
    pub dag: Dag,
    /// dx/dt of each state component, of order 0.
    pub rates: Vec<NodeId>,
    /// Its coefficient of order n.
    pub coefficients: Vec<NodeId>,
    /// aₙ and bₙ of each inner sum.
    pub sums: Vec<[NodeId; 2]>,
    /// aₙ and bₙ of each product.
    pub products: Vec<[NodeId; 2]>,
    /// a₀ and b₀ of each product.
    pub starts: Vec<[NodeId; 2]>,
    /// The number 0.
    pub zero: NodeId,
}

impl Series {
    /// Unknowns that are no component of the state: t, n, 1/n.
    pub const GIVEN: usize = 3;

    /// The coefficient of order n of t.
    pub fn time(n_states: usize) -> Leaf {
        Leaf::Unknown(n_states)
    }

    /// n
    pub fn order(n_states: usize) -> Leaf {
        Leaf::Unknown(n_states + 1)
    }

    /// 1/n
    pub fn inverse_order(n_states: usize) -> Leaf {
        Leaf::Unknown(n_states + 2)
    }

    /// An inner sum.
    pub fn sum(n_states: usize, lane: usize) -> usize {
        n_states + Self::GIVEN + 2 * lane
    }

    /// A product.
    pub fn product(n_states: usize, lane: usize) -> usize {
        n_states + Self::GIVEN + 2 * lane + 1
    }
}
