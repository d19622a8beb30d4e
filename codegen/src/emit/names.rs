//! The identifiers of one schedule: the same value has the same name in every function.

use super::number;
use super::phrase::phrases;
use super::scope::Scope;
use super::variables::Variables;
use crate::dag::Leaf;
use crate::dag::Rate;
use crate::schedule::Op;
use crate::schedule::Schedule;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::Signed;
use proc_macro2::Ident;
use std::collections::BTreeMap;
use std::collections::HashMap;

/// Identifiers of values and numbers.
pub(super) struct Names {
    scope: Scope,
    phrases: Vec<Option<String>>,
    values: HashMap<ValueId, Ident>,
    leaves: HashMap<Leaf, Ident>,
    numbers: BTreeMap<BigRational, Ident>,
    pi: Option<Ident>,
}

impl Names {
    /// Inputs take their names first, then cached values; others when they are first asked for.
    pub(super) fn new(schedule: &Schedule, variables: &Variables) -> Self {
        let mut scope = Scope::function();
        let leaves = variables
            .leaves()
            .map(|l| (l, scope.claim(variables.name(l))))
            .collect();
        let mut names = Self {
            scope,
            phrases: phrases(schedule, variables),
            values: HashMap::new(),
            leaves,
            numbers: BTreeMap::new(),
            pi: None,
        };
        for &cached in schedule.scene.iter().chain(&schedule.step) {
            names.value(schedule, cached);
        }
        names
    }

    /// The name of an input.
    pub(super) fn leaf(&self, leaf: Leaf) -> &Ident {
        &self.leaves[&leaf]
    }

    /// The name of a value that is not a number.
    pub(super) fn value(&mut self, schedule: &Schedule, id: ValueId) -> Ident {
        let value = schedule.value(id);
        if let Op::Leaf(leaf) = &value.op {
            return self.leaves[leaf].clone();
        }
        let (scope, phrases) = (&mut self.scope, &self.phrases);
        let name = self
            .values
            .entry(id)
            .or_insert_with(|| match &phrases[id.index()] {
                Some(phrase) => scope.claim(phrase),
                None => scope.number(match value.rate {
                    Rate::Scene => 'c',
                    Rate::Step => 's',
                    Rate::Iteration => 'v',
                }),
            });
        name.clone()
    }

    /// The name of |value|.
    pub(super) fn number(&mut self, value: &BigRational) -> Ident {
        let scope = &mut self.scope;
        let magnitude = value.abs();
        let wish = number::name(&magnitude);
        let name = self.numbers.entry(magnitude).or_insert_with(|| match wish {
            Some(name) => scope.claim(&name),
            None => scope.number('k'),
        });
        name.clone()
    }

    /// The name of π.
    pub(super) fn pi(&mut self) -> Ident {
        let scope = &mut self.scope;
        self.pi.get_or_insert_with(|| scope.claim("pi")).clone()
    }
}
