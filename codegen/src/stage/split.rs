//! Nodes to values: one loop over the graph.

use super::Wanted;
use super::values::Values;
use crate::dag::Dag;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::schedule::Op;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;

/// A kernel with its results as values.
pub(super) type Rooted = (&'static str, Rate, Vec<ValueId>);

/// A node as c · Π vᵉ. It becomes values only where it is used, because the use may bring a
/// coefficient or slower factors along.
#[derive(Clone)]
struct Monomial {
    coefficient: BigRational,
    factors: Vec<(ValueId, i32)>,
}

impl Monomial {
    fn of(value: ValueId) -> Self {
        Self {
            coefficient: BigRational::one(),
            factors: vec![(value, 1)],
        }
    }

    fn number(coefficient: BigRational) -> Self {
        Self {
            coefficient,
            factors: Vec::new(),
        }
    }
}

/// The values behind the nodes that `kernels` need.
pub(super) fn split(dag: &Dag, kernels: &[Wanted]) -> (Values, Vec<Rooted>) {
    let wanted: Vec<NodeId> = kernels.iter().flat_map(|k| k.2.iter().copied()).collect();
    let needed = dag.reachable(&wanted);
    let mut values = Values::default();
    let mut monomials: Vec<Monomial> = Vec::with_capacity(dag.nodes().len());
    for (node, needed) in dag.nodes().iter().zip(needed) {
        let monomial = if needed {
            monomial(dag, node, &monomials, &mut values)
        } else {
            Monomial::number(BigRational::one())
        };
        monomials.push(monomial);
    }
    let rooted = kernels
        .iter()
        .map(|(name, rate, roots)| {
            let roots = roots
                .iter()
                .map(|r| whole(&monomials[r.index()], &mut values));
            (*name, *rate, roots.collect())
        })
        .collect();
    (values, rooted)
}

fn monomial(dag: &Dag, node: &Node, known: &[Monomial], values: &mut Values) -> Monomial {
    match node {
        Node::Constant(number) => Monomial::number(number.clone()),
        Node::Pi => Monomial::of(values.intern(Op::Pi)),
        Node::Leaf(leaf) => Monomial::of(values.intern(Op::Leaf(*leaf))),
        Node::Sum(terms) => match terms.as_slice() {
            [(coefficient, core)] => {
                let mut scaled = known[core.index()].clone();
                scaled.coefficient *= coefficient;
                scaled
            }
            _ => sum(terms, known, values),
        },
        Node::Product(factors) => product(dag, factors, known, values),
        Node::Call(function, arguments) => {
            let arguments = arguments.iter().map(|a| whole(&known[a.index()], values));
            let arguments = arguments.collect();
            Monomial::of(values.intern(Op::Call(*function, arguments)))
        }
    }
}

fn sum(terms: &[(BigRational, NodeId)], known: &[Monomial], values: &mut Values) -> Monomial {
    let terms: Vec<_> = terms
        .iter()
        .map(|(coefficient, id)| {
            let term = &known[id.index()];
            values.product(coefficient * &term.coefficient, &term.factors)
        })
        .collect();
    let (sign, value) = values.sum(&terms);
    Monomial {
        coefficient: sign,
        factors: vec![(value, 1)],
    }
}

/// The factors of a product in one list. A factor that is itself a product, a number or a multiple
/// stays one value: the normal form kept it apart because of its size.
fn product(
    dag: &Dag,
    factors: &[(NodeId, i32)],
    known: &[Monomial],
    values: &mut Values,
) -> Monomial {
    let mut merged = Monomial::number(BigRational::one());
    for &(id, exponent) in factors {
        let factor = &known[id.index()];
        let is_large = match dag.node(id) {
            Node::Constant(_) | Node::Product(_) => true,
            Node::Sum(terms) => terms.len() == 1,
            Node::Pi | Node::Leaf(_) | Node::Call(..) => false,
        };
        if is_large {
            merged.factors.push((whole(factor, values), exponent));
        } else {
            merged.coefficient *= factor.coefficient.pow(exponent);
            merged
                .factors
                .extend(factor.factors.iter().map(|f| (f.0, exponent)));
        }
    }
    merged
}

fn whole(monomial: &Monomial, values: &mut Values) -> ValueId {
    let coefficient = monomial.coefficient.clone();
    let (rest, value) = values.product(coefficient, &monomial.factors);
    values.scaled(rest, value)
}
