//! The same runs in other units: grams, kilometres, hours, or near enough.

use num_rational::Ratio;
use residua_codegen::analyse;
use residua_codegen::source::read_source;
use residua_codegen::unit::Unit;
use residua_models::Entry;

use super::Case;
use super::Kind;

/// Powers of two that the numbers of kilograms, metres and seconds are multiplied by.
const SCALES: [[i32; 3]; 4] = [[10, 0, 0], [0, -10, 0], [0, 0, 12], [-14, 7, -9]];

/// `cases` as they are in other units; none of a scene, the constants of which are in the units of its file.
pub fn in_other_units<'c>(entry: &Entry, cases: impl Iterator<Item = &'c Case>) -> Vec<Case> {
    let Some((parameters, states)) = units(entry) else {
        return Vec::new();
    };
    let scaled = cases.zip(SCALES.iter().cycle()).map(|(case, scales)| {
        let convert = |values: &[f64], units: &[Unit]| {
            let pairs = values.iter().zip(units);
            pairs.map(|(x, unit)| x * factor(unit, scales)).collect()
        };
        Case {
            kind: Kind::Units,
            parameters: convert(&case.parameters, &parameters),
            start: convert(&case.start, &states),
            h: case.h * f64::powi(2.0, scales[2]),
        }
    });
    scaled.collect()
}

/// The units of all components of the parameters and the states.
fn units(entry: &Entry) -> Option<(Vec<Unit>, Vec<Unit>)> {
    if entry.catalogued.description.scene.is_some() {
        return None;
    }
    let tokens = read_source(entry.source.as_bytes()).ok()?;
    let model = analyse(entry.name(), tokens).ok()?.model;
    let parameters = model.parameters.iter().map(|p| &p.variable);
    let states = model.states.iter().map(|s| &s.variable);
    let repeated =
        |v: &residua_codegen::model::Variable| core::iter::repeat_n(v.unit, v.shape.len());
    Some((
        parameters.flat_map(repeated).collect(),
        states.flat_map(repeated).collect(),
    ))
}

/// What a number in `unit` is multiplied by.
fn factor(unit: &Unit, scales: &[i32; 3]) -> f64 {
    let pairs = unit.exponents.iter().zip(scales);
    let power: Ratio<i32> = pairs.map(|(exponent, scale)| exponent * scale).sum();
    f64::powf(2.0, f64::from(*power.numer()) / f64::from(*power.denom()))
}
