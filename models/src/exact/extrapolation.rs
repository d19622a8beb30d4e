//! Initial value problems in double-double arithmetic, by extrapolating the midpoint rule to step 0.
//!
//! Over a step H the explicit midpoint rule with n = 2, 4, 6, … substeps h = H/n,
//!
//! y₁ = y₀ + h f(t₀, y₀), yᵢ₊₁ = yᵢ₋₁ + 2 h f(t₀ + i h, yᵢ), T = (yₙ₋₁ + 2 yₙ + yₙ₊₁)/4,
//!
//! has an error in even powers of h (Gragg 1965), which the Aitken–Neville scheme removes one by one: column k is
//! of order 2 k. Columns are added until they agree.
//!
//! Source: Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, II.9.

use super::Double;

/// Substeps of the last column, which is of order 28. More cost digits: the weights alternate in sign and grow.
const MOST_SUBSTEPS: u32 = 28;

/// Change from one column to the next, relative to the largest component, at which the last one is taken. Its own
/// error is smaller by orders of magnitude; lower costs columns, 1e-30 is out of reach.
const AGREED: f64 = 1e-20;

/// The states at `times` of dy/dt = f(t, y), y(0) = `start`, in steps no longer than `longest`, and the largest
/// difference from a run with half as many steps again, whose states these are.
pub(crate) fn run<const N: usize>(
    f: impl Fn(Double, &[Double; N]) -> [Double; N],
    start: [Double; N],
    times: &[f64],
    longest: f64,
) -> (Vec<[Double; N]>, f64) {
    let mut states = Vec::with_capacity(times.len());
    let (mut t, mut coarse, mut fine, mut error) = (0.0, start, start, 0f64);
    for &time in times {
        let interval = Double::from(time) - Double::from(t);
        let n = (interval.to_f64() / longest).ceil();
        coarse = steps(&f, t, coarse, interval, n);
        fine = steps(&f, t, fine, interval, n + (n / 2.0).ceil());
        // `max` would pass over NaN.
        let difference = distance(&coarse, &fine);
        error = if difference <= error {
            error
        } else {
            difference
        };
        states.push(fine);
        t = time;
    }
    (states, error)
}

fn steps<const N: usize>(
    f: &impl Fn(Double, &[Double; N]) -> [Double; N],
    t: f64,
    start: [Double; N],
    interval: Double,
    n: f64,
) -> [Double; N] {
    let mut y = start;
    let h = interval / n;
    for k in 0..n as u64 {
        y = step(f, Double::from(t) + h * (k as f64), &y, h);
    }
    y
}

/// The state a step `h` after `start`.
fn step<const N: usize>(
    f: &impl Fn(Double, &[Double; N]) -> [Double; N],
    t: Double,
    start: &[Double; N],
    h: Double,
) -> [Double; N] {
    let slope = f(t, start);
    let mut row: Vec<[Double; N]> = Vec::new();
    let mut best = *start;
    for n in (2..=MOST_SUBSTEPS).step_by(2) {
        let mut entry = midpoint(f, t, start, &slope, h, n);
        let fewer = (2..n).step_by(2).rev();
        for (above, fewer) in row.iter_mut().zip(fewer) {
            let weight = Double::from(f64::from(fewer * fewer)) / f64::from(n * n - fewer * fewer);
            let next = moved(&entry, weight, &difference(&entry, above));
            *above = entry;
            entry = next;
        }
        row.push(entry);
        let change = distance(&entry, &best);
        best = entry;
        if change <= AGREED * size(&best) {
            break;
        }
    }
    best
}

/// Gragg's smoothed midpoint rule with `n` substeps.
fn midpoint<const N: usize>(
    f: &impl Fn(Double, &[Double; N]) -> [Double; N],
    t: Double,
    start: &[Double; N],
    slope: &[Double; N],
    step: Double,
    n: u32,
) -> [Double; N] {
    let h = step / f64::from(n);
    let mut before = *start;
    let mut y = moved(start, h, slope);
    for i in 1..n {
        let slope = f(t + h * f64::from(i), &y);
        (before, y) = (y, moved(&before, h * 2.0, &slope));
    }
    let after = moved(&before, h * 2.0, &f(t + step, &y));
    let mean = moved(&before, Double::ONE, &after);
    core::array::from_fn(|i| mean[i] * 0.25 + y[i] * 0.5)
}

fn moved<const N: usize>(y: &[Double; N], factor: Double, k: &[Double; N]) -> [Double; N] {
    core::array::from_fn(|i| y[i] + factor * k[i])
}

fn difference<const N: usize>(a: &[Double; N], b: &[Double; N]) -> [Double; N] {
    core::array::from_fn(|i| a[i] - b[i])
}

/// The largest component; NaN if there is one.
fn size<const N: usize>(y: &[Double; N]) -> f64 {
    let sizes = y.iter().map(|y| y.to_f64().abs());
    sizes.fold(
        0.0,
        |largest, size| if size <= largest { largest } else { size },
    )
}

fn distance<const N: usize>(a: &[Double; N], b: &[Double; N]) -> f64 {
    size(&difference(a, b))
}
