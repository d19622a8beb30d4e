//! The paper, reproduced and checked: a page of sections, and the sections.
//!
//! A section is a function from nothing to a [`page::Section`]; [`page::Page::write`] writes them to one
//! HTML file with CSV files beside it.

mod conclusions;
mod errata;
mod figures;
mod html;
mod maps;
mod measure;
pub mod page;
mod precision;
mod reference;
mod runs;
mod schemes;

pub use runs::RunError;

use indicatif::ProgressBar;
use page::Page;

/// The report; the bar moves with what is done.
pub fn report(progress: &ProgressBar) -> Result<Page, RunError> {
    Ok(Page {
        title: "Long time simulation of pendulums, reproduced and checked".to_owned(),
        lead: "The figures of W. Sun, L. Bai, X. Ge, L. Xia, Long Time Simulation Analysis of Geometry \
               Dynamics Model under Iteration, Appl. Sci. 2022, 12, 4910, computed again by Residua from \
               the paper's equations and compared with exact solutions."
            .to_owned(),
        sections: vec![
            conclusions::section(progress)?,
            figures::section(progress)?,
            schemes::section(progress)?,
            maps::section(progress),
            precision::section(progress)?,
            errata::section(progress)?,
        ],
    })
}
