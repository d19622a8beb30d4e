//! `residua errata`: what is misprinted, and what Newton's method makes of it.

mod text;

use crate::failure::Failure;
use crate::list::print_json;
use clap::Args;
use residua_models::{CATALOGUE, find};
use residua_tools::errata::by_eye::SLIPS;
use residua_tools::errata::by_eye::Slip;
use residua_tools::errata::data::Body;
use residua_tools::errata::data::body;
use residua_tools::errata::errata;
use residua_tools::errata::newton::Plan;
use serde::Serialize;
use std::io::{self, Write};

/// List every printed equation with its verdict, entry by entry, and run Newton's method on the wrong ones
#[derive(Args)]
pub struct Errata {
    /// Models from `residua list`; without any, all of them and what was read by eye
    models: Vec<String>,
    /// Step of the runs with what is printed
    #[arg(long, value_name = "H", default_value_t = Plan::default().h, allow_negative_numbers = true)]
    step: f64,
    /// Number of steps of these runs
    #[arg(long, value_name = "N", default_value_t = Plan::default().steps)]
    steps: usize,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// All that is known.
#[derive(Serialize)]
struct Report {
    models: Vec<residua_tools::errata::Errata>,
    bodies: Vec<Body>,
    read_by_eye: &'static [Slip],
}

impl Errata {
    /// Prints the list.
    pub fn run(self) -> Result<(), Failure> {
        if !(self.step.is_finite() && self.step != 0.0) {
            return Err(Failure::input("the step must be a number other than 0"));
        }
        let plan = Plan {
            h: self.step,
            steps: self.steps,
        };
        let mut entries = Vec::new();
        for name in &self.models {
            let entry = find(name)?;
            if let Some(scene) = entry.catalogued.description.scene {
                let help = format!("`{}` is what it is a scene of", scene.model);
                let message = format!("`{name}` is a scene, and claims are about models");
                return Err(Failure::input_with_help(message, help));
            }
            entries.push(entry);
        }
        let all = entries.is_empty();
        if all {
            entries.extend(CATALOGUE);
        }
        let mut out = io::stdout().lock();
        let mut report = Report {
            models: Vec::new(),
            bodies: Vec::new(),
            read_by_eye: if all { SLIPS } else { &[] },
        };
        for entry in entries {
            let found = errata(entry, &plan).map_err(Failure::Run)?;
            if found.claims.is_empty() && all {
                continue;
            }
            if !self.json {
                text::model(&found, &mut out)?;
            }
            report.models.push(found);
            report.bodies.extend(body(entry.catalogued));
        }
        if self.json {
            return print_json(&report, &mut out);
        }
        text::bodies(&report.bodies, &mut out)?;
        text::by_eye(report.read_by_eye, &mut out)?;
        Ok(out.flush()?)
    }
}
