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

/// `factor` max(±x, 0)
struct Side {
    factor: BigRational,
    x: NodeId,
    /// It is that of x, not of −x.
    is_same: bool,
    /// The terms that it is made of.
    used: Vec<NodeId>,
}

impl Dag {
    /// The sum of merged terms, if some of them are c f(x) ± c x: with these in one term.
    pub(super) fn one_sided(
        &mut self,
        terms: &[(BigRational, NodeId)],
        one: NodeId,
    ) -> Option<NodeId> {
        let found = terms
            .iter()
            .find_map(|term| self.one_side(term, terms, one));
        let Side {
            factor,
            x,
            is_same,
            used,
        } = found?;
        let others = terms.iter().filter(|term| !used.contains(&term.1));
        let mut rest: Vec<_> = others.cloned().collect();
        let side = if is_same { x } else { self.neg(x) };
        rest.push((factor, self.call(Elementary::Positive, vec![side])));
        Some(self.sum(rest))
    }

    /// If a term is c f(x), and c x or −c x is among the others: what they make.
    fn one_side(
        &self,
        (factor, call): &(BigRational, NodeId),
        terms: &[(BigRational, NodeId)],
        one: NodeId,
    ) -> Option<Side> {
        let Node::Call(function, arguments) = self.node(*call) else {
            return None;
        };
        let (signs, times_more): (&[i64], i64) = match function {
            Elementary::Abs => (&[1, -1], 2),
            Elementary::Positive => (&[-1], 1),
            _ => return None,
        };
        let x = arguments[0];
        let (coefficient, core) = self.split_coefficient(x);
        // Merged with others, or by itself.
        let ways = [self.terms(x, one), vec![(coefficient, core)]];
        for own in ways {
            for sign in signs {
                let signed = times(factor, rational(*sign));
                let are_there = own
                    .iter()
                    .all(|(c, core)| terms.contains(&(times(c, signed.clone()), *core)));
                if are_there {
                    let own = own.iter().map(|term| term.1);
                    return Some(Side {
                        factor: times(factor, rational(times_more)),
                        x,
                        is_same: *sign > 0,
                        used: own.chain([*call]).collect(),
                    });
                }
            }
        }
        None
    }
}
