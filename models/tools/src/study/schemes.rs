//! Every scheme against the exact motion.

use super::case::Case;
use super::method::Method;
use super::piece::Piece;
use super::scene::Scene;
use super::signals::Correspondence;
use super::signals::Course;
use super::signals::Signals;
use super::trial::Trial;
use super::trial::Watched;

/// A scheme in a scene.
pub struct Row {
    /// Its model.
    pub model: &'static str,
    /// `next`, `increment` or `RK4`.
    pub method: &'static str,
    /// What was found, or why there is nothing.
    pub found: Result<Found, String>,
}

/// What a scheme does in a scene.
pub struct Found {
    /// Largest error of a signal at the end, relative to its size, with h, h/2 and h/4.
    pub errors: [f64; 3],
    /// log₂ of the last two errors' ratio.
    pub order: f64,
    /// The order in theory.
    pub theory: f64,
    /// Error of the finest run over (h/4)ᵖ, p the order in theory; per sᵖ.
    pub constant: f64,
    /// How far the motion is ahead of the exact one at the end, with h; s. `None` beyond ±0.25 s.
    pub ahead: Option<f64>,
    /// What is left of the error after that shift in time.
    pub aside: f64,
    /// With h, in file order.
    pub invariants: Vec<Watched>,
    /// Newton iterations per step, with h.
    pub iterations: f64,
    /// Seconds per step.
    pub seconds: f64,
}

/// The table of a scene. `exact` is the state of the reference at the end.
///
/// # Errors
/// Where the catalogue lacks the reference.
pub fn schemes(scene: &Scene, exact: &[f64]) -> Result<Vec<Row>, residua_models::UnknownModel> {
    let reference = scene.of_reference()?;
    let generic = scene.generic();
    let courses = |here: &Case| {
        let there = generic.set(here.model);
        [
            Course::new(here, scene.until),
            Course::new(&there, generic.until),
        ]
    };
    let of_reference = courses(&reference);
    let piece = Piece::new(&reference, exact, scene.until, of_reference[0].scales());
    let mut rows = Vec::new();
    for case in scene.cases() {
        let own = courses(&case);
        let alike = Correspondence::new(&of_reference.each_ref(), &own.each_ref());
        for method in Method::of(case.model) {
            let found = match &piece {
                Some(piece) if !alike.pairs.is_empty() => {
                    judge(piece, scene, &case, method, &alike)
                }
                _ => Err("it has nothing in common with the reference".to_owned()),
            };
            rows.push(Row {
                model: case.model.description.name,
                method: method.name(),
                found,
            });
        }
    }
    Ok(rows)
}

fn judge(
    piece: &Piece,
    scene: &Scene,
    case: &Case,
    method: Method,
    alike: &Correspondence,
) -> Result<Found, String> {
    let in_words = |error: residua::RunError| error.to_string();
    let trial = |parts: u32| {
        let h = scene.h / f64::from(parts);
        Trial::new(case, method, h, scene.steps(h)).map_err(in_words)
    };
    let trials = [trial(1)?, trial(2)?, trial(4)?];
    let ends = trials
        .each_ref()
        .map(|trial| Signals::read(case, scene.h, scene.until, &trial.end).values);
    let errors = ends
        .each_ref()
        .map(|signals| piece.difference(signals, alike));
    let [coarse, ..] = &ends;
    let (ahead, aside) = piece.nearest(coarse, alike);
    let [first, ..] = trials;
    Ok(Found {
        errors,
        order: (errors[1] / errors[2]).log2(),
        theory: f64::from(method.order()),
        constant: errors[2] / (scene.h / 4.0).powi(method.order()),
        ahead,
        aside,
        iterations: first.statistics.iterations as f64 / first.statistics.steps as f64,
        invariants: first.invariants,
        seconds: Trial::time(case, method, scene.h, scene.steps(scene.h)).map_err(in_words)?,
    })
}
