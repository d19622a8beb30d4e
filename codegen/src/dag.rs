//! The scalar graph: flat, interned, operands before users.
//!
//! ```text
//! node ::= constant            exact rational
//!        | π
//!        | leaf                parameter, h, t, state, unknown, variation
//!        | Σ cᵢ nᵢ             rational coefficients, terms in node order
//!        | Π nᵢ^eᵢ             integer powers, factors in node order
//!        | f(n, …)             elementary function
//! ```
//!
//! There are no vectors and no time levels any more. Every node is built through the constructors of
//! `normal`, so equal expressions share a node and no node is simplifiable by itself. A pass over
//! the graph is a loop.

use crate::index::Index;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use std::fmt;
use std::hash::Hash;
use std::hash::Hasher;
use std::mem::discriminant;

mod evaluate;
mod operations;
mod rebuild;
mod sign;
mod tape;
mod text;

pub use tape::Number;
pub use tape::Tape;

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
    /// The variation δ of a component of the unknown vector; only claims contain it.
    Variation(usize),
}

impl Leaf {
    /// How often it changes.
    pub fn rate(self) -> Rate {
        match self {
            Leaf::Parameter(_) | Leaf::StepSize => Rate::Scene,
            Leaf::Time | Leaf::State(_) => Rate::Step,
            Leaf::Unknown(_) | Leaf::Variation(_) => Rate::Iteration,
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
    /// max(x, 0)
    Positive,
    /// x^y for an exponent that is not an integer
    Power,
    /// cₙ(s) = Σ (−s)^j / (n + 2j)!
    Stumpff(u32),
}

impl Elementary {
    /// Those of one argument, but [`Elementary::Stumpff`], which are many.
    pub const UNARY: [Elementary; 15] = [
        Elementary::Sin,
        Elementary::Cos,
        Elementary::Tan,
        Elementary::Asin,
        Elementary::Acos,
        Elementary::Atan,
        Elementary::Sinh,
        Elementary::Cosh,
        Elementary::Tanh,
        Elementary::Exp,
        Elementary::Log,
        Elementary::Sqrt,
        Elementary::Abs,
        Elementary::Sign,
        Elementary::Positive,
    ];
}

/// A node.
#[derive(Clone, Debug, PartialEq, Eq)]
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

/// The graph: a list of distinct nodes, operands before users.
#[derive(Clone, Debug, Default)]
pub struct Dag {
    nodes: Vec<Node>,
    rates: Vec<Rate>,
    index: Index,
}

impl Dag {
    /// A graph without nodes.
    pub fn new() -> Self {
        Self::default()
    }

    /// The node behind an id.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.index()]
    }

    /// All nodes, operands before users.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// How often each node changes.
    pub fn rates(&self) -> &[Rate] {
        &self.rates
    }

    /// How often a node changes.
    pub fn rate(&self, id: NodeId) -> Rate {
        self.rates[id.index()]
    }

    /// The operands of a node, first to last.
    pub fn operands(&self, id: NodeId) -> Vec<NodeId> {
        let mut operands = Vec::new();
        self.node(id).visit(|operand| operands.push(operand));
        operands
    }

    /// The value of a node that is a plain number.
    pub fn as_constant(&self, id: NodeId) -> Option<&BigRational> {
        match self.node(id) {
            Node::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// True for the number 0.
    pub fn is_zero(&self, id: NodeId) -> bool {
        self.as_constant(id).is_some_and(num_traits::Zero::is_zero)
    }

    /// A node as coefficient times the rest: `(−2, x)` for −2x, `(1, x)` for x.
    pub fn split_coefficient(&self, id: NodeId) -> (BigRational, NodeId) {
        match self.node(id) {
            Node::Sum(terms) if terms.len() == 1 => terms[0].clone(),
            _ => (BigRational::one(), id),
        }
    }

    /// For each node whether one of `roots` needs it.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<bool> {
        let mut seen = vec![false; self.nodes.len()];
        for root in roots {
            seen[root.index()] = true;
        }
        for i in (0..self.nodes.len()).rev() {
            if seen[i] {
                self.nodes[i].visit(|operand| seen[operand.index()] = true);
            }
        }
        seen
    }

    /// For each node whether it depends on a leaf that `is_variable` accepts.
    pub fn dependence(&self, is_variable: impl Fn(Leaf) -> bool) -> Vec<bool> {
        let mut depends = vec![false; self.nodes.len()];
        for (i, node) in self.nodes.iter().enumerate() {
            depends[i] = match node {
                Node::Leaf(leaf) => is_variable(*leaf),
                _ => {
                    let mut any = false;
                    node.visit(|operand| any |= depends[operand.index()]);
                    any
                }
            };
        }
        depends
    }

    /// For each node the unknowns among `first`, …, `first` + 127 that it depends on: bit i stands for unknown
    /// `first` + i.
    pub fn unknowns(&self, first: usize) -> Vec<u128> {
        let mut masks = vec![0; self.nodes.len()];
        for (i, node) in self.nodes.iter().enumerate() {
            masks[i] = match node {
                Node::Leaf(Leaf::Unknown(col)) if (first..first + 128).contains(col) => {
                    1 << (col - first)
                }
                _ => {
                    let mut mask = 0;
                    node.visit(|operand| mask |= masks[operand.index()]);
                    mask
                }
            };
        }
        masks
    }

    /// For each node those of the first 128 unknowns that stand in arguments of functions or in powers. It is linear in none of them,
    /// whatever its derivative says: that of sign x is 0, and that of atan(tan x) is 1 beside every jump.
    pub fn curved(&self) -> Vec<u128> {
        let unknowns = self.unknowns(0);
        let mut masks = vec![0; self.nodes.len()];
        for (i, node) in self.nodes.iter().enumerate() {
            let of = |operand: &NodeId| masks[operand.index()];
            masks[i] = match node {
                Node::Constant(_) | Node::Pi | Node::Leaf(_) => 0,
                Node::Sum(terms) => terms.iter().fold(0, |mask, (_, term)| mask | of(term)),
                Node::Product(factors) => factors.iter().fold(0, |mask, (factor, exponent)| {
                    mask | match exponent {
                        1 => of(factor),
                        _ => unknowns[factor.index()],
                    }
                }),
                Node::Call(_, arguments) => arguments
                    .iter()
                    .fold(0, |mask, argument| mask | unknowns[argument.index()]),
            };
        }
        masks
    }

    /// The id of `node`, which must be in normal form: only `normal` calls this.
    pub(crate) fn intern(&mut self, node: Node) -> NodeId {
        let id = |position| NodeId(u32::try_from(position).expect("a graph of 2^32 nodes"));
        let hash = match self.index.find(|i| &self.nodes[i], &node) {
            Ok(position) => return id(position),
            Err(hash) => hash,
        };
        let rate = match &node {
            Node::Leaf(leaf) => leaf.rate(),
            _ => {
                let mut rate = Rate::Scene;
                node.visit(|operand| rate = rate.max(self.rate(operand)));
                rate
            }
        };
        self.rates.push(rate);
        self.nodes.push(node);
        self.index.push(hash);
        id(self.nodes.len() - 1)
    }

    /// Checks what every pass relies on: operands stand before users, nodes are distinct.
    ///
    /// # Errors
    /// Says which node breaks which rule.
    pub fn verify(&self) -> Result<(), String> {
        for (i, node) in self.nodes.iter().enumerate() {
            let mut is_ahead = false;
            node.visit(|operand| is_ahead |= operand.index() >= i);
            if is_ahead {
                return Err(format!(
                    "node {i} uses a node that does not stand before it"
                ));
            }
            if self.index.find(|j| &self.nodes[j], node) != Ok(i) {
                return Err(format!("node {i} stands twice"));
            }
        }
        Ok(())
    }
}

impl Node {
    /// Calls `each` with every operand, first to last.
    fn visit(&self, mut each: impl FnMut(NodeId)) {
        match self {
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => {}
            Node::Sum(terms) => terms.iter().for_each(|t| each(t.1)),
            Node::Product(factors) => factors.iter().for_each(|f| each(f.0)),
            Node::Call(_, arguments) => arguments.iter().for_each(|a| each(*a)),
        }
    }
}

/// As derived, but for numbers, of which the hash of a [`BigRational`] takes a continued fraction: they are in lowest
/// terms, and few expressions differ in nothing but large numbers.
impl Hash for Node {
    fn hash<H: Hasher>(&self, state: &mut H) {
        discriminant(self).hash(state);
        match self {
            Node::Constant(value) => low_digits(value).hash(state),
            Node::Pi => {}
            Node::Leaf(leaf) => leaf.hash(state),
            Node::Sum(terms) => {
                for (coefficient, id) in terms {
                    (low_digits(coefficient), id).hash(state);
                }
            }
            Node::Product(factors) => factors.hash(state),
            Node::Call(function, arguments) => (function, arguments).hash(state),
        }
    }
}

/// The low digits of numerator and denominator, with the sign: enough of a number for its hash.
pub(crate) fn low_digits(value: &BigRational) -> u64 {
    let low = |part: &BigInt| part.iter_u64_digits().next().unwrap_or(0);
    let signed = low(value.numer()) << 1 | u64::from(value.is_negative());
    signed ^ low(value.denom()).rotate_left(32)
}

impl fmt::Display for Dag {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, node) in self.nodes.iter().enumerate() {
            write!(f, "%{i} = ")?;
            match node {
                Node::Constant(value) => writeln!(f, "{value}")?,
                Node::Pi => writeln!(f, "π")?,
                Node::Leaf(leaf) => writeln!(f, "{leaf:?}")?,
                Node::Sum(terms) => {
                    let terms: Vec<_> =
                        terms.iter().map(|(c, n)| format!("{c} %{}", n.0)).collect();
                    writeln!(f, "{}", terms.join(" + "))?;
                }
                Node::Product(factors) => {
                    let factors: Vec<_> = factors
                        .iter()
                        .map(|(n, e)| format!("%{}^{e}", n.0))
                        .collect();
                    writeln!(f, "{}", factors.join(" "))?;
                }
                Node::Call(function, arguments) => {
                    let arguments: Vec<_> = arguments.iter().map(|n| format!("%{}", n.0)).collect();
                    writeln!(f, "{function:?}({})", arguments.join(", "))?;
                }
            }
        }
        Ok(())
    }
}
