//! Equations, claims and requirements: do both sides have one shape and one unit?

use super::statements::Block;
use super::types::Type;
use super::typing::Typing;
use crate::ast;
use crate::ast::ClaimKind;
use crate::ast::ExprId;
use crate::diagnostic::Range;
use crate::model::Claim;
use crate::model::Equation;
use crate::model::Requirement;
use crate::model::Shape;

impl Typing<'_> {
    /// The discrete equations.
    pub(super) fn residual(&mut self, block: Block<ast::Equation>) -> Vec<Equation> {
        block.map_or_else(Vec::new, |(list, _)| self.equations(list))
    }

    /// The equations of a block; those with a mistake are left out.
    pub(super) fn equations(&mut self, list: &[ast::Equation]) -> Vec<Equation> {
        list.iter().filter_map(|e| self.equation(e)).collect()
    }

    fn equation(&mut self, equation: &ast::Equation) -> Option<Equation> {
        let (lhs, rhs, shape) = self.sides(equation.lhs, equation.rhs, equation.range)?;
        Some(Equation {
            lhs,
            rhs,
            shape,
            text: equation.text.clone(),
            range: equation.range,
        })
    }

    /// Both sides and their shape; none after a complaint.
    fn sides(&mut self, lhs: ExprId, rhs: ExprId, range: Range) -> Option<(ExprId, ExprId, Shape)> {
        let lhs = self.expression(lhs);
        let rhs = self.expression(rhs);
        if matches!(self.ty(lhs), Type::Poison) || matches!(self.ty(rhs), Type::Poison) {
            return None;
        }
        let Some((shape, left, right)) = self.align(lhs, rhs) else {
            let (left, right) = (self.ty(lhs).noun(), self.ty(rhs).noun());
            let message = format!("the left side is {left}, the right side {right}");
            self.errors.push(range, message);
            return None;
        };
        let Some(shape) = shape else {
            self.errors.push(range, "the size of `I` is not known here");
            return None;
        };
        self.equal_units(
            range,
            Some(shape),
            &left,
            &right,
            |position, left, right| {
                format!("the left side has the unit {left}, the right side {right}{position}")
            },
        );
        Some((lhs, rhs, shape))
    }

    /// What the data of a run must be like.
    pub(super) fn requirements(&mut self, list: &[&ast::Requirement]) -> Vec<Requirement> {
        let typed = |requirement: &&ast::Requirement| {
            let &&ast::Requirement {
                lhs, rhs, range, ..
            } = requirement;
            let (lhs, rhs, shape) = self.sides(lhs, rhs, range)?;
            Some(Requirement {
                lhs,
                relation: requirement.relation,
                rhs,
                shape,
                otherwise: requirement.otherwise.clone(),
                text: requirement.text.clone(),
                range,
            })
        };
        list.iter().filter_map(typed).collect()
    }

    /// The claims. Units inside them are not compared: what a paper prints need not be right.
    pub(super) fn claims(&mut self, list: &[&ast::Claim]) -> Vec<Claim> {
        self.lenient = true;
        let mut claims = Vec::new();
        for claim in list {
            let mut blocks = Vec::new();
            for row in &claim.blocks {
                let typed = row
                    .iter()
                    .map(|(id, text)| (self.expression(*id), text.clone()));
                blocks.push(typed.collect());
            }
            self.varying = claim.kind == ClaimKind::Differential;
            let equations = self.equations(&claim.equations);
            self.varying = false;
            claims.push(Claim {
                kind: claim.kind,
                label: claim.label.clone(),
                of: self.claimed_residual(claim, list),
                required: claim.required,
                blocks,
                equations,
                range: claim.range,
            });
        }
        self.lenient = false;
        claims
    }

    /// Where among the claims the residual stands that `claim` is the Jacobian of.
    fn claimed_residual(&mut self, claim: &ast::Claim, list: &[&ast::Claim]) -> Option<usize> {
        let (label, range) = claim.of.as_ref()?;
        let found = list
            .iter()
            .position(|c| c.kind == ClaimKind::Residual && c.label == *label);
        if found.is_none() {
            let message = format!("there is no `claim residual {label:?}`");
            self.errors.push(*range, message);
        }
        found
    }

    /// All that `roots` are made of, operands first.
    pub(super) fn reached(&self, roots: Vec<ExprId>) -> Vec<ExprId> {
        let mut seen = vec![false; self.exprs.len()];
        let mut pending = roots;
        while let Some(id) = pending.pop() {
            if !std::mem::replace(&mut seen[id.index()], true) {
                pending.extend(self.exprs[id.index()].op.operands());
            }
        }
        let ids = (0..self.exprs.len() as u32).map(ExprId);
        ids.filter(|id| seen[id.index()]).collect()
    }
}
