//! The same runs in other body frames.

use nalgebra::Matrix3;
use nalgebra::Rotation3;
use nalgebra::Vector3;
use residua::description::Variable;
use residua_models::Entry;
use residua_models::values::size;

use super::Case;
use super::Kind;

/// Euler angles of the frames, in radians: no axis stays where it was.
const FRAMES: [[f64; 3]; 3] = [[0.3, -0.7, 1.1], [2.0, 0.4, -2.5], [-1.2, 1.4, 0.9]];

/// `cases` as they are in other frames, for the models that have a vector. A state that a scene relies on being 0 is turned
/// away from it, and the run refused.
pub fn in_other_frames<'c>(entry: &Entry, cases: impl Iterator<Item = &'c Case>) -> Vec<Case> {
    let description = entry.catalogued.description;
    let (parameters, states) = (description.parameters, description.states);
    if !parameters.iter().chain(states).any(|v| v.rows == 3) {
        return Vec::new();
    }
    let turned = cases.zip(FRAMES.iter().cycle()).map(|(case, angles)| {
        let frame = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        Case {
            kind: Kind::Frame,
            parameters: turned(parameters, &case.parameters, &frame, |tensor| {
                frame * tensor * frame.inverse()
            }),
            start: turned(states, &case.start, &frame, |attitude| {
                attitude * frame.inverse()
            }),
            h: case.h,
        }
    });
    turned.collect()
}

/// Q v of vectors, Q A Qᵀ of the tensors among parameters, R Qᵀ of a state, which is an attitude; the rest as it is.
fn turned(
    variables: &[Variable],
    values: &[f64],
    frame: &Rotation3<f64>,
    matrix: impl Fn(Matrix3<f64>) -> Matrix3<f64>,
) -> Vec<f64> {
    let mut turned = Vec::with_capacity(values.len());
    for variable in variables {
        let own = &values[turned.len()..turned.len() + size(variable)];
        match (variable.rows, variable.cols) {
            (3, 1) => turned.extend((frame * Vector3::from_column_slice(own)).iter()),
            (3, 3) => {
                let matrix = matrix(Matrix3::from_row_slice(own));
                turned.extend(matrix.transpose().iter());
            }
            _ => turned.extend(own),
        }
    }
    turned
}
