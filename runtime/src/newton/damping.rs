//! Corrections that are shortened until the residual falls, where whole ones lead nowhere.

use super::Newton;
use crate::error::Failure;
use crate::linear::Correctable;
use crate::report::Statistics;
use crate::scalar::Real;
use crate::settings::FALL;
use crate::settings::MOST_HALVED;

impl<S: Correctable<T>, T: Real> Newton<S, T> {
    /// What the residual is measured by where corrections are shortened: the inverse of Σ |Jᵢⱼ| |xⱼ|, the size of the terms at `x`.
    pub(super) fn measures(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        known: &[T],
        x: S::Unknowns,
    ) -> S::Unknowns {
        let one = T::constant(1.0);
        self.x = x;
        S::residual_and_jacobian(scene, step, &self.x, &mut self.r, &mut self.j);
        let mut measures = self.x;
        for (measure, row) in measures.as_mut().iter_mut().zip(self.rows()) {
            let inverse = one / self.terms(row, known);
            *measure = if inverse.is_finite() { inverse } else { one };
        }
        measures
    }

    /// Halves a correction until the squares of the residual fall by a share of what they would if it were linear (Armijo 1966;
    /// Dennis and Schnabel, *Numerical Methods for Unconstrained Optimization and Nonlinear Equations*, 6.3). Between the
    /// pieces of a contact or of friction, whole corrections go back and forth for ever.
    pub(super) fn shorten(
        &mut self,
        scene: &S::Scene,
        step: &S::Step,
        measures: &S::Unknowns,
        from: &S::Unknowns,
        correction: &S::Unknowns,
        statistics: &mut Statistics,
    ) -> Result<(), Failure> {
        let squares = |r: &S::Unknowns| {
            let pairs = r.as_ref().iter().zip(measures.as_ref());
            pairs.fold(T::constant(0.0), |sum, (r, measure)| {
                sum + (*r * *measure) * (*r * *measure)
            })
        };
        let before = squares(&self.r);
        let (mut part, mut r) = (T::constant(1.0), self.r);
        for _ in 0..MOST_HALVED {
            self.x = *from;
            for (x, correction) in self.x.as_mut().iter_mut().zip(correction.as_ref()) {
                *x = *x - part * *correction;
            }
            S::residual(scene, step, &self.x, &mut r);
            statistics.residuals += 1;
            let most = (T::constant(1.0) - T::constant(FALL) * part) * before;
            if squares(&r) <= most {
                return Ok(());
            }
            part = T::constant(0.5) * part;
        }
        Err(Failure::Stalled)
    }
}
