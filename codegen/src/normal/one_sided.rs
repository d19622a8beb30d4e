//! Sums that vanish on one side of 0, as the one function that does so to the last digit: x may be a sum whose terms no
//! longer cancel once they are merged with those of others.
//!
//! ```text
//! |x| + x = 2 max(x, 0)        |x| − x = 2 max(−x, 0)        max(x, 0) − x = max(−x, 0)
//! ```

use super::rational;
use super::times;
use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Node;
use crate::dag::NodeId;
use num_rational::BigRational;
use num_traits::Signed;

impl Dag {
    /// c f(x) ± c x in one term, if that is what `call` and `other` are.
    pub(super) fn one_sided(
        &mut self,
        call: &(BigRational, NodeId),
        other: &(BigRational, NodeId),
    ) -> Option<NodeId> {
        let (inner, core) = self.split_coefficient(call.1);
        let Node::Call(function, arguments) = self.node(core) else {
            return None;
        };
        let (function, x) = (*function, arguments[0]);
        let factor = times(&call.0, inner);
        let is_same = self.is_same_side(&factor, x, other)?;
        let factor = match (function, is_same) {
            (Elementary::Abs, _) => times(&rational(2), factor),
            (Elementary::Positive, false) => factor,
            _ => return None,
        };
        let side = if is_same { x } else { self.neg(x) };
        let positive = self.call(Elementary::Positive, vec![side]);
        Some(self.scale(factor, positive))
    }

    /// True where `other` is `factor` x, false where it is −`factor` x.
    fn is_same_side(
        &self,
        factor: &BigRational,
        x: NodeId,
        other: &(BigRational, NodeId),
    ) -> Option<bool> {
        let (of_x, core) = self.split_coefficient(x);
        let (of_other, other_core) = self.split_coefficient(other.1);
        if core != other_core {
            return None;
        }
        let (left, right) = (times(factor, of_x), times(&other.0, of_other));
        (left.abs() == right.abs()).then(|| left == right)
    }
}
