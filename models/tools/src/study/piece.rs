//! The exact motion about its end, for phase to be looked for on.

use super::case::Case;
use super::distance::largest_size;
use super::signals::Correspondence;
use super::signals::Signals;
use residua::erased::AnyFlow;
use residua::erased::Sample;
use residua::erased::Scheme;
use std::ops::ControlFlow;

/// Half the length of the piece of the exact motion that phase is looked for on, s.
const REACH: f64 = 0.25;
/// Steps of RK4 over that length.
const PIECES: u64 = 2000;

/// The exact motion about its end.
pub struct Piece {
    /// Time from the end, and the signals of the reference.
    moments: Vec<(f64, Vec<f64>)>,
    /// The size of each signal.
    scales: Vec<f64>,
}

impl Piece {
    /// Of the motion of `reference` that is at `exact` at the time `until`, with these sizes of its signals. None where
    /// it cannot be followed.
    pub fn new(reference: &Case, exact: &[f64], until: f64, scales: &[f64]) -> Option<Self> {
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

    /// Largest difference of `signals` from those at the end, each relative to its size.
    pub fn difference(&self, signals: &[f64], alike: &Correspondence) -> f64 {
        let end = &self.moments[self.moments.len() / 2].1;
        alike.difference(end, signals, &self.scales)
    }

    /// The time at which the exact motion comes nearest to `signals`, and how near that is: the first nearest place
    /// on the way from its end, for a motion that repeats itself comes near again.
    pub fn nearest(&self, signals: &[f64], alike: &Correspondence) -> (Option<f64>, f64) {
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
