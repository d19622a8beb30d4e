//! Ranges of axes and the numbers on them.

use super::Curve;

/// Smallest and largest coordinate of all curves, (0, 1) if there is none.
pub fn extent<'c>(
    curves: impl IntoIterator<Item = &'c Curve>,
    coordinate: impl Fn(&(f64, f64)) -> f64,
) -> (f64, f64) {
    let values = curves
        .into_iter()
        .flat_map(|curve| curve.points.iter().map(&coordinate));
    let bounds = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if bounds.0 <= bounds.1 {
        bounds
    } else {
        (0.0, 1.0)
    }
}

/// The range of an axis around its values, never empty and at least so large.
pub fn padded((low, high): (f64, f64), least: f64) -> (f64, f64) {
    let magnitude = low.abs().max(high.abs());
    // Below this share of its size a variation is rounding, and magnifying it would mislead.
    let flat = 1e-9 * magnitude;
    match high - low {
        height if height < least => {
            let middle = low + 0.5 * height;
            (middle - 0.5 * least, middle + 0.5 * least)
        }
        _ if magnitude == 0.0 => (-1.0, 1.0),
        height if height <= flat => (low - 0.5 * magnitude, high + 0.5 * magnitude),
        height => (low - 0.08 * height, high + 0.08 * height),
    }
}

/// The power of ten that the values of an axis share, 0 where they read well as they are.
pub fn common_exponent(low: f64, high: f64) -> i32 {
    let exponent = low
        .abs()
        .max(high.abs())
        .log10()
        .floor()
        .clamp(-300.0, 300.0) as i32;
    if (-2..=3).contains(&exponent) {
        0
    } else {
        exponent
    }
}

/// A tick value without the noise of binary fractions.
pub fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" => "0".to_owned(),
        _ => text.replace('-', "−"),
    }
}
