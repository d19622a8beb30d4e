//! The data of Section 6: what they describe, and what is not given.

use super::part;
use crate::errata::data::Body;
use crate::errata::data::body;
use crate::notation::rounded;
use crate::report::page::Block;
use crate::report::page::Cell;
use crate::report::page::Data;
use crate::report::page::Section;
use crate::report::page::Table;
use crate::report::reference::Planar;
use crate::report::runs::RunError;
use residua_models::CATALOGUE;

/// The part.
pub(super) fn section() -> Result<Section, RunError> {
    let mut data = Data::new(&[
        "model",
        "J [kg m²]",
        "m l² [kg m²]",
        "J − m l² [kg m²]",
        "such a body",
    ]);
    let bodies: Vec<Body> = CATALOGUE
        .iter()
        .filter_map(|e| body(e.catalogued))
        .collect();
    for body in &bodies {
        data.row([
            Cell::Code(body.model.to_owned()),
            Cell::given(body.pivot),
            Cell::given(body.offset),
            Cell::given(body.central),
            match body.exists() {
                true => "exists",
                false => "does not exist",
            }
            .into(),
        ]);
    }
    let mut blocks = vec![Block::Text(
        "About the pivot the moment of inertia of a body is at least m l², the part of its centre of mass (Steiner). \
         What is left about the centre of mass must not be negative. In space the table has the axis with the least \
         left."
            .to_owned(),
    )];
    let planar = bodies.iter().find(|body| body.model == "planar_angle");
    if let Some(body) = planar {
        blocks.push(Block::Text(reading(body)?));
    }
    blocks.push(Block::Table(Table {
        csv: "errata-data".to_owned(),
        caption: "The data of Section 6, read so that J is about the pivot and l ends at the centre of mass.".to_owned(),
        data,
    }));
    blocks.push(Block::Text("What the paper does not give:".to_owned()));
    let missing = [
        "g; 9.81 m/s² here",
        "ε of Eq. 30, when Newton’s method stops",
        "h of Figures 5 to 11 and 16, that of Runge–Kutta 4 among them",
        "what the “standard results” are; exact solutions here",
    ];
    blocks.push(Block::List(missing.map(str::to_owned).into()));
    Ok(part("data", "The data of Section 6", blocks))
}

/// On what the verdict rests.
fn reading(body: &Body) -> Result<String, RunError> {
    let Planar {
        inertia, torque, ..
    } = Planar::paper()?;
    let both = inertia + body.offset;
    let half = body.offset / 4.0;
    Ok(format!(
        "In the plane this rests on a reading: the “length of the pendulum” as the distance l from the pivot to the centre of \
         mass, as l is above Eq. 38. Were it the length of a uniform rod, l would be half of it and m l² = {} kg m², less than \
         J: that body exists, but then all figures have half the torque. If J is about the centre of mass instead, as the \
         subscript of J_C in Section 5 suggests, J + m l² = {} kg m² belongs into an equation of moments about the pivot, and \
         the frequency of small swings is {} 1/s, not {} 1/s. In space ρ is called the position of the centre of mass; what is \
         too small is Jx and Jy, since ρ lies along z and adds nothing to Jz.",
        rounded(half, 2),
        rounded(both, 3),
        rounded((torque / both).sqrt(), 3),
        rounded((torque / inertia).sqrt(), 3)
    ))
}
