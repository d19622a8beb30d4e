//! The `residua` command: data on stdout or in files, everything else on stderr; exit code 0 if all
//! went well, 1 if a run or a check failed, 2 for bad usage or input.

#[macro_use]
mod output;

mod assignment;
mod bench;
mod check;
mod describe;
mod diagnose;
mod errata;
mod expand;
mod explain;
mod expression;
mod failure;
mod list;
mod motion;
mod name;
mod new;
mod report;
mod requirements;
mod show;
mod simulate;
mod stress;
mod sweep;
mod table;

use clap::{Parser, Subcommand};
use failure::Failure;
use residua_tools::notation;
use residua_tools::plot;
use std::process::ExitCode;

/// Newton solvers generated from discrete equations of motion.
#[derive(Parser)]
#[command(name = "residua", version, arg_required_else_help = true)]
struct Command {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    List(list::List),
    Simulate(simulate::Simulate),
    Sweep(sweep::Sweep),
    Check(check::Check),
    Stress(stress::Stress),
    Bench(bench::Bench),
    Explain(explain::Explain),
    Errata(errata::Errata),
    Expand(expand::Expand),
    Report(report::Report),
    New(new::New),
}

fn main() -> ExitCode {
    let outcome = match Command::parse().verb {
        Verb::List(list) => list.run(),
        Verb::Simulate(simulate) => simulate.run(),
        Verb::Sweep(sweep) => sweep.run(),
        Verb::Check(check) => check.run(),
        Verb::Stress(stress) => stress.run(),
        Verb::Bench(bench) => bench.run(),
        Verb::Explain(explain) => explain.run(),
        Verb::Errata(errata) => errata.run(),
        Verb::Expand(expand) => expand.run(),
        Verb::Report(report) => report.run(),
        Verb::New(new) => new.run(),
    };
    outcome.map_or_else(Failure::report, |()| ExitCode::SUCCESS)
}
