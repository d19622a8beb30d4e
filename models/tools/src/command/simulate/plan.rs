//! From the options of `simulate` to a run that can start.

mod scheme;

use super::Simulate;
use crate::assignment::{Assignment, Target, assign};
use crate::expression::Symbol;
use crate::failure::Failure;
use crate::notation::number;
use residua::Catalogued;
use residua::description::{Description, Variable};
use residua_models::values;
use scheme::scheme;

pub use scheme::{NEWTON, Scheme, Terms, solver};

/// More steps than this are taken for a mistake: at 100 ns a step they last a day.
const MAX_STEPS: f64 = 1e12;

/// Step and end where nobody says otherwise.
const STEP: f64 = 0.01;
const UNTIL: f64 = 10.0;

/// How far `until / step` may fall short of a whole number for a run that is meant to end there.
/// It covers the rounding of decimal steps, [steps].
const END_TOLERANCE: f64 = 1e-9;

/// A run that can start.
pub struct Plan {
    /// What advances the state.
    pub scheme: Scheme,
    /// Flat.
    pub parameters: Vec<f64>,
    /// Flat.
    pub start: Vec<f64>,
    /// The time step.
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// What the user should know before the run.
    pub note: Option<String>,
}

/// Checks the options against the model.
pub fn plan(options: &Simulate, model: &'static Catalogued) -> Result<Plan, Failure> {
    let Span { step, steps, note } = span(model, options.step, options.until)?;
    if let Some(tolerance) = options.tolerance.filter(|t| !(*t > 0.0 && *t < 1.0)) {
        let message = format!("the tolerance is {tolerance}, not between 0 and 1");
        return Err(Failure::input(message));
    }
    let is_newton = options.scheme == NEWTON;
    if !is_newton
        && (options.strategy.is_some()
            || options.uncompensated
            || options.halve > 0
            || options.single)
    {
        return Err(Failure::input(format!(
            "--strategy, --uncompensated, --halve and --single are of Newton's method on the discrete equations, and {} is another scheme",
            options.scheme
        )));
    }
    let (parameters, start) = assigned(model, &options.set, &options.start)?;
    Ok(Plan {
        scheme: scheme(options, model)?,
        parameters,
        start,
        step,
        steps,
        note,
    })
}

/// Step and end of a run.
pub struct Span {
    /// The time step.
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// What is to be said about the last one.
    pub note: Option<String>,
}

/// Step and end as asked for, or as the scene has them, checked.
pub fn span(model: &Catalogued, step: Option<f64>, until: Option<f64>) -> Result<Span, Failure> {
    let scene = model.description.scene;
    let step = step.unwrap_or_else(|| scene.map_or(STEP, |scene| scene.step));
    let until = until.unwrap_or_else(|| scene.map_or(UNTIL, |scene| scene.until));
    steps(step, until)
}

fn steps(step: f64, until: f64) -> Result<Span, Failure> {
    if !(step.is_finite() && step > 0.0) {
        return Err(Failure::input(format!(
            "the step is {step}, not a positive number"
        )));
    }
    if !(until.is_finite() && until > 0.0) {
        return Err(Failure::input(format!(
            "the end time is {until}, not a positive number"
        )));
    }
    let ratio = until / step;
    if ratio + END_TOLERANCE < 1.0 {
        let message = format!("the run ends at t = {until}, before its first step of {step}");
        return Err(Failure::input(message));
    }
    if ratio > MAX_STEPS {
        let message = format!("{until} / {step} are {ratio:.1e} steps, more than {MAX_STEPS:e}");
        return Err(Failure::input(message));
    }
    let steps = (ratio + END_TOLERANCE).floor();
    let whole = (ratio - steps).abs() <= END_TOLERANCE * ratio.max(1.0);
    let end = number(steps * step);
    let note = format!("{until} is no multiple of the step {step}: the run ends at t = {end}");
    Ok(Span {
        step,
        steps: steps as u64,
        note: (!whole).then_some(note),
    })
}

/// Parameters and start values: those of the file, overwritten by `--set` and `--start`.
pub fn assigned(
    model: &'static Catalogued,
    parameter_values: &[Assignment],
    start_values: &[Assignment],
) -> Result<(Vec<f64>, Vec<f64>), Failure> {
    let description = model.description;
    for assignment in parameter_values.iter().chain(start_values) {
        refuse_skipped(assignment, description)?;
    }
    let mut parameters = values::defaults(model);
    let defaults = symbols(description.parameters, &parameters);
    let target = Target {
        kind: "parameter",
        variables: description.parameters,
        values: &mut parameters,
    };
    assign(parameter_values, target, &defaults)?;

    let mut start = values::start(model, &parameters);
    let set = symbols(description.parameters, &parameters);
    let target = Target {
        kind: "state",
        variables: description.states,
        values: &mut start,
    };
    assign(start_values, target, &set)?;
    match start.iter().find(|value| !value.is_finite()) {
        Some(value) => Err(Failure::input(format!(
            "a start value of `{}` is {value}",
            description.name
        ))),
        None => Ok((parameters, start)),
    }
}

/// What a scene has folded in or left out cannot be given another value.
pub fn refuse_skipped(
    assignment: &Assignment,
    description: &'static Description,
) -> Result<(), Failure> {
    let Some(scene) = description.scene else {
        return Ok(());
    };
    let kept = description.parameters.iter().chain(description.states);
    let is_kept = kept.into_iter().any(|v| assignment.is_to(v.name));
    let is_meant = |what: &str| what.split(", ").any(|part| assignment.is_to(part));
    let mut skipped = scene.skipped.iter().filter(|s| match s.kind {
        "parameter" | "state" => true,
        // What is left of a variable says itself why a component has to be 0.
        "component" => !is_kept,
        _ => false,
    });
    let Some(skipped) = skipped.find(|s| is_meant(s.what)) else {
        return Ok(());
    };
    let (name, model) = (description.name, scene.model);
    let gone = format!(
        "the scene `{name}` does without `{}`: {}",
        skipped.what, skipped.reason
    );
    let help = format!("the model `{model}` has everything in it");
    Err(Failure::input_with_help(gone, help))
}

/// The parameters under their names.
pub fn symbols<'a>(variables: &'a [Variable], values: &[f64]) -> Vec<(Symbol<'a>, Vec<f64>)> {
    let mut offset = 0;
    let symbol = |variable: &'a Variable| {
        let len = variable.rows * variable.cols;
        offset += len;
        let symbol = Symbol {
            name: variable.name,
            shape: (variable.rows, variable.cols),
            unit: variable.unit,
        };
        (symbol, values[offset - len..offset].to_vec())
    };
    variables.iter().map(symbol).collect()
}

#[cfg(test)]
mod tests;
