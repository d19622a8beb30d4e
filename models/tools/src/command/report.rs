//! `residua report`: the paper, reproduced and checked, as a page.

use crate::failure::Failure;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use residua_tools::report;
use std::path::PathBuf;

/// Reproduce the paper's figures, check what it says, and write a page
#[derive(Args)]
pub struct Report {
    /// Folder for `index.html` and the data behind it
    #[arg(long, value_name = "DIR", default_value = "report")]
    out: PathBuf,
}

impl Report {
    /// Writes the page.
    pub fn run(self) -> Result<(), Failure> {
        let style = ProgressStyle::with_template("{bar:40} {pos}/{len}");
        // Drawn on stderr, and only on a terminal.
        let progress =
            ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let page = report::report(&progress).map_err(|error| Failure::Run(error.to_string()));
        progress.finish_and_clear();
        let written = page?.write(&self.out);
        written.map_err(|error| Failure::file("write", &self.out, &error))?;
        tell!("{}", self.out.join("index.html").display());
        Ok(())
    }
}
