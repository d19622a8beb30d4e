//! The motion of any model to some 28 digits.

use super::Double;
use residua::Record;
use residua::RunError;
use residua::Series;
use residua::Tolerance;
use residua::taylor::AdaptiveTaylor;
use residua::taylor::MOST_ORDER;

/// The largest terms left out of a step, of the size of each component. Double-double arithmetic has 31 digits, and the
/// motion multiplies what is lost.
const TOLERANCE: f64 = 1e-30;

/// The states at `interval`, 2 `interval`, …, `n` times, of the motion of `M` from `start` at t = 0 by Taylor series of order
/// 24 in double-double arithmetic. Parameters and start values are taken for exact.
///
/// How good it is shows where another `tolerance` gives the same digits; `None` is 10⁻³⁰.
///
/// # Errors
/// As [`AdaptiveTaylor`].
pub fn reference<M: Series<Double>>(
    parameters: M::Parameters,
    start: M::State,
    interval: f64,
    n: usize,
    tolerance: Option<f64>,
) -> Result<Vec<Vec<Double>>, RunError> {
    let run = AdaptiveTaylor::<M, Double>::new(parameters, start, Double::from(interval))?;
    let tolerance = Tolerance::both(Double::from(tolerance.unwrap_or(TOLERANCE)));
    let mut run = run.with_tolerance(tolerance).with_order(MOST_ORDER);
    let mut states = Vec::with_capacity(n);
    for _ in 0..n {
        run.step()?;
        states.push(run.state().to_array().as_ref().to_vec());
    }
    Ok(states)
}
