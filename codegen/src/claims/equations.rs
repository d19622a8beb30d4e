//! Claimed equations against what they should say.

use super::bounded::Bounded;
use super::bounded::Verdict;
use super::misfit;
use super::names::Names;
use super::points::Points;
use crate::dag::NodeId;
use crate::finding::Difference;
use crate::model::Claim;
use crate::model::Equation;

/// Left − right of every component of a claim, and what it should be.
pub(super) struct Against<'a> {
    pub(super) printed: &'a [NodeId],
    /// A component of the model's residual, or of its variation.
    pub(super) derived: &'a [NodeId],
    /// Printed − derived.
    pub(super) gaps: &'a [NodeId],
}

/// The components of `claim` against those of the model, equation by equation and up to a factor in each.
pub(super) fn against(
    names: &Names,
    points: &Points,
    claim: &Claim,
    Against {
        printed,
        derived,
        gaps,
    }: &Against,
) -> Vec<Difference> {
    let own = &names.model.residual;
    let lengths =
        |list: &[Equation]| -> Vec<usize> { list.iter().map(|e| e.shape.len()).collect() };
    if lengths(&claim.equations) != lengths(own) {
        let said = |list: &[Equation]| {
            let shapes: Vec<_> = list.iter().map(|e| e.shape.to_string()).collect();
            format!("{} equations: {}", list.len(), shapes.join(", "))
        };
        return vec![misfit(said(&claim.equations), said(own))];
    }
    let mut differences = Vec::new();
    let mut offset = 0;
    for equation in own {
        let rows = offset..offset + equation.shape.len();
        offset = rows.end;
        let factor = common_factor(points, &printed[rows.clone()], &derived[rows.clone()]);
        for row in rows {
            if let Some(values) = points.disagreement(printed[row], derived[row], factor) {
                let is_long = names.text(derived[row]).ends_with('…');
                // Of two long texts only the difference shows the slip.
                let text = if is_long && factor.is_one() {
                    format!("what is right + ({})", names.text(gaps[row]))
                } else {
                    names.text(printed[row])
                };
                let derived = times(factor, names.text(derived[row]));
                differences.push(difference(names, claim, row, text, derived, values));
            }
        }
    }
    differences
}

/// Left and right of every component of `claim`.
pub(super) fn identity(
    names: &Names,
    points: &Points,
    claim: &Claim,
    sides: &[(NodeId, NodeId)],
) -> Vec<Difference> {
    let mut differences = Vec::new();
    for (row, &(left, right)) in sides.iter().enumerate() {
        if let Some(values) = points.disagreement(right, left, Bounded::exact(1.0)) {
            let (printed, derived) = (names.text(right), names.text(left));
            differences.push(difference(names, claim, row, printed, derived, values));
        }
    }
    differences
}

/// The equations of `claim`, `printed` being left − right, and `along` the same at the model's rates.
pub(super) fn vanishing(
    names: &Names,
    points: &Points,
    claim: &Claim,
    printed: &[NodeId],
    along: &[NodeId],
) -> Vec<Difference> {
    let mut differences = Vec::new();
    for (row, (&printed, &along)) in printed.iter().zip(along).enumerate() {
        if let Some(values) = points.remainder(along) {
            let (printed, derived) = (names.text(printed), "0".to_owned());
            differences.push(difference(names, claim, row, printed, derived, values));
        }
    }
    differences
}

/// The component `row` of `claim` that is wrong.
fn difference(
    names: &Names,
    claim: &Claim,
    row: usize,
    printed: String,
    derived: String,
    values: (f64, f64),
) -> Difference {
    Difference {
        row,
        col: 0,
        entry: names.row(&claim.equations, row),
        printed,
        derived,
        values,
    }
}

/// The factor between printed and derived that most components of an equation have; 1 if none has any.
fn common_factor(points: &Points, printed: &[NodeId], derived: &[NodeId]) -> Bounded {
    let one = Bounded::exact(1.0);
    let pairs = printed.iter().zip(derived);
    let ratios: Vec<Bounded> = pairs.filter_map(|(&p, &d)| points.ratio(p, d)).collect();
    let fits = |a: Bounded, b: Bounded| matches!(a.compare(b), Verdict::Equal | Verdict::Similar);
    let votes = |ratio: Bounded| ratios.iter().filter(|r| fits(**r, ratio)).count();
    let mut factor = one;
    for &ratio in &ratios {
        if votes(ratio) > votes(factor) {
            factor = ratio;
        }
    }
    if fits(factor, one) { one } else { factor }
}

fn times(factor: Bounded, text: String) -> String {
    if factor.is_one() {
        text
    } else {
        format!("{}*({text})", in_digits(factor.value))
    }
}

/// A number to nine digits, which hides rounding.
fn in_digits(value: f64) -> String {
    let short = format!("{value:.8e}");
    match short.parse::<f64>() {
        Ok(short) if (1e-4..1e6).contains(&short.abs()) => short.to_string(),
        Ok(short) => format!("{short:e}"),
        Err(_) => short,
    }
}
