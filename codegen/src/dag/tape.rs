//! Part of a graph, ready to be evaluated again and again.

use std::ops::Add;
use std::ops::Mul;

use super::Dag;
use super::Elementary;
use super::Leaf;
use super::Node;
use super::NodeId;
use super::evaluate::call;
use super::evaluate::to_f64;
use num_rational::BigRational;
use num_traits::Zero;

/// What a [`Tape`] computes with: `f64`, or something more precise to judge it by.
pub trait Number: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// The number nearest to high + low, where |low| is at most half a unit in the last place of `high`.
    fn constant(high: f64, low: f64) -> Self;
    /// xⁿ
    fn power(self, exponent: i32) -> Self;
    /// f(x), or f(x, y) of a function of two arguments.
    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self;
}

impl Number for f64 {
    fn constant(high: f64, _low: f64) -> Self {
        high
    }

    fn power(self, exponent: i32) -> Self {
        self.powi(exponent)
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        call(function, x, y.unwrap_or(f64::NAN))
    }
}

/// The nodes that some roots need, operands before users, with their numbers as `N`.
#[derive(Clone, Debug)]
pub struct Tape<N = f64> {
    operations: Vec<Operation<N>>,
    roots: Vec<usize>,
}

/// A node; operands are positions on the tape.
#[derive(Clone, Debug)]
enum Operation<N> {
    Constant(N),
    Leaf(Leaf),
    Sum(Vec<(N, usize)>),
    Product(Vec<(usize, i32)>),
    Call(Elementary, Vec<usize>),
}

impl Dag {
    /// What it takes to evaluate `roots`, and nothing else, in double precision.
    pub fn tape(&self, roots: &[NodeId]) -> Tape {
        self.tape_of(roots)
    }

    /// What it takes to evaluate `roots` and nothing else.
    pub fn tape_of<N: Number>(&self, roots: &[NodeId]) -> Tape<N> {
        let needed = self.reachable(roots);
        let mut position = vec![0; needed.len()];
        let mut operations = Vec::new();
        for (i, node) in self.nodes().iter().enumerate().filter(|(i, _)| needed[*i]) {
            let at = |id: &NodeId| position[id.index()];
            let operation = match node {
                Node::Constant(value) => Operation::Constant(number(value)),
                Node::Pi => Operation::Constant(N::constant(std::f64::consts::PI, PI_LOW)),
                Node::Leaf(leaf) => Operation::Leaf(*leaf),
                Node::Sum(terms) => {
                    Operation::Sum(terms.iter().map(|(c, n)| (number(c), at(n))).collect())
                }
                Node::Product(factors) => {
                    Operation::Product(factors.iter().map(|(n, e)| (at(n), *e)).collect())
                }
                Node::Call(function, arguments) => {
                    Operation::Call(*function, arguments.iter().map(at).collect())
                }
            };
            position[i] = operations.len();
            operations.push(operation);
        }
        let roots = roots.iter().map(|root| position[root.index()]).collect();
        Tape { operations, roots }
    }
}

/// π less its nearest double.
const PI_LOW: f64 = 1.2246467991473532e-16;

fn number<N: Number>(value: &BigRational) -> N {
    let high = to_f64(value);
    if high == 0.0 && !value.is_zero() {
        // Too small for a double, which is not the same as 0.
        return N::constant(0.0, f64::from_bits(1));
    }
    let rest = BigRational::from_float(high).map(|high| value - high);
    N::constant(high, rest.map_or(0.0, |rest| to_f64(&rest)))
}

impl<N: Number> Tape<N> {
    /// The values of the roots for given leaves.
    pub fn evaluate(&self, leaf: impl Fn(Leaf) -> N) -> Vec<N> {
        let mut values: Vec<N> = Vec::with_capacity(self.operations.len());
        let zero = N::constant(0.0, 0.0);
        for operation in &self.operations {
            let value = match operation {
                Operation::Constant(value) => *value,
                Operation::Leaf(l) => leaf(*l),
                Operation::Sum(terms) => {
                    let terms = terms.iter().map(|(c, n)| *c * values[*n]);
                    terms.reduce(N::add).unwrap_or(zero)
                }
                Operation::Product(factors) => {
                    let powers = factors.iter().map(|(n, e)| values[*n].power(*e));
                    powers.reduce(N::mul).unwrap_or(N::constant(1.0, 0.0))
                }
                Operation::Call(function, arguments) => {
                    let argument = |i: usize| arguments.get(i).map(|&n| values[n]);
                    let x = argument(0).unwrap_or(N::constant(f64::NAN, 0.0));
                    N::call(*function, x, argument(1))
                }
            };
            values.push(value);
        }
        self.roots.iter().map(|root| values[*root]).collect()
    }
}
