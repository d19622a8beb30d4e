//! Every scheme against the exact motion.

use super::case::Case;
use super::distance::largest_size;
use super::method::Method;
use super::scene::Scene;
use super::signals::Correspondence;
use super::signals::Course;
use super::signals::Signals;
use super::trial::Trial;
use super::trial::Watched;
use residua::erased::AnyFlow;
use residua::erased::Sample;
use residua::erased::Scheme;
use std::ops::ControlFlow;

/// Half the length of the piece of the exact motion that phase is looked for on, s.
const REACH: f64 = 0.25;
/// Steps of RK4 over that length.
const PIECES: u64 = 2000;

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
pub fn schemes(scene: &Scene, exact: &[f64]) -> Result<Vec<Row>, crate::UnknownModel> {
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
                Some(piece) if !alike.pairs.is_empty() => piece.judge(scene, &case, method, &alike),
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

/// The exact motion about its end.
struct Piece {
    /// Time from the end, and the signals of the reference.
    moments: Vec<(f64, Vec<f64>)>,
    /// The size of each signal.
    scales: Vec<f64>,
}

impl Piece {
    fn new(reference: &Case, exact: &[f64], until: f64, scales: &[f64]) -> Option<Self> {
        let flow: &dyn AnyFlow = reference.model.flow?;
        let mut case = reference.clone();
        case.start = exact.to_vec();
        let mut moments = Vec::new();
        for h in [-REACH / PIECES as f64, REACH / PIECES as f64] {
            let mut run = case.run(h, PIECES);
            run.t0 = until;
            let outcome = flow.simulate(Scheme::RungeKutta4, &run, &mut |sample: Sample<'_>| {
                let signals = Signals::read(&case, h, sample.t, sample.state);
                moments.push((sample.t - until, signals.values));
                ControlFlow::Continue(())
            });
            outcome.ok()?;
            if h < 0.0 {
                moments.reverse();
                moments.pop();
            }
        }
        Some(Self {
            scales: scales.to_vec(),
            moments,
        })
    }

    fn judge(
        &self,
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
        let end = &self.moments[self.moments.len() / 2].1;
        let errors = ends
            .each_ref()
            .map(|signals| alike.difference(end, signals, &self.scales));
        let [coarse, ..] = &ends;
        let (ahead, aside) = self.nearest(coarse, alike);
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

    /// The time at which the exact motion comes nearest to `signals`, and how near that is: the first nearest place
    /// on the way from its end, for a motion that repeats itself comes near again.
    fn nearest(&self, signals: &[f64], alike: &Correspondence) -> (Option<f64>, f64) {
        let distance = |k: usize| {
            let squares = alike.pairs.iter().map(|&(i, j)| {
                let d = (self.moments[k].1[i] - signals[j]) / self.scales[i];
                d * d
            });
            squares.sum::<f64>()
        };
        let all: Vec<f64> = (0..self.moments.len()).map(distance).collect();
        let mut least = all.len() / 2;
        loop {
            let neighbours = [least.checked_sub(1), Some(least + 1)];
            let lower = neighbours.into_iter().flatten().filter(|&k| k < all.len());
            match lower.min_by(|&a, &b| all[a].total_cmp(&all[b])) {
                Some(next) if all[next] < all[least] => least = next,
                _ => break,
            }
        }
        if least == 0 || least + 1 == all.len() {
            return (None, all[least].sqrt());
        }
        // Onto the chord through the neighbours.
        let (before, after) = (&self.moments[least - 1], &self.moments[least + 1]);
        let (mut along, mut length) = (0.0, 0.0);
        for &(i, j) in &alike.pairs {
            let chord = (after.1[i] - before.1[i]) / self.scales[i];
            along += chord * (signals[j] - self.moments[least].1[i]) / self.scales[i];
            length += chord * chord;
        }
        let shift = along / length;
        let ahead = self.moments[least].0 + shift * (after.0 - before.0);
        let aside: Vec<f64> = alike
            .pairs
            .iter()
            .map(|&(i, j)| {
                let chord = after.1[i] - before.1[i];
                (signals[j] - self.moments[least].1[i] - shift * chord) / self.scales[i]
            })
            .collect();
        (Some(ahead), largest_size(&aside))
    }
}
