//! Reference states of the paper's pendulums, from `tests/data/reference.json`.

use serde_json::Value;

static DATA: &str = include_str!("../data/reference.json");

/// A run whose true states are known.
pub struct Scene {
    /// In the order of the model files.
    pub parameters: Vec<f64>,
    samples: Vec<Truth>,
}

/// The true state at a time.
#[derive(Clone)]
pub struct Truth {
    /// Time, s.
    pub t: f64,
    /// Angular velocity: one number in the plane, three in the body frame, rad/s.
    pub omega: Vec<f64>,
    /// Attitude by rows: 2×2 or 3×3.
    pub attitude: Vec<f64>,
    /// The angle of the planar pendulum, rad; 0 in space.
    pub angle: f64,
}

impl Scene {
    /// The scene `name` of the planar pendulum: `w0_1` or `w0_9p8`.
    pub fn planar(name: &str) -> Self {
        Self::read("planar", name, |sample| {
            let angle = number(&sample["theta"]);
            let (sin, cos) = angle.sin_cos();
            Truth {
                t: number(&sample["t"]),
                omega: vec![number(&sample["omega"])],
                attitude: vec![cos, -sin, sin, cos],
                angle,
            }
        })
    }

    /// The scene `name` of the 3D pendulum: `paper` or `asym_m10`.
    pub fn spatial(name: &str) -> Self {
        Self::read("spatial", name, |sample| Truth {
            t: number(&sample["t"]),
            omega: numbers(&sample["omega"]),
            attitude: list(&sample["R"]).iter().flat_map(numbers).collect(),
            angle: 0.0,
        })
    }

    /// The state at time `t`, which must be one of those on file.
    pub fn truth(&self, t: f64) -> &Truth {
        let found = self.samples.iter().find(|sample| sample.t == t);
        found.unwrap_or_else(|| panic!("no reference state at t = {t}"))
    }

    fn read(kind: &str, name: &str, truth: impl Fn(&Value) -> Truth) -> Self {
        let data: Value = serde_json::from_str(DATA).expect("valid JSON");
        let scene = &data[kind][name];
        Scene {
            parameters: numbers(&scene["parameters"]),
            samples: list(&scene["samples"]).iter().map(truth).collect(),
        }
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// Numbers are decimal strings, longer than f64 reads exactly.
fn number(value: &Value) -> f64 {
    let text = value.as_str().expect("a string");
    text.parse().expect("a number")
}
