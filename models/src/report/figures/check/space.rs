//! Stability and sensitivity in space: Figures 18 to 27.

use super::super::spatial;
use super::damping::measured;
use super::lag;
use super::percent;
use super::verdict;
use crate::notation::rounded;
use crate::report::measure::COINCIDE;
use crate::report::measure::Measure;
use crate::report::page::Block;
use crate::report::page::Judgement;
use crate::report::runs::RunError;

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

pub(super) fn cardan(measures: &[Measure]) -> Result<Vec<Block>, RunError> {
    let [coarse, fine, ..] = measures else {
        return Ok(Vec::new());
    };
    let (h, half) = (coarse.run.step, fine.run.step);
    let lost = coarse.off_axis > COINCIDE;
    let reason = format!(
        "What is lost is the plane of the swing, and with it the angular momentum about the vertical: the part of ω \
         across its exact axis grows from exactly 0 to {} of the largest ω at h = {h} s and {} at {half} s. \
         It is no collapse: Newton converges in every step, and the energy is off by {} and {} of the \
         swing's, without a trend.",
        percent(coarse.off_axis),
        percent(fine.off_axis),
        rounded(coarse.energy_error, 2),
        rounded(fine.energy_error, 2)
    );
    let group = measured(&spatial::group(h))?;
    let steps = format!(
        "one looks at the plane of the swing: it turns at a rate that goes with h², is off by a hundredth after {} s at \
         h = {h} s and after {} s at {half} s, so that late in the run the two steps show different planes. In \
         tilt and energy these runs are no more sensitive than others: halving h divides the energy error by {}, \
         and at h = {h} s the run is {}, that of the complete group {}.",
        rounded(coarse.on_axis_until, 2),
        rounded(fine.on_axis_until, 2),
        rounded(coarse.energy_error / fine.energy_error, 2),
        lag(coarse.lag),
        lag(group.lag)
    );
    let sensitive = match fine.on_axis_until > coarse.on_axis_until {
        true => Judgement::HoldsWhen,
        false => Judgement::DoesNotHold,
    };
    Ok(vec![
        verdict(
            Judgement::of(lost),
            "Section 6, on Figures 26 and 27, and conclusion 5: the dynamics are lost in Cardan angles.",
            reason,
        ),
        verdict(
            sensitive,
            "Section 6, on Figures 26 and 27: very sensitive to the time step.",
            steps,
        ),
    ])
}
