//! The flow: does it determine the rates?

use super::advance::counted;
use super::statements::Block;
use super::typing::Typing;
use crate::ast;
use crate::ast::ExprId;
use crate::diagnostic::Range;
use crate::model::Equation;
use crate::model::Op;
use crate::model::Variable;

impl Typing<'_> {
    /// The equations of the flow, which must determine the rate of every state.
    pub(super) fn flow(
        &mut self,
        block: Block<ast::Equation>,
        states: &[Variable],
    ) -> Vec<Equation> {
        let Some((list, keyword)) = block else {
            return Vec::new();
        };
        let flow = self.equations(list);
        let roots = flow.iter().flat_map(|e| [e.lhs, e.rhs]).collect();
        let reached = self.reached(roots);
        if flow.len() == list.len() && !self.symbols.any_contested() {
            self.check_rates(&flow, &reached, states, keyword);
        }
        flow
    }

    /// Complains unless there are as many equations as rates and each state has its rate.
    fn check_rates(
        &mut self,
        flow: &[Equation],
        reached: &[ExprId],
        states: &[Variable],
        keyword: Range,
    ) {
        let mut complete = true;
        for (i, state) in states.iter().enumerate() {
            let is_rate = |&id: &ExprId| matches!(self.exprs[id.index()].op, Op::Rate(j) if i == j);
            if !reached.iter().any(is_rate) {
                complete = false;
                let shown = &state.name.display;
                let message = format!("the flow does not contain the rate of `{shown}`");
                let help = format!("write `der({shown}) = …;`");
                self.errors.push_with_help(keyword, message, help);
            }
        }
        let n_equations: usize = flow.iter().map(|e| e.shape.len()).sum();
        let n_rates: usize = states.iter().map(|s| s.shape.len()).sum();
        if complete && n_equations != n_rates {
            let equations = counted(n_equations, "scalar equation");
            let message = format!("{equations} for {}", counted(n_rates, "scalar rate"));
            self.errors.push(keyword, message);
        }
    }
}
