//! Which curves coincide: Figures 8 to 17.

use super::super::Scene;
use super::capital;
use super::lag;
use super::percent;
use super::verdict;
use crate::notation::rounded;
use crate::report::measure::COINCIDE;
use crate::report::measure::Measure;
use crate::report::page::Block;
use crate::report::page::Judgement;
use crate::report::runs::RunError;

/// Largest difference of the angles of the first two runs, and the range.
fn between(scene: &Scene<'_>) -> Result<(f64, f64), RunError> {
    let range = scene.measures.first().map_or(1.0, |measure| measure.range);
    let [one, other, ..] = &scene.curves[..] else {
        return Ok((0.0, range));
    };
    let (a, b) = (one.made.values("θ")?, other.made.values("θ")?);
    let distances = a.iter().zip(&b).map(|(a, b)| (a - b).abs());
    Ok((distances.fold(0.0, f64::max), range))
}

pub(super) fn forms(scene: &Scene<'_>, statement: &str) -> Result<Block, RunError> {
    let (difference, range) = between(scene)?;
    let number = scene.plan.number;
    let reason = format!(
        "Over the whole run θ differs by {} rad at most, {} of the range: the two forms are one map, \
         written in x[k+1] and in Δx, and differ by rounding only.",
        rounded(difference, 2),
        rounded(difference / range, 2)
    );
    let statement = format!(
        "Section 6, on Figure {number}: {}.",
        statement.to_lowercase()
    );
    Ok(verdict(
        Judgement::of(difference < COINCIDE * range),
        statement,
        reason,
    ))
}

pub(super) fn coincide_first(measures: &[Measure]) -> Block {
    let worst = measures
        .iter()
        .map(Measure::first_share)
        .fold(0.0, f64::max);
    let until = measures
        .iter()
        .map(|m| m.coincides_until)
        .fold(f64::INFINITY, f64::min);
    let statement = "Section 6, on Figure 10: the three results highly coincide in the first 5 s.";
    let h = measures.first().map_or(0.0, |measure| measure.run.step);
    let reason = match worst < COINCIDE {
        true => format!(
            "At h = {h} s they are within {} of the range.",
            percent(worst)
        ),
        false => format!(
            "t is below {} s, at h = {h} s; by 5 s they are {} of the range apart. The distance grows with h² t.",
            rounded(until, 2),
            percent(worst)
        ),
    };
    let judgement = if worst < COINCIDE {
        Judgement::Holds
    } else {
        Judgement::HoldsWhen
    };
    verdict(judgement, statement, reason)
}

pub(super) fn part_last(scene: &Scene<'_>) -> Block {
    let measures = &scene.measures;
    let statement = "Section 6, on Figures 10 and 11: later the results are obviously distinguishable from the standard values.";
    let least = measures
        .iter()
        .map(Measure::last_share)
        .fold(f64::INFINITY, f64::min);
    let labels = scene.curves.iter().map(|curve| curve.line.label);
    let each: Vec<String> = labels
        .zip(measures)
        .map(|(label, measure)| {
            format!(
                "{label} {}, {} of the range off",
                lag(measure.lag),
                percent(measure.last_share())
            )
        })
        .collect();
    let reason = format!(
        "In the last 5 s: {}. Reduced attitude is no better than the angle: both are the midpoint rule.",
        each.join("; ")
    );
    verdict(Judgement::of(least > COINCIDE), statement, reason)
}

pub(super) fn steps(measures: &[Measure]) -> Vec<Block> {
    let [large, small, ..] = measures else {
        return Vec::new();
    };
    let far = format!(
        "At h = {} s the last swing ends {} and the angle is up to {} of the range off.",
        large.run.step,
        lag(large.lag),
        percent(large.last_share())
    );
    let ratio = large.lag / small.lag;
    let hysteresis = format!(
        "The difference is a lag: {} at h = {} s and {} at h = {} s, {} times less for a step {} times smaller, as \
         h² asks for; the amplitude changes by {} and {}. Hysteresis in the usual sense it is not: nothing \
         depends on the way back.",
        lag(large.lag),
        large.run.step,
        lag(small.lag),
        small.run.step,
        rounded(ratio, 3),
        rounded(large.run.step / small.run.step, 2),
        percent(large.amplitude_change),
        percent(small.amplitude_change)
    );
    vec![
        verdict(
            Judgement::of(large.last_share() > COINCIDE),
            "Section 6, on Figure 12: with h = 0.05 s the results are obviously distinguishable from the standard ones.",
            far,
        ),
        coincide_with(
            "Section 6, on Figure 12: with h = 0.01 s the results coincide.",
            small,
        ),
        verdict(
            Judgement::of(large.lag > small.lag && small.lag > 0.0),
            "Section 6, on Figure 12: a long time step leads to time hysteresis.",
            hysteresis,
        ),
    ]
}

pub(super) fn coincide_last(measure: &Measure) -> Block {
    let statement = format!(
        "Section 6: with h = {} s the results highly coincide with the standard ones.",
        measure.run.step
    );
    coincide_with(&statement, measure)
}

pub(super) fn coincide_with(statement: &str, measure: &Measure) -> Block {
    let share = measure.last_share();
    let off = format!(
        "in the last 5 s the angle is up to {} rad off, {} of the range, because the swing ends {}",
        rounded(measure.last, 2),
        percent(share),
        lag(measure.lag)
    );
    match share < COINCIDE {
        true => verdict(Judgement::Holds, statement, format!("{}.", capital(&off))),
        false => verdict(
            Judgement::HoldsWhen,
            statement,
            format!(
                "t is below {} s: {off}. The lag grows with h² t.",
                rounded(measure.coincides_until, 3)
            ),
        ),
    }
}

pub(super) fn group_forms(scene: &Scene<'_>) -> Result<Vec<Block>, RunError> {
    let (difference, range) = between(scene)?;
    let mut blocks = vec![forms(
        scene,
        "the two difference results approximately coincide with the step 0.05 s",
    )?];
    if let Some(measure) = scene.measures.first() {
        let differs = difference > COINCIDE * range;
        let reason = format!(
            "Between the two forms there is no difference but rounding ({} rad) at any time; a visible one means that \
             Newton was stopped early or coded with a wrong Jacobian. What does differ in the last 5 s is both \
             from the exact solution: {}, {} of the range.",
            rounded(difference, 2),
            lag(measure.lag),
            percent(measure.last_share())
        );
        let statement =
            "Section 6, on Figure 14: the two results show some differentiation in the last 5 s.";
        blocks.push(verdict(Judgement::of(differs), statement, reason));
    }
    Ok(blocks)
}
