//! Collocation with a step that follows the error.

use super::Coefficients;
use super::Collocated;
use super::Core;
use super::Flat;
use super::coefficients::LANES;
use super::coefficients::legendre;
use super::larger;
use super::zeros;
use crate::compensated::compensated_sums;
use crate::error::Fault;
use crate::integration::require_finite;
use crate::model::Flow;
use crate::model::Model;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::report::Statistics;
use crate::scheme::Adaptive;
use crate::scheme::Attempt;
use crate::scheme::Tolerance;
use crate::scheme::Variable;
use crate::scheme::rates;

/// [`Gauss`](crate::Gauss) with `S` stages, 3 ≤ S ≤ 8, for an [`Adaptive`](crate::Adaptive) run.
///
/// Error estimate: with the coefficients γₖ of the rates f along the step in Legendre polynomials, |h γₛ₋₁|²/|h γ₀, h γ₁|.
/// The error of collocation is the integral of its defect, Σ γₖ Pₖ for k ≥ s, times the resolvent of the linearised flow
/// (Alekseev and Gröbner; Hairer, Lubich and Wanner, II.1.2, theorem 1.5), which is orthogonal to it but for its own
/// coefficients from s on. If those decay like those of f, both give one factor |γₛ|/|γ₀|, of which γₛ₋₁, one order more, is
/// known. So the estimate is of order 2 S − 1 where the error is of order 2 S + 1: it is on the safe side.
pub struct VariableGauss<M: Collocated<T>, const S: usize, T: Packed> {
    core: Core<M, T>,
    t: T,
    start: Flat<M, T>,
    weights: Flat<M, T>,
    floor: T,
    /// Of the accepted step.
    accepted: Option<Accepted<M, T>>,
}

struct Accepted<M: Collocated<T>, T: Packed> {
    t: T,
    h: T,
    start: Flat<M, T>,
    lost: Flat<M, T>,
    end: Flat<M, T>,
    weights: Flat<M, T>,
}

impl<M: Collocated<T>, const S: usize, T: Packed> VariableGauss<M, S, T> {
    /// How far h f at the end of the step is from the polynomial through the stages, none of which is there: a kink between the last
    /// stage and the end is seen by nothing else.
    fn defect_at_end(&self, h: T) -> T {
        let (end, _) = compensated_sums(&self.start, &self.core.change, &self.core.lost);
        let rates = rates::<M, T>(&self.core.scene, self.t + h, &end);
        let zero = T::constant(0.0);
        let stages = self.core.coefficients.stages;
        // Pₖ(1) = 1
        let at_end = self
            .core
            .coefficients
            .legendre
            .map(|column| column.iter().take(stages).fold(zero, |sum, p| sum + *p));
        let rows = self.core.rates.as_ref().iter().zip(self.weights.as_ref());
        let squares = rows.zip(rates.as_ref()).map(|((row, weight), rate)| {
            let terms = at_end.iter().zip(row.numbers());
            let expected = terms.fold(zero, |sum, (p, rate)| sum + *p * *rate);
            let size = (h * *rate - expected) * *weight;
            size * size
        });
        squares.fold(zero, |sum, square| sum + square).sqrt()
    }
}

/// Share of the tolerance that the sweeps may leave. Larger saves a sweep at times, and disturbs the estimate.
const SWEEPS_SHARE: f64 = 0.1;

impl<M: Collocated<T>, T: Packed> Adaptive<VariableGauss<M, LANES, T>, T> {
    /// The same run with so many stages, 3 to 8: one compiled function for all.
    pub(crate) fn with_stages(mut self, stages: usize) -> Self {
        self.method.change(|scheme| {
            scheme.core.coefficients = Coefficients::new(usize::max(stages, 3));
        });
        self
    }
}

impl<M: Collocated<T>, const S: usize, T: Packed> Variable<T> for VariableGauss<M, S, T> {
    type Model = M;
    const PREFERS_EQUAL_STEPS: bool = true;

    fn new(parameters: &<M as Model<T>>::Parameters) -> Self {
        const { assert!(S >= 3 && S <= LANES, "3 to 8 stages") };
        let zero = T::constant(0.0);
        let mut core = Core::new(parameters, Coefficients::new(S));
        core.wants_spectrum = true;
        Self {
            core,
            t: zero,
            start: zeros::<M, T>(),
            weights: zeros::<M, T>(),
            floor: zero,
            accepted: None,
        }
    }

    fn order(&self) -> usize {
        2 * self.core.coefficients.stages - 1
    }

    fn attempt(
        &mut self,
        t: T,
        x: &Flat<M, T>,
        h: T,
        tolerance: &Tolerance<T>,
        statistics: &mut Statistics,
    ) -> Result<Attempt<T>, Fault> {
        let (one, zero) = (T::constant(1.0), T::constant(0.0));
        (self.t, self.start) = (t, *x);
        let share = T::constant(SWEEPS_SHARE);
        self.floor = zero;
        for (weight, x) in self.weights.as_mut().iter_mut().zip(x.as_ref()) {
            *weight = one / (share * tolerance.of(*x, *x));
            let rounding = T::constant(64.0) * T::EPSILON * x.abs() * *weight;
            self.floor = larger(self.floor, rounding);
        }
        if !self.core.has_past() {
            self.core.begin(t, x, h, statistics);
        }
        let sweeps = self
            .core
            .solve(t, x, h, &self.weights, self.floor, statistics)?;
        require_finite(&self.core.change)?;

        let sizes = &self.core.spectrum;
        let low = larger(sizes[0], sizes[1]).sqrt();
        // Where the linearised flow is stiff, its coefficients do not decay, and only γ does. At a kink neither does fast enough for one
        // coefficient to tell the next.
        let size = sizes[self.core.coefficients.stages - 1].sqrt();
        let error = if self.core.is_stiff() || <M as Flow<T>>::FLOW_HAS_KINKS {
            share * size
        } else if low > zero {
            share * sizes[self.core.coefficients.stages - 1] / low
        } else {
            zero
        };
        let error = if <M as Flow<T>>::FLOW_HAS_KINKS {
            larger(error, share * self.defect_at_end(h))
        } else {
            error
        };
        Ok(Attempt {
            error,
            iterations: sweeps as usize,
        })
    }

    fn accept(&mut self) -> Flat<M, T> {
        let lost = self.core.lost;
        let (end, rest) = compensated_sums(&self.start, &self.core.change, &lost);
        self.core.lost = rest;
        self.core.take();
        self.accepted = Some(Accepted {
            t: self.t,
            h: self.core.h,
            start: self.start,
            lost,
            end,
            weights: self.weights,
        });
        end
    }

    /// A step of length θ h of the same scheme, for its end is exact to order 2 S where the polynomial of the step is so to
    /// S + 1 only; the polynomial is where it starts, and what is returned where it fails.
    fn at(&self, theta: T) -> Flat<M, T> {
        let Some(step) = &self.accepted else {
            return self.start;
        };
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        if theta == one {
            return step.end;
        }
        let mut core = self.core.copy();
        core.follow(zero, theta);
        let mut unused = Statistics::default();
        let h = theta * step.h;
        let solved = core.solve(
            step.t,
            &step.start,
            h,
            &step.weights,
            self.floor,
            &mut unused,
        );
        if solved.is_ok() {
            return compensated_sums(&step.start, &core.change, &step.lost).0;
        }
        // ∫₀^θ Pₖ = (Pₖ₊₁(θ) − Pₖ₋₁(θ))/(2 (2k + 1))
        let p = legendre(theta);
        let mut x = step.start;
        for (x, row) in x.as_mut().iter_mut().zip(self.core.known.as_ref()) {
            for k in 0..self.core.coefficients.stages.min(LANES - 1) {
                let terms = self.core.coefficients.legendre.iter().zip(row.numbers());
                let coefficient = terms.fold(zero, |sum, (p, l)| sum + p[k] * *l);
                let below = if k == 0 { -one } else { p[k - 1] };
                let integral = (p[k + 1] - below) / T::constant((4 * k + 2) as f64);
                *x = *x + integral * coefficient;
            }
        }
        x
    }

    fn restart(&mut self) {
        self.core.forget();
    }
}
