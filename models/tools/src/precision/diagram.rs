//! Work–precision diagrams.

use super::problem::Problem;
use super::row::Kind;
use super::row::Row;
use super::verdict::LEVELS;
use super::verdict::Verdict;
use super::verdict::verdicts;
use crate::plot::LogCurve;
use crate::plot::LogPanel;
use crate::plot::Logarithmic;
use crate::plot::MAX_CURVES;

/// Errors beyond this are no motion any more, and would squeeze the others.
const LARGEST: f64 = 1.0;

/// Errors below this are drawn here: they are 0 or nearly so.
const LEAST: f64 = 1e-17;

/// A lane: one scheme on one formulation.
struct Lane<'r> {
    rows: Vec<&'r Row>,
    label: String,
}

/// The diagram of some rows. Named are the lanes that are fastest at one of the errors of [`LEVELS`], ours and of
/// the rival packages, and the first lane of all; the others are drawn pale.
pub fn picture(problem: &Problem, rows: &[Row]) -> Logarithmic {
    let lanes = lanes(rows);
    let has = |kind: Kind| rows.iter().any(|row| row.error(kind).is_finite());
    let panels = Kind::ALL.into_iter().filter(|kind| has(*kind));
    let panels = panels.map(|kind| LogPanel {
        horizontal: kind.title().to_owned(),
        curves: lanes.iter().map(|lane| lane.curve(kind)).collect(),
    });
    let (lanes, error) = (lanes.len(), problem.exact.error);
    Logarithmic {
        title: format!("{}: {}", problem.name, problem.caption),
        subtitle: format!(
            "until {} s, {lanes} lanes, shortest times; reference by {}, two resolutions {error:.0e} apart",
            problem.until, problem.source
        ),
        vertical: "time [s]".to_owned(),
        panels: panels.collect(),
    }
}

/// The rows by lane, the named ones with a label.
fn lanes(rows: &[Row]) -> Vec<Lane<'_>> {
    let mut lanes: Vec<Lane<'_>> = Vec::new();
    for row in rows {
        match lanes.iter_mut().find(|lane| lane.rows[0].is_of_lane(row)) {
            Some(lane) => lane.rows.push(row),
            None => lanes.push(Lane {
                rows: vec![row],
                label: String::new(),
            }),
        }
    }
    let mut best: Vec<&Row> = Vec::new();
    let all: Vec<Verdict<'_>> = [Kind::Trajectory, Kind::Energy]
        .into_iter()
        .flat_map(|kind| verdicts(rows, kind, &LEVELS))
        .collect();
    best.extend(all.iter().filter_map(|verdict| verdict.ours));
    let rivals = all.iter().map(|verdict| &verdict.rivals);
    best.extend(rivals.clone().filter_map(|rivals| rivals.first()));
    best.extend(all.iter().filter_map(|verdict| verdict.fixed));
    best.extend(rivals.flatten());
    best.extend(rows.first());
    let mut named = 0;
    for row in best {
        let lane = lanes.iter_mut().find(|lane| lane.rows[0].is_of_lane(row));
        if let Some(lane) = lane.filter(|lane| lane.label.is_empty() && named < MAX_CURVES) {
            lane.label = name(row);
            named += 1;
        }
    }
    lanes
}

/// `gauss8, spatial_group`
pub fn name(row: &Row) -> String {
    match row.is_ours() {
        true => format!("{}, {}", row.scheme, row.model),
        false => format!("{} {}, {}", row.by, row.scheme, row.model),
    }
}

impl Lane<'_> {
    fn curve(&self, kind: Kind) -> LogCurve {
        let point = |row: &&Row| {
            let error = row.error(kind);
            // Written so that a NaN is a gap.
            match error <= LARGEST {
                true => (error.max(LEAST), row.seconds),
                false => (f64::NAN, f64::NAN),
            }
        };
        LogCurve {
            label: self.label.clone(),
            points: self.rows.iter().map(point).collect(),
        }
    }
}
