//! A step solved by corrections that are each judged by those before.

use core::ops::Range;

use super::Newton;
use super::blocks;
use super::rate::is_last;
use super::rate::is_telling;
use super::rate::most_enough;
use super::rate::most_harmless;
use super::relative_size;
use super::scales;
use super::subtract;
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
use crate::scalar::is_infinite;
use crate::scalar::largest_of;
use crate::sensitivity::follows;
use crate::settings::AT_ROUNDING;
use crate::settings::LEFTOVER;
use crate::settings::ROUNDING;
use crate::settings::TRUSTED_STEPS;
use crate::settings::most_growth;

impl<S: Correctable<T>, T: Real> Newton<S, T> {
    /// The solution from the extrapolated start, if that fails from the plain guess, and if that fails from there by corrections
    /// that are shortened until the residual falls.
    #[cold]
    #[inline(never)]
    pub(super) fn solve_thoroughly(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        guess: S::Unknowns,
        statistics: &mut Statistics,
    ) -> Result<(S::Unknowns, Report), Fault> {
        self.shifts.choose_order(&scales::<S, T>(known, &self.x));
        let ahead = if self.trust == 0 {
            // From further away, so that convergence shows above rounding.
            self.shifts.shortly_ahead(guess)
        } else {
            self.shifts.ahead(guess)
        };
        let starts = [ahead, guess];
        let attempts = if self.shifts.are_zero() { 1 } else { 2 };
        let mut outcome = Err(Failure::Stalled);
        for x in starts.into_iter().take(attempts) {
            self.start(x);
            outcome = self.iterate(scene, step, known, None, statistics);
            if outcome.is_ok() {
                break;
            }
        }
        let failure = match outcome {
            Ok(report) => return Ok((self.x, report)),
            Err(failure) => failure,
        };
        self.trust = 0;
        // Where damping fails as well, it is told how Newton's method did.
        let fault = self.loose(known).unwrap_or_else(|| self.fault(failure));
        let history = self.history;
        for x in [guess, ahead].into_iter().take(attempts) {
            let measures = self.measures(scene, step, known, x);
            self.start(x);
            if let Ok(report) = self.iterate(scene, step, known, Some(&measures), statistics) {
                return Ok((self.x, report));
            }
        }
        self.history = history;
        Err(fault)
    }

    fn start(&mut self, x: S::Unknowns) {
        self.x = x;
        self.previous.as_mut().fill(T::constant(f64::INFINITY));
        self.history = History::default();
    }

    fn iterate(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        measures: Option<&S::Unknowns>,
        statistics: &mut Statistics,
    ) -> Result<Report, Failure> {
        let mut growths = 0;
        let mut before = T::constant(0.0);
        while self.history.iterations() < self.settings.max_iterations {
            S::residual_and_jacobian(scene, step, &self.x, &mut self.r, &mut self.j);
            statistics.iterations += 1;
            require_finite(&self.r)?;
            // Any residual would be nothing beside it.
            if self.j.entries().iter().any(is_infinite) {
                return Err(Failure::Singular);
            }

            let correction = self.j.solve(&self.r).ok_or(Failure::Singular)?;
            let from = self.x;
            subtract(&mut self.x, &correction);
            require_finite(&self.x)?;

            let progress = self.progress(&correction, known);
            self.history.push(progress.size.to_f64());
            if self.history.iterations() == 2 && is_telling(before) {
                self.learn(&correction, known);
            }
            let tolerance = self.settings.tolerance;
            if self.history.iterations() >= 2
                && self.settings.is_above_rounding()
                && measures.is_none()
                && !S::HAS_KINKS
                && is_last(progress.size, before, tolerance)
            {
                return Ok(self.report(Success::Converged));
            }
            if progress.converged {
                let is_shrinking = progress.size <= before;
                if is_shrinking || self.residual_has_fallen(scene, step, known, statistics) {
                    return Ok(self.report(Success::Converged));
                }
            }
            if progress.shrinking {
                growths = 0;
            } else if self.residual_is_rounding(known)
                && self.undetermined(&correction, known).is_none()
            {
                return Ok(self.report(Success::AtFloor));
            } else if measures.is_none() {
                growths += 1;
                if growths >= self.settings.max_growths {
                    return Err(Failure::Diverged);
                }
            }
            if let Some(measures) = measures {
                self.shorten(scene, step, measures, &from, &correction, statistics)?;
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

    /// Takes in how the first correction was followed by this second one. Newton's method converges quadratically:
    /// had all of the first been smaller by a factor, the second would have been by its square.
    fn learn(&mut self, second: &S::Unknowns, known: &[T]) {
        let largest = T::constant(LEFTOVER) * T::EPSILON;
        let mut square = T::constant(LEFTOVER);
        for (unknowns, scale) in self.blocks(known) {
            let size = largest_of(second.as_ref(), &unknowns);
            let is_seen = size > T::constant(AT_ROUNDING) * T::EPSILON * scale;
            if is_seen && largest * scale < square * size {
                square = largest * scale / size;
            }
        }
        let is_due = self.trust == 0;
        let (mut enough, mut part, mut harmless) = (self.enough, self.part, self.harmless);
        for (unknowns, scale) in self.blocks(known) {
            let own = harmless.as_mut().iter_mut();
            for harmless in own.take(unknowns.end).skip(unknowns.start) {
                *harmless = most_harmless::<T>() * scale;
            }
            let limit = square.sqrt() * largest_of(self.previous.as_ref(), &unknowns);
            let most = most_enough(self.settings.tolerance, S::HAS_KINKS) * scale;
            let limit = if limit > most { most } else { limit };
            let limits = enough.as_mut().iter_mut().zip(part.as_mut());
            for (enough, part) in limits.take(unknowns.end).skip(unknowns.start) {
                if is_due || limit > *enough {
                    *enough = limit;
                    // What is nothing, and stays so, needs no correction.
                    let is_nothing = limit <= T::constant(0.0);
                    *part = if is_nothing { limit } else { limit / scale };
                }
            }
        }
        (self.enough, self.part, self.harmless) = (enough, part, harmless);
        // A tolerance near rounding asks for the thorough way.
        if is_due && self.shifts.are_many() && self.settings.is_above_rounding() {
            self.trust = TRUSTED_STEPS;
        }
    }

    fn report(&self, success: Success) -> Report {
        Report {
            iterations: self.history.iterations(),
            success,
        }
    }

    /// Blames the first component that is not finite, or else the largest residual.
    #[cold]
    pub(crate) fn fault(&self, failure: Failure) -> Fault {
        let (r, x) = (self.r.as_ref(), self.x.as_ref());
        let (place, value) = if let Some((row, value)) = first_not_finite(r) {
            (Place::Equation(row), value)
        } else if let Some((i, value)) = first_not_finite(x) {
            (Place::Unknown(i), value)
        } else {
            let row = largest_row(r);
            let value = r.get(row).map_or(0.0, |value| value.to_f64());
            (Place::Equation(row), value)
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
        let mut progress = Progress {
            size: relative_size::<S, T>(known, &self.x, correction),
            converged: true,
            shrinking: true,
        };
        for (unknowns, scale) in self.blocks(known) {
            let length = largest_of(correction.as_ref(), &unknowns);
            let before = largest_of(self.previous.as_ref(), &unknowns);
            let within = length <= self.settings.tolerance * scale;
            if !within {
                progress.converged = false;
                progress.shrinking &= length < before;
            }
        }
        progress
    }

    /// Whether every |rᵢ| is within rounding of Σ |Jᵢⱼ| |xⱼ|, the size of its terms (the componentwise
    /// backward error of Oettli and Prager, 1964). It tells noise from corrections that do not shrink because
    /// Newton's method fails.
    fn residual_is_rounding(&self, known: &[T]) -> bool {
        let rounding = T::constant(ROUNDING) * T::EPSILON;
        let r = self.r.as_ref().iter();
        r.zip(self.rows())
            .all(|(r, row)| r.abs() <= rounding * self.terms(row, known))
    }

    /// Whether all equations hold at `x` to ten digits of their terms.
    pub(crate) fn holds_at(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        x: S::Unknowns,
    ) -> bool {
        self.x = x;
        S::residual_and_jacobian(scene, step, &self.x, &mut self.r, &mut self.j);
        let digits = most_growth::<T>() * T::EPSILON;
        let r = self.r.as_ref().iter();
        r.zip(self.rows())
            .all(|(r, row)| r.abs() <= digits * self.terms(row, known))
    }

    /// The first block that is not known to ten digits, although what it is corrected by is more than rounding to an equation: an
    /// unknown that is small among large terms has fewer digits and needs no more. Nor does one that no state follows from, such as
    /// the multiplier of a constraint on positions, which has ε/h².
    fn undetermined(&self, correction: &S::Unknowns, known: &[T]) -> Option<(usize, T)> {
        let digits = most_growth::<T>() * T::EPSILON;
        let rounding = T::constant(ROUNDING) * T::EPSILON;
        let follows = follows::<S, T>();
        let blocks: &[Unknown] = S::UNKNOWNS;
        let mut pairs = self.blocks(known).zip(blocks);
        pairs.find_map(|((unknowns, scale), block)| {
            let size = largest_of(correction.as_ref(), &unknowns);
            let leads_nowhere = !block.told && !follows;
            let is_known = size <= digits * scale
                || leads_nowhere
                || self.rows().all(|row| {
                    let own = row.iter().take(unknowns.end).skip(unknowns.start);
                    let felt = own.fold(T::constant(0.0), |sum, entry| sum + entry.abs() * size);
                    felt <= rounding * self.terms(row, known)
                });
            (!is_known).then(|| (unknowns.start, size / scale))
        })
    }

    /// What is not known where the equations hold to rounding all the same.
    #[cold]
    fn loose(&self, known: &[T]) -> Option<Fault> {
        let (unknown, part) = match self.residual_is_rounding(known) {
            true => self.undetermined(&self.previous, known)?,
            false => return None,
        };
        let is_finite = part.is_finite();
        is_finite.then(|| Fault {
            failure: Failure::Loose,
            place: Place::Unknown(unknown),
            value: part.to_f64(),
        })
    }

    /// The rows of the Jacobian.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[T]> {
        let n = self.r.as_ref().len().max(1);
        self.j.entries().chunks_exact(n)
    }

    /// The size of the terms of an equation with this row of the Jacobian, each unknown as large as its block.
    pub(super) fn terms(&self, row: &[T], known: &[T]) -> T {
        let mut terms = T::constant(0.0);
        for (unknowns, scale) in self.blocks(known) {
            let entries = row.iter().take(unknowns.end).skip(unknowns.start);
            for entry in entries {
                terms = terms + entry.abs() * scale;
            }
        }
        terms
    }

    /// The blocks of unknowns with their scales.
    fn blocks<'a>(&'a self, known: &'a [T]) -> impl Iterator<Item = (Range<usize>, T)> + 'a {
        blocks::<S, T>(known, &self.x)
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

/// The position of the largest magnitude among finite numbers.
fn largest_row<T: Real>(r: &[T]) -> usize {
    let (mut largest, mut most) = (0, T::constant(0.0));
    for (row, value) in r.iter().enumerate() {
        if value.abs() > most {
            (largest, most) = (row, value.abs());
        }
    }
    largest
}

/// Keeps NaN and infinity out of every comparison that follows.
fn require_finite<T: Real>(values: &impl AsRef<[T]>) -> Result<(), Failure> {
    match first_not_finite(values.as_ref()) {
        None => Ok(()),
        Some(_) => Err(Failure::NotFinite),
    }
}
