//! How each state moves on: solved for, or given by `update`.

use super::Assembly;
use super::context::Context;
use super::statements::values;
use super::symbols::Kind;
use crate::ast::ExprId;
use crate::ast::Level;
use crate::diagnostic::Range;
use crate::model::Equation;
use crate::model::Op;
use crate::model::State;
use std::collections::BTreeSet;

impl Assembly<'_> {
    /// The states, with their start values and what `update` says of them.
    pub(super) fn states(&mut self, residual: &[Equation]) -> Vec<State> {
        let starts = values(
            self.statements.start(),
            self.symbols,
            &mut self.typing.errors,
        );
        let updates = values(
            self.statements.update(),
            self.symbols,
            &mut self.typing.errors,
        );
        let variables = self.variables(Kind::State);
        let mut states = Vec::new();
        for (i, variable) in variables.into_iter().enumerate() {
            let update = updates[i].map(|a| {
                let value = self.typing.expression_in(a.value, Context::Update);
                self.fit(value, &variable, true);
                value
            });
            let start = match starts[i] {
                Some(assignment) => {
                    let value = self.typing.expression_in(assignment.value, Context::Start);
                    self.fit(value, &variable, false);
                    value
                }
                None => self.missing_start(&variable),
            };
            states.push(State {
                variable,
                start,
                solved: true,
                update,
            });
        }
        self.classify(&mut states, residual);
        states
    }

    fn missing_start(&mut self, variable: &crate::model::Variable) -> ExprId {
        let name = &variable.name;
        let message = format!("`{}` has no start value", name.display);
        let help = format!("write `start {{ {} = …; }}`", name.display);
        let range = self.statements.start_range().unwrap_or(name.range);
        self.typing.errors.push_with_help(range, message, help);
        self.typing.poison(name.range)
    }

    /// Tells states that are solved for from those that `update` gives, and complains about those that
    /// nothing moves.
    fn classify(&mut self, states: &mut [State], residual: &[Equation]) {
        for (i, state) in states.iter_mut().enumerate() {
            if let Some(update) = state.update {
                state.solved = self.advanced_states(&[update]).contains(&i);
            }
        }
        if let Some(cycle) = self.cycle(states) {
            let name = &states[cycle].variable.name;
            let message = format!("the update of `{}` needs its own result", name.display);
            self.typing.errors.push(name.range, message);
            states[cycle].solved = true;
            return;
        }
        let sides: Vec<_> = residual.iter().flat_map(|e| [e.lhs, e.rhs]).collect();
        let updates = states.iter().filter_map(|s| s.update);
        let reached = self.advanced_states(&sides.into_iter().chain(updates).collect::<Vec<_>>());
        for (i, state) in states.iter().enumerate() {
            if state.solved && !reached.contains(&i) && !residual.is_empty() {
                let name = &state.variable.name;
                let shown = &name.display;
                let message = format!("the state `{shown}` is never advanced");
                let help = format!(
                    "the residual must contain `{shown}[k+1]` or `Δ{shown}`, or an update give it"
                );
                self.typing.errors.push_with_help(name.range, message, help);
            }
        }
    }

    /// The states whose next value, increment or rate occurs in `roots`.
    fn advanced_states(&self, roots: &[ExprId]) -> BTreeSet<usize> {
        let mut states = BTreeSet::new();
        for root in roots {
            for id in self.typing.reachable(*root) {
                match self.typing.exprs[id.index()].op {
                    Op::State(i, Level::Half | Level::Next) | Op::Increment(i) | Op::Rate(i) => {
                        states.insert(i);
                    }
                    _ => {}
                }
            }
        }
        states
    }

    /// A state given by `update` whose value needs itself through other updates.
    fn cycle(&self, states: &[State]) -> Option<usize> {
        let explicit = |i: usize| states[i].update.filter(|_| !states[i].solved);
        let needs: Vec<BTreeSet<usize>> = (0..states.len())
            .map(|i| explicit(i).map_or(BTreeSet::new(), |update| self.advanced_states(&[update])))
            .collect();
        (0..states.len()).find(|&start| {
            let mut seen = BTreeSet::new();
            let mut open: Vec<usize> = needs[start].iter().copied().collect();
            while let Some(i) = open.pop() {
                if seen.insert(i) {
                    open.extend(&needs[i]);
                }
            }
            seen.contains(&start)
        })
    }

    /// Complains about states whose rate the flow does not contain.
    pub(super) fn check_rates(&mut self, flow: &[Equation], range: Range) {
        let sides: Vec<_> = flow.iter().flat_map(|e| [e.lhs, e.rhs]).collect();
        let reached = self.advanced_states(&sides);
        let missing: Vec<_> = self
            .symbols
            .of_kind(Kind::State)
            .filter(|(_, s)| !reached.contains(&s.index))
            .map(|(_, s)| format!("`der({})`", s.name.display))
            .collect();
        if !missing.is_empty() {
            let message = format!("the flow does not contain {}", missing.join(", "));
            let help = "it must give the rate of every state";
            self.typing.errors.push_with_help(range, message, help);
        }
    }
}
