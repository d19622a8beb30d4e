//! One schedule on its way to functions: names, caches, and how a body gets at its inputs.

use super::cache::Cache;
use super::expression::Expression;
use super::names::Names;
use super::record::Record;
use super::scope::identifier;
use super::statements::Statements;
use super::statements::write;
use super::variables::Variables;
use crate::dag::Leaf;
use crate::dag::Rate;
use crate::model::Model;
use crate::schedule::Count;
use crate::schedule::Expansion;
use crate::schedule::Kernel;
use crate::schedule::Schedule;
use crate::schedule::Solver;
use crate::schedule::ValueId;
use crate::system::Series;
use proc_macro2::Ident;
use proc_macro2::TokenStream;
use quote::ToTokens;
use quote::quote;
use std::collections::BTreeSet;

/// A schedule with everything its functions share.
pub(super) struct Context<'a> {
    pub(super) model: &'a Model,
    schedule: &'a Schedule,
    names: Names,
    pub(super) scene: Cache,
    pub(super) step: Cache,
    unknowns: Vec<Group>,
}

/// Some unknowns, and the array that holds them.
struct Group {
    argument: &'static str,
    unknowns: Vec<usize>,
}

/// The body of a function.
pub(super) struct Body {
    /// Inputs, numbers, values.
    pub(super) tokens: TokenStream,
    /// Its results, unless they were written with the body.
    pub(super) roots: Vec<TokenStream>,
    /// What it costs, in words.
    pub(super) cost: String,
    used: BTreeSet<&'static str>,
}

impl Body {
    /// The name of an argument, with an underscore if the body does not need it.
    pub(super) fn argument(&self, name: &'static str) -> Ident {
        if self.used.contains(name) {
            identifier(name)
        } else {
            identifier(&format!("_{name}"))
        }
    }
}

impl<'a> Context<'a> {
    /// A schedule without unknowns.
    pub(super) fn new(model: &'a Model, schedule: &'a Schedule) -> Self {
        Self::with_unknowns(model, &Variables::new(model, None), schedule, Vec::new())
    }

    /// The schedule of a solver.
    pub(super) fn of_solver(model: &'a Model, solver: &'a Solver) -> Self {
        let unknowns = Group {
            argument: "unknowns",
            unknowns: solver.unknowns.clone(),
        };
        let variables = Variables::new(model, Some(solver.form));
        Self::with_unknowns(model, &variables, &solver.schedule, vec![unknowns])
    }

    /// The schedule of Taylor coefficients.
    pub(super) fn of_series(model: &'a Model, expansion: &'a Expansion) -> Self {
        let n = model.n_states();
        let sums = 0..expansion.n_sums;
        let products = 0..expansion.n_products;
        let group = |argument, unknowns| Group { argument, unknowns };
        let groups = vec![
            group("newest", (0..n).collect()),
            group("order", (n..n + Series::GIVEN).collect()),
            group("sums", sums.map(|lane| Series::sum(n, lane)).collect()),
            group(
                "products",
                products.map(|lane| Series::product(n, lane)).collect(),
            ),
        ];
        let variables = Variables::of_series(model, expansion);
        Self::with_unknowns(model, &variables, &expansion.schedule, groups)
    }

    fn with_unknowns(
        model: &'a Model,
        variables: &Variables,
        schedule: &'a Schedule,
        unknowns: Vec<Group>,
    ) -> Self {
        let mut names = Names::new(schedule, variables);
        Self {
            model,
            schedule,
            scene: Cache::new("Scene", &schedule.scene, schedule, &mut names),
            step: Cache::new("Step", &schedule.step, schedule, &mut names),
            names,
            unknowns,
        }
    }

    /// There is such a kernel.
    pub(super) fn has(&self, name: &str) -> bool {
        self.schedule.kernel(name).is_some()
    }

    /// The body of a kernel that finds slower values in the caches.
    pub(super) fn body(&mut self, name: &str) -> Body {
        let mut roots = Vec::new();
        let mut body = self.body_with(name, |_, root| {
            roots.push(root.tokens);
            TokenStream::new()
        });
        body.roots = roots;
        body
    }

    /// The same with each result written by `finish` as soon as it is known.
    pub(super) fn body_with(
        &mut self,
        name: &str,
        finish: impl FnMut(usize, Expression) -> TokenStream,
    ) -> Body {
        let Some(kernel) = self.schedule.kernel(name) else {
            return self.assemble(&[], &[], Rate::Scene, finish);
        };
        self.assemble(&[kernel], &kernel.roots, kernel.rate, finish)
    }

    /// The body of a kernel that computes slower values itself and looks nothing up.
    pub(super) fn straight(&mut self, name: &str) -> Body {
        let schedule = self.schedule;
        let last = schedule.kernel(name);
        let kernels: Vec<&Kernel> = schedule.kernel("scene").into_iter().chain(last).collect();
        let mut results = Vec::new();
        let roots = last.map_or(&[][..], |k| &k.roots);
        let mut body = self.assemble(&kernels, roots, Rate::Scene, |_, root| {
            results.push(root.tokens);
            TokenStream::new()
        });
        body.roots = results;
        body
    }

    /// Values slower than `own` come from the caches.
    fn assemble(
        &mut self,
        kernels: &[&Kernel],
        roots: &[ValueId],
        own: Rate,
        finish: impl FnMut(usize, Expression) -> TokenStream,
    ) -> Body {
        let schedule = self.schedule;
        let mut count = Count::default();
        let mut values = Vec::new();
        let mut is_listed = vec![false; schedule.values.len()];
        for kernel in kernels {
            count += schedule.count(kernel);
            for id in &kernel.body {
                if !std::mem::replace(&mut is_listed[id.index()], true) {
                    values.push(*id);
                }
            }
        }
        let statements = write(schedule, &mut self.names, &values, roots, finish);
        // The values of the file are data, which a run takes as doubles whatever it computes with.
        let is_data = kernels.iter().any(|kernel| kernel.name == "defaults");
        let written = statements.tokens(is_data);
        let read = Read::new(schedule, &statements, own);
        let mut used = read.names();
        let inputs = self.inputs(&read, own, &mut used);
        Body {
            tokens: quote!(#inputs #written),
            roots: Vec::new(),
            cost: cost(count),
            used,
        }
    }

    /// The `let`s that give inputs their names.
    fn inputs(&self, read: &Read, own: Rate, used: &mut BTreeSet<&'static str>) -> TokenStream {
        let name = |leaf: Leaf| {
            let name = self.names.leaf(leaf).to_token_stream();
            read.leaves.contains(&leaf).then_some(name)
        };
        let parameters = Record::parameters(self.model);
        let state = Record::state(self.model);
        let is_record = own == Rate::Scene;
        let record = |record: &Record, leaf: fn(usize) -> Leaf| {
            let path = &record.name;
            record.pattern(&quote!(super::#path), |i| name(leaf(i)))
        };
        let states = (0..state.len()).map(|i| name(Leaf::State(i)));
        let patterns = [
            ("parameters", record(&parameters, Leaf::Parameter)),
            ("scene", self.scene.pattern(|v| read.cached.contains(&v))),
            ("step", self.step.pattern(|v| read.cached.contains(&v))),
            (
                "state",
                if is_record {
                    record(&state, Leaf::State)
                } else {
                    array(states.collect())
                },
            ),
        ];
        let groups = self.unknowns.iter().map(|group| {
            let unknowns = group.unknowns.iter().map(|&i| name(Leaf::Unknown(i)));
            let pattern = match group.argument {
                "sums" | "products" => rows(unknowns.collect()),
                _ => array(unknowns.collect()),
            };
            (group.argument, pattern)
        });
        let mut inputs = TokenStream::new();
        for (argument, pattern) in patterns.into_iter().chain(groups) {
            if let Some(pattern) = pattern {
                let source = identifier(argument);
                used.insert(argument);
                inputs.extend(quote!(let #pattern = *#source;));
            }
        }
        inputs
    }
}

/// What a body reads.
struct Read {
    leaves: BTreeSet<Leaf>,
    cached: BTreeSet<ValueId>,
}

impl Read {
    /// Inputs of the body's own rate, and what slower functions have left in the caches.
    fn new(schedule: &Schedule, statements: &Statements, own: Rate) -> Self {
        let cached = schedule.scene.iter().chain(&schedule.step).copied();
        let is_read = |id: &ValueId| schedule.value(*id).rate < own && statements.reads(*id);
        Self {
            leaves: statements
                .leaves()
                .filter(|leaf| leaf.rate() >= own)
                .collect(),
            cached: cached.filter(is_read).collect(),
        }
    }

    /// The inputs that are arguments themselves.
    fn names(&self) -> BTreeSet<&'static str> {
        let scalars = [(Leaf::StepSize, "h"), (Leaf::Time, "t")];
        let read = scalars
            .into_iter()
            .filter(|(leaf, _)| self.leaves.contains(leaf));
        read.map(|(_, name)| name).collect()
    }
}

/// `[a, _, c]` with what is wanted, if anything is.
fn array(components: Vec<Option<TokenStream>>) -> Option<TokenStream> {
    let is_wanted = components.iter().any(Option::is_some);
    let components = components.into_iter().map(|c| c.unwrap_or(quote!(_)));
    is_wanted.then(|| quote!([#(#components),*]))
}

/// `[[a, _, …], [c, …]]` in full rows with what is wanted, if anything is.
fn rows(mut components: Vec<Option<TokenStream>>) -> Option<TokenStream> {
    components.resize(components.len().next_multiple_of(Expansion::ROW), None);
    let is_wanted = components.iter().any(Option::is_some);
    let rows = components.chunks(Expansion::ROW).map(|row| {
        let row = row.iter().map(|c| c.clone().unwrap_or(quote!(_)));
        quote!([#(#row),*])
    });
    is_wanted.then(|| quote!([#(#rows),*]))
}

/// `12 additions, 1 call`
fn cost(count: Count) -> String {
    let part = |n: usize, one: &str| match n {
        0 => None,
        1 => Some(format!("1 {one}")),
        _ => Some(format!("{n} {one}s")),
    };
    let parts = [
        part(count.additions, "addition"),
        part(count.multiplications, "multiplication"),
        part(count.divisions, "division"),
        part(count.calls, "call"),
    ];
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    if parts.is_empty() {
        "no operations".into()
    } else {
        parts.join(", ")
    }
}
