//! How each state moves on, and whether the residual determines the unknowns.
//!
//! A state is *explicit* if `update` gives its next value without naming it: then `x[k+1]` anywhere
//! stands for that value. Every other state must have an unknown next value in the residual.

use super::statements::Block;
use super::typing::Typing;
use crate::ast;
use crate::ast::ExprId;
use crate::ast::LARGEST_DIMENSION;
use crate::ast::Level;
use crate::diagnostic::Range;
use crate::model::Equation;
use crate::model::Op;
use crate::model::Unknown;
use crate::model::Variable;

/// The states that move on, and what `update` says about them.
pub(super) struct Advance<'a> {
    states: &'a [Variable],
    unknowns: &'a [Unknown],
    update: &'a [Option<ExprId>],
    /// The state is explicit.
    pub(super) explicit: Vec<bool>,
}

/// The unknowns that some expressions contain, explicit states written out.
struct Contained {
    /// Next values of states, explicit ones included.
    states: Vec<bool>,
    /// Own unknowns.
    unknowns: Vec<bool>,
}

impl<'a> Advance<'a> {
    /// Finds the explicit states.
    pub(super) fn new(
        typing: &Typing,
        states: &'a [Variable],
        unknowns: &'a [Unknown],
        update: &'a [Option<ExprId>],
    ) -> Self {
        let explicit = (0..states.len()).map(|i| match update[i] {
            Some(value) => {
                let future = |id: &ExprId| future_state(&typing.exprs[id.index()].op) == Some(i);
                !typing.reached(vec![value]).iter().any(future)
            }
            None => false,
        });
        Self {
            states,
            unknowns,
            update,
            explicit: explicit.collect(),
        }
    }

    /// Complains unless the residual determines all that is unknown; `residual` are those of the
    /// equations in `block` that have no mistake.
    pub(super) fn check(
        &self,
        typing: &mut Typing,
        block: Block<ast::Equation>,
        residual: &[Equation],
    ) {
        self.check_order(typing);
        // With an equation missing, whatever is found would be a consequence.
        if let Some((list, keyword)) = block
            && list.len() == residual.len()
            && !list.is_empty()
            && !self.states.is_empty()
            && !typing.symbols.any_contested()
        {
            self.check_residual(typing, residual, keyword);
        }
    }

    /// Complains about explicit states that need each other's next value.
    fn check_order(&self, typing: &mut Typing) {
        let mut open: Vec<usize> = (0..self.states.len())
            .filter(|&i| self.explicit[i])
            .collect();
        let needs: Vec<Vec<usize>> = (0..self.states.len())
            .map(|i| {
                let reached = typing.reached(self.update[i].into_iter().collect());
                let future = |id: &ExprId| future_state(&typing.exprs[id.index()].op);
                reached.iter().filter_map(future).collect()
            })
            .collect();
        loop {
            let waits = |&i: &usize| needs[i].iter().any(|j| open.contains(j));
            let waiting: Vec<usize> = open.iter().copied().filter(waits).collect();
            if waiting.len() == open.len() {
                break;
            }
            open = waiting;
        }
        if let [first, ..] = open.as_slice() {
            let names: Vec<_> = open.iter().map(|&i| self.shown(i)).collect();
            let message = format!(
                "the updates of {} need each other's next value",
                names.join(", ")
            );
            typing.errors.push(self.states[*first].name.range, message);
        }
    }

    /// Complains about states that are never advanced, unknowns in no equation, equations without an
    /// unknown, and a wrong number of equations; `keyword` is where the residual begins.
    fn check_residual(&self, typing: &mut Typing, residual: &[Equation], keyword: Range) {
        let n_equations: usize = residual.iter().map(|e| e.shape.len()).sum();
        if n_equations > LARGEST_DIMENSION {
            let message =
                format!("{n_equations} scalar equations, expected at most {LARGEST_DIMENSION}");
            typing.errors.push(keyword, message);
            return;
        }
        let roots = residual.iter().flat_map(|e| [e.lhs, e.rhs]).collect();
        let contained = self.contained(typing, roots);
        let mut complete = self.check_contained(typing, &contained);
        // Without any unknown, their number says it all.
        let any_unknown = !self.unknowns.is_empty() || self.explicit.contains(&false);
        for equation in residual.iter().filter(|_| any_unknown) {
            let contained = self.contained(typing, vec![equation.lhs, equation.rhs]);
            let solved = (0..self.states.len()).any(|i| contained.states[i] && !self.explicit[i]);
            if !solved && !contained.unknowns.contains(&true) {
                complete = false;
                let message = "no unknown in this equation";
                let known = (0..self.states.len()).filter(|&i| contained.states[i]);
                let help = self.known(known).unwrap_or_else(|| {
                    "x[k+1], Δx, x[k+1/2] and der(x) of a state are unknown".to_owned()
                });
                typing.errors.push_with_help(equation.range, message, help);
            }
        }
        if complete {
            self.check_count(typing, n_equations, keyword);
        }
    }

    fn check_contained(&self, typing: &mut Typing, contained: &Contained) -> bool {
        let mut complete = true;
        for (i, state) in self.states.iter().enumerate() {
            if self.explicit[i] || contained.states[i] {
                continue;
            }
            complete = false;
            let shown = &state.name.display;
            let message = format!("the state `{shown}` is never advanced");
            let help = match self.update[i] {
                Some(_) => format!(
                    "its update needs its own next value, so `residual` must determine {shown}[k+1]"
                ),
                None => format!(
                    "name {shown}[k+1] or Δ{shown} in `residual`, or give `{shown}` a value in `update`"
                ),
            };
            typing
                .errors
                .push_with_help(state.name.range, message, help);
        }
        for (i, unknown) in self.unknowns.iter().enumerate() {
            if !contained.unknowns[i] {
                complete = false;
                let name = &unknown.variable.name;
                let message = format!("no equation contains the unknown `{}`", name.display);
                typing.errors.push(name.range, message);
            }
        }
        complete
    }

    fn check_count(&self, typing: &mut Typing, n_equations: usize, keyword: Range) {
        let solved = (0..self.states.len()).filter(|&i| !self.explicit[i]);
        let states = solved.map(|i| &self.states[i]);
        let unknowns = states.chain(self.unknowns.iter().map(|u| &u.variable));
        let list: Vec<_> = unknowns
            .map(|v| (v.name.display.as_str(), v.shape.len()))
            .collect();
        let n_unknowns: usize = list.iter().map(|(_, n)| n).sum();
        if n_unknowns == n_equations {
            return;
        }
        let list: Vec<_> = list
            .iter()
            .map(|(name, n)| format!("{name} ({n})"))
            .collect();
        let equations = counted(n_equations, "scalar equation");
        let message = format!("{equations} for {}", counted(n_unknowns, "scalar unknown"));
        let unknowns = (!list.is_empty()).then(|| format!("the unknowns are {}", list.join(", ")));
        let reason = if n_unknowns < n_equations {
            self.known((0..self.states.len()).filter(|&i| self.explicit[i]))
        } else {
            self.unknown_through_update()
        };
        let help: Vec<_> = unknowns.into_iter().chain(reason).collect();
        if help.is_empty() {
            typing.errors.push(keyword, message);
        } else {
            typing
                .errors
                .push_with_help(keyword, message, help.join("; "));
        }
    }

    /// Why these explicit states are no unknowns.
    fn known(&self, states: impl Iterator<Item = usize>) -> Option<String> {
        let names: Vec<_> = states
            .map(|i| self.states[i].name.display.as_str())
            .collect();
        match names.as_slice() {
            [] => None,
            [x] => Some(format!(
                "{x} is no unknown, as `update` gives it without {x}[k+1]"
            )),
            [x, ..] => Some(format!(
                "{} are no unknowns, as `update` gives them without {x}[k+1] and the like",
                names.join(", ")
            )),
        }
    }

    /// Why a state is unknown although `update` gives it.
    fn unknown_through_update(&self) -> Option<String> {
        let is_such = |&i: &usize| self.update[i].is_some() && !self.explicit[i];
        let state = (0..self.states.len()).find(is_such)?;
        let x = &self.states[state].name.display;
        Some(format!(
            "{x} is one, as its own update contains {x}[k+1] or Δ{x}"
        ))
    }

    /// What `roots` contain.
    fn contained(&self, typing: &Typing, roots: Vec<ExprId>) -> Contained {
        let mut contained = Contained {
            states: vec![false; self.states.len()],
            unknowns: vec![false; self.unknowns.len()],
        };
        let mut roots = roots;
        while !roots.is_empty() {
            let reached = typing.reached(std::mem::take(&mut roots));
            for id in reached {
                let op = &typing.exprs[id.index()].op;
                if let Op::Unknown(i) = op {
                    contained.unknowns[*i] = true;
                }
                if let Some(i) = future_state(op)
                    && !std::mem::replace(&mut contained.states[i], true)
                    && self.explicit[i]
                {
                    roots.extend(self.update[i]);
                }
            }
        }
        contained
    }

    fn shown(&self, state: usize) -> String {
        format!("`{}`", self.states[state].name.display)
    }
}

/// `1 state`, `2 states`
pub(super) fn counted(n: usize, noun: &str) -> String {
    let plural = if n == 1 { "" } else { "s" };
    format!("{n} {noun}{plural}")
}

/// The state whose next value an operation needs.
fn future_state(op: &Op) -> Option<usize> {
    match op {
        Op::State(i, Level::Half | Level::Next) | Op::Increment(i) | Op::Rate(i) => Some(*i),
        Op::State(_, Level::Previous | Level::Now)
        | Op::Number(_)
        | Op::Pi
        | Op::Identity
        | Op::Parameter(_)
        | Op::Unknown(_)
        | Op::Variation(_)
        | Op::Time(_)
        | Op::StepSize
        | Op::Neg(_)
        | Op::Add(..)
        | Op::Sub(..)
        | Op::Mul(..)
        | Op::Div(..)
        | Op::Pow(..)
        | Op::Transpose(_)
        | Op::Component(..)
        | Op::Blocks { .. }
        | Op::Call(..) => None,
    }
}
