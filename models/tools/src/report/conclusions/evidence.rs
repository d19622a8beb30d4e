//! The runs that the conclusions are judged by.

use super::super::measure::Measure;
use super::super::reference::Spatial;
use super::super::reference::reference;
use super::super::runs::Method;
use super::super::runs::RunError;
use super::super::runs::Wanted;
use super::super::schemes::rows;
use crate::notation::rounded;
use crate::study::Found;
use crate::study::Row;
use crate::study::SCENES;
use indicatif::ProgressBar;
use residua_models::exact::PlanarPendulum;

/// Steps in the plane, s; the paper has 0.05 and 0.01.
pub(super) const PLANAR_STEPS: [f64; 4] = [0.1, 0.05, 0.02, 0.01];
/// Steps in space, s; the paper has 0.1, 0.05, 0.01 and, for the Cardan angles, 0.005.
pub(super) const SPATIAL_STEPS: [f64; 5] = [0.1, 0.05, 0.01, 0.005, 0.001];
/// The finer of the paper's steps with Cardan angles, s.
pub(super) const CARDAN_STEP: f64 = 0.005;
/// Ends of the runs, s.
pub(super) const PLANAR_END: f64 = 50.0;
/// As the paper's.
pub(super) const SPATIAL_END: f64 = 100.0;

/// Energy that counts as kept to rounding, as a share of what the swing has above rest: 10⁵ steps collect some
/// hundred ε, and Newton's tolerance adds less than that of a step per step.
pub(super) const KEPT: f64 = 1e-10;

/// The models of the plane, by what the paper calls them.
pub(super) const PLANAR: [(&str, &str); 5] = [
    ("planar_angle", "angle"),
    ("planar_reduced", "reduced attitude"),
    ("planar_recursive", "recursive"),
    ("planar_group", "complete group"),
    ("planar_algebra", "Lie algebra"),
];

/// Those of space.
pub(super) const SPATIAL: [(&str, &str); 4] = [
    ("spatial_recursive", "recursive"),
    ("spatial_reduced", "reduced attitude"),
    ("spatial_group", "complete group"),
    ("spatial_cardan", "Lie algebra (Cardan angles)"),
];

/// The runs that the conclusions are about.
pub(super) struct Evidence {
    pub(super) planar: Vec<Measure>,
    pub(super) runge_kutta: Vec<Measure>,
    pub(super) spatial: Vec<Measure>,
    /// The table of the large swing in the plane.
    pub(super) large: Vec<Row>,
    /// The table of the paper's motion in space.
    pub(super) space: Vec<Row>,
    /// Of the exact swing in space, s.
    pub(super) period: f64,
    /// The largest |θy| of the Cardan run at [`CARDAN_STEP`], degrees.
    pub(super) tilt: f64,
}

impl Evidence {
    pub(super) fn gather(progress: &ProgressBar) -> Result<Self, RunError> {
        let planar = wanted(&PLANAR, &PLANAR_STEPS, PLANAR_END);
        let runge_kutta = PLANAR_STEPS.map(|step| Wanted {
            model: "planar_angle",
            method: Method::RungeKutta4,
            step,
            until: PLANAR_END,
        });
        let spatial = wanted(&SPATIAL, &SPATIAL_STEPS, SPATIAL_END);
        let runs = planar.len() + runge_kutta.len() + spatial.len();
        progress.inc_length(runs as u64);
        let measure = |list: &[Wanted]| {
            let measures = list.iter().map(|run| {
                let measure = Measure::of(run, &run.record()?, &reference(run)?);
                progress.inc(1);
                measure
            });
            measures.collect::<Result<Vec<_>, RunError>>()
        };
        Ok(Self {
            planar: measure(&planar)?,
            runge_kutta: measure(&runge_kutta)?,
            spatial: measure(&spatial)?,
            large: table_of("planar-large")?,
            space: table_of("spatial-paper")?,
            period: swing_period()?,
            tilt: cardan_tilt()?,
        })
    }

    pub(super) fn planar(&self, model: &str, step: f64) -> &Measure {
        pick(&self.planar, model, step)
    }

    pub(super) fn spatial(&self, model: &str, step: f64) -> &Measure {
        pick(&self.spatial, model, step)
    }
}

/// What a scheme of a table does.
pub(super) fn found<'a>(rows: &'a [Row], model: &str) -> &'a Found {
    let row = rows
        .iter()
        .find(|row| row.model == model && row.method != "RK4");
    let found = row.and_then(|row| row.found.as_ref().ok());
    found.expect("the scheme is in the table of the scene")
}

/// The table of a scene of the study.
pub(super) fn table_of(name: &str) -> Result<Vec<Row>, RunError> {
    let scene = SCENES.iter().find(|scene| scene.name == name);
    rows(scene.expect("the scene is in the list"))
}

pub(super) fn wanted(models: &[(&'static str, &str)], steps: &[f64], until: f64) -> Vec<Wanted> {
    let pairs = models
        .iter()
        .flat_map(|(model, _)| steps.iter().map(|step| (*model, *step)));
    let run = |(model, step)| Wanted {
        model,
        method: Method::Newton("increment"),
        step,
        until,
    };
    pairs.map(run).collect()
}

/// The period of the exact swing of the 3D scene, s.
pub(super) fn swing_period() -> Result<f64, RunError> {
    let swing = Spatial::paper()?.swing;
    let pendulum = PlanarPendulum::new(swing.torque, swing.inertia, 1.0, 1.0, swing.angle, 0.0)?;
    Ok(pendulum.period().unwrap_or(f64::INFINITY))
}

/// The largest |θy| of the Cardan angles on the way, degrees; the chart ends at 90.
pub(super) fn cardan_tilt() -> Result<f64, RunError> {
    let run = Wanted {
        model: "spatial_cardan",
        method: Method::Newton("increment"),
        step: CARDAN_STEP,
        until: SPATIAL_END,
    };
    let angles = run.record()?.values("θy")?;
    Ok(largest(angles.into_iter().map(f64::abs)).to_degrees())
}

/// The measure of a run in one of the lists above.
pub(super) fn pick<'a>(list: &'a [Measure], model: &str, step: f64) -> &'a Measure {
    let found = list
        .iter()
        .find(|m| m.run.model == model && m.run.step == step);
    found.expect("the run is in the list of runs to make")
}

pub(super) fn of<'a>(list: &'a [Measure], model: &str) -> Vec<&'a Measure> {
    list.iter().filter(|m| m.run.model == model).collect()
}

pub(super) fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

pub(super) fn percent(share: f64) -> String {
    format!("{} %", rounded(100.0 * share, 2))
}
