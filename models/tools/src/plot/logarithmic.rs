//! Panels with logarithmic axes, two in a row, as SVG.

use super::*;
use plotters::coord::combinators::IntoLogRange;
use std::ops::Range;

/// A picture.
pub struct Logarithmic {
    /// Large, above everything.
    pub title: String,
    /// Small, below the title.
    pub subtitle: String,
    /// Label of all vertical axes.
    pub vertical: String,
    /// Row by row.
    pub panels: Vec<LogPanel>,
}

/// Curves against one quantity.
pub struct LogPanel {
    /// Label of the horizontal axis.
    pub horizontal: String,
    /// In legend order; those without a label are drawn pale, below the others.
    pub curves: Vec<LogCurve>,
}

/// Points joined by a line.
pub struct LogCurve {
    /// Its name; curves of one name have one colour in all panels.
    pub label: String,
    /// Positive and finite; others leave a gap.
    pub points: Vec<(f64, f64)>,
}

/// Height of a panel, px.
const HEIGHT: i32 = 380;
/// Height of a line of the legend, px.
const LINE: i32 = 20;
/// Width of a name in the legend, px.
const NAME: i32 = 300;
/// Space around the curves, px.
const MARGIN: i32 = 18;
/// Radius of a point, px.
const POINT: i32 = 3;

/// The picture as the text of an SVG file.
///
/// # Errors
/// Where plotters fails, in its words.
pub fn logarithmic_svg(picture: &Logarithmic) -> Result<String, String> {
    let labels = labels(picture);
    let columns = (WIDTH / NAME) as usize;
    let legend = LINE * labels.len().div_ceil(columns) as i32 + MARGIN;
    let rows = picture.panels.len().div_ceil(2) as i32;
    let height = HEADER + HEIGHT * rows + legend;
    let size = ((WIDTH * SCALE) as u32, (height * SCALE) as u32);
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        compose(picture, &labels, &root).map_err(|error| error.to_string())?;
        root.present().map_err(|error| error.to_string())?;
    }
    let drawn = format!(r#"width="{}" height="{}""#, size.0, size.1);
    let shown = format!(r#"width="{WIDTH}" height="{height}""#);
    Ok(text.replacen(&drawn, &shown, 1))
}

/// The names of all curves, in the order of their first appearance.
fn labels(picture: &Logarithmic) -> Vec<&str> {
    let mut labels: Vec<&str> = Vec::new();
    for curve in picture.panels.iter().flat_map(|panel| &panel.curves) {
        if !curve.label.is_empty() && !labels.contains(&curve.label.as_str()) {
            labels.push(&curve.label);
        }
    }
    labels
}

fn compose<'a>(picture: &Logarithmic, labels: &[&str], root: &Area<'a>) -> Drawn<'a> {
    root.fill(&PAPER)?;
    let (header, body) = root.split_vertically(HEADER * SCALE);
    write(&header, &picture.title, (22, 16), bold(17.0, INK))?;
    write(&header, &picture.subtitle, (22, 40), font(12.0, MUTED))?;
    let rows = picture.panels.len().div_ceil(2);
    let (panels, legend) = body.split_vertically(HEIGHT * rows as i32 * SCALE);
    let curves = picture.panels.iter().flat_map(|panel| &panel.curves);
    let times = decades(curves, |point| point.1);
    let areas = panels.split_evenly((rows, 2));
    for (panel, area) in picture.panels.iter().zip(&areas) {
        draw_log_panel(panel, picture, labels, times.clone(), area)?;
    }
    let columns = (WIDTH / NAME) as usize;
    for (i, label) in labels.iter().enumerate() {
        let place = (
            22 + NAME * (i % columns) as i32,
            12 + LINE * (i / columns) as i32,
        );
        draw_entry(label, colour(i), place, &legend)?;
    }
    Ok(())
}

/// The powers of ten around all values, (0.1, 1) if there is none.
fn decades<'c>(
    curves: impl IntoIterator<Item = &'c LogCurve>,
    coordinate: impl Fn(&(f64, f64)) -> f64,
) -> Range<f64> {
    let values = curves
        .into_iter()
        .flat_map(|curve| &curve.points)
        .map(coordinate);
    let values = values.filter(|value| value.is_finite() && *value > 0.0);
    let exponents = values.map(f64::log10);
    let (low, high) = exponents.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return 0.1..1.0;
    }
    let (low, high) = (low.floor(), high.ceil().max(low.floor() + 1.0));
    10f64.powf(low)..10f64.powf(high)
}

fn draw_log_panel<'a>(
    panel: &LogPanel,
    picture: &Logarithmic,
    labels: &[&str],
    times: Range<f64>,
    area: &Area<'a>,
) -> Drawn<'a> {
    let errors = decades(&panel.curves, |point| point.0);
    let mut chart = ChartBuilder::on(area)
        .margin(MARGIN * SCALE)
        .set_label_area_size(LabelAreaPosition::Left, LEFT * SCALE)
        .set_label_area_size(LabelAreaPosition::Bottom, AXIS * SCALE)
        .build_cartesian_2d(errors.log_scale(), times.log_scale())?;
    let power = |value: &f64| power_of_ten(value.log10().round() as i32);
    chart
        .configure_mesh()
        .max_light_lines(0)
        .x_labels(9)
        .y_labels(8)
        .bold_line_style(GRID.stroke_width(SCALE as u32))
        .axis_style(AXES.stroke_width(SCALE as u32))
        .label_style(font(11.0, MUTED))
        .axis_desc_style(font(12.0, MUTED))
        .x_desc(&panel.horizontal)
        .y_desc(&picture.vertical)
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .set_all_tick_mark_size(4 * SCALE)
        .draw()?;
    let (named, pale): (Vec<_>, Vec<_>) = panel
        .curves
        .iter()
        .partition(|curve| !curve.label.is_empty());
    for curve in pale.into_iter().chain(named) {
        let place = labels.iter().position(|label| *label == curve.label);
        let color = place.map_or(BANDS, colour);
        for piece in pieces(&curve.points) {
            let line = color.mix(OPACITY).stroke_width(STROKE);
            chart.draw_series(LineSeries::new(piece.iter().copied(), line))?;
            if place.is_some() {
                let points = piece.iter();
                let points = points.map(|&at| Circle::new(at, POINT * SCALE, color.filled()));
                chart.draw_series(points)?;
            }
        }
    }
    Ok(())
}

/// Stretches of points that can be drawn.
fn pieces(points: &[(f64, f64)]) -> impl Iterator<Item = &[(f64, f64)]> {
    let can = |value: f64| value.is_finite() && value > 0.0;
    let pieces = points.split(move |&(x, y)| !(can(x) && can(y)));
    pieces.filter(|piece| !piece.is_empty())
}

/// Colours repeat, should there be too many curves.
fn colour(position: usize) -> RGBColor {
    PALETTE[position % PALETTE.len()]
}

fn draw_entry<'a>(
    label: &str,
    color: RGBColor,
    (left, y): (i32, i32),
    area: &Area<'a>,
) -> Drawn<'a> {
    let right = left + SWATCH_LINE;
    area.draw(&PathElement::new(
        [(left * SCALE, y * SCALE), (right * SCALE, y * SCALE)],
        color.stroke_width(2 * SCALE as u32),
    ))?;
    let middle = Pos::new(HPos::Left, VPos::Center);
    let name = fitted(label, NAME);
    write(area, &name, (right + 6, y), font(12.0, INK).pos(middle))
}
