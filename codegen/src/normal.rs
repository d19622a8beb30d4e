//! The constructors of the graph: every node they return is in normal form.
//!
//! - A sum holds each term once, with a rational coefficient; sums inside it are merged into it, and
//!   small integer contents and the sign of the first term are taken out in front, so that `a − b`,
//!   `b − a` and `(a − b)/2` share one node.
//! - A product holds each factor once, with an integer exponent; coefficients are taken out in front.
//! - A rational times a node is a sum of one term.
//! - Functions of an exact argument with an exact value are that value; odd and even functions take
//!   no negative coefficient as their argument.
//!
//! | rewrite | exact in floating point |
//! |---|---|
//! | merging, cancelling, reordering of terms and factors | no: the rounding changes, the value does not |
//! | taking out ±1 and powers of two | yes |
//! | `abs(x) + x = 2 max(x, 0)`, `x + max(−x, 0) = max(x, 0)`, … | yes |
//! | `sqrt(x)^2 = x`, `sin(−x) = −sin x`, `sin 0 = 0`, … | in exact arithmetic |

mod calls;
mod one_sided;

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use num_traits::ToPrimitive;
use num_traits::Zero;

/// Most terms of a sum, or factors of a product, that are merged into a larger one. Larger merges
/// less and shares more; without a bound a chain of sums would grow quadratically.
const MERGED: usize = 24;

/// Largest numerator and denominator of a content that is taken out of a sum. Larger shares more
/// and turns decimal coefficients into unwieldy integers.
const CONTENT: u128 = 64;

/// Largest exponent that products of powers are merged into.
const EXPONENT: i32 = 1 << 12;

/// Most bits of a number that is exact, and that a power is folded into: twice those of any double. Larger makes nonsense such
/// as a product of a hundred fractions slow.
const BITS: u64 = 1 << 12;

/// Bits of what a longer number is rounded to: more than twice those of the most precise evaluation.
const KEPT_BITS: u64 = 256;

impl Dag {
    /// A number.
    pub fn constant(&mut self, value: BigRational) -> NodeId {
        self.intern(Node::Constant(value))
    }

    /// A whole number.
    pub fn integer(&mut self, value: i64) -> NodeId {
        self.constant(rational(value))
    }

    /// π
    pub fn pi(&mut self) -> NodeId {
        self.intern(Node::Pi)
    }

    /// An input.
    pub fn leaf(&mut self, leaf: Leaf) -> NodeId {
        self.intern(Node::Leaf(leaf))
    }

    /// a + b
    pub fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.sum([(BigRational::one(), a), (BigRational::one(), b)])
    }

    /// a − b
    pub fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.sum([(BigRational::one(), a), (-BigRational::one(), b)])
    }

    /// −a
    pub fn neg(&mut self, a: NodeId) -> NodeId {
        self.scale(-BigRational::one(), a)
    }

    /// c a
    pub fn scale(&mut self, coefficient: BigRational, a: NodeId) -> NodeId {
        if let Some(value) = self.as_constant(a) {
            let value = times(value, coefficient);
            return self.constant(value);
        }
        let (inner, core) = self.split_coefficient(a);
        let coefficient = times(&coefficient, inner);
        if coefficient.is_zero() {
            self.integer(0)
        } else if coefficient.is_one() {
            core
        } else {
            self.intern(Node::Sum(vec![(coefficient, core)]))
        }
    }

    /// a b
    pub fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.product([(a, 1), (b, 1)])
    }

    /// a / b
    pub fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.product([(a, 1), (b, -1)])
    }

    /// Σ cᵢ nᵢ
    pub fn sum(&mut self, terms: impl IntoIterator<Item = (BigRational, NodeId)>) -> NodeId {
        let one = self.integer(1);
        let mut collected: Vec<(BigRational, NodeId)> = Vec::new();
        for (outer, id) in terms {
            let own = self.terms(id, one).into_iter();
            collected.extend(own.map(|(inner, core)| (times(&outer, inner), core)));
        }
        collected.sort_by_key(|term| term.1);
        let mut terms: Vec<(BigRational, NodeId)> = Vec::with_capacity(collected.len());
        for (coefficient, id) in collected {
            match terms.last_mut() {
                Some(last) if last.1 == id => last.0 = shortened(&last.0 + coefficient),
                _ => terms.push((coefficient, id)),
            }
        }
        terms.retain(|(coefficient, _)| !coefficient.is_zero());
        if let Some(folded) = self.one_sided(&terms, one) {
            return folded;
        }
        match terms.as_slice() {
            [] => self.integer(0),
            [(coefficient, id)] if *id == one => self.constant(coefficient.clone()),
            [(coefficient, id)] if coefficient.is_one() => *id,
            [_] => self.intern(Node::Sum(terms)),
            _ => self.primitive(terms, one),
        }
    }

    /// The terms that `id` contributes to a sum; `one` carries the constant.
    fn terms(&self, id: NodeId, one: NodeId) -> Vec<(BigRational, NodeId)> {
        match self.node(id) {
            Node::Constant(value) => vec![(value.clone(), one)],
            Node::Sum(terms) => match terms.as_slice() {
                [(coefficient, core)] => match self.node(*core) {
                    Node::Sum(inner) if inner.len() <= MERGED && small(coefficient).is_some() => {
                        inner
                            .iter()
                            .map(|(c, n)| (times(c, coefficient.clone()), *n))
                            .collect()
                    }
                    _ => terms.clone(),
                },
                _ if terms.len() <= MERGED => terms.clone(),
                _ => vec![(BigRational::one(), id)],
            },
            Node::Pi | Node::Leaf(_) | Node::Product(_) | Node::Call(..) => {
                vec![(BigRational::one(), id)]
            }
        }
    }

    /// A sum of several terms as content times a sum of content one.
    fn primitive(&mut self, terms: Vec<(BigRational, NodeId)>, one: NodeId) -> NodeId {
        let content = content(&terms, one);
        if content.is_one() {
            return self.intern(Node::Sum(terms));
        }
        let terms = if (-&content).is_one() {
            terms.into_iter().map(|(c, n)| (-c, n)).collect()
        } else {
            let quotient = |c: BigRational| {
                // A whole number: the content is that of all terms.
                let above = c.numer() / content.numer();
                BigRational::from_integer(above * (content.denom() / c.denom()))
            };
            terms.into_iter().map(|(c, n)| (quotient(c), n)).collect()
        };
        let core = self.intern(Node::Sum(terms));
        self.intern(Node::Sum(vec![(content, core)]))
    }

    /// Π nᵢ^eᵢ
    pub fn product(&mut self, factors: impl IntoIterator<Item = (NodeId, i32)>) -> NodeId {
        let mut coefficient = BigRational::one();
        let mut collected: Vec<(NodeId, i32)> = Vec::new();
        let mut open: Vec<(NodeId, i32)> = factors.into_iter().collect();
        while let Some((id, exponent)) = open.pop() {
            match self.node(id) {
                Node::Constant(value) if folds(value, exponent) => {
                    coefficient = times(&coefficient, power(value, exponent));
                }
                Node::Sum(terms) if terms.len() == 1 && folds(&terms[0].0, exponent) => {
                    coefficient = times(&coefficient, power(&terms[0].0, exponent));
                    open.push((terms[0].1, exponent));
                }
                Node::Product(inner) if inner.len() <= MERGED && merges(inner, exponent) => {
                    open.extend(inner.iter().map(|(n, e)| (*n, e * exponent)));
                }
                Node::Call(Elementary::Sqrt, argument) => {
                    let known = collected.iter().position(|factor| factor.0 == id);
                    let known = known.map_or(0, |at| collected.swap_remove(at).1);
                    let total = known + exponent;
                    if total % 2 == 0 {
                        open.push((argument[0], total / 2));
                    } else {
                        collected.push((id, total));
                    }
                }
                _ => match collected.iter_mut().find(|factor| factor.0 == id) {
                    Some(factor) => factor.1 += exponent,
                    None => collected.push((id, exponent)),
                },
            }
        }
        collected.retain(|factor| factor.1 != 0);
        collected.sort_unstable_by_key(|factor| factor.0);
        if coefficient.is_zero() {
            return self.integer(0);
        }
        let core = match collected.as_slice() {
            [] => return self.constant(coefficient),
            [(id, 1)] => *id,
            _ => self.intern(Node::Product(collected)),
        };
        self.scale(coefficient, core)
    }
}

/// A whole number as a rational.
pub fn rational(value: i64) -> BigRational {
    BigRational::from_integer(value.into())
}

/// a b, at little cost if one of them is 1, as it usually is, or both are whole.
pub fn times(a: &BigRational, b: BigRational) -> BigRational {
    if a.is_one() {
        b
    } else if b.is_one() {
        a.clone()
    } else if a.denom().is_one() && b.denom().is_one() {
        shortened(BigRational::from_integer(a.numer() * b.numer()))
    } else {
        shortened(a * b)
    }
}

/// The number, or one of [`KEPT_BITS`] where it has more than [`BITS`].
fn shortened(value: BigRational) -> BigRational {
    let (above, below) = (value.numer().bits(), value.denom().bits());
    if above + below <= BITS {
        return value;
    }
    let spare = |bits: u64| bits.saturating_sub(KEPT_BITS);
    let (above, below) = (spare(above), spare(below));
    let leading = BigRational::new(value.numer() >> above, value.denom() >> below);
    let common = above.min(below);
    let power = |bits: u64| BigInt::one() << (bits - common);
    leading * BigRational::new(power(above), power(below))
}

/// aⁿ, at no cost for n = 1: the usual case.
pub fn power(a: &BigRational, exponent: i32) -> BigRational {
    if exponent == 1 {
        a.clone()
    } else {
        a.pow(exponent)
    }
}

/// The common factor to take out of a sum, with the sign of its first term that is not a constant.
fn content(terms: &[(BigRational, NodeId)], one: NodeId) -> BigRational {
    let leading = terms.iter().find(|t| t.1 != one).unwrap_or(&terms[0]);
    let sign = leading.0.signum();
    let small: Option<Vec<(u128, u128)>> = terms.iter().map(|t| small(&t.0)).collect();
    let Some(small) = small else { return sign };
    // The least common multiple of all numbers up to `CONTENT` is below 2^128.
    let numerator = small.iter().fold(0, |g, t| t.0.gcd(&g));
    let denominator = small.iter().fold(1, |l, t| t.1.lcm(&l));
    if numerator == 1 && denominator == 1 {
        return sign;
    }
    sign * BigRational::new(numerator.into(), denominator.into())
}

/// `value^exponent` is a number of reasonable length.
fn folds(value: &BigRational, exponent: i32) -> bool {
    let bits = value.numer().bits() + value.denom().bits();
    let power = u64::from(exponent.unsigned_abs());
    (exponent > 0 || !value.is_zero()) && bits * power <= BITS
}

/// The factors keep reasonable exponents when raised to `exponent`.
fn merges(factors: &[(NodeId, i32)], exponent: i32) -> bool {
    factors
        .iter()
        .all(|(_, e)| e.checked_mul(exponent).is_some_and(|e| e.abs() <= EXPONENT))
}

/// The magnitudes of numerator and denominator, if they are small.
fn small(c: &BigRational) -> Option<(u128, u128)> {
    let magnitude = |part: &BigInt| Some(u128::from(part.magnitude().to_u32()?));
    let parts = (magnitude(c.numer())?, magnitude(c.denom())?);
    (parts.0 <= CONTENT && parts.1 <= CONTENT).then_some(parts)
}

#[cfg(test)]
mod tests;
