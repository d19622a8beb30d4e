//! What it costs to compute part of a graph.

use super::Dag;
use super::Node;
use super::NodeId;
use num_traits::One;
use num_traits::Signed;

impl Dag {
    /// Additions, multiplications, divisions and calls of everything that `roots` need, for each [`super::Rate`] what is
    /// computed at it; a sum or product counts at its own rate as a whole.
    pub fn operations(&self, roots: &[NodeId]) -> [usize; 3] {
        let mut operations = [0; 3];
        let needed = self.reachable(roots);
        for (i, node) in self.nodes.iter().enumerate().filter(|(i, _)| needed[*i]) {
            operations[self.rates[i] as usize] += node.operations();
        }
        operations
    }
}

impl Node {
    fn operations(&self) -> usize {
        match self {
            Node::Constant(_) | Node::Pi | Node::Leaf(_) => 0,
            Node::Sum(terms) => {
                let scaled = terms.iter().filter(|t| !t.0.abs().is_one()).count();
                terms.len() - 1 + scaled
            }
            // Powers are repeated squares.
            Node::Product(factors) => {
                let squares = factors.iter().map(|f| f.1.unsigned_abs().ilog2() as usize);
                let divisions = factors.iter().any(|f| f.1 < 0);
                factors.len() - 1 + squares.sum::<usize>() + usize::from(divisions)
            }
            Node::Call(..) => 1,
        }
    }
}
