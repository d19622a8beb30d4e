//! Misprints, for people.

use residua_tools::errata::Errata;
use residua_tools::errata::Misprint;
use residua_tools::errata::Verdict;
use residua_tools::errata::by_eye::Slip;
use residua_tools::errata::data::Body;
use residua_tools::errata::newton::Comparison;
use residua_tools::errata::newton::Run;
use residua_tools::errata::title;
use std::io::{self, Write};

/// The claims of a model.
pub fn model(errata: &Errata, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{}", errata.model)?;
    for verdict in &errata.claims {
        claim(verdict, out)?;
    }
    writeln!(out)
}

fn claim(verdict: &Verdict, out: &mut impl Write) -> io::Result<()> {
    let title = title(verdict.kind, &verdict.label, verdict.of.as_deref());
    let outcome = match verdict.differences.len() {
        0 => "right".to_owned(),
        1 => "WRONG in 1 entry".to_owned(),
        n => format!("WRONG in {n} entries"),
    };
    writeln!(out, "  {title} (line {}): {outcome}", verdict.line)?;
    writeln!(out, "    by       {}", verdict.decided)?;
    for difference in &verdict.differences {
        let Misprint {
            row,
            col,
            entry,
            printed,
            right,
            printed_value,
            right_value,
        } = difference;
        writeln!(out, "    ({row},{col}) {entry}")?;
        if verdict.leaves_remainders() {
            let value = equals(*printed_value);
            writeln!(out, "      left − right is not 0:  {printed}{value}")?;
            continue;
        }
        writeln!(out, "      printed  {printed}{}", equals(*printed_value))?;
        writeln!(out, "      right    {right}{}", equals(*right_value))?;
    }
    if let Some(comparison) = &verdict.newton {
        newton(comparison, out)?;
    }
    match verdict.note {
        Some(note) => writeln!(out, "    note     {note}"),
        None => Ok(()),
    }
}

fn newton(comparison: &Comparison, out: &mut impl Write) -> io::Result<()> {
    let Comparison {
        form,
        plan,
        printed,
        right,
        difference,
    } = comparison;
    let (h, steps) = (plan.h, plan.steps);
    writeln!(
        out,
        "    Newton   form {form}, h = {h}, {steps} steps from the model's start"
    )?;
    writeln!(out, "      printed  {}", run(printed, h))?;
    writeln!(out, "      right    {}", run(right, h))?;
    match difference {
        None => Ok(()),
        Some(difference) => {
            let common = printed.steps.min(right.steps);
            writeln!(
                out,
                "      states differ by {difference:.1e} after {common} steps"
            )
        }
    }
}

fn run(run: &Run, h: f64) -> String {
    let done = match run.steps {
        0 => String::new(),
        _ => format!(
            "{:.1} iterations per step, at most {}",
            run.mean_iterations, run.most_iterations
        ),
    };
    match run.failure {
        None => done,
        Some(failure) => {
            let (step, t) = (run.steps + 1, run.steps as f64 * h);
            let failed = format!("FAILED in step {step}, t = {t:.4}: {failure}");
            if done.is_empty() {
                failed
            } else {
                format!("{failed}; before, {done}")
            }
        }
    }
}

/// What is left of the moments of inertia about the centre of mass.
pub fn bodies(bodies: &[Body], out: &mut impl Write) -> io::Result<()> {
    if bodies.is_empty() {
        return Ok(());
    }
    writeln!(out, "data: moments of inertia about the pivot, kg m²")?;
    for body in bodies {
        let Body {
            model,
            pivot,
            offset,
            central,
        } = body;
        let verdict = if body.exists() {
            "possible"
        } else {
            "NO SUCH BODY"
        };
        writeln!(
            out,
            "  {model}: J = {pivot:.4}, m l² = {offset:.4}, J − m l² = {central:.4} about the centre of mass: {verdict}"
        )?;
    }
    if bodies.iter().any(|body| !body.exists()) {
        writeln!(
            out,
            "  This reads l as the distance to the centre of mass, as above Eq. 38, and J as that about the pivot, which an\n  \
             equation of moments about the pivot has. In space it concerns Jx and Jy only."
        )?;
    }
    writeln!(out)
}

/// The list that no tool decided.
pub fn by_eye(slips: &[Slip], out: &mut impl Write) -> io::Result<()> {
    if slips.is_empty() {
        return Ok(());
    }
    writeln!(out, "read by eye, not decided by a tool")?;
    for slip in slips {
        let doubt = if slip.doubtful {
            " (perhaps only in the extracted text)"
        } else {
            ""
        };
        writeln!(out, "  {}{doubt}", slip.place)?;
        writeln!(out, "    printed  {}", slip.printed)?;
        writeln!(out, "    right    {}", slip.right)?;
        writeln!(out, "    because  {}", slip.reason)?;
    }
    Ok(())
}

fn equals(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("  = {value:.6}"))
}
