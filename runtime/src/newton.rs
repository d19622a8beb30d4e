//! Newton's method for the unknowns of one step: r(x) = 0, x ← x − J(x)⁻¹ r(x).

mod damping;
pub(crate) mod rate;
mod thorough;

use crate::description::Unknown;
use crate::error::Fault;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;
use crate::scalar::larger;
use crate::scalar::largest_of;
use crate::settings::MOST_QUICK;
use crate::settings::Settings;
use crate::settings::TRUSTED_STEPS;
use crate::settings::USUAL;
use crate::settings::most_growth;
use crate::shifts::Shifts;
use core::ops::Range;
use rate::is_settled;

/// Newton's method with its workspace, made once per run.
///
/// A step is solved quickly where earlier ones allow it: from an extrapolated start, with corrections in closed form,
/// up to one of a size that was `enough` before. Now and then, and wherever that fails, it is solved thoroughly: every
/// correction by a pivoted elimination and judged by those before it. That one finds out what is enough.
pub(crate) struct Newton<S: Correctable<T>, T: Real> {
    pub(crate) settings: Settings<T>,
    /// The last iterate of a thorough solution.
    x: S::Unknowns,
    /// The residual before its last correction.
    r: S::Unknowns,
    /// The Jacobian before the last correction.
    j: S::Jacobian,
    /// The last correction but one.
    previous: S::Unknowns,
    /// The corrections of the last thorough solution.
    history: History,
    /// Where earlier solutions lay from their guesses.
    shifts: Shifts<S::Unknowns>,
    /// Corrections up to here, unknown by unknown, leave less than rounding,
    enough: S::Unknowns,
    /// if they are also no more than that part of the scale: it may have become smaller.
    part: S::Unknowns,
    /// Those up to here leave little, whatever the equations have become.
    harmless: S::Unknowns,
    /// Steps until these are found out anew.
    trust: u32,
    /// The first correction of the last quick step.
    first: S::Unknowns,
}

impl<S: Correctable<T>, T: Real> Newton<S, T> {
    pub(crate) fn new(settings: Settings<T>) -> Self {
        let (zeros, j) = S::zeros();
        Self {
            settings,
            x: zeros,
            r: zeros,
            j,
            previous: zeros,
            history: History::default(),
            shifts: Shifts::new(zeros),
            enough: zeros,
            part: zeros,
            harmless: zeros,
            trust: 0,
            first: zeros,
        }
    }

    /// The unknowns of the step from `known`, the flat state, by corrections judged by those before.
    pub(crate) fn solve(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        statistics: &mut Statistics,
    ) -> Result<(S::Unknowns, Report), Fault> {
        let guess = S::guess(scene, step);
        if guess.as_ref().is_empty() {
            self.trust = TRUSTED_STEPS;
            return Ok((guess, Report::converged(0)));
        }
        let (x, report) = self.solve_thoroughly(scene, step, known, guess, statistics)?;
        self.shifts.push(&x, &guess);
        self.shifts.set_out();
        Ok((x, report))
    }

    /// How many of so many steps may be solved quickly before convergence is measured again.
    #[inline]
    pub(crate) fn trusted(&self, steps: u64) -> u64 {
        steps.min(u64::from(self.trust))
    }

    /// Takes in that so many of them were.
    #[inline]
    pub(crate) fn spend(&mut self, steps: u64) {
        // No more than were trusted.
        self.trust -= steps as u32;
    }

    /// The unknowns of a trusted step, and what was guessed; `None` where it needs to be solved thoroughly.
    #[inline]
    pub(crate) fn solve_quickly(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        statistics: &mut Statistics,
    ) -> Option<(S::Unknowns, S::Unknowns)> {
        let guess = S::guess(scene, step);
        if guess.as_ref().is_empty() {
            return Some((guess, guess));
        }
        let mut x = self.shifts.ahead_in_run(guess);
        let first = self.correction(scene, step, &x, statistics)?;
        subtract(&mut x, &first);
        if self.is_usual(&first) && self.is_enough(known, &x, &first) {
            self.first = first;
            return Some((x, guess));
        }
        let mut before = first;
        for _ in 1..self.settings.max_iterations.min(MOST_QUICK) {
            let correction = self.correction(scene, step, &x, statistics)?;
            subtract(&mut x, &correction);
            if self.is_enough(known, &x, &correction)
                && self.is_settled(known, &x, &before, &correction)
            {
                self.first = first;
                return Some((x, guess));
            }
            before = correction;
        }
        None
    }

    /// Takes in the solution of a quick step.
    #[inline]
    pub(crate) fn follow(&mut self, x: &S::Unknowns, guess: &S::Unknowns) {
        self.shifts.push(x, guess);
    }

    /// Drops what earlier steps told, where they were not followed by this one.
    pub(crate) fn forget(&mut self) {
        self.shifts = Shifts::new(self.x);
        self.trust = 0;
    }

    /// The last iterate of the last thorough solution, or of what was to become one.
    pub(crate) fn last(&self) -> S::Unknowns {
        self.x
    }

    /// The corrections of the last thorough solution.
    pub(crate) fn history(&self) -> History {
        self.history
    }

    /// J(x)⁻¹ r(x), if it can be trusted.
    #[inline]
    fn correction(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        x: &S::Unknowns,
        statistics: &mut Statistics,
    ) -> Option<S::Unknowns> {
        statistics.iterations += 1;
        if S::HAS_CORRECTION {
            let (correction, growth) = S::correction(scene, step, x);
            return (growth <= most_growth::<T>()).then_some(correction);
        }
        S::residual_and_jacobian(scene, step, x, &mut self.r, &mut self.j);
        self.j.solve(&self.r)
    }

    /// Whether a first correction is not much larger than the one of the step before: had the equations changed since
    /// convergence was measured, starts would be further off. False for NaN.
    #[inline]
    fn is_usual(&self, first: &S::Unknowns) -> bool {
        let usual = self.first.as_ref().iter().zip(self.harmless.as_ref());
        let pairs = first.as_ref().iter().zip(usual);
        let times = T::constant(USUAL);
        pairs.fold(true, |all, (c, (before, harmless))| {
            all & ((c.abs() <= times * before.abs()) | (c.abs() <= *harmless))
        })
    }

    /// Whether the next correction would be within the tolerance, as the last two tell.
    #[cold]
    fn is_settled(
        &self,
        known: &[T],
        x: &S::Unknowns,
        before: &S::Unknowns,
        last: &S::Unknowns,
    ) -> bool {
        let [before, last] =
            [before, last].map(|correction| relative_size::<S, T>(known, x, correction));
        is_settled(last, before, self.settings.tolerance)
    }

    /// Whether a correction of `x` to here is the last one. False for NaN.
    #[inline]
    fn is_enough(&self, known: &[T], x: &S::Unknowns, correction: &S::Unknowns) -> bool {
        let scales = scales::<S, T>(known, x);
        let limits = self.enough.as_ref().iter().zip(self.part.as_ref());
        let pairs = correction.as_ref().iter().zip(limits);
        // All are compared, so that there is one branch.
        pairs
            .zip(scales.as_ref())
            .fold(true, |all, ((c, (enough, part)), scale)| {
                all & (c.abs() <= *enough) & (c.abs() <= *part * *scale)
            })
    }
}

/// The blocks of unknowns, each with its scale: the largest |x| in the block and in the state that it advances.
fn blocks<'a, S: Correctable<T>, T: Real>(
    known: &'a [T],
    x: &'a S::Unknowns,
) -> impl Iterator<Item = (Range<usize>, T)> + 'a {
    let blocks: &[Unknown] = S::UNKNOWNS;
    let mut offset = 0;
    blocks.iter().map(move |block| {
        let unknowns = offset..offset + block.len;
        offset = unknowns.end;
        let now = match &block.measure {
            Some(states) => largest_of(known, states),
            None => T::constant(0.0),
        };
        let next = largest_of(x.as_ref(), &unknowns);
        (unknowns, larger(now, next))
    })
}

/// The scale of each unknown: that of its block.
#[inline]
pub(crate) fn scales<S: Correctable<T>, T: Real>(known: &[T], x: &S::Unknowns) -> S::Unknowns {
    let mut scales = *x;
    for (unknowns, scale) in blocks::<S, T>(known, x) {
        let own = scales.as_mut().iter_mut();
        for own in own.take(unknowns.end).skip(unknowns.start) {
            *own = scale;
        }
    }
    scales
}

/// The largest part of the scale of its block that a component of `correction` is.
fn relative_size<S: Correctable<T>, T: Real>(
    known: &[T],
    x: &S::Unknowns,
    correction: &S::Unknowns,
) -> T {
    let zero = T::constant(0.0);
    blocks::<S, T>(known, x).fold(zero, |most, (unknowns, scale)| {
        let size = largest_of(correction.as_ref(), &unknowns);
        if size > most * scale {
            size / scale
        } else {
            most
        }
    })
}

pub(crate) fn subtract<T: Real>(x: &mut impl AsMut<[T]>, correction: &impl AsRef<[T]>) {
    for (x, correction) in x.as_mut().iter_mut().zip(correction.as_ref()) {
        *x = *x - *correction;
    }
}

#[cfg(test)]
mod tests;
#[cfg(test)]
mod trust;
