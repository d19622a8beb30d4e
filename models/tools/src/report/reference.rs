//! The paper's "standard results": the exact solutions of its two scenes.
//!
//! The 3D scene is as planar as the other. Its inertia is a multiple of the identity and it starts from
//! rest, so that ω̇ = (m g/J) ρ × Γ stays along n = ρ × Γ(0)/|ρ × Γ(0)|: the body swings about the fixed
//! axis n, and its tilt ψ from the vertical obeys J ψ̈ = −m g |ρ| sin ψ. With φ = ψ(0) − ψ,
//! ω = φ̇ n, Γᵢ(t) = exp(−φ S(n)) Γᵢ(0).

use super::runs::Recording;
use super::runs::RunError;
use super::runs::Wanted;
use residua_models::exact::PlanarPendulum;
use residua_models::exact::PlanarState;

/// A pendulum in the plane: J θ̈ = −m g l sin θ.
#[derive(Clone, Copy)]
pub struct Planar {
    /// Moment of inertia about the pivot, kg·m².
    pub inertia: f64,
    /// m g l, N·m.
    pub torque: f64,
    /// θ at the start, rad.
    pub angle: f64,
    /// ω at the start, rad/s.
    pub velocity: f64,
}

impl Planar {
    /// The paper's planar scene, as its model file has it.
    pub fn paper() -> Result<Self, RunError> {
        let (parameters, start) = scene("planar_angle")?;
        match (&parameters[..], &start[..]) {
            (&[m, inertia, l, g], &[velocity, angle]) => Ok(Self {
                inertia,
                torque: m * g * l,
                angle,
                velocity,
            }),
            _ => Err(RunError::Column("m, J, l, g; ω, θ".to_owned())),
        }
    }

    /// The largest angle A of a swing with this energy: E + m g l = 2 m g l sin²(A/2).
    pub fn amplitude(&self, energy: f64) -> f64 {
        let share = (energy + self.torque) / (2.0 * self.torque);
        2.0 * share.clamp(0.0, 1.0).sqrt().asin()
    }

    /// (θ, ω) at these times.
    fn states(&self, times: &[f64]) -> Result<Vec<(f64, f64)>, RunError> {
        // The equation has the torque m g l only.
        let (m, l, g) = (self.torque, 1.0, 1.0);
        let pendulum = PlanarPendulum::new(m, self.inertia, l, g, self.angle, self.velocity)?;
        let state = |t: &f64| {
            let PlanarState { theta, omega } = pendulum.at(*t);
            (theta, omega)
        };
        Ok(times.iter().map(state).collect())
    }
}

/// The 3D scene as a swing in a plane.
#[derive(Clone, Copy)]
pub struct Spatial {
    /// The swing, in the tilt ψ.
    pub swing: Planar,
    /// Its plane.
    pub plane: Plane,
    /// The rows of R at the start.
    pub rows: [[f64; 3]; 3],
}

/// The plane of a swing from rest, in the body frame.
#[derive(Clone, Copy)]
pub struct Plane {
    /// n, the axis of the swing.
    pub axis: [f64; 3],
    /// Where ψ counts to, horizontally: Γ(0) = cos ψ(0) e₃ + sin ψ(0) `side`.
    pub side: [f64; 3],
}

impl Plane {
    /// Of a swing that starts with this Γ, which is not along e₃.
    pub fn of(vertical: [f64; 3]) -> Self {
        let horizontal = vertical[0].hypot(vertical[1]);
        let side = [vertical[0] / horizontal, vertical[1] / horizontal, 0.0];
        Self {
            axis: [-side[1], side[0], 0.0],
            side,
        }
    }

    /// (ψ, ψ̇) of a body with this vertical and angular velocity.
    pub fn tilt(&self, vertical: [f64; 3], omega: [f64; 3]) -> (f64, f64) {
        let angle = dot(vertical, self.side).atan2(vertical[2]);
        (angle, -dot(omega, self.axis))
    }
}

impl Spatial {
    /// The paper's 3D scene, as its model file has it.
    pub fn paper() -> Result<Self, RunError> {
        let (parameters, start) = scene("spatial_group")?;
        let (&[m, inertia, ..], &[_, _, length, g], &[_, _, _, ref rows @ ..]) = (
            &parameters[..],
            &parameters[parameters.len() - 4..],
            &start[..],
        ) else {
            return Err(RunError::Column("m, J, ρ, g; ω, Γ1, Γ2, Γ3".to_owned()));
        };
        let row = |i: usize| [rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]];
        let vertical = row(2);
        let horizontal = vertical[0].hypot(vertical[1]);
        Ok(Self {
            swing: Planar {
                inertia,
                torque: m * g * length,
                angle: horizontal.atan2(vertical[2]),
                velocity: 0.0,
            },
            plane: Plane::of(vertical),
            rows: [row(0), row(1), row(2)],
        })
    }

    /// Γ turned back by the body's turn φ about n.
    fn turned(&self, row: [f64; 3], turn: f64) -> [f64; 3] {
        let n = self.plane.axis;
        let (sin, cos) = turn.sin_cos();
        let along = dot(n, row) * (1.0 - cos);
        let across = cross(n, row);
        [0, 1, 2].map(|i| cos * row[i] - sin * across[i] + along * n[i])
    }
}

/// The exact solution of a model's scene at the times of a run.
pub fn reference(wanted: &Wanted) -> Result<Recording, RunError> {
    let times: Vec<f64> = (0..=wanted.steps())
        .map(|k| k as f64 * wanted.step)
        .collect();
    let (columns, rows): (&[&str], Vec<Vec<f64>>) = if wanted.is_planar() {
        let states = Planar::paper()?.states(&times)?;
        let row = |(angle, velocity): (f64, f64)| vec![velocity, angle];
        (&["ω", "θ"], states.into_iter().map(row).collect())
    } else {
        (SPATIAL, spatial_rows(&times)?)
    };
    Ok(Recording {
        columns: columns.iter().map(ToString::to_string).collect(),
        times,
        rows,
        iterations: 0.0,
        failure: None,
    })
}

/// Columns of the exact 3D solution; the vertical has the names that the models give it.
const SPATIAL: &[&str] = &[
    "ω.x",
    "ω.y",
    "ω.z",
    "Γ1.x",
    "Γ1.y",
    "Γ1.z",
    "Γ2.x",
    "Γ2.y",
    "Γ2.z",
    "Γ3.x",
    "Γ3.y",
    "Γ3.z",
    "Γ.x",
    "Γ.y",
    "Γ.z",
    "vertical.x",
    "vertical.y",
    "vertical.z",
    "θx",
    "θy",
    "θz",
];

fn spatial_rows(times: &[f64]) -> Result<Vec<Vec<f64>>, RunError> {
    let scene = Spatial::paper()?;
    let mut turns = [0.0; 3];
    let row = |(angle, velocity): (f64, f64)| {
        let turn = scene.swing.angle - angle;
        let omega = scene.plane.axis.map(|n| -velocity * n);
        let rows = scene.rows.map(|row| scene.turned(row, turn));
        turns = near(cardan(&rows), turns);
        let vertical = rows[2];
        let parts = [omega, rows[0], rows[1], rows[2], vertical, vertical, turns];
        parts.concat()
    };
    let states = scene.swing.states(times)?;
    Ok(states.into_iter().map(row).collect())
}

/// The angles of R = Rx(θx) Ry(θy) Rz(θz) with these rows.
fn cardan([x, y, z]: &[[f64; 3]; 3]) -> [f64; 3] {
    let about_y = x[2].atan2(x[0].hypot(x[1]));
    [(-y[2]).atan2(z[2]), about_y, (-x[1]).atan2(x[0])]
}

/// The angles less whole turns that bring them near to others.
fn near(angles: [f64; 3], others: [f64; 3]) -> [f64; 3] {
    let turn = std::f64::consts::TAU;
    [0, 1, 2].map(|i| angles[i] - turn * ((angles[i] - others[i]) / turn).round())
}

/// Default parameters and start of a model.
fn scene(model: &str) -> Result<(Vec<f64>, Vec<f64>), RunError> {
    let model = residua_models::find(model)?.catalogued;
    let parameters = residua_models::values::defaults(model);
    let start = residua_models::values::start(model, &parameters);
    Ok((parameters, start))
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
