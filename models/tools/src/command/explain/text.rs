//! A receipt for people.

use super::{Column, Eliminated, Form, Operations, Receipt};
use crate::table::Table;
use std::fmt;

impl fmt::Display for Receipt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.name)?;
        if let (Some(model), Some(step), Some(until)) = (self.model, self.step, self.until) {
            write!(f, ": a scene of {model}, step {step}, until {until}")?;
        }
        writeln!(f)?;
        if let Some(keep) = self.keep {
            writeln!(f, "keeps {}", keep.join(", "))?;
        }
        for form in &self.forms {
            write!(f, "\n{form}")?;
        }
        if self.model.is_none() {
            return Ok(());
        }
        let file = self.model.unwrap_or_default();
        writeln!(f, "\nskipped, with lines of {file}.model")?;
        let mut table = Table::plain();
        for skipped in &self.skipped {
            table.row([
                format!("  {}", skipped.kind),
                skipped.what.to_owned(),
                format!("line {}", skipped.line),
                skipped.reason.to_owned(),
            ]);
        }
        write!(f, "{table}")
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let title = format!("form {}", self.form);
        let titles = self.columns.iter().map(|column| column.title);
        let headings: Vec<&str> = std::iter::once(title.as_str()).chain(titles).collect();
        let mut table = Table::new(&headings);
        let mut row = |name: &str, number: fn(&Column) -> usize| {
            let numbers = self.columns.iter().map(|column| number(column).to_string());
            table.row(std::iter::once(format!("  {name}")).chain(numbers));
        };
        row("states", |column| column.states);
        row("equations and unknowns", |column| column.unknowns);
        row("unknowns iterated on", |column| column.iterated);
        row("entries of their Jacobian", |column| column.nonzeros);
        let rates = self
            .columns
            .first()
            .map_or(0, |column| column.operations.len());
        for i in 0..rates {
            let name = self.columns[0].operations[i].rate;
            let cells = self
                .columns
                .iter()
                .map(|column| cost(&column.operations[i]));
            table.row(std::iter::once(format!("  {name}")).chain(cells));
        }
        write!(f, "{table}")?;
        writeln!(f, "  (additions / multiplications / divisions / functions)")?;
        let dense = |column: &&Column| column.iterated > 1;
        if let Some(column) = self.columns.iter().rfind(dense) {
            let n = column.iterated;
            writeln!(
                f,
                "  in {}, an iteration also solves a linear system of {n}",
                column.title
            )?;
        }
        match &self.eliminated {
            Some(eliminated) => write!(f, "{eliminated}"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Eliminated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unknowns = self.unknowns.iter().map(|&(name, len)| match len {
            1 => name.to_owned(),
            _ => format!("{len} of {name}"),
        });
        let unknowns: Vec<String> = unknowns.collect();
        let lines: Vec<String> = self.lines.iter().map(ToString::to_string).collect();
        let (s, verb) = match self.lines.len() {
            1 => ("", "is"),
            _ => ("s", "are"),
        };
        writeln!(
            f,
            "  {} enter linearly: line{s} {} {verb} solved for them in closed form",
            unknowns.join(", "),
            lines.join(", ")
        )
    }
}

fn cost(operations: &Operations) -> String {
    let Operations {
        additions,
        multiplications,
        divisions,
        calls,
        ..
    } = operations;
    format!("{additions} / {multiplications} / {divisions} / {calls}")
}
