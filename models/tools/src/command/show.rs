//! Everything about one model, for people.

use crate::describe::{Block, Form, Model, Operations, Quantity};
use crate::notation::{unit, value};
use crate::table::Table;
use residua_codegen::emit::BUDGET;
use residua_tools::errata::title;
use std::io::{self, Write};

/// Prints a model.
pub fn show(model: &Model, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{}", model.name)?;
    for line in model.doc.lines() {
        writeln!(out, "{}", format!("  {line}").trim_end())?;
    }
    quantities("parameters", &model.parameters, out)?;
    quantities("states and where they start", &model.states, out)?;
    for solver in &model.solvers {
        form(solver, out)?;
    }
    quantities("invariants", &model.invariants, out)?;
    quantities("observables", &model.observables, out)?;
    if !model.requirements.is_empty() {
        writeln!(out, "\nrequirements")?;
        let mut table = Table::plain();
        for requirement in &model.requirements {
            let line = format!("line {}", requirement.line);
            table.row([
                format!("  {}", requirement.text),
                format!("else {}", requirement.otherwise),
                line,
            ]);
        }
        write!(out, "{table}")?;
    }
    if !model.claims.is_empty() {
        writeln!(out, "\nclaims")?;
    }
    for claim in &model.claims {
        let verdict = match claim.wrong_entries {
            0 => "right".to_owned(),
            1 => "wrong in 1 entry".to_owned(),
            n => format!("wrong in {n} entries"),
        };
        let title = title(claim.kind, claim.label, claim.of);
        writeln!(out, "  {title} (line {}): {verdict}", claim.line)?;
    }
    let flow = if model.flow { "yes" } else { "no" };
    writeln!(out, "\ncontinuous equations: {flow}")?;
    writeln!(
        out,
        "operations of all functions: {} of a budget of {BUDGET}",
        model.operations
    )
}

fn quantities(title: &str, quantities: &[Quantity], out: &mut impl Write) -> io::Result<()> {
    if quantities.is_empty() {
        return Ok(());
    }
    writeln!(out, "\n{title}")?;
    let mut table = Table::plain();
    for quantity in quantities {
        let name = match quantity.shape {
            (1, 1) => quantity.name.to_owned(),
            (rows, 1) => format!("{}[{rows}]", quantity.name),
            (rows, cols) => format!("{}[{rows},{cols}]", quantity.name),
        };
        let unit = if quantity.unit == "1" {
            String::new()
        } else {
            unit(quantity.unit)
        };
        let value = quantity.value.as_ref().map(|v| value(v, quantity.shape));
        let doc = quantity
            .doc
            .lines()
            .map(str::trim)
            .collect::<Vec<_>>()
            .join(" ");
        let cells = [Some(format!("  {name}")), value, Some(unit), Some(doc)];
        table.row(cells.into_iter().flatten());
    }
    write!(out, "{table}")
}

fn form(form: &Form, out: &mut impl Write) -> io::Result<()> {
    let n: usize = form.unknowns.iter().map(|block| block.len).sum();
    let blocks: Vec<&str> = form.unknowns.iter().map(|block| block.text).collect();
    writeln!(
        out,
        "\nform {}: {n} unknowns {}",
        form.form,
        blocks.join(", ")
    )?;
    let mut equations = Table::plain();
    for &Block { text, len, line } in &form.equations {
        let line = line.map_or(String::new(), |line| format!("line {line}"));
        let rows = if len == 1 {
            String::new()
        } else {
            format!("{len} rows")
        };
        equations.row([format!("  {text}"), rows, line]);
    }
    write!(out, "{equations}")?;
    writeln!(
        out,
        "  Jacobian: {} of {} entries can differ from zero",
        form.nonzeros,
        n * n
    )?;
    write!(out, "{}", counted("  operations", &form.operations))?;
    let Some(core) = &form.core else {
        return Ok(());
    };
    let n: usize = core.unknowns.iter().map(|block| block.len).sum();
    let blocks: Vec<&str> = core.unknowns.iter().map(|block| block.text).collect();
    let (s, of) = (if n == 1 { "" } else { "s" }, blocks.join(", "));
    writeln!(
        out,
        "  iterated on: {n} unknown{s} of {of}; Jacobian: {} of {} entries can differ from zero",
        core.nonzeros,
        n * n
    )?;
    write!(out, "{}", counted("  operations", &core.operations))
}

fn counted(title: &str, operations: &[Operations]) -> Table {
    let mut counts = Table::new(&[title, "+ −", "×", "÷", "functions"]);
    for count in operations {
        let numbers = [
            count.additions,
            count.multiplications,
            count.divisions,
            count.calls,
        ];
        let name = std::iter::once(format!("  {}", count.function));
        counts.row(name.chain(numbers.iter().map(ToString::to_string)));
    }
    counts
}
