//! Every scheme against the exact motion, scene by scene.

use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Section;
use super::page::Table;
use super::runs::RunError;
use crate::study::Found;
use crate::study::Row;
use crate::study::SCENES;
use crate::study::Scene;
use crate::study::Watched;
use crate::study::schemes;
use indicatif::ProgressBar;

/// Relative error from which an order means nothing: the run has lost the motion.
const LOST: f64 = 0.1;

/// Distance of the measured order from that in theory from which an error constant means nothing.
const PREASYMPTOTIC: f64 = 0.2;

/// The tables of all scenes.
///
/// # Errors
/// A scene without an exact motion.
pub fn section(progress: &ProgressBar) -> Result<Section, RunError> {
    progress.inc_length(SCENES.len() as u64);
    let mut parts = Vec::new();
    for scene in SCENES {
        parts.push(part(scene)?);
        progress.inc(1);
    }
    let texts = [
        "Every model of the catalogue that describes the same body, in every form, and the paper’s Runge–Kutta 4 on \
         its continuous equations, from the same start. The planar motions are exact by Jacobi’s elliptic functions, \
         the others converged in double-double arithmetic.",
        "Error: the largest of any component of ω and attitude at the end, relative to the size of its variable. \
         Order: from h/2 to h/4; none where the run with h/4 is still a tenth off. Constant: error of that run over \
         (h/4)ᵖ, p = 2 and 4 for Runge–Kutta 4; none where the order measured is further than a fifth from p, so that \
         the step is not yet small. Ahead: the shift in time within ±0.25 s that brings the exact motion nearest, \
         negative for a scheme that lags; beside: what is left of the error after it, the error in amplitude and plane. Energy, constraint and \
         vertical momentum: largest departure from the start; trend: what a straight line fitted to the energy \
         gains over the run. Time per step: fastest of three runs on the machine that made this page, of the dense \
         solver.",
    ];
    Ok(Section {
        id: "schemes".to_owned(),
        title: "Every scheme against the exact motion".to_owned(),
        blocks: texts.map(|text| Block::Text(text.to_owned())).into(),
        parts,
    })
}

fn part(scene: &Scene) -> Result<Section, RunError> {
    let rows = rows(scene)?;
    let mut data = Data::new(&[
        "model",
        "form",
        "error",
        "order",
        "constant [s⁻ᵖ]",
        "ahead [s]",
        "beside",
        "energy [J]",
        "energy trend [J]",
        "constraint",
        "vertical momentum [kg m²/s]",
        "iterations",
        "ns per step",
    ]);
    let mut failures = Vec::new();
    for row in &rows {
        match &row.found {
            Ok(found) => data.row(cells(row, found)),
            Err(why) => failures.push(format!("{} ({}): {why}", row.model, row.method)),
        }
    }
    let steps = format!("h = {} s, to t = {} s", scene.h, scene.until);
    let mut blocks = vec![Block::Table(Table {
        csv: format!("schemes-{}", scene.name),
        caption: format!("{}; {steps}.", scene.caption),
        data,
    })];
    if !failures.is_empty() {
        blocks.push(Block::Text("Without a result:".to_owned()));
        blocks.push(Block::List(failures));
    }
    Ok(Section {
        id: format!("schemes-{}", scene.name),
        title: scene.caption.to_owned(),
        blocks,
        parts: Vec::new(),
    })
}

/// The table of a scene.
///
/// # Errors
/// A scene without an exact motion.
pub(super) fn rows(scene: &Scene) -> Result<Vec<Row>, RunError> {
    let exact = scene.exact_end(&scene.of_reference()?)?;
    Ok(schemes(scene, &exact)?)
}

fn cells(row: &Row, found: &Found) -> Vec<Cell> {
    let [error, _, finest] = found.errors;
    let is_lost = finest > LOST;
    let is_small = !is_lost && (found.order - found.theory).abs() <= PREASYMPTOTIC;
    let named = |name: &str| found.invariants.iter().find(|watched| watched.name == name);
    let largest = |watched: Option<&Watched>| watched.map(|w| Cell::number(w.largest, 2)).into();
    let constraint = found
        .invariants
        .iter()
        .find(|watched| !["energy", "vertical_momentum"].contains(&watched.name));
    let implicit = found.iterations > 0.0;
    vec![
        Cell::Code(row.model.to_owned()),
        row.method.into(),
        Cell::number(error, 2),
        (!is_lost).then_some(Cell::number(found.order, 3)).into(),
        is_small.then_some(Cell::number(found.constant, 2)).into(),
        found.ahead.map(|ahead| Cell::number(ahead, 2)).into(),
        Cell::number(found.aside, 2),
        largest(named("energy")),
        named("energy").map(|w| Cell::number(w.trend, 2)).into(),
        largest(constraint),
        largest(named("vertical_momentum")),
        implicit.then_some(Cell::number(found.iterations, 3)).into(),
        Cell::number(1e9 * found.seconds, 3),
    ]
}
