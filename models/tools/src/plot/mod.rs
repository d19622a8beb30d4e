//! A run as a picture: panels above each other over one time axis, as SVG.
//!
//! Comes in: a [`Figure`] of curves that are already thinned out. Goes out: the text of an SVG file.

mod axis;
mod logarithmic;

use crate::notation::power_of_ten;
pub use logarithmic::{LogCurve, LogPanel, Logarithmic, logarithmic_svg};

use axis::{common_exponent, extent, padded, short};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// A picture.
pub struct Figure {
    /// Large, above everything; empty for a picture without a header.
    pub title: String,
    /// Small, below the title.
    pub subtitle: String,
    /// Label of the time axis.
    pub time: String,
    /// From top to bottom.
    pub panels: Vec<Panel>,
    /// Width of the picture, px.
    pub width: i32,
}

/// Curves of one unit.
pub struct Panel {
    /// What the panel shows: `ω`, `drift of energy`.
    pub title: String,
    /// Its unit, `1` for none.
    pub unit: String,
    /// In legend order.
    pub curves: Vec<Curve>,
    /// The least range of its axis: what varies less is shown as flat as it is. 0 for any.
    pub least_range: f64,
}

/// One component over time.
pub struct Curve {
    /// Its name in the legend; without one it is left out there.
    pub label: String,
    /// What the others are compared with: drawn as a pale band below them.
    pub reference: bool,
    /// (t, value), all finite.
    pub points: Vec<(f64, f64)>,
}

/// Backend units per pixel: plotters rounds coordinates to integers, which would show as steps.
const SCALE: i32 = 10;
/// Width of a picture that stands by itself, px.
pub const WIDTH: i32 = 960;
/// Height of the title, px.
const HEADER: i32 = 62;
/// Height of a panel, px.
const PANEL: i32 = 148;
/// Space above the curves of a panel for its title, px.
const CAPTION: i32 = 26;
/// Height of the time axis below the last panel, px.
const AXIS: i32 = 46;
/// Space left of the curves for the values, px.
const LEFT: i32 = 64;
/// Least and most space right of the curves for the legend, px.
const RIGHT: (i32, i32) = (104, 260);
/// Space right of the curves where the legend is above them: half of the last number of the axis, px.
const EDGE: i32 = 16;
/// Length of the line before a name in the legend, px.
const SWATCH_LINE: i32 = 22;
/// Space that it takes with its margins, px.
const SWATCH: i32 = SWATCH_LINE + 26;
/// Width of a letter in the legend, on the safe side, px.
const LETTER: i32 = 7;

/// Width of a curve, [backend units].
const STROKE: u32 = 13;
/// Width of the band of a reference, [backend units].
const BAND: u32 = 44;
/// Of a curve, so that those below show through where long runs leave no gaps.
const OPACITY: f64 = 0.85;

/// The reader's own interface font, as the picture is looked at in browsers.
const FONTS: &str = "system-ui, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";

const PAPER: RGBColor = RGBColor(252, 252, 250);
const INK: RGBColor = RGBColor(38, 43, 49);
const MUTED: RGBColor = RGBColor(108, 115, 123);
const GRID: RGBColor = RGBColor(229, 229, 224);
const AXES: RGBColor = RGBColor(158, 164, 170);
const BANDS: RGBColor = RGBColor(201, 205, 210);

/// Colours of the curves of a panel, told apart by hue and lightness.
const PALETTE: [RGBColor; 9] = [
    RGBColor(41, 98, 168),
    RGBColor(214, 118, 30),
    RGBColor(52, 140, 92),
    RGBColor(188, 62, 66),
    RGBColor(126, 92, 168),
    RGBColor(30, 146, 160),
    RGBColor(140, 102, 60),
    RGBColor(200, 106, 160),
    RGBColor(110, 118, 128),
];

/// Dashes of curves that may lie on each other, [backend units].
const DASHES: [&str; 4] = ["none", "70 50", "20 35", "110 35 20 35"];

/// Curves that a panel has room for.
pub const MAX_CURVES: usize = PALETTE.len();

/// Style rules that give the colours of pictures inside an element of class `plot` to the variables
/// `--ink`, `--muted`, `--grid`, `--axis`, `--band` and `--curve-1`, `--curve-2`, … of a page, so that they
/// follow its light or dark scheme.
pub fn recolouring() -> String {
    let named = [
        (INK, "ink"),
        (MUTED, "muted"),
        (GRID, "grid"),
        (AXES, "axis"),
        (BANDS, "band"),
    ];
    let fixed = named
        .into_iter()
        .map(|(color, name)| (color, name.to_owned()));
    let curves = PALETTE
        .into_iter()
        .zip(1..)
        .map(|(color, i)| (color, format!("curve-{i}")));
    let mut rules = format!(".plot [fill=\"{}\"]{{fill:none}}\n", hex(PAPER));
    for (color, name) in fixed.chain(curves) {
        let hex = hex(color);
        rules += &format!(".plot [fill=\"{hex}\"]{{fill:var(--{name})}}\n");
        rules += &format!(".plot [stroke=\"{hex}\"]{{stroke:var(--{name})}}\n");
    }
    for (color, dashes) in PALETTE.into_iter().zip(DASHES) {
        let hex = hex(color);
        rules += &format!(".overlay polyline[stroke=\"{hex}\"]{{stroke-dasharray:{dashes}}}\n");
    }
    rules
}

/// As plotters writes it.
fn hex(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}

/// The picture as the text of an SVG file.
pub fn svg(figure: &Figure) -> Result<String, String> {
    let width = figure.width;
    let height = header_height(figure) + PANEL * figure.panels.len() as i32 + AXIS;
    let size = ((width * SCALE) as u32, (height * SCALE) as u32);
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(figure, &root).map_err(|error| error.to_string())?;
        root.present().map_err(|error| error.to_string())?;
    }
    let drawn = format!(r#"width="{}" height="{}""#, size.0, size.1);
    let shown = format!(r#"width="{width}" height="{height}""#);
    Ok(text.replacen(&drawn, &shown, 1))
}

fn header_height(figure: &Figure) -> i32 {
    if figure.title.is_empty() { 0 } else { HEADER }
}

/// What all panels share.
struct Frame {
    /// Of the picture, px.
    width: i32,
    start: f64,
    end: f64,
    /// Space right of the curves, px.
    right: i32,
    /// Where the names of the curves are.
    legend: Legend,
}

#[derive(Clone, Copy)]
enum Legend {
    Right,
    Above,
}

impl Frame {
    fn around(figure: &Figure) -> Self {
        let panels = &figure.panels;
        let (start, end) = extent(panels.iter().flat_map(|panel| &panel.curves), |p| p.0);
        let named = panels.iter().filter(|panel| panel.curves.len() > 1);
        let lengths = named
            .flat_map(|panel| &panel.curves)
            .map(|curve| curve.label.chars().count() as i32);
        let (least, most) = RIGHT;
        let beside = (SWATCH + LETTER * lengths.max().unwrap_or(0)).clamp(least, most);
        let (legend, right) = match figure.title.is_empty() {
            true => (Legend::Above, EDGE),
            false => (Legend::Right, beside),
        };
        Self {
            width: figure.width,
            start,
            end: if end > start { end } else { start + 1.0 },
            right,
            legend,
        }
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(figure: &Figure, root: &Area<'a>) -> Drawn<'a> {
    root.fill(&PAPER)?;
    let header_height = header_height(figure);
    let (header, body) = root.split_vertically(header_height * SCALE);
    if header_height > 0 {
        write(&header, &figure.title, (22, 16), bold(17.0, INK))?;
        write(&header, &figure.subtitle, (22, 40), font(12.0, MUTED))?;
    }
    let frame = Frame::around(figure);
    let mut rest = body;
    for (i, panel) in figure.panels.iter().enumerate() {
        let last = i + 1 == figure.panels.len();
        let height = if last { PANEL + AXIS } else { PANEL };
        let (area, below) = rest.split_vertically(height * SCALE);
        rest = below;
        draw_panel(panel, &frame, last.then_some(figure.time.as_str()), &area)?;
    }
    Ok(())
}

fn draw_panel<'a>(panel: &Panel, frame: &Frame, time: Option<&str>, area: &Area<'a>) -> Drawn<'a> {
    let (low, high) = padded(extent(&panel.curves, |p| p.1), panel.least_range);
    let exponent = common_exponent(low, high);
    // plotters finds no good ticks for numbers like 1e-16, so it gets numbers of ordinary size.
    let scale = 10f64.powi(exponent);
    draw_caption(panel, exponent, area)?;
    draw_legend(panel, exponent, frame, area)?;
    let mut chart = ChartBuilder::on(area)
        .margin_top(CAPTION * SCALE)
        .margin_right(frame.right * SCALE)
        .set_label_area_size(LabelAreaPosition::Left, LEFT * SCALE)
        .set_label_area_size(
            LabelAreaPosition::Bottom,
            if time.is_some() { AXIS * SCALE } else { 0 },
        )
        .build_cartesian_2d(frame.start..frame.end, low / scale..high / scale)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .y_max_light_lines(0)
        .y_labels(5)
        .x_labels(11)
        .bold_line_style(GRID.stroke_width(SCALE as u32))
        .axis_style(AXES.stroke_width(SCALE as u32))
        .label_style(font(11.0, MUTED))
        .axis_desc_style(font(12.0, MUTED))
        .x_desc(time.unwrap_or_default())
        .x_label_formatter(&|value| short(*value))
        .y_label_formatter(&|value| short(*value))
        .set_all_tick_mark_size(4 * SCALE)
        .draw()?;
    for (curve, style) in styled(panel) {
        let points = curve.points.iter().map(|&(t, value)| (t, value / scale));
        chart.draw_series(LineSeries::new(points, style))?;
    }
    Ok(())
}

/// The curves of a panel, references first, each with its line.
fn styled(panel: &Panel) -> impl Iterator<Item = (&Curve, ShapeStyle)> {
    let (references, others): (Vec<_>, Vec<_>) =
        panel.curves.iter().partition(|curve| curve.reference);
    let band = |curve| (curve, BANDS.stroke_width(BAND));
    let line = |(curve, color): (_, RGBColor)| (curve, color.mix(OPACITY).stroke_width(STROKE));
    let lines = others.into_iter().zip(PALETTE).map(line);
    references.into_iter().map(band).chain(lines)
}

/// The title of a panel on its upper edge.
fn draw_caption<'a>(panel: &Panel, exponent: i32, area: &Area<'a>) -> Drawn<'a> {
    write(area, &caption(panel, exponent), (LEFT, 8), bold(12.5, INK))
}

fn caption(panel: &Panel, exponent: i32) -> String {
    let unit = match (exponent, panel.unit.as_str()) {
        (0, "1") => String::new(),
        (0, unit) => format!("[{unit}]"),
        (_, "1") => format!("[{}]", power_of_ten(exponent)),
        (_, unit) => format!("[{} {unit}]", power_of_ten(exponent)),
    };
    format!("{}  {unit}", panel.title).trim_end().to_owned()
}

/// The names of the curves, if there is more than one: on the right of a panel, or on its upper edge in a
/// picture without a header.
fn draw_legend<'a>(panel: &Panel, exponent: i32, frame: &Frame, area: &Area<'a>) -> Drawn<'a> {
    if panel.curves.len() < 2 {
        return Ok(());
    }
    let named: Vec<_> = styled(panel)
        .filter(|(curve, _)| !curve.label.is_empty())
        .collect();
    let pitch = if panel.curves.len() > 6 { 13 } else { 17 };
    let width = |curve: &Curve| SWATCH + LETTER * curve.label.chars().count() as i32;
    let caption = caption(panel, exponent);
    let mut place = match frame.legend {
        Legend::Right => (frame.width - frame.right + 14, CAPTION + 8),
        Legend::Above => (LEFT + SWATCH + LETTER * caption.chars().count() as i32, 14),
    };
    for (curve, style) in named {
        draw_name(curve, style, place, area)?;
        match frame.legend {
            Legend::Right => place.1 += pitch,
            Legend::Above => place.0 += width(curve),
        }
    }
    Ok(())
}

fn draw_name<'a>(
    curve: &Curve,
    style: ShapeStyle,
    (left, y): (i32, i32),
    area: &Area<'a>,
) -> Drawn<'a> {
    let right = left + SWATCH_LINE;
    let stroke = style.stroke_width.max(2 * SCALE as u32);
    area.draw(&PathElement::new(
        [(left * SCALE, y * SCALE), (right * SCALE, y * SCALE)],
        style.stroke_width(stroke),
    ))?;
    let middle = Pos::new(HPos::Left, VPos::Center);
    let text = font(12.0, INK).pos(middle);
    write(area, &fitted(&curve.label, RIGHT.1), (right + 6, y), text)
}

/// The name as long as fits behind its line into so many px, with `…` for its middle: components differ at the end.
fn fitted(name: &str, space: i32) -> String {
    let most = ((space - SWATCH) / LETTER) as usize;
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= most {
        return name.to_owned();
    }
    let (head, tail) = (most / 2, most - most / 2 - 1);
    let parts = [&letters[..head], &['…'], &letters[letters.len() - tail..]];
    parts.concat().iter().collect()
}

fn write<'a>(area: &Area<'a>, text: &str, (x, y): (i32, i32), style: TextStyle<'_>) -> Drawn<'a> {
    area.draw(&Text::new(text, (x * SCALE, y * SCALE), style))
}

/// Text of `size` px.
fn font(size: f64, color: RGBColor) -> TextStyle<'static> {
    typeface(size).color(&color)
}

fn bold(size: f64, color: RGBColor) -> TextStyle<'static> {
    typeface(size).style(FontStyle::Bold).color(&color)
}

/// The factor undoes the conversion of plotters' SVG backend.
fn typeface(size: f64) -> FontDesc<'static> {
    (FONTS, size * 1.24 * f64::from(SCALE)).into_font()
}

#[cfg(test)]
mod tests {
    use super::{LETTER, SWATCH, fitted};

    #[test]
    fn long_names_lose_their_middle() {
        let space = SWATCH + 9 * LETTER;
        assert_eq!(fitted("momentum", space), "momentum");
        assert_eq!(fitted("momenta(1)", space), "mome…a(1)");
        assert_eq!(fitted("Überlänge(12)", space), "Über…(12)");
    }
}
