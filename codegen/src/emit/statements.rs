//! The body of an emitted function: one `let` per shared value, the rest written where it is used.

use super::expression::Expression;
use super::names::Names;
use super::number;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::schedule::Op;
use crate::schedule::Schedule;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use proc_macro2::Ident;
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::BTreeMap;
use std::collections::BTreeSet;

/// Longest expression that is written inside another one instead of getting a name.
const INLINE: usize = 72;

/// A function body under construction.
pub(super) struct Statements<'a> {
    schedule: &'a Schedule,
    names: &'a mut Names,
    places: Vec<Place>,
    /// The sine and cosine of each angle of which both are needed.
    turns: BTreeMap<ValueId, [ValueId; 2]>,
    numbers: BTreeMap<BigRational, Ident>,
    pi: Option<Ident>,
    /// Inputs and cached values that the body reads.
    read: BTreeSet<ValueId>,
    tokens: TokenStream,
}

/// What the body does with a value.
#[derive(Clone, Default)]
struct Place {
    /// It is computed here.
    is_own: bool,
    is_root: bool,
    /// How often it is needed.
    uses: usize,
    /// What to write for it, once it is computed.
    written: Option<Expression>,
}

/// Writes `body` and, as soon as it can be computed, each of `roots` as `finish` puts it.
pub(super) fn write<'a>(
    schedule: &'a Schedule,
    names: &'a mut Names,
    body: &[ValueId],
    roots: &[ValueId],
    mut finish: impl FnMut(usize, Expression) -> TokenStream,
) -> Statements<'a> {
    let mut statements = Statements::new(schedule, names, body, roots);
    let mut open = body.iter();
    for (i, &root) in roots.iter().enumerate() {
        while statements.is_missing(root)
            && let Some(&next) = open.next()
        {
            statements.compute(next);
        }
        let expression = statements.operand(root);
        statements.tokens.extend(finish(i, expression));
    }
    statements
}

impl<'a> Statements<'a> {
    /// The body: numbers first, as doubles or as exact as `T` has them.
    pub(super) fn tokens(&self, are_doubles: bool) -> TokenStream {
        let (mut names, mut literals) = (Vec::new(), Vec::new());
        let mut others = TokenStream::new();
        for (value, name) in &self.numbers {
            match number::quotient(value).filter(|_| !are_doubles) {
                Some([numerator, denominator]) => others.extend(
                    quote!(let #name = T::constant(#numerator) / T::constant(#denominator);),
                ),
                None => {
                    names.push(name);
                    literals.push(number::literal(value));
                }
            }
        }
        if let Some(pi) = &self.pi {
            // π less the nearest double: nothing to a double, the rest of the digits to more.
            others.extend(
                quote!(let #pi = T::constant(::core::f64::consts::PI) + T::constant(1.2246467991473532e-16);),
            );
        }
        let numbers = match literals.as_slice() {
            [] => TokenStream::new(),
            [literal] => quote!(let #(#names)* = T::constant(#literal);),
            _ => quote!(let [#(#names),*] = [#(#literals),*].map(T::constant);),
        };
        let body = &self.tokens;
        quote!(#numbers #others #body)
    }

    /// Whether the body reads an input or a cached value.
    pub(super) fn reads(&self, id: ValueId) -> bool {
        self.read.contains(&id)
    }

    /// The inputs among what the body reads.
    pub(super) fn leaves(&self) -> impl Iterator<Item = Leaf> {
        self.read
            .iter()
            .filter_map(|id| match self.schedule.value(*id).op {
                Op::Leaf(leaf) => Some(leaf),
                _ => None,
            })
    }

    fn new(
        schedule: &'a Schedule,
        names: &'a mut Names,
        body: &[ValueId],
        roots: &[ValueId],
    ) -> Self {
        let mut places = vec![Place::default(); schedule.values.len()];
        for id in body {
            places[id.index()].is_own = true;
            for operand in schedule.value(*id).op.operands() {
                places[operand.index()].uses += 1;
            }
        }
        for root in roots {
            places[root.index()].is_root = true;
            places[root.index()].uses += 1;
        }
        let turns = turns(schedule, body);
        for angle in turns.keys() {
            places[angle.index()].uses -= 1;
        }
        Self {
            schedule,
            names,
            places,
            turns,
            numbers: BTreeMap::new(),
            pi: None,
            read: BTreeSet::new(),
            tokens: TokenStream::new(),
        }
    }

    fn is_missing(&self, id: ValueId) -> bool {
        let place = &self.places[id.index()];
        place.is_own && place.written.is_none()
    }

    /// Writes one value: at once if it is shared or long, otherwise where it will be used.
    fn compute(&mut self, id: ValueId) {
        if !self.is_missing(id) {
            return;
        }
        let schedule = self.schedule;
        let op = &schedule.value(id).op;
        if let Op::Call(Elementary::Sin | Elementary::Cos, angle) = op
            && let Some(turn) = self.turns.get(&angle[0]).copied()
        {
            self.compute_turn(angle[0], turn);
            return;
        }
        let expression = self.expression(op);
        let place = &self.places[id.index()];
        let is_long = expression.length > INLINE && !place.is_root;
        let expression = if place.uses > 1 || is_long {
            let name = self.names.value(schedule, id);
            let value = expression.tokens;
            self.tokens.extend(quote!(let #name = #value;));
            Expression::name(&name)
        } else {
            expression
        };
        self.places[id.index()].written = Some(expression);
    }

    fn compute_turn(&mut self, angle: ValueId, turn: [ValueId; 2]) {
        let pair = Expression::method(self.operand(angle), "sin_cos", Vec::new()).tokens;
        let names = turn.map(|id| self.names.value(self.schedule, id));
        self.tokens.extend(quote!(let (#(#names),*) = #pair;));
        for (id, name) in turn.iter().zip(&names) {
            self.places[id.index()].written = Some(Expression::name(name));
        }
    }

    fn expression(&mut self, op: &Op) -> Expression {
        match op {
            Op::Constant(value) => {
                let magnitude = self.number(value);
                if value.is_negative() {
                    Expression::sum(vec![(true, magnitude)])
                } else {
                    magnitude
                }
            }
            Op::Pi => {
                let name = self.names.pi();
                self.pi = Some(name.clone());
                Expression::name(&name)
            }
            Op::Leaf(leaf) => Expression::name(self.names.leaf(*leaf)),
            Op::Sum(terms) => self.sum(terms),
            Op::Product {
                coefficient,
                numerator,
                denominator,
            } => self.product(coefficient, numerator, denominator),
            Op::Call(function, arguments) => {
                let arguments = arguments.iter().map(|a| self.operand(*a)).collect();
                Expression::call(*function, arguments)
            }
        }
    }

    fn sum(&mut self, terms: &[(BigRational, ValueId)]) -> Expression {
        let terms = terms.iter().map(|(coefficient, id)| {
            let value = self.operand(*id);
            let term = if coefficient.abs().is_one() {
                value
            } else {
                let factor = self.number(coefficient);
                Expression::scaled(factor, number::is_power_of_two(coefficient), value)
            };
            (coefficient.is_negative(), term)
        });
        Expression::sum(terms.collect())
    }

    fn product(
        &mut self,
        coefficient: &BigRational,
        numerator: &[ValueId],
        denominator: &[ValueId],
    ) -> Expression {
        let mut factors = Vec::new();
        if !coefficient.is_one() || numerator.is_empty() {
            factors.push(self.number(coefficient));
        }
        factors.extend(numerator.iter().map(|v| self.operand(*v)));
        let divisors = denominator.iter().map(|v| self.operand(*v)).collect();
        Expression::product(factors, divisors)
    }

    /// What to write where `id` is used.
    fn operand(&mut self, id: ValueId) -> Expression {
        let place = &self.places[id.index()];
        if let Some(expression) = &place.written {
            return expression.clone();
        }
        let schedule = self.schedule;
        let op = &schedule.value(id).op;
        if op.is_number() {
            return self.expression(op);
        }
        self.read.insert(id);
        Expression::name(&self.names.value(schedule, id))
    }

    fn number(&mut self, value: &BigRational) -> Expression {
        let name = self.names.number(value);
        self.numbers.insert(value.abs(), name.clone());
        Expression::name(&name)
    }
}

/// The angles in `body` of which both sine and cosine are computed.
fn turns(schedule: &Schedule, body: &[ValueId]) -> BTreeMap<ValueId, [ValueId; 2]> {
    let mut found: BTreeMap<ValueId, [Option<ValueId>; 2]> = BTreeMap::new();
    for &id in body {
        match &schedule.value(id).op {
            Op::Call(Elementary::Sin, angle) => found.entry(angle[0]).or_default()[0] = Some(id),
            Op::Call(Elementary::Cos, angle) => found.entry(angle[0]).or_default()[1] = Some(id),
            _ => {}
        }
    }
    let both = |(angle, [sin, cos]): (ValueId, [Option<ValueId>; 2])| Some((angle, [sin?, cos?]));
    found.into_iter().filter_map(both).collect()
}
