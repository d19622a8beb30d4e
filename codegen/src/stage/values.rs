//! The value list under construction: equal operations share a value.

use crate::dag::Rate;
use crate::index::Index;
use crate::normal::times;
use crate::schedule::Op;
use crate::schedule::Value;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use std::cmp::Ordering;
use std::cmp::Reverse;

/// All rates, slowest first.
const RATES: [Rate; 3] = [Rate::Scene, Rate::Step, Rate::Iteration];

/// Values by number. After `share` has rewritten operands, operands need not stand before users.
#[derive(Default)]
pub(super) struct Values {
    pub(super) list: Vec<Value>,
    /// The operations as they were before `share` rewrote them.
    original: Vec<Op>,
    index: Index,
}

impl Values {
    /// All values with their numbers.
    pub(super) fn iter(&self) -> impl Iterator<Item = (ValueId, &Value)> {
        (0..).map(ValueId).zip(&self.list)
    }

    /// When a value is computed.
    pub(super) fn rate(&self, id: ValueId) -> Rate {
        self.list[id.index()].rate
    }

    /// The value of `op`.
    pub(super) fn intern(&mut self, op: Op) -> ValueId {
        let id = |position| ValueId(u32::try_from(position).expect("a schedule of 2^32 values"));
        let hash = match self.index.find(|i| &self.original[i], &op) {
            Ok(position) => return id(position),
            Err(hash) => hash,
        };
        let rate = match &op {
            Op::Leaf(leaf) => leaf.rate(),
            _ => fastest(op.operands().into_iter().map(|v| self.rate(v))),
        };
        self.original.push(op.clone());
        self.index.push(hash);
        self.list.push(Value { op, rate });
        id(self.list.len() - 1)
    }

    /// c · v as one value.
    pub(super) fn scaled(&mut self, coefficient: BigRational, value: ValueId) -> ValueId {
        match &self.list[value.index()].op {
            Op::Constant(number) => {
                let number = times(number, coefficient);
                self.intern(Op::Constant(number))
            }
            _ if coefficient.is_negative() => {
                let positive = self.scaled(-coefficient, value);
                self.intern(Op::Sum(vec![(-BigRational::one(), positive)]))
            }
            Op::Product {
                coefficient: inner,
                numerator,
                denominator,
            } => {
                let (numerator, denominator) = (numerator.clone(), denominator.clone());
                self.quotient(times(inner, coefficient), numerator, denominator)
            }
            Op::Pi | Op::Leaf(_) | Op::Sum(_) | Op::Call(..) => {
                self.quotient(coefficient, vec![value], Vec::new())
            }
        }
    }

    /// c · Π vᵉ as a remaining coefficient and a value: |c| goes to the slowest factors if there
    /// are faster ones, so that it costs nothing at their rate.
    pub(super) fn product(
        &mut self,
        mut coefficient: BigRational,
        factors: &[(ValueId, i32)],
    ) -> (BigRational, ValueId) {
        if factors.is_empty() {
            let number = self.intern(Op::Constant(coefficient.abs()));
            return (coefficient.signum(), number);
        }
        let factors = self.with_equal_powers_joined(factors);
        let rates: Vec<Rate> = factors.iter().map(|f| self.rate(f.0)).collect();
        let last = fastest(rates.iter().copied());
        let mut slower = None;
        for rate in RATES {
            let mut numerator: Vec<ValueId> = slower.into_iter().collect();
            let mut denominator = Vec::new();
            for (&(value, exponent), _) in factors.iter().zip(&rates).filter(|f| *f.1 == rate) {
                let side = if exponent > 0 {
                    &mut numerator
                } else {
                    &mut denominator
                };
                self.power(value, exponent.unsigned_abs(), side);
            }
            if numerator.len() + denominator.len() > usize::from(slower.is_some()) {
                let mut own = BigRational::one();
                if rate < last {
                    own = coefficient.abs();
                    coefficient = coefficient.signum();
                }
                slower = Some(self.quotient(own, numerator, denominator));
            }
        }
        let value = slower.expect("a product of at least one factor");
        (coefficient, value)
    }

    /// h² ω² as (h ω)²: no dearer, and its rounding error changes with ω. That of h² is the same in every step, and what
    /// 1 + (h ω)² and h ω keep together, such as the length of a turned vector, would drift by it.
    fn with_equal_powers_joined(&mut self, factors: &[(ValueId, i32)]) -> Vec<(ValueId, i32)> {
        let mut joined: Vec<(ValueId, i32)> = Vec::with_capacity(factors.len());
        let mut powers: Vec<i32> = factors.iter().map(|f| f.1).filter(|e| *e > 1).collect();
        powers.sort_unstable();
        powers.dedup();
        for power in powers {
            let own = factors.iter().filter(|f| f.1 == power);
            let bases: Vec<(ValueId, i32)> = own.map(|f| (f.0, 1)).collect();
            let rates = bases.iter().map(|f| self.rate(f.0));
            if rates.clone().min() == rates.max() {
                joined.extend(bases.iter().map(|f| (f.0, power)));
            } else {
                let (_, base) = self.product(BigRational::one(), &bases);
                joined.push((base, power));
            }
        }
        joined.extend(factors.iter().filter(|f| f.1 <= 1));
        joined
    }

    /// Pushes the factors of vⁿ: the squares v, v², v⁴, … that the binary digits of n ask for.
    fn power(&mut self, value: ValueId, exponent: u32, factors: &mut Vec<ValueId>) {
        let mut square = value;
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                factors.push(square);
            }
            rest >>= 1;
            if rest > 0 {
                square = self.quotient(BigRational::one(), vec![square, square], Vec::new());
            }
        }
    }

    /// c · Π vᵢ / Π wᵢ with the divisors multiplied first: one division.
    fn quotient(
        &mut self,
        coefficient: BigRational,
        numerator: Vec<ValueId>,
        denominator: Vec<ValueId>,
    ) -> ValueId {
        if coefficient.is_one() && denominator.is_empty() && numerator.len() == 1 {
            return numerator[0];
        }
        let denominator = if denominator.len() > 1 {
            vec![self.quotient(BigRational::one(), denominator, Vec::new())]
        } else {
            denominator
        };
        self.fraction(coefficient, numerator, denominator)
    }

    /// 1 / v
    pub(super) fn reciprocal(&mut self, value: ValueId) -> ValueId {
        self.fraction(BigRational::one(), Vec::new(), vec![value])
    }

    /// The same for a single divisor at most. Factors stand slower ones first.
    pub(super) fn fraction(
        &mut self,
        coefficient: BigRational,
        mut numerator: Vec<ValueId>,
        denominator: Vec<ValueId>,
    ) -> ValueId {
        numerator.sort_by_key(|v| (self.rate(*v), *v));
        self.intern(Op::Product {
            coefficient,
            numerator,
            denominator,
        })
    }

    /// Σ cᵢ vᵢ as a coefficient and a value. Terms of equal weight are added up first, so that
    /// c·a − c·b costs one multiplication and a small difference keeps its digits: c·(a − b).
    pub(super) fn sum(&mut self, terms: &[(BigRational, ValueId)]) -> (BigRational, ValueId) {
        let mut groups: Vec<Vec<(BigRational, ValueId)>> = Vec::new();
        for term in terms {
            match groups.iter_mut().find(|g| has_magnitude(&g[0].0, &term.0)) {
                Some(group) => group.push(term.clone()),
                None => groups.push(vec![term.clone()]),
            }
        }
        let mut grouped = Vec::new();
        for group in groups {
            let weight = group[0].0.abs();
            if weight.is_one() || group.len() == 1 {
                grouped.extend(group);
            } else {
                let unscaled: Vec<_> = group.iter().map(|t| (t.0.signum(), t.1)).collect();
                let (sign, value) = self.split_sum(&unscaled);
                grouped.push((sign * weight, value));
            }
        }
        self.split_sum(&grouped)
    }

    /// Σ cᵢ vᵢ as a coefficient and a value, its slower terms added up at their own rate.
    fn split_sum(&mut self, terms: &[(BigRational, ValueId)]) -> (BigRational, ValueId) {
        let last = fastest(terms.iter().map(|t| self.rate(t.1)));
        let mut slower: Option<(BigRational, ValueId)> = None;
        for rate in RATES {
            let own = terms.iter().filter(|t| self.rate(t.1) == rate);
            let mut own: Vec<_> = own.cloned().collect();
            if own.is_empty() {
                continue;
            }
            own.extend(slower.take());
            slower = Some(match own.as_slice() {
                [(coefficient, value)] if rate < last => {
                    (coefficient.signum(), self.scaled(coefficient.abs(), *value))
                }
                [term] => term.clone(),
                _ => self.signed_sum(own),
            });
        }
        slower.expect("a sum of at least one term")
    }

    /// Σ cᵢ vᵢ or its negative, whichever reads better: more plus than minus signs, `next − now`
    /// rather than `now − next`. Plus signs come first, faster terms before slower ones.
    pub(super) fn signed_sum(
        &mut self,
        mut terms: Vec<(BigRational, ValueId)>,
    ) -> (BigRational, ValueId) {
        terms.sort_by_key(|t| (Reverse(self.rate(t.1)), t.1));
        let negative = terms.iter().filter(|t| t.0.is_negative()).count();
        let flip = match (2 * negative).cmp(&terms.len()) {
            Ordering::Less => false,
            Ordering::Equal => terms[0].0.is_negative(),
            Ordering::Greater => true,
        };
        if flip {
            for term in &mut terms {
                term.0 = -&term.0;
            }
        }
        terms.sort_by_key(|t| t.0.is_negative());
        let one = BigRational::one();
        (if flip { -one } else { one }, self.intern(Op::Sum(terms)))
    }
}

/// |a| = |b|
pub(super) fn has_magnitude(a: &BigRational, b: &BigRational) -> bool {
    a.numer().magnitude() == b.numer().magnitude() && a.denom() == b.denom()
}

/// The rate at which something with these operands changes.
fn fastest(rates: impl Iterator<Item = Rate>) -> Rate {
    rates.max().unwrap_or(Rate::Scene)
}
