//! What advances the state, by its name.

use super::Simulate;
use crate::failure::Failure;
use residua::erased::{self, AnyFlow, AnySeries, AnySolver};
use residua::taylor::{MOST_ORDER, USUAL_ORDER};
use residua::{Catalogued, Tolerance};

/// The scheme that solves discrete equations.
pub const NEWTON: &str = "newton";

/// The Taylor series of any order, or, with a number behind it, of that one.
const TAYLOR: &str = "taylor";

/// What advances the state.
#[derive(Clone, Copy)]
pub enum Scheme {
    /// The discrete equations.
    Newton(&'static dyn AnySolver),
    /// A scheme on the continuous ones.
    Flow(&'static dyn AnyFlow, erased::Scheme),
    /// The Taylor series of the continuous ones.
    Series(&'static dyn AnySeries, Terms),
}

/// Where a Taylor series ends.
#[derive(Clone, Copy)]
pub enum Terms {
    /// At this order, in steps of H.
    Order(usize),
    /// Where the tolerance asks for it, in steps that follow it.
    Within(Tolerance),
}

/// The scheme that is asked for.
pub fn scheme(options: &Simulate, model: &Catalogued) -> Result<Scheme, Failure> {
    if options.scheme == NEWTON {
        return options.motion.solver(model).map(Scheme::Newton);
    }
    let word = options.scheme.as_str();
    if let Some(order) = word.strip_prefix(TAYLOR) {
        refuse_form(options)?;
        return series(order, options, model);
    }
    let Some(scheme) = erased::Scheme::named(word) else {
        let known = erased::Scheme::names().chain([TAYLOR, NEWTON]);
        let names: Vec<&str> = known.clone().collect();
        let message = format!("there is no scheme `{word}`, only {}", names.join(", "));
        return Err(Failure::unknown(message, word, known));
    };
    refuse_form(options)?;
    let flow = model.flow.ok_or_else(|| without_flow(model, word))?;
    let Some(tolerance) = options.tolerance else {
        return Ok(Scheme::Flow(flow, scheme));
    };
    let within = scheme.within(Tolerance::both(tolerance));
    let scheme = within.ok_or_else(|| {
        Failure::input_with_help(
            format!("{word} has no error estimate that could keep to a tolerance"),
            "gauss3 … gauss8, dopri5 and taylor have one",
        )
    })?;
    Ok(Scheme::Flow(flow, scheme))
}

/// `taylor` and `taylor20`.
fn series(order: &str, options: &Simulate, model: &Catalogued) -> Result<Scheme, Failure> {
    let word = &options.scheme;
    let terms = if order.is_empty() {
        let tolerance = options.tolerance.map(Tolerance::both);
        Terms::Within(tolerance.unwrap_or_default())
    } else {
        let order = order.parse().ok();
        let Some(order) = order.filter(|order| (1..=MOST_ORDER).contains(order)) else {
            return Err(Failure::input(format!(
                "there is no scheme `{word}`: Taylor series are of orders 1 to {MOST_ORDER}, such as taylor{USUAL_ORDER}"
            )));
        };
        if options.tolerance.is_some() {
            return Err(Failure::input_with_help(
                format!("{word} takes steps of one length, whatever the tolerance"),
                "taylor, without a number, chooses its order and its steps",
            ));
        }
        Terms::Order(order)
    };
    if let Some(series) = model.series {
        return Ok(Scheme::Series(series, terms));
    }
    Err(match model.description.no_series {
        Some(reason) => Failure::input(format!(
            "`{}` has no Taylor series: {reason}",
            model.description.name
        )),
        None => without_flow(model, word),
    })
}

fn refuse_form(options: &Simulate) -> Result<(), Failure> {
    if options.motion.form.is_none() {
        return Ok(());
    }
    Err(Failure::input(format!(
        "--form chooses discrete equations, and {} integrates the continuous ones",
        options.scheme
    )))
}

fn without_flow(model: &Catalogued, word: &str) -> Failure {
    let name = model.description.name;
    Failure::input_with_help(
        format!("`{name}` has no continuous equations for {word}"),
        "give its model file a `flow { … }`",
    )
}
