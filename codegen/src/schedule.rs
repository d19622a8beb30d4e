//! What is computed where: the output of `stage`, the input of `emit`.

use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::Rate;
use num_rational::BigRational;

/// Index of a value in its [`Schedule`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueId(pub u32);

impl ValueId {
    /// The position in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// How a value comes about. Unlike a node of the graph, a sum or product here is split so that each
/// part is computed at its own rate.
#[derive(Clone, Debug, PartialEq)]
pub enum Op {
    /// An exact number.
    Constant(BigRational),
    /// π
    Pi,
    /// An input.
    Leaf(Leaf),
    /// Σ cᵢ vᵢ, left to right.
    Sum(Vec<(BigRational, ValueId)>),
    /// c · Π vᵢ / Π wᵢ, left to right; powers are repeated factors or values of their own.
    Product {
        /// Factor in front, 1 if none.
        coefficient: BigRational,
        /// Factors.
        numerator: Vec<ValueId>,
        /// Divisors.
        denominator: Vec<ValueId>,
    },
    /// f(v, …)
    Call(Elementary, Vec<ValueId>),
}

/// A value and when it is computed.
#[derive(Clone, Debug)]
pub struct Value {
    /// How.
    pub op: Op,
    /// When.
    pub rate: Rate,
}

/// A function to emit.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// `residual`, `jacobian`, `flow`, …
    pub name: &'static str,
    /// When it is called.
    pub rate: Rate,
    /// Its results.
    pub roots: Vec<ValueId>,
    /// The values of its own rate that it computes, operands first.
    pub body: Vec<ValueId>,
}

/// Additions, multiplications, divisions and calls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// `+` and `-`
    pub additions: usize,
    /// `*`
    pub multiplications: usize,
    /// `/`
    pub divisions: usize,
    /// Elementary functions.
    pub calls: usize,
}

/// Values at their rates.
#[derive(Clone, Debug)]
pub struct Schedule {
    /// All values, operands first.
    pub values: Vec<Value>,
    /// Values of rate Scene that faster code needs: the fields of the scene cache.
    pub scene: Vec<ValueId>,
    /// Values of rate Step that faster code needs: the fields of the step cache.
    pub step: Vec<ValueId>,
    /// The functions to emit.
    pub kernels: Vec<Kernel>,
}
