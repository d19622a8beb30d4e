//! Exact derivatives: from residuals to the structural non-zeros of their Jacobian.
//!
//! Forward through the list once per unknown, over the nodes that depend on it, and shared with everything else since
//! derivatives are nodes of the same graph.

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::normal::rational;
use crate::system::Entry;
use num_rational::BigRational;
use num_traits::One;

/// ∂rootᵢ/∂xⱼ wherever it is not identically zero, row by row; x are the unknowns.
pub fn differentiate(dag: &mut Dag, roots: &[NodeId], n_unknowns: usize) -> Vec<Entry> {
    let needed = dag.reachable(roots);
    let mut derivatives: Vec<Option<NodeId>> = vec![None; needed.len()];
    let mut entries = Vec::new();
    let mut depends = Vec::new();
    for col in 0..n_unknowns {
        if col % 128 == 0 {
            let masks = dag.unknowns(col).into_iter().zip(&needed).enumerate();
            let masks = masks.filter(|(_, (mask, needed))| **needed && *mask != 0);
            depends = masks.map(|(i, (mask, _))| (i, mask)).collect();
        }
        let bit = 1_u128 << (col % 128);
        let own = depends.iter().filter(|(_, mask)| mask & bit != 0);
        derivatives.fill(None);
        for &(i, _) in own {
            derivatives[i] = derivative(dag, i, &derivatives);
        }
        for (row, root) in roots.iter().enumerate() {
            if let Some(node) = derivatives[root.index()] {
                entries.push(Entry { row, col, node });
            }
        }
    }
    entries.sort_by_key(|e| (e.row, e.col));
    entries
}

/// The derivative of a node from those of its operands; `None` where it vanishes.
fn derivative(dag: &mut Dag, index: usize, operands: &[Option<NodeId>]) -> Option<NodeId> {
    let of = |id: NodeId| operands[id.index()];
    let result = match &dag.nodes()[index] {
        Node::Constant(_) | Node::Pi => return None,
        Node::Leaf(_) => dag.integer(1),
        Node::Sum(terms) => {
            let terms: Vec<_> = terms
                .iter()
                .filter_map(|(c, n)| Some((c.clone(), of(*n)?)))
                .collect();
            dag.sum(terms)
        }
        Node::Product(factors) => {
            let factors = factors.clone();
            let terms: Vec<_> = (0..factors.len())
                .filter_map(|i| Some(product_term(dag, &factors, i, of(factors[i].0)?)))
                .collect();
            dag.sum(terms)
        }
        Node::Call(function, arguments) => {
            let (function, arguments) = (*function, arguments.clone());
            let mut terms = Vec::new();
            for (i, argument) in arguments.iter().enumerate() {
                if let Some(inner) = of(*argument) {
                    let outer = partial(dag, function, &arguments, i);
                    terms.push((BigRational::one(), dag.mul(outer, inner)));
                }
            }
            dag.sum(terms)
        }
    };
    (!dag.is_zero(result)).then_some(result)
}

/// e nᵢ^(e−1) nᵢ' Π_{j≠i} nⱼ
fn product_term(
    dag: &mut Dag,
    factors: &[(NodeId, i32)],
    i: usize,
    inner: NodeId,
) -> (BigRational, NodeId) {
    let mut term = factors.to_vec();
    let exponent = term[i].1;
    term[i].1 -= 1;
    term.push((inner, 1));
    (rational(exponent.into()), dag.product(term))
}

/// ∂f/∂(argument i)
fn partial(dag: &mut Dag, function: Elementary, arguments: &[NodeId], i: usize) -> NodeId {
    let x = arguments[0];
    let one = dag.integer(1);
    match function {
        Elementary::Sin => dag.call(Elementary::Cos, vec![x]),
        Elementary::Cos => {
            let sin = dag.call(Elementary::Sin, vec![x]);
            dag.neg(sin)
        }
        Elementary::Tan => {
            let tan = dag.call(Elementary::Tan, vec![x]);
            let square = dag.mul(tan, tan);
            dag.add(one, square)
        }
        Elementary::Asin => inverse_root_of_complement(dag, x),
        Elementary::Acos => {
            let positive = inverse_root_of_complement(dag, x);
            dag.neg(positive)
        }
        Elementary::Atan => {
            let square = dag.mul(x, x);
            let below = dag.add(one, square);
            dag.product([(below, -1)])
        }
        Elementary::Atan2 => {
            let (y, x) = (arguments[0], arguments[1]);
            let squares = [dag.mul(x, x), dag.mul(y, y)];
            let below = dag.add(squares[0], squares[1]);
            let above = if i == 0 { x } else { dag.neg(y) };
            dag.div(above, below)
        }
        Elementary::Sinh => dag.call(Elementary::Cosh, vec![x]),
        Elementary::Cosh => dag.call(Elementary::Sinh, vec![x]),
        Elementary::Tanh => {
            let tanh = dag.call(Elementary::Tanh, vec![x]);
            let square = dag.mul(tanh, tanh);
            dag.sub(one, square)
        }
        Elementary::Exp => dag.call(Elementary::Exp, vec![x]),
        Elementary::Log => dag.product([(x, -1)]),
        Elementary::Sqrt => {
            let root = dag.call(Elementary::Sqrt, vec![x]);
            let inverse = dag.product([(root, -1)]);
            dag.scale(BigRational::new(1.into(), 2.into()), inverse)
        }
        Elementary::Abs => dag.call(Elementary::Sign, vec![x]),
        Elementary::Sign => dag.integer(0),
        Elementary::Positive => {
            let sign = dag.call(Elementary::Sign, vec![x]);
            let twice = dag.add(one, sign);
            dag.scale(BigRational::new(1.into(), 2.into()), twice)
        }
        Elementary::Power => power_partial(dag, arguments[0], arguments[1], i),
        Elementary::Stumpff(n) => {
            let terms = [
                (
                    BigRational::new(n.into(), 2.into()),
                    dag.call(Elementary::Stumpff(n + 2), vec![x]),
                ),
                (
                    BigRational::new((-1).into(), 2.into()),
                    dag.call(Elementary::Stumpff(n + 1), vec![x]),
                ),
            ];
            dag.sum(terms)
        }
    }
}

/// 1/√(1 − x²)
fn inverse_root_of_complement(dag: &mut Dag, x: NodeId) -> NodeId {
    let one = dag.integer(1);
    let square = dag.mul(x, x);
    let complement = dag.sub(one, square);
    let root = dag.call(Elementary::Sqrt, vec![complement]);
    dag.product([(root, -1)])
}

/// ∂x^y/∂x = y x^(y−1), ∂x^y/∂y = x^y ln x
fn power_partial(dag: &mut Dag, x: NodeId, y: NodeId, i: usize) -> NodeId {
    if i == 0 {
        let one = dag.integer(1);
        let lower = dag.sub(y, one);
        let power = dag.power(x, lower);
        dag.mul(y, power)
    } else {
        let power = dag.power(x, y);
        let log = dag.call(Elementary::Log, vec![x]);
        dag.mul(power, log)
    }
}

#[cfg(test)]
mod tests;
