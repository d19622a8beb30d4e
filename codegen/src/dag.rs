//! The scalar graph: flat, interned, operands before users.
//!
//! ```text
//! node ::= constant            exact rational
//!        | π
//!        | leaf                parameter, h, t, state, unknown
//!        | Σ cᵢ nᵢ             rational coefficients, terms in node order
//!        | Π nᵢ^eᵢ             integer powers, factors in node order
//!        | f(n, …)             elementary function
//! ```
//!
//! There are no vectors and no time levels any more. Every node is built through the constructors of
//! `normal`, so equal expressions share a node and no node is simplifiable by itself. A pass over
//! the graph is a loop.

use num_rational::BigRational;
use num_traits::ToPrimitive;
use std::collections::HashMap;
use std::fmt;

/// Index of a node in its [`Dag`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

impl NodeId {
    /// The position in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// How often a value changes, slowest first. A node's rate is the maximum of its operands'.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Rate {
    /// Parameters and h: once per run.
    Scene,
    /// Time and the known state: once per step.
    Step,
    /// Unknowns: every Newton iteration.
    Iteration,
}

/// An input of the graph. Indices count scalar components over all variables of the kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Leaf {
    /// A parameter component.
    Parameter(usize),
    /// The step h.
    StepSize,
    /// The time t of the known state.
    Time,
    /// A component of the known state.
    State(usize),
    /// A component of the unknown vector.
    Unknown(usize),
}

impl Leaf {
    /// How often it changes.
    pub fn rate(self) -> Rate {
        match self {
            Leaf::Parameter(_) | Leaf::StepSize => Rate::Scene,
            Leaf::Time | Leaf::State(_) => Rate::Step,
            Leaf::Unknown(_) => Rate::Iteration,
        }
    }
}

/// An elementary function.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Elementary {
    /// sin x
    Sin,
    /// cos x
    Cos,
    /// tan x
    Tan,
    /// asin x
    Asin,
    /// acos x
    Acos,
    /// atan x
    Atan,
    /// atan2(y, x)
    Atan2,
    /// sinh x
    Sinh,
    /// cosh x
    Cosh,
    /// tanh x
    Tanh,
    /// eˣ
    Exp,
    /// ln x
    Log,
    /// √x
    Sqrt,
    /// |x|
    Abs,
    /// sign x, 0 at 0
    Sign,
    /// x^y for an exponent that is not an integer
    Power,
    /// cₙ(s) = Σ (−s)^j / (n + 2j)!
    Stumpff(u32),
}

/// A node.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// An exact number.
    Constant(BigRational),
    /// π
    Pi,
    /// An input.
    Leaf(Leaf),
    /// Σ cᵢ nᵢ
    Sum(Vec<(BigRational, NodeId)>),
    /// Π nᵢ^eᵢ
    Product(Vec<(NodeId, i32)>),
    /// f(n, …)
    Call(Elementary, Vec<NodeId>),
}
