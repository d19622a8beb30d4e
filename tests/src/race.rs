//! Races of lanes that cannot fail, printed.

use residua_tools::race;
use std::convert::Infallible;

/// Largest difference of the end states of two lanes, relative to their size: rounding, grown over some seconds.
const AGREEMENT: f64 = 1e-9;

/// One way to make the run.
pub struct Lane {
    name: &'static str,
    run: Box<dyn Fn() -> Vec<f64>>,
}

impl Lane {
    /// `run` makes the whole run and returns its end state.
    pub fn new(name: &'static str, run: impl Fn() -> Vec<f64> + 'static) -> Self {
        let run = Box::new(run);
        Self { name, run }
    }
}

/// Compares the end states of `lanes`, then times `rounds` of them and prints, per lane, how many times faster than the
/// first it is, the median time of one of its `steps` and the quartiles.
///
/// # Panics
/// Where the end states differ: nobody wins by doing less.
pub fn race(title: &str, steps: u64, rounds: usize, lanes: Vec<Lane>) {
    let lanes = lanes.into_iter().map(|Lane { name, run }| {
        race::Lane::<Infallible>::new(name, steps as f64, move || Ok(run()))
    });
    let mut lanes: Vec<_> = lanes.collect();
    let paces = race::race(&mut lanes, AGREEMENT, rounds as u64);
    let paces = paces.unwrap_or_else(|unfair| panic!("{title}: {unfair}"));
    println!("{title}");
    for pace in &paces {
        let ratio = paces[0].median / pace.median;
        let [low, median, high] = [pace.low, pace.median, pace.high].map(|time| time * 1e9);
        println!(
            "    {:<12} {ratio:>6.2} x  {median:>8.1} ns a step ({low:.1} to {high:.1})",
            pace.name
        );
    }
}
