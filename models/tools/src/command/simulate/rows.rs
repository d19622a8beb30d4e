//! Rows of a run as CSV, written as they come.

use std::io::{self, Write};

/// A CSV file that grows.
pub struct Rows {
    out: Box<dyn Write>,
    written: u64,
}

impl Rows {
    /// Writes the header.
    pub fn new(mut out: Box<dyn Write>, header: &[String]) -> io::Result<Self> {
        // The entry `R(2,1)` has a comma in its name.
        let cell = |name: &String| match name.contains(',') {
            true => format!("\"{name}\""),
            false => name.clone(),
        };
        let cells: Vec<String> = header.iter().map(cell).collect();
        writeln!(out, "{}", cells.join(","))?;
        Ok(Self { out, written: 0 })
    }

    /// Writes one row. Each number has the digits that bring the same number back.
    pub fn push(&mut self, t: f64, values: &[f64]) -> io::Result<()> {
        write!(self.out, "{t:?}")?;
        for value in values {
            write!(self.out, ",{value:?}")?;
        }
        self.written += 1;
        writeln!(self.out)
    }

    /// Passes on what is still buffered and returns the number of rows.
    pub fn finish(mut self) -> io::Result<u64> {
        self.out.flush()?;
        Ok(self.written)
    }
}
