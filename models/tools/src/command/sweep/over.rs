//! `--over NAME=FROM..TO:COUNT`: one axis of the grid.

use crate::assignment::{Assignment, Target, component_of, parse as parse_assignment};
use crate::expression::{Symbol, evaluate};
use crate::failure::Failure;
use crate::motion::refuse_skipped;
use crate::motion::symbols;
use residua::description::Description;
use std::fmt;

/// What marks a start value.
const START: &str = "start.";

/// `NAME=FROM..TO:COUNT`, as given.
#[derive(Clone, Debug)]
pub struct Over {
    /// `m`, or `start.ω.x`.
    name: String,
    range: String,
    /// What is swept, from and to which value.
    ends: [Assignment; 2],
    count: usize,
    is_start: bool,
}

impl fmt::Display for Over {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "--over {}={}", self.name, self.range)
    }
}

/// Splits at the first `=`, the first `..` and the last `:`.
pub fn parse(text: &str) -> Result<Over, String> {
    let form = "write NAME=FROM..TO:COUNT, as in m=1..3:100 or start.ω.x=-1..1:50";
    let (name, range) = text.split_once('=').ok_or(form)?;
    let (ends, count) = range.rsplit_once(':').ok_or(form)?;
    let (from, to) = ends.split_once("..").ok_or(form)?;
    let count: usize = count
        .trim()
        .parse()
        .map_err(|_| format!("`{}` is not a number of values", count.trim()))?;
    if count == 0 {
        return Err("the number of values is 0".to_owned());
    }
    let name: String = name.chars().filter(|c| !c.is_whitespace()).collect();
    let target = name.strip_prefix(START).unwrap_or(&name);
    let end = |value: &str| parse_assignment(&format!("{target}={value}")).map_err(|_| form);
    Ok(Over {
        ends: [end(from)?, end(to)?],
        range: range.to_owned(),
        is_start: target.len() < name.len(),
        count,
        name,
    })
}

/// An axis that fits the model.
#[derive(Debug)]
pub struct Axis {
    /// Its name in the table.
    pub name: String,
    /// A start value, not a parameter.
    pub is_start: bool,
    /// Position in the flat parameters or the flat state.
    pub position: usize,
    /// Number of values.
    pub count: usize,
    from: f64,
    to: f64,
}

impl Axis {
    /// Value number `i`; the first and the last are those given, to the last bit.
    pub fn value(&self, i: usize) -> f64 {
        if i == 0 {
            self.from
        } else if i + 1 == self.count {
            self.to
        } else {
            let part = i as f64 / (self.count - 1) as f64;
            self.from * (1.0 - part) + self.to * part
        }
    }
}

/// Checks `--over` against the model; expressions may use the `parameters`.
pub fn axes(
    over: &[Over],
    description: &'static Description,
    parameters: &[f64],
) -> Result<Vec<Axis>, Failure> {
    let known = symbols(description.parameters, parameters);
    let mut axes: Vec<Axis> = Vec::new();
    for over in over {
        let axis = axis(over, description, &known)?;
        let is_same =
            |other: &&Axis| (other.is_start, other.position) == (axis.is_start, axis.position);
        if let Some(other) = axes.iter().find(is_same) {
            let message = match other.name == axis.name {
                true => format!("`{}` is swept twice", axis.name),
                false => format!("`{}` and `{}` are the same", other.name, axis.name),
            };
            return Err(Failure::input(format!("in `{over}`: {message}")));
        }
        axes.push(axis);
    }
    Ok(axes)
}

fn axis(
    over: &Over,
    description: &'static Description,
    known: &[(Symbol<'_>, Vec<f64>)],
) -> Result<Axis, Failure> {
    let mut nothing = [];
    let target = match over.is_start {
        true => Target {
            kind: "state",
            variables: description.states,
            values: &mut nothing,
        },
        false => Target {
            kind: "parameter",
            variables: description.parameters,
            values: &mut nothing,
        },
    };
    let place = |failure: Failure| match failure {
        Failure::Input { message, help } => Failure::Input {
            message: format!("in `{over}`: {message}"),
            help,
        },
        other => other,
    };
    refuse_skipped(&over.ends[0], description).map_err(place)?;
    let (position, symbol) = component_of(&over.ends[0], &target).map_err(place)?;
    let end = |assignment: &Assignment| {
        let refuse = |message: &str| place(Failure::input(message));
        let value =
            evaluate(assignment.value(), &symbol, known).map_err(|message| refuse(&message))?[0];
        match value.is_finite() {
            true => Ok(value),
            false => Err(refuse(&format!("`{}` is {value}", assignment.value()))),
        }
    };
    Ok(Axis {
        name: over.name.clone(),
        is_start: over.is_start,
        position,
        count: over.count,
        from: end(&over.ends[0])?,
        to: end(&over.ends[1])?,
    })
}
