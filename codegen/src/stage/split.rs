//! Nodes to values: one loop over the graph.

use super::Wanted;
use super::values::Values;
use crate::dag::Dag;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::normal::power;
use crate::normal::times;
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
    let is_inverted = inverted(dag, &needed);
    let mut values = Values::default();
    let mut monomials: Vec<Monomial> = Vec::with_capacity(dag.nodes().len());
    for (node, needed) in dag.nodes().iter().zip(needed) {
        let monomial = if needed {
            monomial(dag, node, &monomials, &is_inverted, &mut values)
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

/// For each node whether several powers of it are divided by, as a quotient and its derivative do:
/// x/d and y/d² become x·(1/d) and y·(1/d)² with one division. The scene part is computed once and
/// reads better as it is.
fn inverted(dag: &Dag, needed: &[bool]) -> Vec<bool> {
    let mut exponents = vec![0; dag.nodes().len()];
    let mut is_inverted = vec![false; dag.nodes().len()];
    for (node, _) in dag.nodes().iter().zip(needed).filter(|n| *n.1) {
        let Node::Product(factors) = node else {
            continue;
        };
        for &(factor, exponent) in factors.iter().filter(|f| f.1 < 0) {
            let known = &mut exponents[factor.index()];
            let has_another = *known != 0 && *known != exponent;
            is_inverted[factor.index()] |= has_another && dag.rate(factor) > Rate::Scene;
            *known = exponent;
        }
    }
    is_inverted
}

fn monomial(
    dag: &Dag,
    node: &Node,
    known: &[Monomial],
    is_inverted: &[bool],
    values: &mut Values,
) -> Monomial {
    match node {
        Node::Constant(number) => Monomial::number(number.clone()),
        Node::Pi => Monomial::of(values.intern(Op::Pi)),
        Node::Leaf(leaf) => Monomial::of(values.intern(Op::Leaf(*leaf))),
        Node::Sum(terms) => match terms.as_slice() {
            [(coefficient, core)] => {
                let mut scaled = known[core.index()].clone();
                scaled.coefficient = times(coefficient, scaled.coefficient);
                scaled
            }
            _ => sum(terms, known, values),
        },
        Node::Product(factors) => product(dag, factors, known, is_inverted, values),
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
            values.product(times(coefficient, term.coefficient.clone()), &term.factors)
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
    is_inverted: &[bool],
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
        let (coefficient, value) = if is_large {
            (BigRational::one(), whole(factor, values))
        } else {
            values.product(factor.coefficient.clone(), &factor.factors)
        };
        merged.coefficient = times(&merged.coefficient, power(&coefficient, exponent));
        merged
            .factors
            .push(if exponent < 0 && is_inverted[id.index()] {
                (values.reciprocal(value), -exponent)
            } else {
                (value, exponent)
            });
    }
    merged
}

fn whole(monomial: &Monomial, values: &mut Values) -> ValueId {
    let coefficient = monomial.coefficient.clone();
    let (rest, value) = values.product(coefficient, &monomial.factors);
    values.scaled(rest, value)
}
