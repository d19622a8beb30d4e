//! What can be said of the sign of a node, whatever its inputs are.

use super::Dag;
use super::Elementary;
use super::Node;
use super::NodeId;
use num_rational::BigRational;
use num_traits::Signed;

impl Dag {
    /// True for sums of a number above 0 and terms that are never negative; false where nothing is known.
    pub fn is_positive(&self, id: NodeId) -> bool {
        let Node::Sum(terms) = self.node(id) else {
            return false;
        };
        let is_never_negative =
            |(c, node): &(BigRational, NodeId)| c.is_positive() && self.is_never_negative(*node);
        let is_number = |(c, node): &(BigRational, NodeId)| {
            c.is_positive() && self.as_constant(*node).is_some_and(Signed::is_positive)
        };
        terms.iter().all(is_never_negative) && terms.iter().any(is_number)
    }

    /// True for numbers from 0 and for products of even powers; false where nothing is known.
    pub fn is_never_negative(&self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Constant(value) => !value.is_negative(),
            Node::Pi => true,
            Node::Product(factors) => factors.iter().all(|(_, exponent)| exponent % 2 == 0),
            Node::Call(
                Elementary::Exp | Elementary::Cosh | Elementary::Abs | Elementary::Positive,
                _,
            ) => true,
            Node::Leaf(_) | Node::Sum(_) | Node::Call(..) => false,
        }
    }
}
