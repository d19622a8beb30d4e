//! Timings side by side: every lane computes the same thing, in turns, so that a slow moment of the machine is one for
//! all.

use std::convert::Infallible;
use std::fmt;
use std::hint::black_box;
use std::time::Instant;

/// One way to make a run, which may fail with an `E`.
pub struct Lane<'a, E = Infallible> {
    name: String,
    run: Box<dyn Fn() -> Result<Vec<f64>, E> + 'a>,
    units: f64,
    seconds: Vec<f64>,
}

/// Why lanes do not race.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unfair<E> {
    /// A run failed.
    Failed(E),
    /// This lane, by position, does not end where the first one ends.
    Differs(usize),
}

/// What a lane takes for one of its units, s.
#[derive(Clone, Debug, PartialEq)]
pub struct Pace {
    /// The name of the lane.
    pub name: String,
    /// The lower quartile.
    pub low: f64,
    /// The median.
    pub median: f64,
    /// The upper quartile.
    pub high: f64,
}

impl<'a, E> Lane<'a, E> {
    /// `run` makes the whole run, of so many units (steps, say), and returns its end state.
    pub fn new(
        name: impl Into<String>,
        units: f64,
        run: impl Fn() -> Result<Vec<f64>, E> + 'a,
    ) -> Self {
        Self {
            name: name.into(),
            run: Box::new(run),
            units,
            seconds: Vec::new(),
        }
    }

    /// Makes the run, untimed, and returns its end state.
    ///
    /// # Errors
    /// Where the run fails.
    pub fn end(&self) -> Result<Vec<f64>, E> {
        (self.run)()
    }

    /// Times a run.
    ///
    /// # Errors
    /// Where it fails.
    pub fn time(&mut self) -> Result<(), E> {
        let clock = Instant::now();
        let end = black_box((self.run)()?);
        self.seconds.push(clock.elapsed().as_secs_f64());
        drop(end);
        Ok(())
    }

    /// How often it was timed.
    pub fn runs(&self) -> usize {
        self.seconds.len()
    }

    /// The `share`-th part of the sorted times of a unit, s: 0 for the fastest run. NaN before the first.
    pub fn quantile(&self, share: f64) -> f64 {
        let mut sorted = self.seconds.clone();
        sorted.sort_by(f64::total_cmp);
        let at = (share * sorted.len().saturating_sub(1) as f64).round() as usize;
        sorted.get(at).map_or(f64::NAN, |time| time / self.units)
    }

    fn pace(&self) -> Pace {
        Pace {
            name: self.name.clone(),
            low: self.quantile(0.25),
            median: self.quantile(0.5),
            high: self.quantile(0.75),
        }
    }
}

/// Compares where the lanes end, then times `rounds` runs of each, in turns: nobody wins by doing less. End states may
/// differ by `agreement`, relative to their largest component if that exceeds 1.
///
/// # Errors
/// Where a run fails, or end states differ.
pub fn race<E>(
    lanes: &mut [Lane<'_, E>],
    agreement: f64,
    rounds: u64,
) -> Result<Vec<Pace>, Unfair<E>> {
    let ends = lanes.iter().map(Lane::end);
    let ends = ends
        .collect::<Result<Vec<_>, E>>()
        .map_err(Unfair::Failed)?;
    let differs = |end: &Vec<f64>| !agree(&ends[0], end, agreement);
    if let Some(lane) = ends.iter().position(differs) {
        return Err(Unfair::Differs(lane));
    }
    for _ in 0..rounds {
        for lane in lanes.iter_mut() {
            lane.time().map_err(Unfair::Failed)?;
        }
    }
    Ok(lanes.iter().map(Lane::pace).collect())
}

/// As many components, no two further apart than `agreement`, relative to the largest of `one` if that exceeds 1.
pub fn agree(one: &[f64], other: &[f64], agreement: f64) -> bool {
    let size = one.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    // Written so that a NaN fails.
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= agreement * size;
    one.len() == other.len() && one.iter().zip(other).all(near)
}

impl<E: fmt::Display> fmt::Display for Unfair<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Failed(error) => error.fmt(f),
            Self::Differs(lane) => write!(f, "lane {lane} ends elsewhere than the first"),
        }
    }
}

#[cfg(test)]
mod tests;
