//! What was measured, as text.

use crate::notation::{number, power_of_ten};
use crate::table::Table;
use residua_tools::precision::{Kind, LEVELS, Problem, Row, Verdict, name, verdicts};

/// Prints the fastest of us and of the others at each error, and what to use.
pub(super) fn show(problem: &Problem, rows: &[Row]) {
    let Problem {
        name,
        until,
        exact,
        source,
        ..
    } = problem;
    let failed = rows.iter().filter(|row| !row.failure.is_empty()).count();
    let models: Vec<&str> = problem.formulations.iter().map(|of| of.name()).collect();
    println!(
        "{name}, until {} s: {} runs, {failed} failed",
        number(*until),
        rows.len()
    );
    println!("formulations: {}", models.join(", "));
    println!(
        "reference: {source}, two resolutions {:.0e} apart\n",
        exact.error
    );
    let mut table = Table::new(&["error", "fastest", "with", "time", "of ours"]);
    let list = verdicts(rows, Kind::Trajectory, &LEVELS);
    for verdict in &list {
        for cells in lines(verdict) {
            table.row(cells);
        }
    }
    println!("{table}");
    for verdict in &list {
        println!("{}", sentence(verdict));
    }
    for kind in [Kind::Phase, Kind::Energy, Kind::Constraint, Kind::Momentum] {
        for verdict in verdicts(rows, kind, &LEVELS[2..3]) {
            if let Some(row) = verdict.ours.or(verdict.fixed) {
                let (level, title) = (level(verdict.level), kind.title());
                println!("for {level} as {title} use {}", used(row));
            }
        }
    }
    println!();
}

/// Ours, ours with a fixed step, and those of the others, with their times as multiples of ours.
fn lines(verdict: &Verdict<'_>) -> Vec<[String; 5]> {
    let all = verdict.ours.iter().chain(&verdict.fixed);
    let all = all.chain(&verdict.rivals);
    let lines = all.enumerate().map(|(i, row)| {
        let level = if i == 0 {
            level(verdict.level)
        } else {
            String::new()
        };
        let ratio = verdict.ours.map(|ours| row.seconds / ours.seconds);
        let ratio = ratio.map_or_else(String::new, |ratio| format!("{ratio:.2}"));
        [level, name(row), rung(row), time(row.seconds), ratio]
    });
    lines.collect()
}

/// for 1e-9 on this scene use gauss8, 155 µs
fn sentence(verdict: &Verdict<'_>) -> String {
    let level = level(verdict.level);
    match (verdict.ours.or(verdict.fixed), verdict.rivals.first()) {
        (Some(row), _) => format!("for {level} on this scene use {}", used(row)),
        (None, Some(rival)) => format!(
            "for {level} on this scene only rivals will do: {}",
            used(rival)
        ),
        (None, None) => format!("for {level} on this scene there is nothing"),
    }
}

fn used(row: &Row) -> String {
    format!("{}, {}, {}", name(row), rung(row), time(row.seconds))
}

/// 10⁻⁹
fn level(level: f64) -> String {
    power_of_ten(level.log10().round() as i32)
}

fn rung(row: &Row) -> String {
    match (row.step, row.tolerance) {
        (Some(step), _) => format!("h = {step:.3e}"),
        (_, Some(tolerance)) => format!("tolerance {tolerance:e}"),
        (None, None) => String::new(),
    }
}

fn time(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{:.1} µs", s * 1e6),
        s if s < 1.0 => format!("{:.2} ms", s * 1e3),
        s => format!("{s:.2} s"),
    }
}
