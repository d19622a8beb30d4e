//! From a checked model to scalars: no vectors, no time levels and no `let`s after this point.
//!
//! Each solver gets a graph of its own, because what `x[k+1]` and `Δx` mean depends on the form:
//!
//! | | form `next` | form `increment` |
//! |---|---|---|
//! | unknown | `x[k+1]` | `Δx` |
//! | `x[k+1]` | the unknown | `x + Δx` |
//! | `Δx` | `x[k+1] − x` | the unknown |
//! | `x[k+1/2]` | `(x + x[k+1])/2` | `x + Δx/2` |
//! | `der(x)` | `Δx/h` | `Δx/h` |
//!
//! A state that `update` defines explicitly has that expression as its `x[k+1]`.

mod arithmetic;
mod context;
mod functions;

use crate::ast::ClaimKind;
use crate::ast::ExprId;
use crate::ast::Form;
use crate::dag::Dag;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::model::Equation;
use crate::model::Model;
use crate::system::Claimed;
use crate::system::Continuous;
use crate::system::Discrete;
use context::Context;
use context::Meaning;

/// One solver of `model` as scalars.
///
/// # Errors
/// What only shows in scalars: `exp` and `cay` of a matrix that is not skew, division by zero,
/// exponents out of range.
pub fn lower_discrete(model: &Model, form: Form) -> Result<Discrete, Errors> {
    let mut context = Context::new(model, Meaning::Discrete(form));
    let residual = differences(&mut context, &model.residual);
    let guess = context.guesses();
    let next = context.next_states();
    let claims = claims(&mut context, &|kind| kind != ClaimKind::Flow);
    let Context { dag, errors, .. } = context;
    errors.or(Discrete {
        form,
        dag,
        residual,
        guess,
        next,
        claims,
    })
}

/// The components of each of `expressions` of the discrete equations, as many as it has.
///
/// # Errors
/// As [`lower_discrete`].
pub fn lower_expressions(
    model: &Model,
    form: Form,
    expressions: &[ExprId],
) -> Result<(Dag, Vec<Vec<NodeId>>), Errors> {
    let mut context = Context::new(model, Meaning::Discrete(form));
    let lowered = expressions.iter().map(|&id| context.claimed(id).entries);
    let lowered = lowered.collect();
    let Context { dag, errors, .. } = context;
    errors.or((dag, lowered))
}

/// Defaults, start, outputs and flow of `model` as scalars.
///
/// # Errors
/// As [`lower_discrete`].
pub fn lower_continuous(model: &Model) -> Result<Continuous, Errors> {
    let mut context = Context::new(model, Meaning::Continuous);
    let mut defaults = Vec::new();
    for parameter in &model.parameters {
        defaults.extend(context.components(parameter.default, parameter.variable.shape));
    }
    let mut start = Vec::new();
    for state in &model.states {
        start.extend(context.components(state.start, state.variable.shape));
    }
    let mut outputs = Vec::new();
    for output in &model.outputs {
        outputs.extend(context.components(output.value, output.variable.shape));
    }
    let flow = differences(&mut context, &model.flow);
    let claims = claims(&mut context, &|kind| kind == ClaimKind::Flow);
    let Context { dag, errors, .. } = context;
    errors.or(Continuous {
        dag,
        defaults,
        start,
        outputs,
        flow,
        claims,
    })
}

/// Left − right of every component of `equations`.
fn differences(context: &mut Context, equations: &[Equation]) -> Vec<NodeId> {
    let sides = sides(context, equations).into_iter();
    sides
        .map(|(left, right)| context.dag.sub(left, right))
        .collect()
}

/// Left and right of every component of `equations`.
fn sides(context: &mut Context, equations: &[Equation]) -> Vec<(NodeId, NodeId)> {
    let mut sides = Vec::new();
    for equation in equations {
        let left = context.components(equation.lhs, equation.shape);
        let right = context.components(equation.rhs, equation.shape);
        sides.extend(left.into_iter().zip(right));
    }
    sides
}

/// The claims of the kinds that `belongs` accepts; nothing for the others.
fn claims(context: &mut Context, belongs: &dyn Fn(ClaimKind) -> bool) -> Vec<Claimed> {
    let mut claims = Vec::new();
    for claim in &context.model.claims {
        if !belongs(claim.kind) {
            claims.push(Claimed::default());
            continue;
        }
        let row = |row: &Vec<(ExprId, String)>| row.iter().map(|b| context.claimed(b.0)).collect();
        let blocks = claim.blocks.iter().map(row).collect();
        let sides = sides(context, &claim.equations);
        let pairs = sides.iter();
        let differences = pairs.map(|s| context.dag.sub(s.0, s.1)).collect();
        claims.push(Claimed {
            blocks,
            sides,
            differences,
        });
    }
    claims
}
