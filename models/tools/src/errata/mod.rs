//! Misprints: every claim of the model files with its verdict, and what becomes of Newton's method for somebody
//! who codes a wrong one.
//!
//! Verdicts are the generator's: it compares each claim with what follows from the model at generic points.
//! Newton's method as printed is run on the graphs of the generator, not on compiled code. What no tool can
//! decide is in [`by_eye`], and says so.

pub mod by_eye;
pub mod data;
pub mod newton;

use newton::Comparison;
use newton::Plan;
use newton::compare;
use residua_codegen::Analysis;
use residua_codegen::analyse;
use residua_codegen::ast::ClaimKind;
use residua_codegen::claims::POINTS;
use residua_codegen::finding::Difference;
use residua_codegen::finding::Finding;
use residua_codegen::source::read_source;
use residua_models::Entry;
use serde::Serialize;

/// The claims of one model.
#[derive(Clone, Debug, Serialize)]
pub struct Errata {
    /// Its name.
    pub model: String,
    /// In file order.
    pub claims: Vec<Verdict>,
}

/// What came of a claim.
#[derive(Clone, Debug, Serialize)]
pub struct Verdict {
    /// `jacobian`, `residual`, `flow`, `equation` or `differential`.
    pub kind: &'static str,
    /// What its author calls it: `Eq. 87`.
    pub label: String,
    /// The claimed residual that a Jacobian belongs to.
    pub of: Option<String>,
    /// Line in the model file.
    pub line: usize,
    /// Nothing differs.
    pub right: bool,
    /// How that was decided.
    pub decided: String,
    /// What differs.
    pub differences: Vec<Misprint>,
    /// What else there is to say of a wrong claim.
    pub note: Option<&'static str>,
    /// Newton's method with a wrong Jacobian or residual; none for other claims and where the claim cannot be
    /// coded, because its blocks do not fit.
    pub newton: Option<Comparison>,
}

/// An entry of a Jacobian, or a component of an equation, in which a claim is wrong.
#[derive(Clone, Debug, Serialize)]
pub struct Misprint {
    /// Counted from 1.
    pub row: usize,
    /// Counted from 1; 1 in equations.
    pub col: usize,
    /// Which one, in words.
    pub entry: String,
    /// What is printed; the right side of an identity.
    pub printed: String,
    /// What is right; the left side of an identity.
    pub right: String,
    /// The printed value at one generic point, where there is one.
    pub printed_value: Option<f64>,
    /// The right value there.
    pub right_value: Option<f64>,
}

/// Judges the claims of `entry` and runs the wrong ones by `plan`.
///
/// # Errors
/// What is wrong with the model; the models of the catalogue have compiled, so theirs have no mistakes.
pub fn errata(entry: &Entry, plan: &Plan) -> Result<Errata, String> {
    errata_of(entry.name(), entry.source, plan)
}

/// The same for the text of a model file.
///
/// # Errors
/// The mistakes of the model, in words.
pub fn errata_of(name: &str, source: &str, plan: &Plan) -> Result<Errata, String> {
    let tokens = read_source(source.as_bytes()).map_err(|error| error.to_string())?;
    let analysis = analyse(name, tokens).map_err(|errors| {
        let list = errors.into_sorted().into_iter();
        let messages: Vec<String> = list.map(|d| d.message).collect();
        messages.join("; ")
    })?;
    let claims = analysis.findings.iter().enumerate();
    Ok(Errata {
        model: name.to_owned(),
        claims: claims
            .map(|(i, finding)| verdict(&analysis, i, finding, plan))
            .collect(),
    })
}

/// `jacobian Eq. 87 of Eq. 86`
pub fn title(kind: &str, label: &str, of: Option<&str>) -> String {
    match of {
        Some(of) => format!("{kind} {label} of {of}"),
        None => format!("{kind} {label}"),
    }
}

fn verdict(analysis: &Analysis, claim: usize, finding: &Finding, plan: &Plan) -> Verdict {
    let right = finding.differences.is_empty();
    // Against a residual that is itself wrong, even a right Jacobian leads elsewhere.
    let of_wrong = finding.of.is_some();
    let run = !right || of_wrong;
    Verdict {
        kind: finding.kind.keyword(),
        label: finding.label.clone(),
        of: finding.of.clone(),
        line: finding.line,
        right,
        decided: decided(finding),
        differences: finding.differences.iter().map(misprint).collect(),
        note: run
            .then(|| note(&analysis.model.name, &finding.label))
            .flatten(),
        newton: run.then(|| compare(analysis, claim, plan)).flatten(),
    }
}

impl Verdict {
    /// Its differences are what is left of left side − right side, which should be 0; no entry that
    /// could be printed instead.
    pub fn leaves_remainders(&self) -> bool {
        [ClaimKind::Flow, ClaimKind::Differential]
            .map(ClaimKind::keyword)
            .contains(&self.kind)
    }
}

/// Functions in the formulas of the generator.
pub const FUNCTIONS: &str = "stumpff(1, a²) stands for sin(a)/a and stumpff(2, a²) for (1 − cos a)/a², both without a gap at a = 0.";

const CHARTS: &str = "Line 2 of Eq. 84, Eqs. 86 and 87 as printed fit each other: they are a scheme for the Cardan angles of \
    R = Rz Ry Rx, and right in the model spatial_cardan_zyx. They contradict Eqs. 10, 12 and 15, lines 1 and 3 of Eq. 84 and \
    R0 = Rx Ry Rz. Where states differ, the same numbers for the angles are two attitudes in the two charts.";

fn note(model: &str, label: &str) -> Option<&'static str> {
    match (model, label) {
        ("spatial_cardan", "Eq. 84" | "Eq. 86" | "Eq. 87") => Some(CHARTS),
        _ => None,
    }
}

fn decided(finding: &Finding) -> String {
    let how = match (finding.kind, &finding.of) {
        (ClaimKind::Jacobian, Some(of)) => format!("derivative of the residual printed as {of}"),
        (ClaimKind::Jacobian, None) => "derivative of the residual".to_owned(),
        (ClaimKind::Residual, _) => "the model's residual, each equation up to a factor".to_owned(),
        (ClaimKind::Flow, _) => "the rates of the model's flow put in".to_owned(),
        (ClaimKind::Equation, _) => "left side against right side".to_owned(),
        (ClaimKind::Differential, _) => "Jacobian times arbitrary variations".to_owned(),
    };
    format!("{how}, at {POINTS} generic points")
}

fn misprint(difference: &Difference) -> Misprint {
    let value = |value: f64| Some(value).filter(|v| v.is_finite());
    Misprint {
        row: difference.row + 1,
        col: difference.col + 1,
        entry: difference.entry.clone(),
        printed: difference.printed.clone(),
        right: difference.derived.clone(),
        printed_value: value(difference.values.0),
        right_value: value(difference.values.1),
    }
}
