//! What to use for an error.

use super::row::Kind;
use super::row::Row;

/// Errors that a verdict is passed on.
pub const LEVELS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-11];

/// Errors of the trajectory from which on a run does not take the motion any more, whatever it conserves.
const LOST: f64 = 1e-2;

/// The fastest runs that are at least so exact.
#[derive(Clone, Debug)]
pub struct Verdict<'r> {
    /// The error.
    pub level: f64,
    /// Ours that chooses its own steps, as those of the others do.
    pub ours: Option<&'r Row>,
    /// Ours with steps of one length: which, nobody knows beforehand.
    pub fixed: Option<&'r Row>,
    /// That of each other package, the fastest first.
    pub rivals: Vec<&'r Row>,
}

/// A verdict per error of `levels`. `rows` are in the order of their ladders, coarsest first.
pub fn verdicts<'r>(rows: &'r [Row], kind: Kind, levels: &[f64]) -> Vec<Verdict<'r>> {
    let mut packages: Vec<&str> = rows.iter().map(|row| row.by.as_str()).collect();
    packages.sort_unstable();
    packages.dedup();
    let fastest = |level: f64, takes_part: &dyn Fn(&Row) -> bool| {
        let exact = (0..rows.len()).filter(|&i| takes_part(&rows[i]));
        let exact = exact.filter(|&i| is_exact(rows, i, kind, level));
        let exact = exact.map(|i| &rows[i]);
        exact.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
    };
    let verdict = |&level: &f64| {
        let of = |package: &&str| fastest(level, &|row| !row.is_ours() && row.by == *package);
        let mut rivals: Vec<&Row> = packages.iter().filter_map(of).collect();
        rivals.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        Verdict {
            level,
            ours: fastest(level, &|row| row.is_ours() && row.tolerance.is_some()),
            fixed: fastest(level, &|row| row.is_ours() && row.tolerance.is_none()),
            rivals,
        }
    };
    levels.iter().map(verdict).collect()
}

/// The row is so exact, and not by luck: the next finer one is too. A NaN is neither.
fn is_exact(rows: &[Row], i: usize, kind: Kind, level: f64) -> bool {
    let finer = rows.get(i + 1).filter(|row| row.is_of_lane(&rows[i]));
    let is_exact = |row: &Row| row.error(kind) <= level && row.trajectory <= LOST;
    rows[i].seconds.is_finite() && is_exact(&rows[i]) && finer.is_none_or(is_exact)
}

#[cfg(test)]
mod tests;
