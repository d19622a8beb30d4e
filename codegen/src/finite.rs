//! Defaults and start values that are no finite numbers, and numbers in equations that no double can hold.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::model::Model;
use crate::model::Variable;
use crate::system::Equations;
use crate::system::System;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use num_traits::Zero;

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

/// Looks at the numbers that equations consist of once they are worked out.
///
/// # Errors
/// One that a double would take for infinite or, though it is not, for 0: with it, what is added or multiplied would be lost.
pub fn representable(
    model: &Model,
    equations: &Equations,
    systems: &[System],
) -> Result<(), Errors> {
    let mut errors = Errors::default();
    let ranges = model.residual.iter().flat_map(|equation| {
        let (rows, cols) = (equation.shape.rows, equation.shape.cols);
        std::iter::repeat_n(equation.range, rows * cols)
    });
    let ranges: Vec<Range> = ranges.collect();
    for system in systems {
        let own = system.residual.iter().zip(&ranges);
        let own = own.map(|(&row, &range)| (vec![row], range));
        let derived = system.derived();
        let all = own.chain(ranges.first().map(|&range| (derived, range)));
        if let Some((value, range)) = first(&system.dag, all) {
            complain_of(value, range, &mut errors);
            return errors.or(());
        }
    }
    let flow = equations.flow.clone().unwrap_or_default();
    let range = model.flow.first().map(|equation| equation.range);
    if let Some((value, range)) = first(&equations.dag, range.map(|range| (flow, range))) {
        complain_of(value, range, &mut errors);
    }
    errors.or(())
}

/// The first number that no double can hold, and where the roots stand that need it.
fn first(
    dag: &Dag,
    groups: impl IntoIterator<Item = (Vec<NodeId>, Range)>,
) -> Option<(BigRational, Range)> {
    groups.into_iter().find_map(|(roots, range)| {
        let reachable = dag.reachable(&roots);
        let nodes = dag.nodes().iter().zip(reachable);
        let mut used = nodes.filter(|(_, is_used)| *is_used);
        used.find_map(|(node, _)| {
            let numbers: Vec<&BigRational> = match node {
                Node::Constant(value) => vec![value],
                Node::Sum(terms) => terms.iter().map(|term| &term.0).collect(),
                _ => Vec::new(),
            };
            let lost = numbers.into_iter().find(|value| is_lost(value))?;
            Some((lost.clone(), range))
        })
    })
}

fn is_lost(value: &BigRational) -> bool {
    let double = value.to_f64().unwrap_or(f64::NAN);
    !double.is_finite() || (double == 0.0 && !value.is_zero())
}

fn complain_of(value: BigRational, range: Range, errors: &mut Errors) {
    let digits = |part: &BigInt| (part.bits() as f64) * std::f64::consts::LOG10_2;
    let power = digits(value.numer()) - digits(value.denom());
    let message = format!("worked out, the equations contain a number of about 1e{power:.0}");
    let help = "a double is 0 or between 1e-308 and 1e308: choose other units";
    errors.push_with_help(range, message, help);
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
