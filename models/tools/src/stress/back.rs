//! The same runs on their way back: from where they end, with the step turned round.

use residua::erased::AnySolver;

use super::Case;
use super::Kind;
use super::alone;

/// The way back of those of `cases` that get to a state after `steps` steps.
pub fn on_their_way_back<'c>(
    solver: &dyn AnySolver,
    cases: impl Iterator<Item = &'c Case>,
    steps: u64,
) -> Vec<Case> {
    let turned = cases.filter_map(|case| {
        let made = alone(solver, case, steps);
        let end = made.states.last().filter(|_| made.error.is_none())?;
        Some(Case {
            kind: Kind::Back,
            parameters: case.parameters.clone(),
            start: end.clone(),
            h: -case.h,
        })
    });
    turned.collect()
}
