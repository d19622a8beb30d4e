//! The five conclusions of the paper, tested by numbers and judged.

mod evidence;
mod verdicts;

use super::measure::Measure;
use super::page::Block;
use super::page::Cell;
use super::page::Data;
use super::page::Section;
use super::page::Table;
use super::runs::RunError;
use evidence::Evidence;
use evidence::PLANAR;
use evidence::SPATIAL;
use indicatif::ProgressBar;

/// The section.
///
/// # Errors
/// Runs that cannot start.
pub fn section(progress: &ProgressBar) -> Result<Section, RunError> {
    let evidence = Evidence::gather(progress)?;
    let verdicts = [
        evidence.first(),
        evidence.second(),
        evidence.third(),
        evidence.fourth(),
        evidence.fifth(),
        evidence.summary(),
    ];
    let mut blocks: Vec<Block> = verdicts.into_iter().map(Block::Verdict).collect();
    blocks.push(Block::Table(table(
        "the plane",
        &evidence.planar,
        &evidence.runge_kutta,
    )));
    blocks.push(Block::Table(table("space", &evidence.spatial, &[])));
    Ok(Section {
        id: "conclusions".to_owned(),
        title: "The five conclusions".to_owned(),
        blocks,
        parts: Vec::new(),
    })
}

fn table(place: &str, newton: &[Measure], runge_kutta: &[Measure]) -> Table {
    let mut data = Data::new(&[
        "scheme",
        "model",
        "h [s]",
        "lag [s]",
        "off, last 5 s [% of range]",
        "coincides until [s]",
        "amplitude [%]",
        "energy error",
        "ω off its axis",
        "iterations",
    ]);
    let names = PLANAR.iter().chain(&SPATIAL);
    let label = |model: &str| {
        names
            .clone()
            .find(|(own, _)| *own == model)
            .map(|(_, label)| *label)
    };
    let implicit = newton.iter().map(|m| (label(m.run.model), m));
    for (label, measure) in implicit.chain(runge_kutta.iter().map(|m| (Some("Runge–Kutta 4"), m)))
    {
        let iterations = (measure.iterations > 0.0).then_some(Cell::number(measure.iterations, 3));
        data.row([
            label.into(),
            Cell::Code(measure.run.model.to_owned()),
            Cell::given(measure.run.step),
            measure.lag.into(),
            (100.0 * measure.last_share()).into(),
            measure.coincides_until.into(),
            Cell::number(100.0 * measure.amplitude_change, 2),
            Cell::number(measure.energy_error, 2),
            Cell::number(measure.off_axis, 2),
            iterations.into(),
        ]);
    }
    Table {
        csv: format!("conclusions-{}", place.trim_start_matches("the ")),
        caption: format!(
            "The runs behind the verdicts, in {place}: each against the exact motion of Section 6."
        ),
        data,
    }
}
