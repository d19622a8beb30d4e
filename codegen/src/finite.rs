//! Defaults and start values that are no finite numbers.

use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::model::Variable;
use crate::system::Equations;

/// Evaluates the defaults, and with them the start values.
///
/// # Errors
/// Every variable of which a component is infinite or NaN.
pub fn finite(model: &Model, equations: &Equations) -> Result<(), Errors> {
    let mut errors = Errors::default();
    let values = equations.dag.evaluate(|_| f64::NAN);
    let defaults = at(&values, &equations.defaults);
    let parameters = model.parameters.iter().map(|p| &p.variable);
    complain(parameters, "the default", &defaults, &mut errors);
    // What a default spoils is not the start value's fault.
    if errors.is_empty() {
        let values = equations.dag.evaluate(|leaf| match leaf {
            Leaf::Parameter(i) => defaults[i],
            Leaf::StepSize
            | Leaf::Time
            | Leaf::State(_)
            | Leaf::Unknown(_)
            | Leaf::Variation(_) => f64::NAN,
        });
        let states = model.states.iter().map(|s| &s.variable);
        let start = at(&values, &equations.start);
        complain(states, "the start value", &start, &mut errors);
    }
    errors.or(())
}

fn at(values: &[f64], nodes: &[NodeId]) -> Vec<f64> {
    nodes.iter().map(|node| values[node.index()]).collect()
}

fn complain<'a>(
    variables: impl Iterator<Item = &'a Variable>,
    what: &str,
    values: &[f64],
    errors: &mut Errors,
) {
    for variable in variables {
        let own = variable.offset..variable.offset + variable.shape.len();
        let wrong = own.clone().find(|&i| !values[i].is_finite());
        if let Some(i) = wrong {
            let (name, value) = (&variable.name, values[i]);
            let suffix = variable.component_suffix(i - own.start);
            let shown = format!("{}{suffix}", name.display);
            let message = format!("{what} of `{shown}` is {value}, expected a finite number");
            errors.push(name.range, message);
        }
    }
}
