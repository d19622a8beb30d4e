//! From the rates of a flow to recurrences for the Taylor coefficients of the motion.
//!
//! In come the rates as a graph over t and the state x; out comes the same graph with, for every quantity, its coefficient
//! of order n ≥ 1 in terms of orders below n (Moore, *Interval Analysis* (1966); Jorba and Zou, *Experiment. Math.* 14
//! (2005); Griewank and Walther, *Evaluating Derivatives* (2008), table 13.2). Coefficients are those of the powers of the
//! time since the start of the step over a unit that the run chooses.
//!
//! What all recurrences have in common is taken apart: a product is wₙ = a₀ bₙ + aₙ b₀ + Σ aⱼ bₙ₋ⱼ, 0 < j < n, and so are
//! the rest with factors j. These inner sums hold no coefficient of order n, so they need nothing from one another: one
//! loop makes all of them as lanes, and what remains is straight-line code, the same for every order. Products of what is
//! linear in the state come whole from these lanes.
//!
//! ```text
//! w = a b      wₙ = a₀ bₙ + aₙ b₀ + ⟨a, b⟩          ⟨a, b⟩ = Σ aⱼ bₙ₋ⱼ, 0 < j < n;  D a: the series with n aₙ
//! q = a / b    qₙ = (aₙ − q₀ bₙ − ⟨b, q⟩) / b₀
//! r = √a       rₙ = (aₙ − ⟨r, r⟩) / 2 r₀
//! e = exp a    eₙ = e₀ aₙ + ⟨D a, e⟩ / n
//! y' = u a'    yₙ = u₀ aₙ + ⟨D a, u⟩ / n            sin, cos, sinh, cosh, tan, tanh
//! y' d = a'    yₙ = (aₙ − ⟨D y, d⟩ / n) / d₀        ln, asin, acos, atan
//! p = a^c      pₙ = (c p₀ aₙ + (c ⟨D a, p⟩ − ⟨D p, a⟩) / n) / a₀
//! ```

mod function;
mod part;

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::system::Series;
use num_rational::BigRational;
use part::Part;
use std::collections::BTreeMap;

/// The recurrences of the flow with these rates, or why there are none.
///
/// # Errors
/// In words, the function that has no Taylor series everywhere.
pub fn taylor(dag: &Dag, rates: &[NodeId], n_states: usize) -> Result<Series, String> {
    let needed = dag.reachable(rates);
    let mut builder = Builder::new(dag.clone(), n_states);
    for (index, node) in dag.nodes().iter().enumerate() {
        let id = NodeId(u32::try_from(index).expect("a graph of 2^32 nodes"));
        let newest = match needed[index] && dag.rate(id) > Rate::Scene {
            true => builder.newest(id, node)?,
            false => None,
        };
        builder.newest.push(newest);
    }
    let coefficients = rates.iter().map(|rate| builder.newest[rate.index()]);
    let coefficients: Vec<_> = coefficients.collect();
    Ok(builder.finish(rates, &coefficients))
}

/// A graph and the recurrences found so far.
struct Builder {
    dag: Dag,
    n_states: usize,
    /// For each node of the flow its coefficient of order n; `None` for what does not change with time.
    newest: Vec<Option<NodeId>>,
    /// The two series of each inner sum, by their coefficients of order n.
    lanes: Vec<[NodeId; 2]>,
    /// The inner sum of two series that are known apart from it.
    sums: BTreeMap<[NodeId; 2], usize>,
    /// The two series of each product, by their coefficients of order n and 0.
    products: Vec<([NodeId; 2], [NodeId; 2])>,
    /// The product of two series.
    whole: BTreeMap<[NodeId; 2], usize>,
    /// For each node whether it needs an inner sum or a product.
    is_late: Vec<bool>,
    /// Functions that come with others, by what they are: cos with sin.
    companions: BTreeMap<NodeId, NodeId>,
}

impl Builder {
    fn new(dag: Dag, n_states: usize) -> Self {
        Self {
            dag,
            n_states,
            newest: Vec::new(),
            lanes: Vec::new(),
            sums: BTreeMap::new(),
            products: Vec::new(),
            whole: BTreeMap::new(),
            is_late: Vec::new(),
            companions: BTreeMap::new(),
        }
    }

    /// The coefficient of order n of a node that changes with time.
    fn newest(&mut self, id: NodeId, node: &Node) -> Result<Option<NodeId>, String> {
        Ok(match node {
            Node::Constant(_) | Node::Pi => None,
            Node::Leaf(Leaf::State(i)) => Some(self.dag.leaf(Leaf::Unknown(*i))),
            Node::Leaf(Leaf::Time) => Some(self.dag.leaf(Series::time(self.n_states))),
            Node::Leaf(_) => None,
            Node::Sum(terms) => self.sum(terms),
            Node::Product(factors) => self.product(factors),
            Node::Call(function, arguments) => self.call(id, *function, arguments)?,
        })
    }

    /// Σ cᵢ aᵢ
    fn sum(&mut self, terms: &[(BigRational, NodeId)]) -> Option<NodeId> {
        let newest = &self.newest;
        let changing = terms
            .iter()
            .filter_map(|(c, id)| Some((c.clone(), newest[id.index()]?)));
        let changing: Vec<_> = changing.collect();
        (!changing.is_empty()).then(|| self.dag.sum(changing))
    }

    /// Π aᵢ^eᵢ: what does not change with time in front, the rest over what has negative powers.
    fn product(&mut self, factors: &[(NodeId, i32)]) -> Option<NodeId> {
        let is_changing = |f: &&(NodeId, i32)| self.newest[f.0.index()].is_some();
        let fixed: Vec<_> = factors
            .iter()
            .filter(|f| !is_changing(f))
            .copied()
            .collect();
        let above = factors
            .iter()
            .filter(|f| is_changing(f) && f.1 > 0)
            .copied();
        let above: Vec<_> = above.collect();
        let below = factors.iter().filter(|f| is_changing(f) && f.1 < 0);
        let below: Vec<_> = below.map(|(id, e)| (*id, -e)).collect();
        let numerator = self.powers(&above);
        let whole = match below.is_empty() {
            true => numerator,
            false => {
                let denominator = self.powers(&below);
                self.quotient(numerator, denominator)
            }
        };
        let newest = whole.newest?;
        let factor = self.dag.product(fixed);
        Some(self.dag.mul(factor, newest))
    }

    /// Π aᵢ^eᵢ with eᵢ > 0, by repeated squares.
    fn powers(&mut self, factors: &[(NodeId, i32)]) -> Part {
        let one = self.dag.integer(1);
        let mut product = Part::fixed(one);
        for &(id, exponent) in factors {
            let mut square = self.part(id);
            let mut left = exponent;
            while left > 0 {
                if left % 2 == 1 {
                    product = self.times(product, square);
                }
                left /= 2;
                if left > 0 {
                    square = self.times(square, square);
                }
            }
        }
        product
    }

    /// Everything that is emitted.
    fn finish(mut self, rates: &[NodeId], coefficients: &[Option<NodeId>]) -> Series {
        let zero = self.dag.integer(0);
        let coefficients = coefficients.iter().map(|c| c.unwrap_or(zero)).collect();
        debug_assert_eq!(self.dag.verify(), Ok(()));
        Series {
            dag: self.dag,
            rates: rates.to_vec(),
            coefficients,
            sums: self.lanes,
            products: self.products.iter().map(|product| product.0).collect(),
            starts: self.products.iter().map(|product| product.1).collect(),
            zero,
        }
    }
}

/// What cannot be expanded, in words.
fn refusal(function: Elementary) -> String {
    match function {
        Elementary::Abs => "abs(x) has a kink at x = 0, which a Taylor series does not see".into(),
        Elementary::Sign => "sign(x) jumps at x = 0, which a Taylor series does not see".into(),
        Elementary::Positive => {
            "max(x, 0) has a kink at x = 0, which a Taylor series does not see".into()
        }
        Elementary::Stumpff(_) => {
            "sinc, cosc, stumpff, and exp, dexp and dexpinv of a 3×3 matrix have no recurrence"
                .into()
        }
        _ => format!("{function:?} has no recurrence").to_lowercase(),
    }
}
