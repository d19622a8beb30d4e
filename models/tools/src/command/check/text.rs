//! What `check` found, for people.

use super::report::{
    ClaimReport, Consistency, EntryReport, InvariantReport, JacobianReport, ModelReport, RunReport,
    SolverReport,
};
use residua_tools::errata::title;
use std::fmt;

impl fmt::Display for ModelReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.model)?;
        self.solvers.iter().try_for_each(|solver| solver.fmt(f))?;
        self.claims.iter().try_for_each(|claim| claim.fmt(f))?;
        for unmet in &self.unmet {
            writeln!(f, "  not met by the data of the file: {unmet}")?;
        }
        writeln!(f)
    }
}

impl fmt::Display for SolverReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "  form {}", self.form)?;
        self.jacobian.fmt(f)?;
        if let Some(error) = &self.error {
            writeln!(f, "    run          FAILED: {error}")?;
        }
        self.run.iter().try_for_each(|run| run.fmt(f))
    }
}

impl fmt::Display for RunReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            residual,
            consistency,
            convergence,
            invariants,
        } = self;
        writeln!(
            f,
            "    residual     {}: {:.1} ε at {} accepted steps, {:.1e} from an independent solution",
            mark(residual.passed()),
            residual.residual,
            residual.steps,
            residual.step_difference
        )?;
        if let Some(Consistency { decay, worst }) = consistency {
            let passed = decay.vanishes();
            write!(f, "    consistency  {}: Δx/h − flow: {decay}", mark(passed))?;
            if !passed {
                write!(f, ", largest in {worst}")?;
            }
            writeln!(f)?;
        }
        let passed = mark(convergence.vanishes());
        writeln!(f, "    convergence  {passed}: {convergence}")?;
        for InvariantReport { name, drift } in invariants {
            let passed = mark(drift.vanishes());
            writeln!(f, "    drift        {passed}: {name}: {drift}")?;
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
            kind,
            label,
            of,
            line,
            differences,
        } = self;
        let title = title(kind, label, *of);
        match differences.len() {
            0 => writeln!(f, "  claim {title} (line {line}): right")?,
            1 => writeln!(f, "  claim {title} (line {line}): WRONG in 1 entry")?,
            n => writeln!(f, "  claim {title} (line {line}): WRONG in {n} entries")?,
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
            writeln!(f, "      printed  {printed}{}", equals(*printed_value))?;
            writeln!(f, "      true     {derived}{}", equals(*derived_value))?;
        }
        Ok(())
    }
}

/// Blocks of a wrong shape have no value.
fn equals(value: f64) -> String {
    if value.is_nan() {
        String::new()
    } else {
        format!("  = {value:.6}")
    }
}

fn mark(passed: bool) -> &'static str {
    if passed { "ok" } else { "FAILED" }
}
