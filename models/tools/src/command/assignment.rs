//! `NAME=EXPR` of `--set` and `--start`, onto the flat values of parameters or states.

use crate::expression::{Symbol, evaluate};
use crate::failure::Failure;
use crate::notation::{components, excerpt};
use residua::description::Variable;
use residua_codegen::parse::ascii_spelling;
use std::fmt;
use std::ops::Range;

/// `NAME=EXPR`, where NAME may pick a component: `J(2,2)`, `ω.x`.
#[derive(Clone, Debug)]
pub struct Assignment {
    target: String,
    value: String,
}

impl Assignment {
    /// It is for this variable, by the name in its file or in ASCII.
    pub fn is_to(&self, name: &str) -> bool {
        let text = self.target.as_str();
        let own = text.split(['.', '(']).next().unwrap_or(text);
        own == name || Some(own) == ascii_spelling(name).as_deref()
    }

    /// Behind the `=`.
    pub fn value(&self) -> &str {
        &self.value
    }
}

impl fmt::Display for Assignment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", excerpt(&self.target), excerpt(&self.value))
    }
}

/// Splits at the first `=`.
pub fn parse(text: &str) -> Result<Assignment, String> {
    match text.split_once('=') {
        Some((target, value)) if !target.trim().is_empty() && !value.trim().is_empty() => {
            Ok(Assignment {
                target: target.chars().filter(|c| !c.is_whitespace()).collect(),
                value: value.trim().to_owned(),
            })
        }
        _ => Err("write NAME=EXPR, as in m=3 or \"ω=[0.5,-0.5,0.4]\"".to_owned()),
    }
}

/// Where assignments go.
pub struct Target<'a> {
    /// `parameter` or `state`.
    pub kind: &'static str,
    /// What may be assigned.
    pub variables: &'a [Variable],
    /// The flat values, overwritten.
    pub values: &'a mut [f64],
}

/// Carries out the assignments one after the other. Expressions may use `symbols`.
pub fn assign(
    assignments: &[Assignment],
    target: Target<'_>,
    symbols: &[(Symbol<'_>, Vec<f64>)],
) -> Result<(), Failure> {
    let mut made: Vec<(Range<usize>, &Assignment)> = Vec::new();
    for assignment in assignments {
        let place = place(assignment, &target)?;
        let is_covered =
            |range: &Range<usize>| place.range.start <= range.start && range.end <= place.range.end;
        if let Some((_, before)) = made.iter().find(|(range, _)| is_covered(range)) {
            let message = format!("`{assignment}` undoes `{before}` before it");
            return Err(Failure::input(message));
        }
        made.push((place.range.clone(), assignment));
        let values = evaluate(&assignment.value, &place.symbol, symbols)
            .map_err(|message| bad_value(assignment, &message))?;
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            return Err(bad_value(assignment, &format!("the value is {value}")));
        }
        target.values[place.range].copy_from_slice(&values);
    }
    Ok(())
}

/// The position of the one component that is assigned to, and what may be assigned.
pub fn component_of<'a>(
    assignment: &'a Assignment,
    target: &Target<'a>,
) -> Result<(usize, Symbol<'a>), Failure> {
    let place = place(assignment, target)?;
    match place.symbol.shape {
        (1, 1) => Ok((place.range.start, place.symbol)),
        (rows, cols) => {
            let last = match cols {
                1 => format!("({rows})"),
                _ => format!("({rows},{cols})"),
            };
            let name = place.symbol.name;
            Err(Failure::input_with_help(
                format!("`{name}` has {} components, not one", rows * cols),
                format!("name one of them, as in {name}{last}"),
            ))
        }
    }
}

fn bad_value(assignment: &Assignment, message: &str) -> Failure {
    Failure::input(format!("in `{assignment}`: {message}"))
}

/// A stretch of the flat values.
struct Place<'a> {
    range: Range<usize>,
    symbol: Symbol<'a>,
}

fn place<'a>(assignment: &'a Assignment, target: &Target<'a>) -> Result<Place<'a>, Failure> {
    let text = assignment.target.as_str();
    // A component that is all a scene has left of a variable has a name such as `R(2,1)`.
    let is_named = |v: &Variable| text == v.name;
    let end = match target.variables.iter().any(is_named) {
        true => text.len(),
        false => text.find(['.', '(']).unwrap_or(text.len()),
    };
    let (name, pick) = text.split_at(end);
    let mut start = 0;
    for variable in target.variables {
        let len = variable.rows * variable.cols;
        if name == variable.name || name == variable.ascii {
            let symbol = |shape| Symbol {
                name: text,
                shape,
                unit: variable.unit,
            };
            if pick.is_empty() {
                return Ok(Place {
                    range: start..start + len,
                    symbol: symbol((variable.rows, variable.cols)),
                });
            }
            let component =
                component(variable, pick).ok_or_else(|| no_component(variable, text))?;
            let at = start + component;
            return Ok(Place {
                range: at..at + 1,
                symbol: symbol((1, 1)),
            });
        }
        start += len;
    }
    let kind = target.kind;
    let known = target.variables.iter().flat_map(|v| [v.name, v.ascii]);
    Err(Failure::unknown(
        format!("the model has no {kind} `{}`", excerpt(name)),
        name,
        known,
    ))
}

/// The component that `.x`, `.12`, `(3)` or `(1,2)` picks, row by row from 0.
fn component(variable: &Variable, pick: &str) -> Option<usize> {
    let Some(indices) = pick.strip_prefix('(') else {
        let named = format!("{}{pick}", variable.name);
        return components(variable).iter().position(|name| *name == named);
    };
    let indices: Option<Vec<usize>> = indices
        .strip_suffix(')')?
        .split(',')
        .map(|index| index.parse().ok())
        .collect();
    let (row, col) = match indices?[..] {
        [row] if variable.cols == 1 => (row, 1),
        [row, col] => (row, col),
        _ => return None,
    };
    let inside = (1..=variable.rows).contains(&row) && (1..=variable.cols).contains(&col);
    inside.then(|| (row - 1) * variable.cols + col - 1)
}

fn no_component(variable: &Variable, text: &str) -> Failure {
    let Variable {
        name, rows, cols, ..
    } = variable;
    match (rows, cols) {
        (1, 1) => Failure::input(format!(
            "`{text}`: `{name}` is a scalar and has no components"
        )),
        (rows, 1) => Failure::input_with_help(
            format!("`{text}`: `{name}` has no such component"),
            format!("its components are {name}(1) to {name}({rows})"),
        ),
        (rows, cols) => Failure::input_with_help(
            format!("`{text}`: `{name}` has no such component"),
            format!("its components are {name}(1,1) to {name}({rows},{cols})"),
        ),
    }
}
