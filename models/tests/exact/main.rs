//! The exact motions, against digits computed elsewhere and against what they must keep.

mod double;
mod free_body;
mod planar;
mod spatial;

use serde_json::Value;

/// States of thirty digits, shared with the tests of the models.
static REFERENCE: &str = include_str!("../../../tests/data/reference.json");

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn text(value: &Value) -> &str {
    value.as_str().expect("a string")
}
