//! Timings side by side: every lane computes the same thing, in turns, so that a slow moment of the machine is one for
//! all.

use std::time::Instant;

/// Largest difference of the end states of two lanes, for numbers of order one: rounding, grown over some seconds.
const AGREEMENT: f64 = 1e-9;

/// One way to make the run.
pub struct Lane {
    name: &'static str,
    run: Box<dyn Fn() -> Vec<f64>>,
    seconds: Vec<f64>,
}

impl Lane {
    /// `run` makes the whole run and returns its end state.
    pub fn new(name: &'static str, run: impl Fn() -> Vec<f64> + 'static) -> Self {
        Self {
            name,
            run: Box::new(run),
            seconds: Vec::new(),
        }
    }

    fn time(&mut self) {
        let begin = Instant::now();
        let end = std::hint::black_box((self.run)());
        self.seconds.push(begin.elapsed().as_secs_f64());
        drop(end);
    }

    /// The `share`-th part of the sorted times, per step, ns.
    fn quantile(&self, share: f64, steps: u64) -> f64 {
        let mut sorted = self.seconds.clone();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len() - 1;
        sorted[(share * last as f64).round() as usize] / steps as f64 * 1e9
    }
}

/// Compares the end states of `lanes`, then times `rounds` of them and prints, per lane, how many times faster than the
/// first it is, the median time of one of its `steps` and the quartiles.
///
/// # Panics
/// Where the end states differ: nobody wins by doing less.
pub fn race(title: &str, steps: u64, rounds: usize, mut lanes: Vec<Lane>) {
    let ends: Vec<Vec<f64>> = lanes.iter().map(|lane| (lane.run)()).collect();
    for (lane, end) in lanes.iter().zip(&ends) {
        assert_eq!(end.len(), ends[0].len(), "{title}: {}", lane.name);
        for (a, b) in end.iter().zip(&ends[0]) {
            // Written so that a NaN fails.
            assert!(
                (a - b).abs() <= AGREEMENT,
                "{title}: {}: {a} and {b}",
                lane.name
            );
        }
    }
    for _ in 0..rounds {
        lanes.iter_mut().for_each(Lane::time);
    }
    println!("{title}");
    let first = lanes[0].quantile(0.5, steps);
    for lane in &lanes {
        let [low, median, high] = [0.25, 0.5, 0.75].map(|share| lane.quantile(share, steps));
        let ratio = first / median;
        println!(
            "    {:<12} {ratio:>6.2} x  {median:>8.1} ns a step ({low:.1} to {high:.1})",
            lane.name
        );
    }
}
