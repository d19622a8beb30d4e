//! Runge–Kutta 4 against the difference method: Figures 5 to 7.

use super::super::planar;
use super::lag;
use super::percent;
use super::verdict;
use crate::notation::rounded;
use crate::report::measure::COINCIDE;
use crate::report::measure::Measure;
use crate::report::page::Block;
use crate::report::page::Cell;
use crate::report::page::Data;
use crate::report::page::Judgement;
use crate::report::page::Table;
use crate::report::reference::reference;
use crate::report::runs::RunError;
use crate::report::runs::Wanted;

/// Steps of the table of Figure 5, s; all divide 50 s.
const SWEEP: [f64; 7] = [0.01, 0.02, 0.05, 0.08, 0.1, 0.125, 0.2];

pub(super) fn measured(run: &Wanted) -> Result<Measure, RunError> {
    Measure::of(run, &run.record()?, &reference(run)?)
}

pub(super) fn damping(measures: &[Measure]) -> Result<Vec<Block>, RunError> {
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

/// Largest distance between the angles of two runs in the first and in the last 5 s, rad.
pub(super) fn apart(one: &Wanted, other: &Wanted) -> Result<(f64, f64), RunError> {
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
pub(super) fn limit(holds: impl Fn(f64) -> Result<bool, RunError>) -> Result<f64, RunError> {
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

pub(super) fn first_seconds(measures: &[Measure]) -> Result<Block, RunError> {
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
            true => "No common h shows both this and the damping of Figure 5.",
            false => "",
        }
    );
    Ok(verdict(judgement, statement, reason.trim_end().to_owned()))
}

pub(super) fn last_seconds(measures: &[Measure]) -> Block {
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
