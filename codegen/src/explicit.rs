//! From continuous equations M(t, x) ẋ = f(t, x) to the rates ẋ.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::linear::pattern;
use crate::linear::solve;
use crate::model::Model;
use crate::sample::Typical;
use crate::system::Entry;

/// The rate of each state component, from `flow` (left − right) and its derivatives by the rates.
///
/// # Errors
/// Equations that are not linear in the rates, or do not determine all of them.
pub fn explicit(
    model: &Model,
    dag: &mut Dag,
    flow: &[NodeId],
    entries: &[Entry],
    typical: &Typical,
) -> Result<Vec<NodeId>, Errors> {
    check_linear(model, dag, flow, entries)?;
    let n = flow.len();
    let zero = dag.integer(0);
    let at_rest = dag.substitute(flow, |leaf| {
        matches!(leaf, Leaf::Unknown(_)).then_some(zero)
    });
    let mut matrix = vec![vec![zero; n]; n];
    for entry in entries {
        matrix[entry.row][entry.col] = entry.node;
    }
    let right: Vec<NodeId> = at_rest.iter().map(|&r| dag.neg(r)).collect();
    match solve(dag, &matrix, &right, typical) {
        Some(solution) => Ok(solution.x),
        None => Err(undetermined(model, &pattern(dag, &matrix).matching())),
    }
}

/// The first equation whose coefficient of a rate contains a rate.
fn check_linear(
    model: &Model,
    dag: &Dag,
    flow: &[NodeId],
    entries: &[Entry],
) -> Result<(), Errors> {
    let depends = dag.dependence(|leaf| matches!(leaf, Leaf::Unknown(_)));
    let curved = dag.curved();
    let mut errors = Errors::default();
    let mut offset = 0;
    for equation in &model.flow {
        let rows = offset..offset + equation.shape.len();
        offset = rows.end;
        let mut own = entries.iter().filter(|e| rows.contains(&e.row));
        let is_curved = own.any(|e| depends[e.node.index()]);
        let stands_in_function = rows.clone().any(|row| curved[flow[row].index()] != 0);
        if is_curved || stands_in_function {
            errors.push(
                equation.range,
                "the flow must be linear in the rates der(x)",
            );
        }
    }
    errors.or(())
}

fn undetermined(model: &Model, matching: &[Option<usize>]) -> Errors {
    let mut errors = Errors::default();
    for state in &model.states {
        let variable = &state.variable;
        for component in 0..variable.shape.len() {
            if matching[variable.offset + component].is_none() {
                let suffix = variable.component_suffix(component);
                let rate = format!("der({}){suffix}", variable.name.display);
                let message = format!("the flow does not determine `{rate}`");
                errors.push(variable.name.range, message);
            }
        }
    }
    errors
}
