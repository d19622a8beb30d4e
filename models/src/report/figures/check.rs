//! What the paper says about each figure, judged by numbers.

use super::Scene;
use super::planar;
use super::spatial;
use crate::notation::rounded;
use crate::report::measure::COINCIDE;
use crate::report::measure::Measure;
use crate::report::page::Block;
use crate::report::page::Cell;
use crate::report::page::Data;
use crate::report::page::Judgement;
use crate::report::page::Table;
use crate::report::page::Verdict;
use crate::report::reference::reference;
use crate::report::runs::RunError;
use crate::report::runs::Wanted;

/// What is judged.
#[derive(Clone, Copy)]
pub enum Check {
    /// Runge–Kutta 4 damps and the difference method does not; with a table of steps.
    Damping,
    /// Both coincide in the first 5 s.
    FirstSeconds,
    /// They differ in amplitude and period in the last 5 s.
    LastSeconds,
    /// Two forms give the same.
    Forms,
    /// All curves coincide with the exact one in the first 5 s.
    CoincideFirst,
    /// The curves part visibly from the exact one in the last 5 s.
    PartLast,
    /// The first step is visibly off and the second is not; and it is a lag.
    Steps,
    /// All curves coincide with the exact one over the whole run.
    CoincideLast,
    /// Two forms give the same, yet something differs in the last 5 s.
    GroupForms,
    /// The run stays stable.
    Stable,
    /// The run stays stable and depends little on the step.
    StableAndSteps,
    /// The results are lost, and depend much on the step.
    Cardan,
}

/// Largest share by which energy or amplitude may change in a run that counts as stable. A thousandth of
/// the amplitude is a tenth of the width of a line; schemes that conserve stay below 1e-11.
const STABLE: f64 = 1e-3;

/// The verdicts of a figure, with what they rest on.
pub fn check(scene: &Scene<'_>) -> Result<Vec<Block>, RunError> {
    let measures = &scene.measures;
    Ok(match scene.plan.check {
        Check::Damping => damping(measures)?,
        Check::FirstSeconds => vec![first_seconds(measures)?],
        Check::LastSeconds => vec![last_seconds(measures)],
        Check::Forms => vec![forms(
            scene,
            "The two difference calculations highly coincide",
        )?],
        Check::CoincideFirst => vec![coincide_first(measures)],
        Check::PartLast => vec![part_last(measures)],
        Check::Steps => steps(measures),
        Check::CoincideLast => measures.iter().take(1).map(coincide_last).collect(),
        Check::GroupForms => group_forms(scene)?,
        Check::Stable => measures.iter().take(1).map(stable).collect(),
        Check::StableAndSteps => {
            let stable = measures.iter().take(1).map(stable);
            stable.chain(sensitive(measures)).collect()
        }
        Check::Cardan => cardan(measures)?,
    })
}

fn verdict(judgement: Judgement, statement: impl Into<String>, reason: String) -> Block {
    Block::Verdict(Verdict {
        judgement,
        statement: statement.into(),
        reason,
    })
}

/// `3.4 %`
fn percent(share: f64) -> String {
    format!("{} %", rounded(100.0 * share, 2))
}

/// `0.25 s late`
fn lag(seconds: f64) -> String {
    let which = if seconds < 0.0 { "early" } else { "late" };
    format!("{} s {which}", rounded(seconds.abs(), 2))
}

/// Steps of the table of Figure 5, [s]; all divide 50 s.
const SWEEP: [f64; 7] = [0.01, 0.02, 0.05, 0.08, 0.1, 0.125, 0.2];

fn measured(run: &Wanted) -> Result<Measure, RunError> {
    Measure::of(run, &run.record()?, &reference(run)?)
}

fn damping(measures: &[Measure]) -> Result<Vec<Block>, RunError> {
    let [runge_kutta, difference, ..] = measures else {
        return Ok(Vec::new());
    };
    let limit = damping_limit()?;
    let lost = percent(-runge_kutta.amplitude_change);
    let h = runge_kutta.run.step;
    let reason = format!(
        "h is above {} s. At h = {h} s Runge–Kutta 4 loses {lost} of the amplitude in 50 s. Its factor per step on \
         an oscillation of frequency Ω is 1 − (Ωh)⁶/144, so that the loss in a given time grows with h⁵: \
         it is numerical dissipation, not rounding or time.",
        rounded(limit, 2)
    );
    let kept = format!(
        "At h = {h} s its amplitude over the last 5 s differs from that at the start by {}, against {lost} for \
         Runge–Kutta 4. It does not keep the phase: it is {}, Runge–Kutta 4 {}.",
        percent(difference.amplitude_change.abs()),
        lag(difference.lag),
        lag(runge_kutta.lag)
    );
    let bounded = difference.amplitude_change.abs() < COINCIDE;
    Ok(vec![
        verdict(
            Judgement::HoldsWhen,
            "Section 6, on Figure 5: under Runge–Kutta the motion is damped as time goes on.",
            reason,
        ),
        verdict(
            Judgement::of(bounded),
            "Section 6, on Figure 5: the difference method conserves attitude and angular velocity over the long term.",
            kept,
        ),
        Block::Table(sweep()?),
    ])
}

/// The largest h at which Runge–Kutta 4 does not visibly damp.
fn damping_limit() -> Result<f64, RunError> {
    limit(|h| {
        let measure = measured(&planar::runge_kutta(h))?;
        // The range is twice the amplitude: the envelope has moved by less than the width of a line.
        Ok(-measure.amplitude_change / 2.0 < COINCIDE)
    })
}

fn sweep() -> Result<Table, RunError> {
    let mut data = Data::new(&[
        "h [s]",
        "RK 4: amplitude [%]",
        "RK 4: lag [s]",
        "Eq. 42: amplitude [%]",
        "Eq. 42: lag [s]",
        "apart in the first 5 s [% of range]",
        "apart in the last 5 s [% of range]",
    ]);
    for h in SWEEP {
        let (one, other) = (planar::runge_kutta(h), planar::difference(h));
        let (first, last) = apart(&one, &other)?;
        let (one, other) = (measured(&one)?, measured(&other)?);
        let numbers = [
            100.0 * one.amplitude_change,
            one.lag,
            100.0 * other.amplitude_change,
            other.lag,
            100.0 * first / one.range,
            100.0 * last / one.range,
        ];
        let step = std::iter::once(Cell::given(h));
        data.row(step.chain(numbers.map(|number| Cell::number(number, 2))));
    }
    Ok(Table {
        csv: "figure-05-steps".to_owned(),
        caption: "Runge–Kutta 4 and the difference method of Eq. 42 at several steps: change of amplitude \
                  and lag after 50 s, and largest distance between the two."
            .to_owned(),
        data,
    })
}

/// Largest distance between the angles of two runs in the first and in the last 5 s, [rad].
fn apart(one: &Wanted, other: &Wanted) -> Result<(f64, f64), RunError> {
    let (one, other) = (one.record()?, other.record()?);
    let (a, b) = (one.values("θ")?, other.values("θ")?);
    let distances: Vec<f64> = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).collect();
    let largest = |keep: &dyn Fn(f64) -> bool| {
        let kept = one.times.iter().zip(&distances).filter(|(t, _)| keep(**t));
        kept.map(|(_, d)| *d).fold(0.0, f64::max)
    };
    let end = planar::UNTIL - crate::report::measure::WINDOW;
    let first = largest(&|t| t <= crate::report::measure::WINDOW);
    Ok((first, largest(&|t| t >= end)))
}

/// The largest h = 50 s/n at which something still holds that holds for small h, by bisection of n.
fn limit(holds: impl Fn(f64) -> Result<bool, RunError>) -> Result<f64, RunError> {
    let (mut fails, mut stands) = (FEWEST, MOST);
    while stands - fails > 1 {
        let middle = (fails + stands) / 2;
        match holds(planar::UNTIL / f64::from(middle))? {
            true => stands = middle,
            false => fails = middle,
        }
    }
    Ok(planar::UNTIL / f64::from(stands))
}

/// Steps in 50 s between which limits are looked for: h = 0.25 s and 0.002 s.
const FEWEST: u32 = 200;
const MOST: u32 = 25_000;

fn first_seconds(measures: &[Measure]) -> Result<Block, RunError> {
    let statement = "Section 6, on Figure 6: at the beginning the two results coincide.";
    let h = measures
        .first()
        .map_or(planar::COARSE, |measure| measure.run.step);
    let range = measures.first().map_or(1.0, |measure| measure.range);
    let first_share = |h: f64| -> Result<f64, RunError> {
        Ok(apart(&planar::runge_kutta(h), &planar::difference(h))?.0 / range)
    };
    let share = first_share(h)?;
    let limit = limit(|h| Ok(first_share(h)? < COINCIDE))?;
    let judgement = if share < COINCIDE {
        Judgement::Holds
    } else {
        Judgement::HoldsWhen
    };
    let reason = format!(
        "h is at most {} s. At h = {h} s they are already {} of the range apart within 5 s, by the lag of the \
         difference method. {}",
        rounded(limit, 2),
        percent(share),
        match limit < damping_limit()? {
            true => "No h shows both this and the damping of Figure 5.",
            false => "",
        }
    );
    Ok(verdict(judgement, statement, reason.trim_end().to_owned()))
}

fn last_seconds(measures: &[Measure]) -> Block {
    let statement = "Section 6, on Figure 7: in the last 5 s they differ obviously, in amplitude and in period.";
    let [runge_kutta, difference, ..] = measures else {
        return Block::Text(statement.to_owned());
    };
    let differ =
        runge_kutta.amplitude_change.abs() > 2.0 * COINCIDE && difference.last_share() > COINCIDE;
    let reason = format!(
        "Of the two errors each method has its own: Runge–Kutta 4 has {} of amplitude lost and is {}, the \
         difference method has {} lost and is {}. So the amplitude is wrong in the one and the \
         period in the other, and against the exact angle the difference method is further off ({} of the range \
         against {}).",
        percent(-runge_kutta.amplitude_change),
        lag(runge_kutta.lag),
        percent(-difference.amplitude_change),
        lag(difference.lag),
        percent(difference.last_share()),
        percent(runge_kutta.last_share())
    );
    verdict(Judgement::of(differ), statement, reason)
}

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

fn forms(scene: &Scene<'_>, statement: &str) -> Result<Block, RunError> {
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

fn coincide_first(measures: &[Measure]) -> Block {
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

fn part_last(measures: &[Measure]) -> Block {
    let statement = "Section 6, on Figures 10 and 11: later the results are obviously distinguishable from the standard values.";
    let least = measures
        .iter()
        .map(Measure::last_share)
        .fold(f64::INFINITY, f64::min);
    let each: Vec<String> = measures
        .iter()
        .map(|measure| {
            format!(
                "{} {}, {} of the range off",
                measure.run.model,
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

fn steps(measures: &[Measure]) -> Vec<Block> {
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

fn coincide_last(measure: &Measure) -> Block {
    let statement = format!(
        "Section 6: with h = {} s the results highly coincide with the standard ones.",
        measure.run.step
    );
    coincide_with(&statement, measure)
}

fn coincide_with(statement: &str, measure: &Measure) -> Block {
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

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

fn group_forms(scene: &Scene<'_>) -> Result<Vec<Block>, RunError> {
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

fn stable(measure: &Measure) -> Block {
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
fn sensitive(measures: &[Measure]) -> Option<Block> {
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

fn cardan(measures: &[Measure]) -> Result<Vec<Block>, RunError> {
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
