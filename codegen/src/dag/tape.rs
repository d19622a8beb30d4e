//! Part of a graph, ready to be evaluated again and again.

use super::Dag;
use super::Elementary;
use super::Leaf;
use super::Node;
use super::NodeId;
use super::evaluate::call;
use super::evaluate::to_f64;

/// The nodes that some roots need, operands before users, with their numbers in double precision.
#[derive(Clone, Debug)]
pub struct Tape {
    operations: Vec<Operation>,
    roots: Vec<usize>,
}

/// A node; operands are positions on the tape.
#[derive(Clone, Debug)]
enum Operation {
    Constant(f64),
    Leaf(Leaf),
    Sum(Vec<(f64, usize)>),
    Product(Vec<(usize, i32)>),
    Call(Elementary, Vec<usize>),
}

impl Dag {
    /// What it takes to evaluate `roots` and nothing else.
    pub fn tape(&self, roots: &[NodeId]) -> Tape {
        let needed = self.reachable(roots);
        let mut position = vec![0; needed.len()];
        let mut operations = Vec::new();
        for (i, node) in self.nodes().iter().enumerate().filter(|(i, _)| needed[*i]) {
            let at = |id: &NodeId| position[id.index()];
            let operation = match node {
                Node::Constant(value) => Operation::Constant(to_f64(value)),
                Node::Pi => Operation::Constant(std::f64::consts::PI),
                Node::Leaf(leaf) => Operation::Leaf(*leaf),
                Node::Sum(terms) => {
                    Operation::Sum(terms.iter().map(|(c, n)| (to_f64(c), at(n))).collect())
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

impl Tape {
    /// The values of the roots for given leaves.
    pub fn evaluate(&self, leaf: impl Fn(Leaf) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let value = match operation {
                Operation::Constant(value) => *value,
                Operation::Leaf(l) => leaf(*l),
                Operation::Sum(terms) => terms.iter().map(|(c, n)| c * values[*n]).sum(),
                Operation::Product(factors) => {
                    factors.iter().map(|(n, e)| values[*n].powi(*e)).product()
                }
                Operation::Call(function, arguments) => {
                    let argument = |i: usize| arguments.get(i).map_or(f64::NAN, |&n| values[n]);
                    call(*function, argument(0), argument(1))
                }
            };
            values.push(value);
        }
        self.roots.iter().map(|root| values[*root]).collect()
    }
}
