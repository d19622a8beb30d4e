//! What the paper says about each figure, judged by numbers.

mod cardan;
mod coincide;
mod damping;
mod space;

use super::Scene;
use crate::notation::rounded;
use crate::report::page::Block;
use crate::report::page::Judgement;
use crate::report::page::Verdict;
use crate::report::runs::RunError;

/// What is judged.
#[derive(Clone, Copy, PartialEq, Eq)]
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

/// The verdicts on a figure whose runs another figure has, without what is said there.
pub fn repeated(blocks: Vec<Block>, earlier: u8) -> Vec<Block> {
    let short = |block| match block {
        Block::Verdict(verdict) => Some(Block::Verdict(Verdict {
            reason: match verdict.judgement {
                Judgement::HoldsWhen => {
                    format!("the condition is met that Figure {earlier} gives for the same runs.")
                }
                _ => format!("The runs are those of Figure {earlier}: see there."),
            },
            ..verdict
        })),
        _ => None,
    };
    blocks.into_iter().filter_map(short).collect()
}

/// The verdicts of a figure, with what they rest on.
pub fn check(scene: &Scene<'_>) -> Result<Vec<Block>, RunError> {
    let measures = &scene.measures;
    Ok(match scene.plan.check {
        Check::Damping => damping::damping(measures)?,
        Check::FirstSeconds => vec![damping::first_seconds(measures)?],
        Check::LastSeconds => vec![damping::last_seconds(measures)],
        Check::Forms => vec![coincide::forms(
            scene,
            "The two difference calculations highly coincide",
        )?],
        Check::CoincideFirst => vec![coincide::coincide_first(measures)],
        Check::PartLast => vec![coincide::part_last(scene)],
        Check::Steps => coincide::steps(measures),
        Check::CoincideLast => measures
            .iter()
            .take(1)
            .map(coincide::coincide_last)
            .collect(),
        Check::GroupForms => coincide::group_forms(scene)?,
        Check::Stable => measures.iter().take(1).map(space::stable).collect(),
        Check::StableAndSteps => {
            let stable = measures.iter().take(1).map(space::stable);
            stable.chain(space::sensitive(measures)).collect()
        }
        Check::Cardan => cardan::cardan(measures)?,
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

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}
