//! Sums whose latest terms are added last.
//!
//! Recurrences run in a circle: order n + 1 waits for order n, and what it waits for is the longest chain of operations from
//! the newest coefficients to the next. The two terms that are there first are added first, which makes that chain as short
//! as it can be (Huffman 1952; Golumbic, *IEEE Trans. Comput.* 25 (1976)).

use super::order::postorder;
use super::split::Rooted;
use super::values::Values;
use crate::dag::Leaf;
use crate::dag::Rate;
use crate::schedule::Op;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;

/// Cycles until the result of an addition or a multiplication is there.
const ARITHMETIC: u32 = 4;
/// The same for a division.
const DIVISION: u32 = 14;
/// The same for a function.
const CALL: u32 = 40;

/// Splits the sums of rate Iteration; `unknown` tells when an unknown is there.
pub(super) fn balance(values: &mut Values, roots: &[Rooted], unknown: impl Fn(usize) -> u32) {
    let wanted: Vec<ValueId> = roots.iter().flat_map(|k| k.2.iter().copied()).collect();
    let ordered = postorder(&values.list, &wanted, |_| true);
    let mut arrivals = vec![0; values.list.len()];
    for id in ordered {
        if let Op::Sum(terms) = &values.list[id.index()].op
            && terms.len() > 2
            && values.rate(id) == Rate::Iteration
        {
            let last = last_addition(values, &mut arrivals, terms.clone());
            values.list[id.index()].op = Op::Sum(last);
        }
        let op = &values.list[id.index()].op;
        arrivals[id.index()] = arrival(op, &arrivals, &unknown);
    }
}

/// The last two terms after all others are added to one of them.
fn last_addition(
    values: &mut Values,
    arrivals: &mut Vec<u32>,
    mut terms: Vec<(BigRational, ValueId)>,
) -> Vec<(BigRational, ValueId)> {
    while terms.len() > 2 {
        // Stable, so that terms of one time stay in order.
        terms.sort_by_key(|term| scaled(term, arrivals));
        let rest = terms.split_off(2);
        let ready = terms.iter().map(|term| scaled(term, arrivals)).max();
        let sum = values.signed_sum(terms);
        arrivals.resize(values.list.len(), 0);
        arrivals[sum.1.index()] = ready.unwrap_or(0) + ARITHMETIC;
        terms = rest;
        terms.insert(0, sum);
    }
    terms.sort_by_key(|t| t.0.is_negative());
    terms
}

/// When c v is there.
fn scaled((coefficient, value): &(BigRational, ValueId), arrivals: &[u32]) -> u32 {
    let product = match coefficient.abs().is_one() {
        true => 0,
        false => ARITHMETIC,
    };
    arrivals[value.index()] + product
}

fn arrival(op: &Op, arrivals: &[u32], unknown: impl Fn(usize) -> u32) -> u32 {
    let operands = op.operands();
    let last = operands.iter().map(|v| arrivals[v.index()]).max();
    let last = last.unwrap_or(0);
    match op {
        Op::Leaf(Leaf::Unknown(i)) => unknown(*i),
        Op::Constant(_) | Op::Pi | Op::Leaf(_) => 0,
        Op::Sum(terms) => {
            let last = terms.iter().map(|term| scaled(term, arrivals)).max();
            last.unwrap_or(0) + if op.is_negation() { 0 } else { ARITHMETIC }
        }
        Op::Product { denominator, .. } if !denominator.is_empty() => last + DIVISION,
        Op::Product { .. } => last + ARITHMETIC,
        Op::Call(..) => last + CALL,
    }
}
