//! `residua bench`: what things cost.

mod steps;

use crate::failure::Failure;
use clap::{Args, Subcommand};
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
}

impl Bench {
    /// Times it.
    pub fn run(self) -> Result<(), Failure> {
        match self.what {
            What::Steps(steps) => steps.run(),
        }
    }
}
