//! What is to be run, as options: a model, its discrete equations, parameters, a start and a span of time.

use crate::assignment::{Assignment, Target, assign, parse};
use crate::expression::Symbol;
use crate::failure::Failure;
use crate::notation::{exact, number};
use clap::Args;
use residua::Catalogued;
use residua::description::{Description, Variable};
use residua::erased::AnySolver;
use residua_models::values;
use residua_models::{Entry, find};

/// More steps than this are taken for a mistake: at 100 ns a step they last a day.
const MAX_STEPS: f64 = 1e12;

/// Step and end where nobody says otherwise.
const STEP: f64 = 0.01;
const UNTIL: f64 = 10.0;

/// How far `until / step` may fall short of a whole number for a run that is meant to end there.
/// It covers the rounding of decimal steps, [steps].
const END_TOLERANCE: f64 = 1e-9;

/// What is to be run.
#[derive(Args)]
pub struct Motion {
    /// A model or a scene from `residua list`
    model: String,
    /// Which discrete equations to solve: those for x[k+1] or those for Δx [default: the first the
    /// model has]
    #[arg(long, value_name = "next|increment")]
    pub form: Option<String>,
    /// Set a parameter: `--set m=3`, `--set "J=diag(1,2.8,2)"`, `--set "J(2,2)=3"`
    #[arg(long, value_name = "NAME=EXPR", value_parser = parse)]
    set: Vec<Assignment>,
    /// Set a start value: `--start "ω=[0.5,-0.5,0.4]"`, `--start omega.x=pi/3`
    #[arg(long, value_name = "NAME=EXPR", value_parser = parse)]
    pub start: Vec<Assignment>,
    /// Time step h [default: that of the scene, or 0.01]
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    step: Option<f64>,
    /// End time [default: that of the scene, or 10]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    until: Option<f64>,
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

impl Motion {
    /// The model that is named.
    pub fn entry(&self) -> Result<&'static Entry, Failure> {
        Ok(find(&self.model)?)
    }

    /// Step and end as asked for, or as the scene has them, checked.
    pub fn span(&self, model: &Catalogued) -> Result<Span, Failure> {
        let scene = model.description.scene;
        let step = self
            .step
            .unwrap_or_else(|| scene.map_or(STEP, |scene| scene.step));
        let until = self
            .until
            .unwrap_or_else(|| scene.map_or(UNTIL, |scene| scene.until));
        steps(step, until)
    }

    /// The solver of the form, or the first one.
    pub fn solver(&self, model: &Catalogued) -> Result<&'static dyn AnySolver, Failure> {
        let name = model.description.name;
        let form = self.form.as_deref();
        let wanted =
            |solver: &&&'static dyn AnySolver| form.is_none_or(|f| solver.solver().form == f);
        model.solvers.iter().find(wanted).copied().ok_or_else(|| {
            let forms: Vec<&str> = model.solvers.iter().map(|s| s.solver().form).collect();
            Failure::input(match form {
                Some(form) => format!(
                    "`{name}` has no form `{form}`, only {}",
                    forms.join(" and ")
                ),
                None => format!("`{name}` has no discrete equations"),
            })
        })
    }

    /// The parameters: those of the file, overwritten by `--set`.
    pub fn parameters(&self, model: &'static Catalogued) -> Result<Vec<f64>, Failure> {
        for assignment in self.assignments() {
            refuse_skipped(assignment, model.description)?;
        }
        parameters(model, &self.set)
    }

    /// Parameters and start values: those of the file, overwritten by `--set` and `--start`.
    pub fn values(&self, model: &'static Catalogued) -> Result<(Vec<f64>, Vec<f64>), Failure> {
        assigned(model, &self.set, &self.start)
    }

    /// What is set, parameters first.
    pub fn assignments(&self) -> impl Iterator<Item = &Assignment> {
        self.set.iter().chain(&self.start)
    }
}

fn steps(step: f64, until: f64) -> Result<Span, Failure> {
    if !(step.is_finite() && step > 0.0) {
        return Err(Failure::input(format!(
            "the step is {}, not a positive number",
            exact(step)
        )));
    }
    if !(until.is_finite() && until > 0.0) {
        return Err(Failure::input(format!(
            "the end time is {}, not a positive number",
            exact(until)
        )));
    }
    let ratio = until / step;
    if ratio + END_TOLERANCE < 1.0 {
        let message = format!(
            "the run ends at t = {}, before its first step of {}",
            exact(until),
            exact(step)
        );
        return Err(Failure::input(message));
    }
    if ratio > MAX_STEPS {
        let [until, step] = [until, step].map(exact);
        let message = format!("{until} / {step} are {ratio:.1e} steps, more than {MAX_STEPS:e}");
        return Err(Failure::input(message));
    }
    let steps = (ratio + END_TOLERANCE).floor();
    let whole = (ratio - steps).abs() <= END_TOLERANCE * ratio.max(1.0);
    let end = number(steps * step);
    let note = format!(
        "{} is no multiple of the step {}: the run ends at t = {end}",
        exact(until),
        exact(step)
    );
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
    let parameters = parameters(model, parameter_values)?;
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

fn parameters(model: &'static Catalogued, given: &[Assignment]) -> Result<Vec<f64>, Failure> {
    let variables = model.description.parameters;
    let mut parameters = values::defaults(model);
    let defaults = symbols(variables, &parameters);
    let target = Target {
        kind: "parameter",
        variables,
        values: &mut parameters,
    };
    assign(given, target, &defaults)?;
    Ok(parameters)
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
