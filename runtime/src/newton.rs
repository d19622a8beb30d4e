//! Newton's method for the unknowns of one step: r(x) = 0, x ← x − J(x)⁻¹ r(x).

use core::ops::Range;

use crate::description::Unknown;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::report::Success;
use crate::scalar::Real;
use crate::scalar::first_not_finite;
use crate::settings::AT_ROUNDING;
use crate::settings::LEFTOVER;
use crate::settings::RATE_MARGIN;
use crate::settings::ROUNDING;
use crate::settings::Settings;
use crate::settings::TRUSTED_STEPS;
use crate::shifts::Shifts;

/// Newton's method with its workspace, made once per run.
pub(crate) struct Newton<S: Correctable<T>, T: Real> {
    pub(crate) settings: Settings<T>,
    /// The last iterate.
    x: S::Unknowns,
    /// The residual before the last correction.
    r: S::Unknowns,
    /// The Jacobian before the last correction.
    j: S::Jacobian,
    /// The last correction but one.
    previous: S::Unknowns,
    /// Where earlier solutions lay from their guesses.
    shifts: Shifts<S::Unknowns>,
    /// First corrections up to here, unknown by unknown, leave less than rounding, as second corrections told.
    enough: S::Unknowns,
    /// Steps until that is found out anew.
    trust: u32,
    history: History,
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
            shifts: Shifts::new(zeros),
            enough: zeros,
            trust: 0,
            history: History::default(),
        }
    }

    /// The unknowns of the step from `known`, the flat state: from the extrapolated start, and if that fails from
    /// the plain guess.
    pub(crate) fn solve(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        statistics: &mut Statistics,
    ) -> Result<(S::Unknowns, Report), Fault> {
        let guess = S::guess(scene, step);
        // Now and then from further away, so that convergence shows above rounding.
        let starts = [self.shifts.ahead(guess, self.trust == 0), guess];
        let attempts = if self.shifts.are_zero() { 1 } else { 2 };
        let mut outcome = Err(Failure::Stalled);
        for x in starts.into_iter().take(attempts) {
            self.start(x);
            outcome = self.iterate(scene, step, known, statistics);
            if outcome.is_ok() {
                break;
            }
        }
        let report = match outcome {
            Ok(report) => report,
            Err(failure) => {
                self.enough.as_mut().fill(T::constant(0.0));
                return Err(self.fault(failure));
            }
        };
        self.shifts.push(&self.x, &guess);
        Ok((self.x, report))
    }

    /// The corrections of the last [`Newton::solve`].
    pub(crate) fn history(&self) -> History {
        self.history
    }

    fn start(&mut self, x: S::Unknowns) {
        self.x = x;
        self.previous.as_mut().fill(T::constant(f64::INFINITY));
        self.history = History::default();
    }

    #[inline(never)]
    fn iterate(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        statistics: &mut Statistics,
    ) -> Result<Report, Failure> {
        let mut growths = 0;
        let mut before = T::constant(0.0);
        while self.history.iterations() < self.settings.max_iterations {
            S::residual_and_jacobian(scene, step, &self.x, &mut self.r, &mut self.j);
            statistics.residuals += 1;
            statistics.jacobians += 1;
            require_finite(&self.r)?;

            statistics.factorizations += 1;
            let correction = self.j.solve(&self.r).ok_or(Failure::Singular)?;
            subtract(&mut self.x, &correction);
            statistics.iterations += 1;
            require_finite(&self.x)?;

            let progress = self.progress(&correction, known);
            self.history.push(progress.size.to_f64());
            if self.history.iterations() == 1 {
                if self.is_enough(&correction) {
                    return Ok(self.report(Success::Converged, progress));
                }
            } else {
                if self.history.iterations() == 2 {
                    self.learn(&correction, known);
                }
                if self.is_last(progress.size, before) {
                    return Ok(self.report(Success::Converged, progress));
                }
            }
            if progress.converged {
                let is_shrinking = progress.size <= before;
                if is_shrinking || self.residual_has_fallen(scene, step, known, statistics) {
                    return Ok(self.report(Success::Converged, progress));
                }
            }
            if progress.shrinking {
                growths = 0;
            } else if self.residual_is_rounding(known) {
                return Ok(self.report(Success::AtFloor, progress));
            } else {
                growths += 1;
                if growths >= self.settings.max_growths {
                    return Err(Failure::Diverged);
                }
            }
            self.previous = correction;
            before = progress.size;
        }
        Err(Failure::Stalled)
    }

    /// Whether the residual after the correction is less than a tenth of that before, or rounding. Where there is
    /// no larger correction before one within the tolerance, nothing else tells convergence from an equation so
    /// steep that no correction is large.
    #[cold]
    fn residual_has_fallen(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        statistics: &mut Statistics,
    ) -> bool {
        let before = self.r;
        S::residual(scene, step, &self.x, &mut self.r);
        statistics.residuals += 1;
        let tenth = T::constant(0.1);
        let pairs = self.r.as_ref().iter().zip(before.as_ref());
        let mut fell = pairs.map(|(r, before)| r.abs() <= tenth * before.abs());
        fell.all(|fell| fell) || self.residual_is_rounding(known)
    }

    /// Whether the error left after this first correction is far below rounding, if Newton's method converges as it
    /// did of late.
    #[inline]
    fn is_enough(&mut self, correction: &S::Unknowns) -> bool {
        if self.trust == 0 || self.settings.tolerance < T::EPSILON {
            return false;
        }
        self.trust -= 1;
        let pairs = correction.as_ref().iter().zip(self.enough.as_ref());
        let mut within = pairs.map(|(c, enough)| c.abs() <= *enough);
        within.all(|within| within)
    }

    /// Takes in how the first correction was followed by this second one. Newton's method converges quadratically:
    /// had all of the first been smaller by a factor, the second would have been by its square.
    fn learn(&mut self, second: &S::Unknowns, known: &[T]) {
        let largest = T::constant(LEFTOVER) * T::EPSILON;
        let mut square = T::constant(LEFTOVER);
        for (unknowns, scale) in self.blocks(known) {
            let size = self::largest(&second.as_ref()[unknowns]);
            let is_seen = size > T::constant(AT_ROUNDING) * T::EPSILON * scale;
            if is_seen && largest * scale < square * size {
                square = largest * scale / size;
            }
        }
        let is_due = self.trust == 0;
        let mut enough = self.enough;
        for (unknowns, _) in self.blocks(known) {
            let limit = square.sqrt() * self::largest(&self.previous.as_ref()[unknowns.clone()]);
            for enough in &mut enough.as_mut()[unknowns] {
                if is_due || limit > *enough {
                    *enough = limit;
                }
            }
        }
        self.enough = enough;
        if is_due {
            self.trust = TRUSTED_STEPS;
        }
    }

    /// Whether the error left after a correction of size `e` is within the tolerance even if convergence were
    /// only linear, at the rate of the last two corrections (Hairer and Wanner, *Solving ODEs II*, IV.8).
    fn is_last(&self, e: T, before: T) -> bool {
        e * e <= T::constant(RATE_MARGIN) * self.settings.tolerance * before
    }

    fn report(&self, success: Success, progress: Progress<T>) -> Report {
        Report {
            iterations: self.history.iterations(),
            success,
            correction: progress.size.to_f64(),
        }
    }

    /// Blames the first component that is not finite, or else the largest residual.
    fn fault(&self, failure: Failure) -> Fault {
        let (r, x) = (self.r.as_ref(), self.x.as_ref());
        let (place, value) = if let Some((row, value)) = first_not_finite(r) {
            (Place::Equation(row), value)
        } else if let Some((i, value)) = first_not_finite(x) {
            (Place::Unknown(i), value)
        } else {
            let row = largest_row(r);
            (Place::Equation(row), r[row].to_f64())
        };
        Fault {
            failure,
            place,
            value,
        }
    }

    /// Judges `correction` block by block. A block is measured by itself and by the state it advances, never
    /// by another block, so the verdict does not depend on the units of the states.
    fn progress(&self, correction: &S::Unknowns, known: &[T]) -> Progress<T> {
        let zero = T::constant(0.0);
        let mut progress = Progress {
            size: zero,
            converged: true,
            shrinking: true,
        };
        for (unknowns, scale) in self.blocks(known) {
            let length = largest(&correction.as_ref()[unknowns.clone()]);
            let before = largest(&self.previous.as_ref()[unknowns]);
            let within = length <= self.settings.tolerance * scale;
            if !within {
                progress.converged = false;
                progress.shrinking &= length < before;
            }
            if length > progress.size * scale {
                progress.size = length / scale;
            }
        }
        progress
    }

    /// Whether every |rᵢ| is within rounding of Σ |Jᵢⱼ| |xⱼ|, the size of its terms (the componentwise
    /// backward error of Oettli and Prager, 1964). It tells noise from corrections that do not shrink because
    /// Newton's method fails.
    fn residual_is_rounding(&self, known: &[T]) -> bool {
        let (r, j) = (self.r.as_ref(), self.j.entries());
        let rounding = T::constant(ROUNDING) * T::EPSILON;
        r.iter().zip(j.chunks_exact(r.len())).all(|(r, row)| {
            let mut terms = T::constant(0.0);
            for (unknowns, scale) in self.blocks(known) {
                for entry in &row[unknowns] {
                    terms = terms + entry.abs() * scale;
                }
            }
            r.abs() <= rounding * terms
        })
    }

    /// The blocks of unknowns, each with its scale: the largest |x| in the block and in the state it advances.
    fn blocks<'a>(&'a self, known: &'a [T]) -> impl Iterator<Item = (Range<usize>, T)> + 'a {
        let blocks: &[Unknown] = S::UNKNOWNS;
        let mut offset = 0;
        blocks.iter().map(move |block| {
            let unknowns = offset..offset + block.len;
            offset = unknowns.end;
            let now = match &block.measure {
                Some(states) => largest(&known[states.clone()]),
                None => T::constant(0.0),
            };
            let next = largest(&self.x.as_ref()[unknowns.clone()]);
            (unknowns, if next > now { next } else { now })
        })
    }
}

/// What one correction says about the iteration.
struct Progress<T> {
    /// The largest correction relative to the scale of its block.
    size: T,
    /// Every block is within the tolerance.
    converged: bool,
    /// Every block that is not within the tolerance was corrected less than the time before.
    shrinking: bool,
}

/// The largest magnitude among finite numbers.
fn largest<T: Real>(values: &[T]) -> T {
    values.iter().fold(T::constant(0.0), |largest, value| {
        let size = value.abs();
        if size > largest { size } else { largest }
    })
}

/// The position of the largest magnitude among finite numbers.
fn largest_row<T: Real>(r: &[T]) -> usize {
    let mut largest = 0;
    for (row, value) in r.iter().enumerate() {
        if value.abs() > r[largest].abs() {
            largest = row;
        }
    }
    largest
}

fn subtract<T: Real>(x: &mut impl AsMut<[T]>, correction: &impl AsRef<[T]>) {
    for (x, correction) in x.as_mut().iter_mut().zip(correction.as_ref()) {
        *x = *x - *correction;
    }
}

/// Keeps NaN and infinity out of every comparison that follows.
fn require_finite<T: Real>(values: &impl AsRef<[T]>) -> Result<(), Failure> {
    match first_not_finite(values.as_ref()) {
        None => Ok(()),
        Some(_) => Err(Failure::NotFinite),
    }
}

#[cfg(test)]
mod tests;
