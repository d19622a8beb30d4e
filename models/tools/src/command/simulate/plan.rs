//! From the options of `simulate` to a run that can start.

mod scheme;

use super::Simulate;
use crate::failure::Failure;
use crate::motion::Span;
use residua::{Catalogued, Tolerance};
use scheme::scheme;

pub use scheme::{NEWTON, Scheme, Terms};

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
    pub notes: Vec<String>,
}

/// Checks the options against the model.
pub fn plan(options: &Simulate, model: &'static Catalogued) -> Result<Plan, Failure> {
    let Span { step, steps, note } = options.motion.span(model)?;
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
    let (parameters, start) = options.motion.values(model)?;
    let below_rounding = options
        .tolerance
        .filter(|t| !is_newton && *t < Tolerance::LEAST);
    let below_rounding = below_rounding.map(|tolerance| {
        let least = Tolerance::LEAST;
        format!("the tolerance {tolerance:e} is below rounding, and steps keep to {least:.1e} of each component")
    });
    Ok(Plan {
        scheme: scheme(options, model)?,
        parameters,
        start,
        step,
        steps,
        notes: note.into_iter().chain(below_rounding).collect(),
    })
}
