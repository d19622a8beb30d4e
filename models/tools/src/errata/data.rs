//! Do bodies with the masses, lengths and moments of inertia of a model's defaults exist?
//!
//! About the pivot the inertia is that about the centre of mass and m(ρᵀρ I − ρρᵀ) besides (Huygens and
//! Steiner); in the plane, J = J_C + m l². So J less the second part has no negative eigenvalue.

use nalgebra::Matrix3;
use nalgebra::Vector3;
use residua::Catalogued;
use serde::Serialize;

/// The inertia of a rigid pendulum, as its default parameters give it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Body {
    /// The model.
    pub model: &'static str,
    /// Smallest moment of inertia about the pivot, kg·m².
    pub pivot: f64,
    /// What the offset of the centre of mass alone makes of it about the same axis: m l², kg·m².
    pub offset: f64,
    /// Smallest moment of inertia about the centre of mass that is left, kg·m².
    pub central: f64,
}

impl Body {
    /// No moment of inertia is negative.
    pub fn exists(&self) -> bool {
        self.central >= 0.0
    }
}

/// The body of a model with the parameters m, J and l or rho; `None` for other models.
pub fn body(model: &'static Catalogued) -> Option<Body> {
    let mut defaults = vec![
        0.0;
        model
            .description
            .parameters
            .iter()
            .map(|p| p.rows * p.cols)
            .sum()
    ];
    model.model.defaults(&mut defaults);
    let find = |name: &str| {
        let mut offset = 0;
        for parameter in model.description.parameters {
            let len = parameter.rows * parameter.cols;
            if parameter.ascii == name {
                return Some(&defaults[offset..offset + len]);
            }
            offset += len;
        }
        None
    };
    let m = find("m")?.first().copied()?;
    let name = model.description.name;
    match (find("J")?, find("l"), find("rho")) {
        (&[j], Some(&[l]), None) => Some(Body {
            model: name,
            pivot: j,
            offset: m * l * l,
            central: j - m * l * l,
        }),
        (j, None, Some(rho)) if j.len() == 9 && rho.len() == 3 => {
            let (j, rho) = (Matrix3::from_row_slice(j), Vector3::from_row_slice(rho));
            let steiner = (Matrix3::identity() * rho.norm_squared() - rho * rho.transpose()) * m;
            let central = (j - steiner).symmetric_eigen();
            let axis = central
                .eigenvectors
                .column(central.eigenvalues.imin())
                .into_owned();
            Some(Body {
                model: name,
                pivot: axis.dot(&(j * axis)),
                offset: axis.dot(&(steiner * axis)),
                central: central.eigenvalues.min(),
            })
        }
        _ => None,
    }
}
