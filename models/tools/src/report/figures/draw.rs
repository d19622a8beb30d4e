//! The plot of a figure, and the rows behind it.

use super::Extra;
use super::Scene;
use crate::notation::unit;
use crate::plot::Curve;
use crate::plot::Panel;
use crate::report::measure;
use crate::report::measure::SLACK;
use crate::report::page::Cell;
use crate::report::page::Data;
use crate::report::page::Figure;
use crate::report::runs::Recording;
use crate::report::runs::RunError;

/// Width of a plot, px: that of the page's column.
const WIDTH: i32 = 800;

/// Points that a curve may have: about two per pixel.
const MAX_POINTS: usize = 1600;

/// Range of a state's axis below which all is rounding of numbers near 1: a component that is 0 in the exact
/// solution would otherwise be drawn as noise.
const LEAST_RANGE: f64 = 1e-3;

/// The plot and its data.
pub fn figure(scene: &Scene<'_>) -> Result<Figure, RunError> {
    let plan = scene.plan;
    let mut panels = Vec::new();
    for quantity in plan.quantities {
        panels.push(panel(scene, quantity)?);
    }
    let first = plan.quantities.first().copied().unwrap_or_default();
    match plan.extra {
        Extra::None => {}
        Extra::Amplitude => panels.push(amplitudes(scene)?),
        Extra::Error => panels.push(errors(scene, first)?),
        Extra::Forms => panels.push(forms(scene, first)?),
    }
    // One legend is enough: the panels have the same curves.
    for curve in panels
        .iter_mut()
        .skip(1)
        .flat_map(|panel| &mut panel.curves)
    {
        curve.label.clear();
    }
    let (from, to) = plan.window;
    Ok(Figure {
        csv: format!("figure-{:02}", plan.number),
        caption: format!("{} from {from} s to {to} s.", plan.quantities.join(", ")),
        plot: crate::plot::Figure {
            title: String::new(),
            subtitle: String::new(),
            time: "t [s]".to_owned(),
            panels,
            width: WIDTH,
        },
        overlay: true,
        data: data(scene)?,
    })
}

fn panel(scene: &Scene<'_>, quantity: &str) -> Result<Panel, RunError> {
    let mut curves = Vec::new();
    let finest = scene
        .curves
        .iter()
        .min_by(|a, b| a.line.run.step.total_cmp(&b.line.run.step));
    if let Some(finest) = finest {
        let points = points(scene, finest.exact, &finest.exact.values(quantity)?);
        curves.push(curve("exact", true, points));
    }
    for drawn in &scene.curves {
        let points = points(scene, drawn.made, &drawn.made.values(quantity)?);
        curves.push(curve(drawn.line.label, false, points));
    }
    Ok(Panel {
        title: quantity.to_owned(),
        unit: unit(unit_of(quantity)),
        curves,
        least_range: LEAST_RANGE,
    })
}

/// What is drawn less what is exact.
fn errors(scene: &Scene<'_>, quantity: &str) -> Result<Panel, RunError> {
    let mut curves = Vec::new();
    for drawn in &scene.curves {
        let own = drawn.made.values(quantity)?;
        let exact = drawn.exact.values(quantity)?;
        let errors: Vec<f64> = own
            .iter()
            .zip(&exact)
            .map(|(own, exact)| own - exact)
            .collect();
        curves.push(curve(
            drawn.line.label,
            false,
            points(scene, drawn.made, &errors),
        ));
    }
    Ok(Panel {
        title: format!("{quantity} less exact {quantity}"),
        unit: unit(unit_of(quantity)),
        curves,
        least_range: 0.0,
    })
}

/// Of the swing through each state, by its energy.
fn amplitudes(scene: &Scene<'_>) -> Result<Panel, RunError> {
    let mut curves = Vec::new();
    for drawn in &scene.curves {
        let amplitudes = measure::amplitudes(&drawn.line.run, drawn.made)?;
        curves.push(curve(
            drawn.line.label,
            false,
            points(scene, drawn.made, &amplitudes),
        ));
    }
    Ok(Panel {
        title: "amplitude of θ".to_owned(),
        unit: unit(unit_of("θ")),
        curves,
        least_range: 0.0,
    })
}

/// The second run less the first.
fn forms(scene: &Scene<'_>, quantity: &str) -> Result<Panel, RunError> {
    let mut curves = Vec::new();
    let mut title = String::new();
    if let [first, second, ..] = &scene.curves[..] {
        let own = first.made.values(quantity)?;
        let other = second.made.values(quantity)?;
        let differences: Vec<f64> = own
            .iter()
            .zip(&other)
            .map(|(own, other)| other - own)
            .collect();
        curves.push(curve("", false, points(scene, first.made, &differences)));
        title = format!(
            "{quantity} of {} less {quantity} of {}",
            second.line.label, first.line.label
        );
    }
    Ok(Panel {
        title,
        unit: unit(unit_of(quantity)),
        curves,
        least_range: 0.0,
    })
}

fn curve(label: &str, reference: bool, points: Vec<(f64, f64)>) -> Curve {
    Curve {
        label: label.to_owned(),
        reference,
        points,
    }
}

fn unit_of(quantity: &str) -> &'static str {
    match quantity.chars().next() {
        Some('ω') => "rad/s",
        Some('θ') => "rad",
        _ => "1",
    }
}

/// The points inside the window.
fn points(scene: &Scene<'_>, recording: &Recording, values: &[f64]) -> Vec<(f64, f64)> {
    let (from, to) = scene.plan.window;
    let all = recording.times.iter().copied().zip(values.iter().copied());
    let inside = all.filter(|(t, v)| (from - SLACK..=to + SLACK).contains(t) && v.is_finite());
    thinned(inside.collect())
}

/// Of many points the lowest and the highest of each bin, so that oscillations keep their envelope.
fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= MAX_POINTS {
        return points;
    }
    let bin = points.len().div_ceil(MAX_POINTS / 2);
    let mut kept = Vec::with_capacity(MAX_POINTS);
    for bin in points.chunks(bin) {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let (low, high) = (bin.iter().min_by(by_value), bin.iter().max_by(by_value));
        let mut ends: Vec<(f64, f64)> = low.into_iter().chain(high).copied().collect();
        ends.sort_by(|a, b| a.0.total_cmp(&b.0));
        ends.dedup();
        kept.extend(ends);
    }
    kept
}

/// `curve, t, …`: every step inside the window, of each run and of the exact solution at its times.
fn data(scene: &Scene<'_>) -> Result<Data, RunError> {
    let (from, to) = scene.plan.window;
    let quantities = scene.plan.quantities;
    let mut data = Data::new(&[&["curve", "h", "t"], quantities].concat());
    for drawn in &scene.curves {
        let label = drawn.line.label;
        let both = [
            (label.to_owned(), drawn.made),
            (format!("exact for {label}"), drawn.exact),
        ];
        for (name, recording) in both {
            let columns = quantities.iter().map(|quantity| recording.values(quantity));
            let columns = columns.collect::<Result<Vec<_>, _>>()?;
            for (i, t) in recording.times.iter().enumerate() {
                if (from - SLACK..=to + SLACK).contains(t) {
                    let start = [
                        Cell::Text(name.clone()),
                        drawn.line.run.step.into(),
                        (*t).into(),
                    ];
                    data.row(start.into_iter().chain(columns.iter().map(|c| c[i].into())));
                }
            }
        }
    }
    Ok(data)
}
