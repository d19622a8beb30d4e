//! The continuous equations of any model in double-double arithmetic.

use std::marker::PhantomData;

use residua::Flow;
use residua::Model;
use residua::Record;

use super::Double;
use super::Invalid;
use super::extrapolation;

/// Difference between two resolutions that is as good as none after the final rounding, relative to the largest
/// component.
const CONVERGED: f64 = 1e-18;

/// How often the steps are made shorter, by a half each time, until [`CONVERGED`] or else the best is taken.
const ATTEMPTS: usize = 4;

/// Difference that is not accepted as a reference, relative to the largest component.
const USELESS: f64 = 1e-6;

/// A state that was computed with twice the digits.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Flat.
    pub state: Vec<f64>,
    /// Largest difference from a run in two thirds as many steps, relative to the largest component. The state itself
    /// is closer to the truth by orders of magnitude.
    pub error: f64,
}

/// The continuous equations of a model in double-double arithmetic, over flat slices of `f64`.
pub trait Extended: Sync {
    /// The state at the time `until`, from `start` at t = 0, by steps no longer than `longest` at first.
    ///
    /// # Errors
    /// Where smaller steps do not bring two resolutions together.
    ///
    /// # Panics
    /// Where there are not as many values as the model has.
    fn solve(
        &self,
        parameters: &[f64],
        start: &[f64],
        until: f64,
        longest: f64,
    ) -> Result<Reference, Invalid>;
}

/// Finds out whether `M` has continuous equations.
pub struct Probe<M>(PhantomData<fn() -> M>);

impl<M, S, const N: usize> Probe<M>
where
    M: Flow<Double> + Model<Double, State = S> + 'static,
    S: Record<Double, Array = [Double; N]>,
{
    /// They are there.
    pub const EXTENDED: Option<&'static dyn Extended> = Some(&Flowing::<M, N>(PhantomData));
}

/// What is there where a model has none: constants of a type come before those of its traits.
pub trait WithoutFlow {
    /// They are not there.
    const EXTENDED: Option<&'static dyn Extended> = None;
}

impl<M> WithoutFlow for Probe<M> {}

struct Flowing<M, const N: usize>(PhantomData<fn() -> M>);

impl<M, S, const N: usize> Extended for Flowing<M, N>
where
    M: Flow<Double> + Model<Double, State = S>,
    S: Record<Double, Array = [Double; N]>,
{
    fn solve(
        &self,
        parameters: &[f64],
        start: &[f64],
        until: f64,
        longest: f64,
    ) -> Result<Reference, Invalid> {
        let mut array = M::Parameters::default().to_array();
        let given = parameters.iter().map(|&value| Double::from(value));
        array
            .as_mut()
            .iter_mut()
            .zip(given)
            .for_each(|(to, from)| *to = from);
        let scene = M::flow_scene(&M::Parameters::from_array(array));
        let flow = |t: Double, y: &[Double; N]| M::flow(&scene, t, y);
        // Compiled once per number of states.
        let flow: &dyn Fn(Double, &[Double; N]) -> [Double; N] = &flow;
        let start = std::array::from_fn(|i| Double::from(start[i]));
        let mut longest = longest;
        let mut best = run(flow, start, until, longest);
        for _ in 1..ATTEMPTS {
            if best.error <= CONVERGED {
                break;
            }
            longest /= 2.0;
            let next = run(flow, start, until, longest);
            // A NaN is no error to keep.
            if best.error.is_nan() || next.error < best.error {
                best = next;
            }
        }
        match best.error <= USELESS {
            true => Ok(best),
            false => Err(Invalid::NotConverged { error: best.error }),
        }
    }
}

fn run<const N: usize>(
    flow: &dyn Fn(Double, &[Double; N]) -> [Double; N],
    start: [Double; N],
    until: f64,
    longest: f64,
) -> Reference {
    let (states, error) = extrapolation::run(flow, start, &[until], longest);
    let state: Vec<f64> = states[0].iter().map(|y| y.to_f64()).collect();
    let size = state.iter().fold(0.0, |size: f64, y| size.max(y.abs()));
    Reference {
        state,
        error: if size > 0.0 { error / size } else { error },
    }
}
