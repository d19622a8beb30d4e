//! Calls of functions and powers in normal form: numbers where they are known to be, arguments without a sign where the
//! function has a parity.

use super::rational;
use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Node;
use crate::dag::NodeId;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use num_traits::ToPrimitive;
use num_traits::Zero;

impl Dag {
    /// a^b: a product for whole b, a root for half b.
    pub fn power(&mut self, base: NodeId, exponent: NodeId) -> NodeId {
        if let Some(value) = self.as_constant(exponent).cloned() {
            if let Some(whole) = value.is_integer().then(|| value.to_i32()).flatten() {
                return self.product([(base, whole)]);
            }
            let doubled = &value * rational(2);
            if let Some(halves) = doubled.is_integer().then(|| doubled.to_i32()).flatten() {
                let root = self.call(Elementary::Sqrt, vec![base]);
                return self.product([(root, halves)]);
            }
        }
        self.call(Elementary::Power, vec![base, exponent])
    }

    /// f(n, …)
    pub fn call(&mut self, function: Elementary, arguments: Vec<NodeId>) -> NodeId {
        if let Some(value) = self.exact_call(function, &arguments) {
            return self.constant(value);
        }
        if function == Elementary::Sqrt
            && let Some(root) = self.root_of_squares(arguments[0])
        {
            return root;
        }
        let (coefficient, core) = self.split_coefficient(arguments[0]);
        if coefficient.is_negative() && parity(function) != Parity::Neither {
            let positive = self.scale(-coefficient, core);
            let value = self.intern(Node::Call(function, vec![positive]));
            return if parity(function) == Parity::Odd {
                self.neg(value)
            } else {
                value
            };
        }
        self.intern(Node::Call(function, arguments))
    }

    /// √(c Π nᵢ^(2kᵢ)) = √c Π |nᵢ|^kᵢ, for c ≥ 0 and a product of nothing but even powers: it has a kink where an nᵢ
    /// is 0, which the root hides, and squares that overflow or underflow.
    fn root_of_squares(&mut self, argument: NodeId) -> Option<NodeId> {
        let (coefficient, core) = self.split_coefficient(argument);
        let Node::Product(factors) = self.node(core) else {
            return None;
        };
        let is_square = factors.iter().all(|factor| factor.1 % 2 == 0);
        if !is_square || coefficient.is_negative() {
            return None;
        }
        let mut roots: Vec<(NodeId, i32)> = factors.iter().map(|(n, e)| (*n, e / 2)).collect();
        for root in &mut roots {
            if root.1 % 2 != 0 {
                root.0 = self.call(Elementary::Abs, vec![root.0]);
            }
        }
        let scale = self.constant(coefficient);
        roots.push((self.call(Elementary::Sqrt, vec![scale]), 1));
        Some(self.product(roots))
    }

    /// The value of a call whose arguments and value are exact.
    fn exact_call(&self, function: Elementary, arguments: &[NodeId]) -> Option<BigRational> {
        if matches!(function, Elementary::Sin | Elementary::Cos) {
            return self.exact_at_quarter_turns(function, arguments[0]);
        }
        let x = self.as_constant(arguments[0])?;
        match function {
            Elementary::Sin | Elementary::Cos => None,
            Elementary::Tan
            | Elementary::Asin
            | Elementary::Atan
            | Elementary::Sinh
            | Elementary::Tanh => x.is_zero().then(BigRational::zero),
            Elementary::Cosh | Elementary::Exp => x.is_zero().then(BigRational::one),
            Elementary::Log | Elementary::Acos => x.is_one().then(BigRational::zero),
            Elementary::Atan2 => {
                let right = self.as_constant(arguments[1])?.is_positive();
                (x.is_zero() && right).then(BigRational::zero)
            }
            Elementary::Sqrt => exact_root(x),
            Elementary::Abs => Some(x.abs()),
            Elementary::Sign => Some(x.signum()),
            Elementary::Positive => Some(x.max(&BigRational::zero()).clone()),
            Elementary::Power => None,
            Elementary::Stumpff(n) => x.is_zero().then(|| inverse_factorial(n)),
        }
    }

    /// sin and cos of multiples of π/2.
    fn exact_at_quarter_turns(
        &self,
        function: Elementary,
        argument: NodeId,
    ) -> Option<BigRational> {
        let (coefficient, core) = self.split_coefficient(argument);
        let turns: BigRational = match self.node(core) {
            Node::Pi => coefficient * rational(2),
            Node::Constant(value) if value.is_zero() => BigRational::zero(),
            _ => return None,
        };
        let shift = if function == Elementary::Sin { 0 } else { 1 };
        if !turns.is_integer() {
            return None;
        }
        let quarter: BigInt = turns.to_integer() + shift;
        match quarter.mod_floor(&BigInt::from(4)).to_u32()? {
            1 => Some(rational(1)),
            3 => Some(rational(-1)),
            _ => Some(rational(0)),
        }
    }
}

/// 1/n!
fn inverse_factorial(n: u32) -> BigRational {
    let factorial: BigInt = (1..=n).map(BigInt::from).product();
    BigRational::new(BigInt::one(), factorial)
}

/// The root of a square of a rational.
fn exact_root(x: &BigRational) -> Option<BigRational> {
    if x.is_negative() {
        return None;
    }
    let root = BigRational::new(x.numer().sqrt(), x.denom().sqrt());
    (&root * &root == *x).then_some(root)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Parity {
    Even,
    Odd,
    Neither,
}

fn parity(function: Elementary) -> Parity {
    match function {
        Elementary::Sin
        | Elementary::Tan
        | Elementary::Asin
        | Elementary::Atan
        | Elementary::Sinh
        | Elementary::Tanh
        | Elementary::Sign => Parity::Odd,
        Elementary::Cos | Elementary::Cosh | Elementary::Abs => Parity::Even,
        Elementary::Acos
        | Elementary::Atan2
        | Elementary::Exp
        | Elementary::Log
        | Elementary::Sqrt
        | Elementary::Positive
        | Elementary::Power
        | Elementary::Stumpff(_) => Parity::Neither,
    }
}
