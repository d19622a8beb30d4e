//! Where a model stops being finite: its expressions, as written, evaluated at a point.

use crate::ast::ExprId;
use crate::ast::Form;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::lower::lower_expressions;
use crate::model::Model;
use crate::model::Op;

/// What the expressions of a discrete model depend on.
#[derive(Clone, Copy, Debug)]
pub struct Point<'a> {
    /// In file order.
    pub parameters: &'a [f64],
    /// The step.
    pub h: f64,
    /// The time at which the step starts.
    pub t: f64,
    /// The flat state there.
    pub state: &'a [f64],
    /// The unknowns, in their order.
    pub unknowns: &'a [f64],
}

/// An expression and the values of its components, row by row.
#[derive(Clone, Debug)]
pub struct Valued {
    /// Where it stands.
    pub range: Range,
    /// A single value for a multiple of `I`.
    pub values: Vec<f64>,
}

/// An expression that is infinite or NaN although all that it is made of is finite.
#[derive(Clone, Debug)]
pub struct Culprit {
    /// The expression.
    pub whole: Valued,
    /// What it is made of, left to right; numbers as written are left out.
    pub operands: Vec<Valued>,
}

/// The first [`Culprit`] of the equations and updates of `model`, if there is one at this point.
///
/// # Errors
/// Those of [`lower_discrete`](crate::lower::lower_discrete).
pub fn first_not_finite(
    model: &Model,
    form: Form,
    point: &Point,
) -> Result<Option<Culprit>, Errors> {
    let equations = model.residual.iter().flat_map(|e| [e.lhs, e.rhs]);
    let updates = model.states.iter().filter_map(|state| state.update);
    let roots: Vec<ExprId> = equations.chain(updates).collect();
    let order = operands_first(model, &roots);
    let (dag, nodes) = lower_expressions(model, form, &order)?;
    let values = dag.evaluate(|leaf| match leaf {
        Leaf::Parameter(i) => point.parameters[i],
        Leaf::StepSize => point.h,
        Leaf::Time => point.t,
        Leaf::State(i) => point.state[i],
        Leaf::Unknown(i) => point.unknowns[i],
        Leaf::Variation(_) => f64::NAN,
    });
    let valued = |id: ExprId, nodes: &[NodeId]| Valued {
        range: model.expr(id).range,
        values: nodes.iter().map(|node| values[node.index()]).collect(),
    };
    let all: Vec<Valued> = order
        .iter()
        .zip(&nodes)
        .map(|(id, nodes)| valued(*id, nodes))
        .collect();
    let is_finite = |valued: &Valued| valued.values.iter().all(|value| value.is_finite());
    // Operands come first, so those of the first one that is not finite are.
    let Some(first) = all.iter().position(|valued| !is_finite(valued)) else {
        return Ok(None);
    };
    let op = &model.expr(order[first]).op;
    let position = |id: &ExprId| order.iter().position(|other| other == id);
    let operands = op
        .operands()
        .into_iter()
        .filter(|id| !matches!(model.expr(*id).op, Op::Number(_) | Op::Pi | Op::Identity))
        .filter_map(|id| Some(all[position(&id)?].clone()))
        .collect();
    Ok(Some(Culprit {
        whole: all[first].clone(),
        operands,
    }))
}

/// `roots` and all that they are made of, in the order in which they are read, operands before users.
fn operands_first(model: &Model, roots: &[ExprId]) -> Vec<ExprId> {
    let mut is_open = vec![true; model.exprs.len()];
    let mut order = Vec::new();
    let mut stack: Vec<(ExprId, bool)> = roots.iter().rev().map(|root| (*root, false)).collect();
    while let Some((id, is_ready)) = stack.pop() {
        if is_ready {
            order.push(id);
        } else if std::mem::replace(&mut is_open[id.index()], false) {
            stack.push((id, true));
            let operands = model.expr(id).op.operands().into_iter().rev();
            stack.extend(operands.map(|operand| (operand, false)));
        }
    }
    order
}
