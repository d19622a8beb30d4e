//! What is gone, and why.

use super::Special;
use super::narrow::Left;
use super::narrow::own;
use super::needs::Needs;
use super::zeros::Zeros;
use super::zeros::advanced;
use crate::model::Model;
use crate::model::Solved;
use crate::model::Variable;
use crate::scene::Skipped;
use crate::scene::SkippedKind;
use crate::scene::Wishes;

/// What is left of `model`, with a reason for everything that is not.
pub(super) fn explained(
    model: &Model,
    left: Left,
    zeros: &Zeros,
    needs: &Needs,
    wishes: &Wishes,
) -> Special {
    let zero_components = (0..left.states.len()).filter(|&i| zeros.states[left.states[i]]);
    let zero_components: Vec<(usize, String)> = zero_components
        .map(|i| (i, stays_zero(model, zeros, left.states[i])))
        .collect();
    let mut skipped = parameters(model, wishes);
    skipped.extend(states(model, &left, zeros, needs));
    skipped.extend(unknowns(model, zeros, needs));
    skipped.extend(equations(model, zeros, needs));
    skipped.extend(outputs(model, wishes));
    skipped.extend(requirements(model, &left.model));
    if !model.flow.is_empty() && left.equations.flow.is_none() {
        skipped.push(Skipped {
            kind: SkippedKind::Flow,
            what: "flow".to_owned(),
            reason: "its equations need states that the discrete ones do without, or divide by 0 with what is fixed"
                .to_owned(),
            line: model.flow[0].range.line(),
        });
    }
    Special {
        model: left.model,
        equations: left.equations,
        discrete: left.discrete,
        zeros: zero_components,
        skipped,
    }
}

fn parameters(model: &Model, wishes: &Wishes) -> Vec<Skipped> {
    let fixed = model.parameters.iter().zip(&wishes.fixed);
    let skipped = |(parameter, fixed): (&crate::model::Parameter, &Option<(String, usize)>)| {
        let (text, line) = fixed.as_ref()?;
        Some(Skipped {
            kind: SkippedKind::Parameter,
            what: parameter.variable.name.display.clone(),
            reason: format!("fixed as `{text}` in line {line} of the scene and folded in"),
            line: parameter.variable.name.range.line(),
        })
    };
    fixed.filter_map(skipped).collect()
}

fn states(model: &Model, left: &Left, zeros: &Zeros, needs: &Needs) -> Vec<Skipped> {
    let mut skipped = Vec::new();
    for state in &model.states {
        let variable = &state.variable;
        let own = own(variable);
        let line = variable.name.range.line();
        let gone = own
            .clone()
            .filter(|i| !needs.states[*i] && !zeros.states[*i]);
        let gone: Vec<usize> = gone.collect();
        if !gone.is_empty() {
            let is_all = !own.clone().any(|i| left.states.contains(&i));
            skipped.push(Skipped {
                kind: SkippedKind::State,
                what: shown(variable, own.start, is_all, &gone),
                reason: "no kept quantity depends on it".to_owned(),
                line,
            });
        }
        for i in own.clone().filter(|&i| zeros.states[i]) {
            skipped.push(Skipped {
                kind: SkippedKind::Component,
                what: format!(
                    "{}{}",
                    variable.name.display,
                    variable.component_suffix(i - own.start)
                ),
                reason: format!("stays 0: {}", stays_zero(model, zeros, i)),
                line,
            });
        }
    }
    skipped
}

/// `Γ1` if all of it is meant, otherwise the components.
fn shown(variable: &Variable, offset: usize, is_all: bool, components: &[usize]) -> String {
    let name = &variable.name.display;
    if is_all {
        return name.clone();
    }
    let components = components.iter();
    let components = components.map(|i| format!("{name}{}", variable.component_suffix(i - offset)));
    components.collect::<Vec<_>>().join(", ")
}

/// Why a component of the state stays 0.
fn stays_zero(model: &Model, zeros: &Zeros, state: usize) -> String {
    let others = (0..zeros.states.len()).filter(|&i| zeros.states[i]);
    let names: Vec<String> = others.map(|i| component(model, i)).collect();
    let with = if names.len() > 4 {
        format!(
            "{} and {} others at 0",
            names[..3].join(", "),
            names.len() - 3
        )
    } else {
        format!("{} at 0", names.join(", "))
    };
    let unknown = advanced(model).iter().position(|a| *a == Some(state));
    match unknown.and_then(|unknown| zeros.rows[unknown]) {
        Some(row) => {
            let (text, line) = equation(model, row);
            format!(
                "it starts there, and with {with} {text} (line {line}) holds whatever the rest is"
            )
        }
        None => format!("it starts there, and with {with} its `update` is 0"),
    }
}

fn component(model: &Model, state: usize) -> String {
    let variables = model.states.iter().map(|s| &s.variable);
    let mut found = variables.filter(|v| own(v).contains(&state));
    found.next().map_or(String::new(), |variable| {
        let suffix = variable.component_suffix(state - variable.offset);
        format!("{}{suffix}", variable.name.display)
    })
}

/// ``row 3 of `…` ``, and its line.
fn equation(model: &Model, row: usize) -> (String, usize) {
    let mut offset = 0;
    for equation in &model.residual {
        let own = offset..offset + equation.shape.len();
        offset = own.end;
        if own.contains(&row) {
            let text = match own.len() {
                1 => format!("`{}`", equation.text),
                _ => format!("row {} of `{}`", row - own.start + 1, equation.text),
            };
            return (text, equation.range.line());
        }
    }
    (String::new(), 0)
}

/// Unknowns of the model's own; those that advance states go with these.
fn unknowns(model: &Model, zeros: &Zeros, needs: &Needs) -> Vec<Skipped> {
    let mut skipped = Vec::new();
    let mut offset = 0;
    for &solved in &model.solved {
        let variable = model.solved_variable(solved);
        let own = offset..offset + variable.shape.len();
        offset = own.end;
        if matches!(solved, Solved::State(_)) {
            continue;
        }
        let gone = own.clone().filter(|&i| !needs.unknowns[i]);
        let (zero, unused): (Vec<usize>, Vec<usize>) = gone.partition(|&i| zeros.unknowns[i]);
        let reasons = [
            (unused, "no kept quantity depends on it"),
            (zero, "stays 0 with the states that do"),
        ];
        for (list, reason) in reasons.into_iter().filter(|r| !r.0.is_empty()) {
            skipped.push(Skipped {
                kind: SkippedKind::Unknown,
                what: shown(variable, own.start, list.len() == own.len(), &list),
                reason: reason.to_owned(),
                line: variable.name.range.line(),
            });
        }
    }
    skipped
}

fn equations(model: &Model, zeros: &Zeros, needs: &Needs) -> Vec<Skipped> {
    let mut skipped = Vec::new();
    let mut offset = 0;
    for equation in &model.residual {
        let own = offset..offset + equation.shape.len();
        offset = own.end;
        let gone = own.clone().filter(|&row| !needs.rows[row]);
        let (zero, unused): (Vec<usize>, Vec<usize>) =
            gone.partition(|&row| zeros.rows.contains(&Some(row)));
        let reasons = [
            (
                unused,
                "only unknowns that are not needed are solved from it",
            ),
            (zero, "holds by itself where these components are 0"),
        ];
        for (list, reason) in reasons.into_iter().filter(|r| !r.0.is_empty()) {
            let numbers: Vec<String> = list
                .iter()
                .map(|r| (r - own.start + 1).to_string())
                .collect();
            let what = match numbers.as_slice() {
                all if all.len() == own.len() => equation.text.clone(),
                [one] => format!("row {one} of {}", equation.text),
                some => format!("rows {} of {}", some.join(", "), equation.text),
            };
            skipped.push(Skipped {
                kind: SkippedKind::Equation,
                what,
                reason: reason.to_owned(),
                line: equation.range.line(),
            });
        }
    }
    skipped
}

fn requirements(model: &Model, left: &Model) -> Vec<Skipped> {
    let is_left = |text: &str| left.requirements.iter().any(|r| r.text == text);
    let gone = model.requirements.iter().filter(|r| !is_left(&r.text));
    gone.map(|requirement| Skipped {
        kind: SkippedKind::Requirement,
        what: requirement.text.clone(),
        reason: "about a state that is not needed".to_owned(),
        line: requirement.range.line(),
    })
    .collect()
}

fn outputs(model: &Model, wishes: &Wishes) -> Vec<Skipped> {
    let outputs = model.outputs.iter().zip(&wishes.outputs);
    let gone = outputs.filter(|(_, wanted)| !**wanted);
    gone.map(|(output, _)| Skipped {
        kind: SkippedKind::Output,
        what: output.variable.name.display.clone(),
        reason: "not kept".to_owned(),
        line: output.variable.name.range.line(),
    })
    .collect()
}
