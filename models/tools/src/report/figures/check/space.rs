//! Stability and sensitivity in space: Figures 18 to 25.

use super::lag;
use super::verdict;
use crate::notation::rounded;
use crate::report::measure::Measure;
use crate::report::page::Block;
use crate::report::page::Judgement;

/// Largest share by which energy or amplitude may change in a run that counts as stable. A thousandth of
/// the amplitude is a tenth of the width of a line; schemes that conserve stay below 1e-11.
const STABLE: f64 = 1e-3;

pub(super) fn stable(measure: &Measure) -> Block {
    let h = measure.run.step;
    let statement = format!(
        "Section 6: good long-term stability over 100 s with Newton iteration at h = {h} s."
    );
    let is_stable = measure.energy_error < STABLE && measure.amplitude_change.abs() < STABLE;
    let reason = format!(
        "Energy stays within {} of the swing's, the amplitude changes by {} of itself, ω stays along its axis to \
         {}; Newton takes {} iterations per step. Stable is not accurate: after {} exact swings the run is {}.",
        rounded(measure.energy_error, 2),
        rounded(measure.amplitude_change.abs(), 2),
        rounded(measure.off_axis, 2),
        rounded(measure.iterations, 3),
        measure.swings,
        lag(measure.lag)
    );
    verdict(Judgement::of(is_stable), statement, reason)
}

/// The coarse run against the fine one.
pub(super) fn sensitive(measures: &[Measure]) -> Option<Block> {
    let [coarse, fine, ..] = measures else {
        return None;
    };
    let judgement = Judgement::of(coarse.coincides_until >= coarse.run.until);
    let reason = format!(
        "At h = {} s the curve leaves the exact one after {} s and ends {}; at h = {} s after {} s, and ends {}. The lag \
         goes with h² as for every midpoint rule; what does not depend on h is the energy, the amplitude and the \
         plane of the swing.",
        coarse.run.step,
        rounded(coarse.coincides_until, 2),
        lag(coarse.lag),
        fine.run.step,
        rounded(fine.coincides_until, 2),
        lag(fine.lag)
    );
    let statement = "Section 6 and conclusion 4: low sensitivity to the time step; 0.1 s and 0.01 s are not obviously distinguishable.";
    Some(verdict(judgement, statement, reason))
}
