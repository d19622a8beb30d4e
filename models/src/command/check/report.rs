//! What `check` found, as data that prints as JSON and as text.

use super::jacobian::{CENTRAL_BOUND, DUAL_BOUND};
use super::residual::{RESIDUAL_BOUND, STEP_BOUND};
use residua::description::{Claim, Difference};
use serde::Serialize;
use std::fmt;

/// A slope below this does not vanish with the step: the lowest order of a useful scheme is 1.
const LOWEST_ORDER: f64 = 0.5;

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
}

/// One solver.
#[derive(Serialize)]
pub struct SolverReport {
    /// `next` or `increment`.
    pub form: &'static str,
    /// Against dual numbers and central differences.
    pub jacobian: JacobianReport,
    /// At the accepted steps of a run, or why there is none.
    pub residual: Result<ResidualReport, String>,
    /// Of one step with the continuous equations, if there are any.
    pub consistency: Option<Result<Decay, String>>,
    /// Of the run's last state.
    pub convergence: Result<Decay, String>,
    /// Over the run.
    pub invariants: Vec<InvariantReport>,
}

impl SolverReport {
    /// The solver is what its file says.
    pub fn passed(&self) -> bool {
        let consistent = match &self.consistency {
            Some(Ok(decay)) => decay.vanishes(),
            Some(Err(_)) => false,
            None => true,
        };
        self.jacobian.passed()
            && self.residual.as_ref().is_ok_and(ResidualReport::passed)
            && consistent
            && self.convergence.is_ok()
    }
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
    fn passed(&self) -> bool {
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
    fn passed(&self) -> bool {
        self.steps > 0 && self.residual <= RESIDUAL_BOUND && self.step_difference <= STEP_BOUND
    }
}

/// Drift of an invariant.
#[derive(Serialize)]
pub struct InvariantReport {
    /// Its name.
    pub name: &'static str,
    /// Largest over the run, with h and h/2.
    pub drift: Decay,
}

/// Errors for h, h/2, …
#[derive(Serialize)]
pub struct Decay {
    /// Coarsest step first.
    pub errors: Vec<f64>,
    /// p of error ~ hᵖ; none if the errors are rounding.
    pub order: Option<f64>,
}

impl Decay {
    /// `floor` is the size of rounding.
    pub fn new(errors: &[f64], floor: f64) -> Self {
        let order = match errors {
            [first, .., last] if *last > floor => {
                let halvings = (errors.len() - 1) as f64;
                Some((first / last).log2() / halvings)
            }
            _ => None,
        };
        Self {
            errors: errors.to_vec(),
            order,
        }
    }

    fn vanishes(&self) -> bool {
        self.order.is_none_or(|order| order > LOWEST_ORDER)
    }
}

impl fmt::Display for Decay {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors: Vec<String> = self
            .errors
            .iter()
            .map(|error| format!("{error:.1e}"))
            .collect();
        match self.order {
            Some(order) => write!(f, "order {order:.2} ({})", errors.join(", ")),
            None => write!(f, "exact to rounding ({})", errors.join(", ")),
        }
    }
}

/// A printed Jacobian.
#[derive(Serialize)]
pub struct ClaimReport {
    /// What its author calls it.
    pub label: &'static str,
    /// Line in the file.
    pub line: usize,
    /// Entries that differ; none if it is right.
    pub differences: Vec<EntryReport>,
}

/// An entry of a printed Jacobian that differs from the derivative.
#[derive(Serialize)]
pub struct EntryReport {
    /// Counted from 1.
    pub row: usize,
    /// Counted from 1.
    pub col: usize,
    /// ∂(equation)/∂(unknown) in words.
    pub entry: &'static str,
    /// What is printed.
    pub printed: &'static str,
    /// The derivative.
    pub derived: &'static str,
    /// Value of what is printed at one generic point.
    pub printed_value: f64,
    /// Value of the derivative there.
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
            label: claim.label,
            line: claim.line,
            differences: claim.differences.iter().map(entry).collect(),
        }
    }
}

impl fmt::Display for ModelReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.model)?;
        self.solvers.iter().try_for_each(|solver| solver.fmt(f))?;
        self.claims.iter().try_for_each(|claim| claim.fmt(f))?;
        writeln!(f)
    }
}

impl fmt::Display for SolverReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "  form {}", self.form)?;
        self.jacobian.fmt(f)?;
        match &self.residual {
            Ok(report) => writeln!(
                f,
                "    residual     {}: {:.1} ε at {} accepted steps; an independent solution differs by {:.1e}",
                mark(report.passed()),
                report.residual,
                report.steps,
                report.step_difference
            )?,
            Err(error) => writeln!(f, "    residual     FAILED: {error}")?,
        }
        match &self.consistency {
            Some(Ok(decay)) => writeln!(
                f,
                "    consistency  {}: one step approaches the flow with {decay}",
                mark(decay.vanishes())
            )?,
            Some(Err(error)) => writeln!(f, "    consistency  FAILED: {error}")?,
            None => {}
        }
        match &self.convergence {
            Ok(decay) => writeln!(f, "    convergence  {decay}")?,
            Err(error) => writeln!(f, "    convergence  FAILED: {error}")?,
        }
        for invariant in &self.invariants {
            writeln!(
                f,
                "    drift        {}: {}",
                invariant.name, invariant.drift
            )?;
        }
        Ok(())
    }
}

impl fmt::Display for JacobianReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            points,
            skipped,
            dual,
            central,
        } = self;
        writeln!(
            f,
            "    Jacobian     {}: {:.1} ε from dual numbers, {:.1e} from central differences, {points} random points",
            mark(self.passed()),
            dual.value,
            central.value
        )?;
        if *skipped > 0 {
            writeln!(
                f,
                "                 {skipped} more points lie outside the domain of the equations"
            )?;
        }
        if let (false, Some(entry)) = (
            self.passed(),
            dual.entry.as_ref().or(central.entry.as_ref()),
        ) {
            writeln!(f, "                 worst at {entry}")?;
        }
        Ok(())
    }
}

impl fmt::Display for ClaimReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            label,
            line,
            differences,
        } = self;
        match differences.len() {
            0 => writeln!(f, "  claim {label} (line {line}): right")?,
            n => writeln!(
                f,
                "  claim {label} (line {line}): WRONG in {n} of its entries"
            )?,
        }
        for difference in differences {
            let EntryReport {
                row,
                col,
                entry,
                printed,
                derived,
                printed_value,
                derived_value,
            } = difference;
            writeln!(f, "    ({row},{col}) {entry}")?;
            writeln!(f, "      printed  {printed}  = {printed_value:.6}")?;
            writeln!(f, "      true     {derived}  = {derived_value:.6}")?;
        }
        Ok(())
    }
}

fn mark(passed: bool) -> &'static str {
    if passed { "ok" } else { "FAILED" }
}
