//! What a scheme conserves: to rounding, to an order of the step, or not.

use super::case::Case;
use super::decay::Decay;
use super::distance::largest_difference;
use super::distance::largest_size;
use super::method::Method;
use super::trial::Trial;
use residua::RunError;
use residua_models::values::size;
use serde::Serialize;

/// Relative size from which a drift counts as rounding. Runs of some thousand steps collect some hundred ε,
/// and Newton's tolerance adds less.
const ROUNDING: f64 = 1e-11;

/// Halvings of the step.
const HALVINGS: u32 = 2;

/// How an invariant is kept.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Kept {
    /// To rounding.
    Exactly,
    /// Its largest drift goes with this power of the step.
    ToOrder(f64),
    /// Its drift does not go with the step.
    NotAtAll,
}

/// An invariant of a model under a method.
#[derive(Clone, Debug)]
pub struct Conservation {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Largest drift with h, h/2, h/4.
    pub drift: Decay,
    /// The verdict.
    pub kept: Kept,
}

/// Runs `case` for `steps` steps of `h`, twice and four times as many of h/2 and h/4, and judges its invariants.
///
/// # Errors
/// Where a step fails.
pub fn conservation(
    case: &Case,
    method: Method,
    h: f64,
    steps: u64,
) -> Result<Vec<Conservation>, RunError> {
    let trials = (0..=HALVINGS).map(|halvings| {
        let parts = 1_u32 << halvings;
        Trial::new(case, method, h / f64::from(parts), steps * u64::from(parts))
    });
    let trials: Vec<Trial> = trials.collect::<Result<_, _>>()?;
    let mut list = Vec::new();
    let mut offset = 0;
    for output in case.model.description.outputs {
        let own = offset..offset + size(&output.variable);
        offset = own.end;
        if !output.invariant {
            continue;
        }
        let errors = trials
            .iter()
            .map(|trial| trial.invariants[list.len()].largest);
        let terms = |state: &[f64]| case.outputs(h, 0.0, state)[own.clone()].to_vec();
        let sizes = trials.iter().map(|trial| term_size(&trial.end, terms));
        let floor = ROUNDING * sizes.fold(term_size(&case.start, terms), f64::max);
        let drift = Decay::new(&errors.collect::<Vec<_>>(), floor);
        list.push(Conservation {
            name: output.variable.name,
            unit: output.variable.unit,
            kept: match drift.order {
                None => Kept::Exactly,
                Some(order) if drift.vanishes() => Kept::ToOrder(order),
                Some(_) => Kept::NotAtAll,
            },
            drift,
        });
    }
    Ok(list)
}

/// Σⱼ |∂y/∂xⱼ| |xⱼ|: how large the terms of y are, even where they cancel.
pub fn term_size(state: &[f64], value: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
    const SHIFT: f64 = 1e-3;
    let here = value(state);
    let mut shifted = state.to_vec();
    let mut sum = largest_size(&here);
    for (j, &x) in state.iter().enumerate() {
        shifted[j] = x * (1.0 + SHIFT);
        sum += largest_difference(&value(&shifted), &here) / SHIFT;
        shifted[j] = x;
    }
    sum
}
