//! `residua check`: is a solver what its file says?

mod jacobian;
mod order;
mod points;
mod report;
mod residual;
mod text;

use crate::diagnose::compile_file;
use crate::expand::as_path;
use crate::failure::Failure;
use crate::list::print_json;
use crate::requirements;
use clap::Args;
use order::Range;
use report::{ClaimReport, ModelReport, RunReport, SolverReport};
use residua::Catalogued;
use residua::erased::AnySolver;
use residua_models::values;
use residua_models::{CATALOGUE, SCENES, find};
use std::io::{self, Write};

/// Compare Jacobians with dual numbers and central differences, look for consistency, order and drift,
/// and judge the claims
#[derive(Args)]
pub struct Check {
    /// Models and scenes from `residua list`, or paths of their files, whose mistakes are then shown
    #[arg(required_unless_present = "all")]
    models: Vec<String>,
    /// Check every model and scene
    #[arg(long, conflicts_with = "models")]
    all: bool,
    /// Step of the runs that orders are measured on; they are repeated with h/2 and h/4
    #[arg(
        long,
        value_name = "H",
        default_value_t = 0.01,
        allow_negative_numbers = true
    )]
    step: f64,
    /// End of the runs that orders are measured on
    #[arg(
        long,
        value_name = "T",
        default_value_t = 1.0,
        allow_negative_numbers = true
    )]
    until: f64,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Check {
    /// Checks the models and prints what was found.
    pub fn run(self) -> Result<(), Failure> {
        let range = Range::new(self.step, self.until).map_err(Failure::input)?;
        let mut models = Vec::new();
        let mut sound_files = Vec::new();
        for name in &self.models {
            match as_path(name) {
                Some(path) => {
                    compile_file(path)?;
                    sound_files.push(path);
                }
                None => models.push(find(name)?.catalogued),
            }
        }
        if self.all {
            let all = CATALOGUE.iter().chain(SCENES);
            models.extend(all.map(|entry| entry.catalogued));
        }
        let mut out = io::stdout().lock();
        for path in sound_files {
            writeln!(
                out,
                "{}: no mistakes in names, shapes, units and structure; \
                 build it to have its Jacobian and steps checked",
                path.display()
            )?;
        }
        let mut reports = Vec::new();
        for model in models {
            let report = check(model, &range);
            if !self.json {
                write!(out, "{report}")?;
            }
            reports.push(report);
        }
        if self.json {
            print_json(&reports, &mut out)?;
        }
        verdict(&reports)
    }
}

fn verdict(reports: &[ModelReport]) -> Result<(), Failure> {
    let failed: Vec<&str> = reports
        .iter()
        .filter(|r| !r.passed)
        .map(|r| r.model)
        .collect();
    match failed.as_slice() {
        [] => Ok(()),
        names => Err(Failure::Run(format!("checks failed: {}", names.join(", ")))),
    }
}

fn check(model: &'static Catalogued, range: &Range) -> ModelReport {
    let solvers: Vec<SolverReport> = model
        .solvers
        .iter()
        .map(|&solver| check_solver(model, solver, range))
        .collect();
    ModelReport {
        model: model.description.name,
        passed: solvers.iter().all(SolverReport::passed),
        solvers,
        claims: model
            .description
            .claims
            .iter()
            .map(ClaimReport::new)
            .collect(),
        unmet: unmet(model, range.h),
    }
}

/// The requirements that the data of the file do not meet.
fn unmet(model: &Catalogued, h: f64) -> Vec<String> {
    let parameters = values::defaults(model);
    let start = values::start(model, &parameters);
    let unmet = requirements::unmet(model, &parameters, h, &start);
    unmet.map(|i| requirements::text(model, i)).collect()
}

fn check_solver(
    model: &'static Catalogued,
    solver: &'static dyn AnySolver,
    range: &Range,
) -> SolverReport {
    let points = points::random_points(model, solver);
    let run = check_run(model, solver, range);
    SolverReport {
        form: solver.solver().form,
        jacobian: jacobian::compare(solver, &points),
        error: run.as_ref().err().cloned(),
        run: run.ok(),
    }
}

fn check_run(
    model: &'static Catalogued,
    solver: &'static dyn AnySolver,
    range: &Range,
) -> Result<RunReport, String> {
    let runs = order::runs(model, solver, range)?;
    Ok(RunReport {
        residual: residual::at_accepted_steps(model, solver, range, &runs[0])?,
        consistency: order::consistency(model, solver, range, &runs[0])?,
        convergence: order::convergence(&runs),
        invariants: order::invariants(model, solver, range)?,
    })
}
