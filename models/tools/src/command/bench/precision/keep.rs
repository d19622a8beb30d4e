//! Table, picture and description of a work–precision diagram, as files.

use crate::failure::Failure;
use crate::plot::logarithmic_svg;
use residua_models::find;
use residua_tools::precision::{Problem, Row, picture, write};
use serde_json::{Map, Value, json};
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::Path;

/// Writes what was measured.
pub(super) fn keep(problem: &Problem, rows: &[Row], folder: &Path) -> Result<(), Failure> {
    let path = |ending: &str| folder.join(format!("{}.{ending}", problem.name));
    let csv = path("csv");
    let file = File::create(&csv).map_err(|error| Failure::file("write", &csv, &error))?;
    let written = write(rows, BufWriter::new(file));
    written.map_err(|error| Failure::Run(format!("cannot write {}: {error}", csv.display())))?;
    let svg = logarithmic_svg(&picture(problem, rows)).map_err(Failure::Run)?;
    let json = format!("{:#}\n", described(problem));
    for (path, text) in [(path("svg"), svg), (path("json"), json)] {
        fs::write(&path, text).map_err(|error| Failure::file("write", &path, &error))?;
    }
    Ok(())
}

/// The motion, for other programs that want to take part.
fn described(problem: &Problem) -> Value {
    let case = &problem.reference;
    let description = case.model.description;
    let ascii = |name: &str| {
        let scene = description.scene.and_then(|scene| find(scene.model).ok());
        let whole = scene.map_or(case.model, |entry| entry.catalogued);
        let mut parameters = whole.description.parameters.iter();
        let found = parameters.find(|parameter| parameter.name == name);
        found.map_or(name, |parameter| parameter.ascii).to_owned()
    };
    let record = |variables: &'static [residua::description::Variable], values: &[f64]| {
        let mut rest = values;
        let mut record = Map::new();
        for variable in variables {
            let (own, others) = rest.split_at(variable.rows * variable.cols);
            rest = others;
            record.insert(variable.ascii.to_owned(), json!(own));
        }
        record
    };
    // What a scene folds in is a parameter to others.
    let mut parameters = record(description.parameters, &case.parameters);
    for fixed in description.scene.iter().flat_map(|scene| scene.fixed) {
        parameters.insert(ascii(fixed.name), json!(fixed.values));
    }
    json!({
        "scene": problem.name,
        "caption": problem.caption,
        "until": problem.until,
        "model": description.name,
        "parameters": parameters,
        "start": record(description.states, &case.start),
        "end": record(description.states, &problem.exact.state),
        "scales": record(description.states, &problem.scales),
        "uncertainty": problem.exact.error,
    })
}
