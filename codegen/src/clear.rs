//! Equations multiplied by a denominator that is never 0.
//!
//! What elimination puts into the core, A(y)⁻¹ b(y), brings the same few determinants into every equation. Where an
//! equation is affine in 1/d it is multiplied by d:
//!
//! ```text
//! a(y) + b(y)/d(y) = 0  →  a(y) d(y) + b(y) = 0
//! ```
//!
//! It has the same roots, for d > 0 is plain to see, and no division, nor has its Jacobian.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;

/// The equations without the denominators that can be seen to be positive.
pub fn clear(dag: &mut Dag, equations: &[NodeId]) -> Vec<NodeId> {
    equations
        .iter()
        .map(|&equation| clear_one(dag, equation))
        .collect()
}

fn clear_one(dag: &mut Dag, mut equation: NodeId) -> NodeId {
    for denominator in denominators(dag, equation) {
        if let Some((without, with)) = affine(dag, equation, denominator) {
            let without = dag.mul(without, denominator);
            equation = dag.add(without, with);
        }
    }
    equation
}

/// Positive sums that the unknowns change and that something is divided by, once.
fn denominators(dag: &Dag, root: NodeId) -> Vec<NodeId> {
    let reachable = dag.reachable(&[root]);
    let varies = dag.dependence(|leaf| matches!(leaf, Leaf::Unknown(_)));
    let mut found = Vec::new();
    for (i, node) in dag.nodes().iter().enumerate() {
        let Node::Product(factors) = node else {
            continue;
        };
        for &(factor, exponent) in factors {
            let is_one = reachable[i] && exponent == -1 && varies[factor.index()];
            if is_one && dag.is_positive(factor) && !found.contains(&factor) {
                found.push(factor);
            }
        }
    }
    found
}

/// (a, b) with root = a + b/d; `None` if 1/d enters otherwise.
fn affine(dag: &mut Dag, root: NodeId, d: NodeId) -> Option<(NodeId, NodeId)> {
    let reachable = dag.reachable(&[root]);
    let zero = dag.integer(0);
    // What a node is in 1/d; `None` is it, whole, without.
    let mut parts: Vec<Option<(NodeId, NodeId)>> = vec![None; root.index() + 1];
    for i in (0..=root.index()).filter(|&i| reachable[i]) {
        let id = NodeId(i as u32);
        let has_parts = dag.operands(id).iter().any(|o| parts[o.index()].is_some());
        parts[i] = match dag.node(id).clone() {
            Node::Sum(terms) if has_parts => {
                let mut sides = [Vec::new(), Vec::new()];
                for (c, term) in terms {
                    let (a, b) = parts[term.index()].unwrap_or((term, zero));
                    sides[0].push((c.clone(), a));
                    sides[1].push((c, b));
                }
                let [a, b] = sides.map(|side| dag.sum(side));
                Some((a, b))
            }
            Node::Product(factors) => {
                let mut others = Vec::new();
                let mut split = None;
                for (factor, exponent) in factors {
                    if factor == d && exponent < 0 {
                        if exponent != -1 || split.is_some() {
                            return None;
                        }
                        split = Some((zero, dag.integer(1)));
                    } else if let Some(parts) = parts[factor.index()] {
                        if exponent != 1 || split.is_some() {
                            return None;
                        }
                        split = Some(parts);
                    } else {
                        others.push((factor, exponent));
                    }
                }
                split.map(|(a, b)| {
                    let others = dag.product(others);
                    (dag.mul(a, others), dag.mul(b, others))
                })
            }
            _ if has_parts => return None,
            _ => None,
        };
    }
    parts[root.index()]
}

#[cfg(test)]
mod tests {
    use super::clear;
    use crate::dag::Dag;
    use crate::dag::Leaf;
    use crate::dag::NodeId;

    /// x, y and 1 + x².
    fn inputs() -> (Dag, NodeId, NodeId, NodeId) {
        let mut dag = Dag::new();
        let [x, y] = [0, 1].map(|i| dag.leaf(Leaf::Unknown(i)));
        let (one, square) = (dag.integer(1), dag.mul(x, x));
        let d = dag.add(one, square);
        (dag, x, y, d)
    }

    #[test]
    fn an_affine_equation_is_multiplied() {
        let (mut dag, x, y, d) = inputs();
        let quotient = dag.div(x, d);
        let inner = dag.add(quotient, y);
        let product = dag.mul(y, inner);
        let equation = dag.sub(product, x);
        // y (x/d + y) − x, times d
        let (yy, yx) = (dag.mul(y, y), dag.mul(y, x));
        let difference = dag.sub(yy, x);
        let first = dag.mul(difference, d);
        let expected = dag.add(first, yx);
        assert_eq!(clear(&mut dag, &[equation]), [expected]);
    }

    #[test]
    fn what_is_not_affine_stays() {
        let (mut dag, x, y, d) = inputs();
        let quotient = dag.div(x, d);
        let square = dag.mul(quotient, quotient);
        let sine = dag.call(crate::dag::Elementary::Sin, vec![quotient]);
        for equation in [dag.add(square, y), dag.add(sine, y)] {
            assert_eq!(clear(&mut dag, &[equation]), [equation]);
        }
    }

    #[test]
    fn a_denominator_that_may_vanish_stays() {
        let (mut dag, x, y, _) = inputs();
        let sum = dag.add(x, y);
        let quotient = dag.div(x, sum);
        let equation = dag.add(quotient, y);
        assert_eq!(clear(&mut dag, &[equation]), [equation]);
    }
}
