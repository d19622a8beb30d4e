//! `residua bench`: what things cost.

mod precision;
mod steps;

use crate::failure::Failure;
use clap::{Args, Subcommand};
use precision::Precision;
use steps::Steps;

/// Time what Residua does
#[derive(Args)]
pub struct Bench {
    #[command(subcommand)]
    what: What,
}

#[derive(Subcommand)]
enum What {
    Steps(Steps),
    Precision(Precision),
}

impl Bench {
    /// Times it.
    pub fn run(self) -> Result<(), Failure> {
        match self.what {
            What::Steps(steps) => steps.run(),
            What::Precision(precision) => precision.run(),
        }
    }
}
