//! Compares what papers print with what follows from the model.
//!
//! A claimed Jacobian is compared with the derivative of the residual, a claimed residual with the model's
//! own, a claimed differential with the Jacobian times arbitrary variations, a claimed flow with the model's
//! rates, and the left side of a claimed equation with its right side. Two expressions are taken as equal
//! when they agree at several generic points: expressions that differ, differ almost everywhere. They agree at a point if
//! they are no further apart than rounding may have taken them, and if that is not far. Parameters have the signs that
//! they have in the file.

mod bounded;
mod equations;
mod jacobian;
mod names;
mod points;

pub use points::POINTS;

use crate::ast::ClaimKind;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::finding::Difference;
use crate::finding::Finding;
use crate::model::Claim;
use crate::model::Model;
use crate::normal::rational;
use crate::sample::Typical;
use crate::system::Claimed;
use crate::system::Discrete;
use crate::system::Entry;
use crate::system::Printed;
use names::Names;
use points::Points;

/// What came of the claims about the discrete equations.
#[derive(Debug, Default)]
pub struct Judged {
    /// One per claim of the model; `None` for one about something else.
    pub findings: Vec<Option<Finding>>,
    /// The equations that each claim would give to Newton's method, where it does and they fit.
    pub printed: Vec<Option<Printed>>,
}

/// Judges the claims about the discrete equations. `derivatives` are those of the equations of each claim by
/// the unknowns; only claimed residuals need them.
///
/// # Errors
/// Claims marked `require` that are wrong.
pub fn discrete_claims(
    model: &Model,
    discrete: &mut Discrete,
    jacobian: &[Entry],
    derivatives: &[Vec<Entry>],
    typical: &Typical,
) -> Result<Judged, Errors> {
    if model.claims.is_empty() {
        return Ok(Judged::default());
    }
    let n = discrete.residual.len();
    let own = Printed {
        residual: discrete.residual.clone(),
        jacobian: dense(&mut discrete.dag, jacobian, n),
    };
    let variation = variation(&mut discrete.dag, jacobian, n);
    let mut residuals = Vec::new();
    for (claimed, derivative) in discrete.claims.iter().zip(derivatives) {
        residuals.push((claimed.differences.len() == n).then(|| Printed {
            residual: claimed.differences.clone(),
            jacobian: dense(&mut discrete.dag, derivative, n),
        }));
    }
    let mut gaps = Vec::new();
    for (claim, claimed) in model.claims.iter().zip(&discrete.claims) {
        let derived = match claim.kind {
            ClaimKind::Residual => &own.residual[..],
            ClaimKind::Differential => &variation[..],
            ClaimKind::Jacobian | ClaimKind::Flow | ClaimKind::Equation => &[],
        };
        let pairs = claimed.differences.iter().zip(derived);
        let gap = pairs.map(|(&printed, &derived)| discrete.dag.sub(printed, derived));
        gaps.push(gap.collect::<Vec<_>>());
    }
    let zero = discrete.dag.integer(0);
    let printed = discrete.claims.iter().flat_map(Claimed::nodes);
    let derivatives = residuals.iter().flatten().flat_map(|r| &r.jacobian);
    let derived = own.jacobian.iter().chain(&variation).chain(derivatives);
    let nodes = printed.chain(derived.copied()).chain([zero]);
    let points = Points::new(&discrete.dag, typical, &own.residual, nodes);
    let names = Names {
        model,
        form: Some(discrete.form),
        dag: &discrete.dag,
    };
    let mut errors = Errors::default();
    let mut judged = Judged::default();
    for (claim, claimed) in model.claims.iter().zip(&discrete.claims) {
        let mut printed = None;
        let against = |derived| equations::Against {
            printed: &claimed.differences,
            derived,
            gaps: &gaps[judged.findings.len()],
        };
        let differences = match claim.kind {
            ClaimKind::Flow => {
                judged.findings.push(None);
                judged.printed.push(None);
                continue;
            }
            ClaimKind::Jacobian => {
                let (equations, of) = match claim.of {
                    Some(i) => (&model.claims[i].equations, residuals[i].as_ref()),
                    None => (&model.residual, Some(&own)),
                };
                let target = of.unwrap_or(&own);
                let comparison = jacobian::Comparison {
                    names: &names,
                    points: &points,
                    equations,
                    derivative: &target.jacobian,
                    n,
                    zero,
                };
                let (differences, entries) = comparison.compare(claim, &claimed.blocks);
                printed = entries.map(|jacobian| Printed {
                    residual: target.residual.clone(),
                    jacobian,
                });
                differences
            }
            ClaimKind::Residual => {
                printed = residuals[judged.printed.len()].clone();
                equations::against(&names, &points, claim, &against(&own.residual))
            }
            ClaimKind::Differential => {
                equations::against(&names, &points, claim, &against(&variation))
            }
            ClaimKind::Equation => equations::identity(&names, &points, claim, &claimed.sides),
        };
        judged.printed.push(printed);
        judged
            .findings
            .push(Some(finding(model, claim, differences, &mut errors)));
    }
    errors.or(judged)
}

/// Judges the claims about the continuous equations, given the rate of each state component; `None` for the
/// other claims.
///
/// # Errors
/// As [`discrete_claims`].
pub fn continuous_claims(
    model: &Model,
    dag: &mut Dag,
    claims: &[Claimed],
    rates: Option<&[NodeId]>,
    typical: &Typical,
) -> Result<Vec<Option<Finding>>, Errors> {
    if model.claims.is_empty() {
        return Ok(Vec::new());
    }
    let mut along = Vec::new();
    for claimed in claims {
        along.push(rates.map(|rates| {
            dag.substitute(&claimed.differences, |leaf| match leaf {
                Leaf::Unknown(i) => Some(rates[i]),
                _ => None,
            })
        }));
    }
    let nodes = along.iter().flatten().flatten().copied();
    let points = Points::new(dag, typical, rates.unwrap_or_default(), nodes);
    let names = Names {
        model,
        form: None,
        dag,
    };
    let mut errors = Errors::default();
    let mut findings = Vec::new();
    for ((claim, claimed), along) in model.claims.iter().zip(claims).zip(along) {
        findings.push((claim.kind == ClaimKind::Flow).then(|| {
            let differences = match along {
                Some(along) => {
                    equations::vanishing(&names, &points, claim, &claimed.differences, &along)
                }
                None => vec![misfit(
                    "a flow".to_owned(),
                    "no flow in the model".to_owned(),
                )],
            };
            finding(model, claim, differences, &mut errors)
        }));
    }
    errors.or(findings)
}

/// The finding about a claim; an error too if the claim is required and wrong.
fn finding(
    model: &Model,
    claim: &Claim,
    differences: Vec<Difference>,
    errors: &mut Errors,
) -> Finding {
    if let Some(first) = differences.first().filter(|_| claim.required) {
        let others = match differences.len() - 1 {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        let label = &claim.label;
        let message = format!(
            "the required claim {label:?} is wrong in {}{others}",
            first.entry
        );
        let right = match claim.kind {
            ClaimKind::Jacobian => "the derivative is",
            ClaimKind::Residual => "the residual is",
            ClaimKind::Differential => "the variation is",
            ClaimKind::Flow => "along the flow it should be",
            ClaimKind::Equation => "the left side is",
        };
        let help = format!("it says `{}`, {right} `{}`", first.printed, first.derived);
        errors.push_with_help(claim.range, message, help);
    }
    Finding {
        kind: claim.kind,
        label: claim.label.clone(),
        of: claim.of.map(|i| model.claims[i].label.clone()),
        line: claim.range.line(),
        differences,
    }
}

/// A claim that cannot be laid over what it is compared with.
fn misfit(printed: String, derived: String) -> Difference {
    Difference {
        row: 0,
        col: 0,
        entry: "layout".into(),
        printed,
        derived,
        values: (f64::NAN, f64::NAN),
    }
}

/// All n² entries row by row, zeros included.
fn dense(dag: &mut Dag, entries: &[Entry], n: usize) -> Vec<NodeId> {
    let mut all = vec![dag.integer(0); n * n];
    for entry in entries {
        all[entry.row * n + entry.col] = entry.node;
    }
    all
}

/// Σⱼ Jᵢⱼ δxⱼ
fn variation(dag: &mut Dag, jacobian: &[Entry], n: usize) -> Vec<NodeId> {
    let mut terms = vec![Vec::new(); n];
    for entry in jacobian {
        let varied = dag.leaf(Leaf::Variation(entry.col));
        terms[entry.row].push((rational(1), dag.mul(entry.node, varied)));
    }
    terms.into_iter().map(|row| dag.sum(row)).collect()
}
