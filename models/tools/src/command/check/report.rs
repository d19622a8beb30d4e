//! What `check` found, as data that prints as JSON.

use super::jacobian::{CENTRAL_BOUND, DUAL_BOUND};
use super::residual::{RESIDUAL_BOUND, STEP_BOUND};
use residua::description::{Claim, Difference};
use residua_tools::study::Decay;
use serde::Serialize;

/// One model.
#[derive(Serialize)]
pub struct ModelReport {
    /// Its name.
    pub model: &'static str,
    /// Every solver is what its file says. Wrong claims are findings and do not count.
    pub passed: bool,
    /// One per form.
    pub solvers: Vec<SolverReport>,
    /// In file order.
    pub claims: Vec<ClaimReport>,
    /// Requirements that the data of the file do not meet, which is a finding and no failure.
    pub unmet: Vec<String>,
}

/// One solver.
#[derive(Serialize)]
pub struct SolverReport {
    /// `next` or `increment`.
    pub form: &'static str,
    /// Against dual numbers and central differences.
    pub jacobian: JacobianReport,
    /// On a short run from the model's own start, if it gets through.
    pub run: Option<RunReport>,
    /// Why it does not.
    pub error: Option<String>,
}

impl SolverReport {
    /// The solver is what its file says.
    pub fn passed(&self) -> bool {
        self.jacobian.passed() && self.run.as_ref().is_some_and(RunReport::passed)
    }
}

/// What a short run shows.
#[derive(Serialize)]
pub struct RunReport {
    /// At its steps.
    pub residual: ResidualReport,
    /// Of one step with the continuous equations, if there are any.
    pub consistency: Option<Consistency>,
    /// Of its last state.
    pub convergence: Decay,
    /// Over all of it.
    pub invariants: Vec<InvariantReport>,
}

impl RunReport {
    fn passed(&self) -> bool {
        let mut decays = self.invariants.iter().map(|invariant| &invariant.drift);
        self.residual.passed()
            && self.consistency.as_ref().is_none_or(|c| c.decay.vanishes())
            && self.convergence.vanishes()
            && decays.all(Decay::vanishes)
    }
}

/// Steps against the continuous equations.
#[derive(Serialize)]
pub struct Consistency {
    /// Largest |Δx/h − flow| with h, h/2, h/4.
    pub decay: Decay,
    /// The component of the state in which it is largest with the smallest step.
    pub worst: String,
}

/// The generated Jacobian against independent derivatives.
#[derive(Default, Serialize)]
pub struct JacobianReport {
    /// Random points compared.
    pub points: usize,
    /// Random points outside the domain of the equations.
    pub skipped: usize,
    /// Against dual numbers, in units of ε times the row's absolute sum.
    pub dual: Worst,
    /// Against central differences, relative to the row's absolute sum.
    pub central: Worst,
}

impl JacobianReport {
    /// Within the bounds.
    pub fn passed(&self) -> bool {
        self.points > 0 && self.dual.value <= DUAL_BOUND && self.central.value <= CENTRAL_BOUND
    }
}

/// The largest difference and the entry that has it.
#[derive(Default, Serialize)]
pub struct Worst {
    /// How large.
    pub value: f64,
    /// In words.
    pub entry: Option<String>,
}

/// The residual at accepted steps.
#[derive(Default, Serialize)]
pub struct ResidualReport {
    /// How many.
    pub steps: usize,
    /// Largest, in units of ε times the size of its terms.
    pub residual: f64,
    /// Largest difference between the runtime's step and an independent solution, relative.
    pub step_difference: f64,
}

impl ResidualReport {
    /// Within the bounds.
    pub fn passed(&self) -> bool {
        self.steps > 0 && self.residual <= RESIDUAL_BOUND && self.step_difference <= STEP_BOUND
    }
}

/// Drift of an invariant.
#[derive(Serialize)]
pub struct InvariantReport {
    /// Its name.
    pub name: &'static str,
    /// Largest over the run, with h, h/2 and h/4.
    pub drift: Decay,
}

/// A printed statement.
#[derive(Serialize)]
pub struct ClaimReport {
    /// What it is about.
    pub kind: &'static str,
    /// What its author calls it.
    pub label: &'static str,
    /// The claimed residual that a Jacobian belongs to.
    pub of: Option<&'static str>,
    /// Line in the file.
    pub line: usize,
    /// Entries that differ; none if it is right.
    pub differences: Vec<EntryReport>,
}

/// An entry of a Jacobian, or a component of an equation, in which a claim is wrong.
#[derive(Serialize)]
pub struct EntryReport {
    /// Counted from 1.
    pub row: usize,
    /// Counted from 1.
    pub col: usize,
    /// ∂(equation)/∂(unknown), or the component, in words.
    pub entry: &'static str,
    /// What is printed.
    pub printed: &'static str,
    /// What it should be.
    pub derived: &'static str,
    /// Value of what is printed at one generic point.
    pub printed_value: f64,
    /// Value of what it should be there.
    pub derived_value: f64,
}

impl ClaimReport {
    /// From what the generator found.
    pub fn new(claim: &Claim) -> Self {
        let entry = |difference: &Difference| EntryReport {
            row: difference.row + 1,
            col: difference.col + 1,
            entry: difference.entry,
            printed: difference.printed,
            derived: difference.derived,
            printed_value: difference.values.0,
            derived_value: difference.values.1,
        };
        Self {
            kind: claim.kind,
            label: claim.label,
            of: claim.of,
            line: claim.line,
            differences: claim.differences.iter().map(entry).collect(),
        }
    }
}
