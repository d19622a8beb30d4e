//! The reference evaluator: what every pass must preserve, and the tests' oracle.

use super::Dag;
use super::Elementary;
use super::Leaf;
use super::Node;
use num_rational::BigRational;
use num_traits::ToPrimitive;

impl Dag {
    /// The value of every node in double precision, for given leaves.
    pub fn evaluate(&self, leaf: impl Fn(Leaf) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let value = match node {
                Node::Constant(value) => to_f64(value),
                Node::Pi => std::f64::consts::PI,
                Node::Leaf(l) => leaf(*l),
                Node::Sum(terms) => terms
                    .iter()
                    .map(|(c, n)| to_f64(c) * values[n.index()])
                    .sum(),
                Node::Product(factors) => factors
                    .iter()
                    .map(|(n, e)| values[n.index()].powi(*e))
                    .product(),
                Node::Call(function, arguments) => {
                    let x = values[arguments[0].index()];
                    let y = arguments.get(1).map_or(f64::NAN, |n| values[n.index()]);
                    call(*function, x, y)
                }
            };
            values.push(value);
        }
        values
    }
}

/// The double nearest to a rational number.
pub fn to_f64(value: &BigRational) -> f64 {
    let nearest = if value.is_integer() {
        value.numer().to_f64()
    } else {
        value.to_f64()
    };
    nearest.unwrap_or(f64::NAN)
}

pub(super) fn call(function: Elementary, x: f64, y: f64) -> f64 {
    match function {
        Elementary::Sin => x.sin(),
        Elementary::Cos => x.cos(),
        Elementary::Tan => x.tan(),
        Elementary::Asin => x.asin(),
        Elementary::Acos => x.acos(),
        Elementary::Atan => x.atan(),
        Elementary::Atan2 => x.atan2(y),
        Elementary::Sinh => x.sinh(),
        Elementary::Cosh => x.cosh(),
        Elementary::Tanh => x.tanh(),
        Elementary::Exp => x.exp(),
        Elementary::Log => x.ln(),
        Elementary::Sqrt => x.sqrt(),
        Elementary::Abs => x.abs(),
        Elementary::Sign if x == 0.0 => 0.0,
        Elementary::Sign => x.signum(),
        Elementary::Positive if x <= 0.0 => 0.0,
        Elementary::Positive => x,
        Elementary::Power => x.powf(y),
        Elementary::Stumpff(n) => stumpff(n, x),
    }
}

/// cₙ(s) = Σ (−s)^j / (n + 2j)!, by the series where it does not cancel and by
/// c_{n+2} = (1/n! − cₙ)/s elsewhere.
fn stumpff(n: u32, s: f64) -> f64 {
    let first = f64::from((n + 1) * (n + 2));
    if s.abs() < first {
        let mut term = (1..=n).fold(1.0, |product, i| product / f64::from(i));
        let mut sum = 0.0;
        let mut k = f64::from(n);
        while term != 0.0 && (sum + term) != sum {
            sum += term;
            term *= -s / ((k + 1.0) * (k + 2.0));
            k += 2.0;
        }
        return sum;
    }
    let root = s.abs().sqrt();
    match n {
        0 if s >= 0.0 => root.cos(),
        0 => root.cosh(),
        1 if s >= 0.0 => root.sin() / root,
        1 => root.sinh() / root,
        _ => {
            let inverse_factorial = (1..=n - 2).fold(1.0, |product, i| product / f64::from(i));
            (inverse_factorial - stumpff(n - 2, s)) / s
        }
    }
}
