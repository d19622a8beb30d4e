//! Sub-expressions that several values have in common.

use super::split::Rooted;
use super::values::Values;
use super::values::has_magnitude;
use crate::dag::Rate;
use crate::schedule::Op;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use std::cmp::Reverse;
use std::collections::HashMap;
use std::collections::HashSet;

/// Most operands of a value that is searched for common pairs: the search is quadratic in it.
const OPERANDS: usize = 48;

/// Divides by a value once where several products of one rate would: x/d and y/d become x·(1/d) and
/// y·(1/d). The scene part is left as it is, since it is computed once and reads better.
pub(super) fn reciprocals(values: &mut Values) {
    let mut users: HashMap<ValueId, Vec<ValueId>> = HashMap::new();
    let mut divisors = Vec::new();
    for (id, value) in values.iter() {
        if let Op::Product { denominator, .. } = &value.op
            && value.rate > Rate::Scene
        {
            for divisor in denominator {
                let users = users.entry(*divisor).or_default();
                users.push(id);
                if users.len() == 2 {
                    divisors.push(*divisor);
                }
            }
        }
    }
    for divisor in divisors {
        let reciprocal = values.reciprocal(divisor);
        for user in &users[&divisor] {
            if *user != reciprocal
                && let Op::Product {
                    numerator,
                    denominator,
                    ..
                } = &mut values.list[user.index()].op
            {
                denominator.clear();
                numerator.push(reciprocal);
            }
        }
    }
}

/// Takes the sign into sums that are used only with a minus in front: −(a − b) is b − a.
pub(super) fn signs(values: &mut Values, roots: &[Rooted]) {
    let mut users = vec![0; values.list.len()];
    let operands = values.iter().flat_map(|(_, v)| v.op.operands());
    for id in operands.chain(roots.iter().flat_map(|k| k.2.iter().copied())) {
        users[id.index()] += 1;
    }
    for i in 0..values.list.len() {
        let Op::Sum(outer) = &values.list[i].op else {
            continue;
        };
        let [(_, inner)] = outer[..] else { continue };
        if let Op::Sum(terms) = &values.list[inner.index()].op
            && values.list[i].op.is_negation()
            && users[inner.index()] == 1
        {
            let mut terms: Vec<_> = terms.iter().map(|t| (-&t.0, t.1)).collect();
            terms.sort_by_key(|t| t.0.is_negative());
            values.list[i].op = Op::Sum(terms);
        }
    }
}

/// a + c·b or a·b inside larger values of the same kind; a < b, c = ±1.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Pair {
    is_sum: bool,
    a: ValueId,
    b: ValueId,
    is_difference: bool,
}

/// Computes once what several sums, or several products, have in common: in rounds, each of which
/// takes the most frequent pairs of operands out of the values that contain them. The scene part is
/// left as it is here, too.
pub(super) fn pairs(values: &mut Values) {
    loop {
        let mut frequent = occurrences(values);
        frequent.sort_by_key(|f| Reverse(f.1.len()));
        let mut has_changed = HashSet::new();
        for (pair, users) in frequent {
            let users: Vec<_> = users
                .into_iter()
                .filter(|u| !has_changed.contains(u))
                .collect();
            if users.len() > 1 {
                extract(pair, &users, values);
                has_changed.extend(users);
            }
        }
        if has_changed.is_empty() {
            return;
        }
    }
}

/// Which values contain each pair, in value order, for those that several contain.
fn occurrences(values: &Values) -> Vec<(Pair, Vec<ValueId>)> {
    let one = BigRational::one();
    let candidates = || {
        values.iter().filter_map(|(user, value)| {
            let (is_sum, operands) = operands(&value.op, &one);
            let is_candidate = value.rate > Rate::Scene && operands.len() <= OPERANDS;
            is_candidate.then_some((user, is_sum, operands))
        })
    };
    // What a single value uses is in no common pair, and most operands of large values are of that kind.
    let mut users = [vec![0; values.list.len()], vec![0; values.list.len()]];
    for (_, is_sum, operands) in candidates() {
        for (_, id) in operands {
            users[usize::from(is_sum)][id.index()] += 1;
        }
    }
    let mut places = Vec::new();
    for (user, is_sum, mut operands) in candidates() {
        operands.retain(|(_, id)| users[usize::from(is_sum)][id.index()] > 1);
        for (i, first) in operands.iter().enumerate() {
            let others = operands[i + 1..].iter();
            let pairs = others.filter_map(|second| pair(is_sum, *first, *second));
            places.extend(pairs.map(|pair| (pair, user)));
        }
    }
    places.sort_unstable();
    places.dedup();
    let groups = places.chunk_by(|a, b| a.0 == b.0);
    let shared = groups.filter(|group| group.len() > 1);
    shared
        .map(|group| (group[0].0, group.iter().map(|place| place.1).collect()))
        .collect()
}

/// The terms of a sum, or the factors of a product with coefficients `one`.
fn operands<'a>(op: &'a Op, one: &'a BigRational) -> (bool, Vec<(&'a BigRational, ValueId)>) {
    match op {
        Op::Sum(terms) => (true, terms.iter().map(|(c, v)| (c, *v)).collect()),
        Op::Product { numerator, .. } => (false, numerator.iter().map(|v| (one, *v)).collect()),
        Op::Constant(_) | Op::Pi | Op::Leaf(_) | Op::Call(..) => (false, Vec::new()),
    }
}

fn pair(is_sum: bool, x: (&BigRational, ValueId), y: (&BigRational, ValueId)) -> Option<Pair> {
    let (first, second) = if x.1 <= y.1 { (x, y) } else { (y, x) };
    has_magnitude(first.0, second.0).then(|| Pair {
        is_sum,
        a: first.1,
        b: second.1,
        is_difference: first.0 != second.0,
    })
}

/// Replaces `pair` in its users by one value. A user that is nothing but the pair stays as it is.
fn extract(pair: Pair, users: &[ValueId], values: &mut Values) {
    let one = BigRational::one();
    let (sign, shared) = if pair.is_sum {
        let ratio = if pair.is_difference {
            -one.clone()
        } else {
            one.clone()
        };
        values.signed_sum(vec![(one, pair.a), (ratio, pair.b)])
    } else {
        let product = values.fraction(one.clone(), vec![pair.a, pair.b], Vec::new());
        (one, product)
    };
    for user in users {
        if *user == shared {
            continue;
        }
        match &mut values.list[user.index()].op {
            Op::Sum(terms) => {
                let at = position(terms, |t| t.1 == pair.a);
                let coefficient = terms[at].0.clone() * &sign;
                terms[at] = (coefficient, shared);
                terms.remove(position(terms, |t| t.1 == pair.b));
                terms.sort_by_key(|t| t.0.is_negative());
            }
            Op::Product { numerator, .. } => {
                let at = position(numerator, |v| *v == pair.a);
                numerator[at] = shared;
                numerator.remove(position(numerator, |v| *v == pair.b));
            }
            Op::Constant(_) | Op::Pi | Op::Leaf(_) | Op::Call(..) => {}
        }
    }
}

fn position<T>(list: &[T], is_wanted: impl Fn(&T) -> bool) -> usize {
    list.iter()
        .position(is_wanted)
        .expect("an operand that was just found")
}
