//! Motions to study: the paper's two, and harder ones.

use super::case::Case;
use residua::Catalogued;
use residua_models::CATALOGUE;
use residua_models::exact::Invalid;
use residua_models::exact::PlanarPendulum;
use residua_models::exact::SpatialPendulum;
use residua_models::find;

/// A physical system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// The planar pendulum.
    Planar,
    /// A rigid body held at a point.
    Spatial,
}

impl System {
    /// The model whose parameters and state the exact motion is given in.
    pub fn reference(self) -> &'static str {
        match self {
            System::Planar => "planar_angle",
            System::Spatial => "spatial_group",
        }
    }
}

/// A motion of a physical system, to be followed by every model of that system.
pub struct Scene {
    /// One word.
    pub name: &'static str,
    /// What it is.
    pub caption: &'static str,
    /// Whose motion it is.
    pub system: System,
    /// Parameters that differ from the file's: ASCII name and components row by row.
    pub parameters: &'static [(&'static str, &'static [f64])],
    /// Start values of the states that are rates; the attitude is the file's.
    pub rates: &'static [f64],
    /// The step, s.
    pub h: f64,
    /// The end, s.
    pub until: f64,
    /// Whether different signals differ in it: no symmetry, no axis at rest. One scene of each system has that.
    pub generic: bool,
}

/// The planar pendulum of Section 6 with other angular velocities (the separatrix is at 9.9045 rad/s), and
/// the 3D pendulum with other bodies.
pub const SCENES: &[Scene] = &[
    Scene {
        name: "planar-paper",
        caption: "planar, ω₀ = 1 rad/s: the swing of Section 6, 11.6° wide",
        system: System::Planar,
        parameters: &[],
        rates: &[1.0],
        h: 0.01,
        until: 50.0,
        generic: false,
    },
    Scene {
        name: "planar-large",
        caption: "planar, ω₀ = 9.8 rad/s: a swing up to 163°",
        system: System::Planar,
        parameters: &[],
        rates: &[9.8],
        h: 0.01,
        until: 50.0,
        generic: true,
    },
    Scene {
        name: "planar-rotation",
        caption: "planar, ω₀ = 10.5 rad/s: turning over the top",
        system: System::Planar,
        parameters: &[],
        rates: &[10.5],
        h: 0.01,
        until: 50.0,
        generic: false,
    },
    Scene {
        name: "spatial-paper",
        caption: "3D, J = I, ρ = (0, 0, 0.7) m, from rest: the motion of Section 6",
        system: System::Spatial,
        parameters: &[],
        rates: &[0.0, 0.0, 0.0],
        h: 0.01,
        until: 100.0,
        generic: false,
    },
    Scene {
        name: "spatial-asymmetric",
        caption: "3D, J = diag(1, 2.8, 2) kg m², ρ = (0, 0.1, 0.7) m, ω₀ = (0.5, −0.5, 0.4) rad/s",
        system: System::Spatial,
        parameters: &[
            ("J", &[1.0, 0.0, 0.0, 0.0, 2.8, 0.0, 0.0, 0.0, 2.0]),
            ("rho", &[0.0, 0.1, 0.7]),
        ],
        rates: &[0.5, -0.5, 0.4],
        h: 0.005,
        until: 20.0,
        generic: true,
    },
    Scene {
        name: "spatial-top",
        caption: "a fast Lagrange top: J = diag(5.2, 5.2, 0.6) kg m², 100 rad/s about its axis",
        system: System::Spatial,
        parameters: &[("J", &[5.2, 0.0, 0.0, 0.0, 5.2, 0.0, 0.0, 0.0, 0.6])],
        rates: &[0.0, 0.0, 100.0],
        h: 0.001,
        until: 10.0,
        generic: false,
    },
    Scene {
        name: "spatial-free",
        caption: "a free body about its middle axis: g = 0, J = diag(1, 2, 3) kg m², ω₀ = (0.01, 5, 0.01) rad/s",
        system: System::Spatial,
        parameters: &[
            ("J", &[1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0]),
            ("g", &[0.0]),
        ],
        rates: &[0.01, 5.0, 0.01],
        h: 0.005,
        until: 20.0,
        generic: false,
    },
];

impl Scene {
    /// The reference model in this scene.
    ///
    /// # Errors
    /// Where the catalogue has no such model.
    pub fn of_reference(&self) -> Result<Case, residua_models::UnknownModel> {
        Ok(self.set(find(self.system.reference())?.catalogued))
    }

    /// Every model of the system in this scene, in the order of the catalogue: those with the parameters of the
    /// reference.
    pub fn cases(&self) -> Vec<Case> {
        let Ok(reference) = find(self.system.reference()) else {
            return Vec::new();
        };
        let models = CATALOGUE.iter().map(|entry| entry.catalogued);
        let kin = models.filter(|model| are_kin(model, reference.catalogued));
        kin.map(|model| self.set(model)).collect()
    }

    /// The generic scene of the same system.
    pub fn generic(&self) -> &'static Scene {
        let of_system = |scene: &&Scene| scene.generic && scene.system == self.system;
        SCENES.iter().find(of_system).unwrap_or(&SCENES[0])
    }

    /// The exact state of the reference model at the end.
    ///
    /// # Errors
    /// Where there is none for the data of the scene.
    pub fn exact_end(&self, reference: &Case) -> Result<Vec<f64>, Invalid> {
        let Case {
            parameters, start, ..
        } = reference;
        match self.system {
            System::Planar => {
                let [m, j, l, g] = array(parameters);
                let [omega, theta] = array(start);
                let state = PlanarPendulum::new(m, j, l, g, theta, omega)?.at(self.until);
                Ok(vec![state.omega, state.theta])
            }
            System::Spatial => {
                let body = SpatialPendulum {
                    m: parameters[0],
                    j: rows(&parameters[1..10]),
                    rho: array(&parameters[10..13]),
                    g: parameters[13],
                };
                let solution = body.solve(array(&start[..3]), rows(&start[3..]), &[self.until])?;
                let state = solution.states[0];
                Ok([&state.omega, state.attitude.as_flattened()].concat())
            }
        }
    }

    /// Steps of size `h` to the end.
    pub fn steps(&self, h: f64) -> u64 {
        (self.until / h).round() as u64
    }

    /// `model` with the parameters and rates of this scene.
    pub fn set(&self, model: &'static Catalogued) -> Case {
        let mut parameters = Case::of_file(model).parameters;
        let mut offset = 0;
        for variable in model.description.parameters {
            let n = variable.rows * variable.cols;
            let given = self.parameters.iter().find(|p| p.0 == variable.ascii);
            if let Some((_, values)) = given {
                parameters[offset..offset + n].copy_from_slice(values);
            }
            offset += n;
        }
        Case::with_parameters(model, parameters).with_rates(self.rates)
    }
}

fn array<const N: usize>(values: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| values[i])
}

fn rows(values: &[f64]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| array(&values[3 * i..3 * i + 3]))
}

/// The same parameters, in name, shape and unit.
pub fn are_kin(one: &Catalogued, other: &Catalogued) -> bool {
    let list = |model: &Catalogued| {
        let parameters = model.description.parameters.iter();
        let list = parameters.map(|p| (p.ascii, p.rows, p.cols, p.unit));
        list.collect::<Vec<_>>()
    };
    list(one) == list(other)
}
