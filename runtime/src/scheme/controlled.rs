//! Steps as long as a tolerance allows.

use super::Tolerance;
use super::Variable;
use super::rates;
use crate::compensated::compensated_sum;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Flow;
use crate::model::Model;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;

/// A run with outputs every h and steps between as long as the tolerance allows, of the [`Variable`] scheme `V`.
///
/// The step follows the error estimate by a PI controller, h ← h · 0.9 · (1/e)^(0.3/p) · (e₋₁/e)^(0.4/p) (Gustafsson 1991;
/// Hairer and Wanner, *Solving Ordinary Differential Equations II*, IV.2; Söderlind 2003), a rejected one by
/// 0.9 · (1/e)^(1/p); the first one is found as in Hairer, Nørsett and Wanner I, II.4. Linear
/// invariants are kept as the scheme keeps them; quadratic ones of Gauss schemes to what sweeps may leave, a tenth of the
/// tolerance per step; that energies do not drift is lost with equal steps.
pub type Adaptive<V, T = f64> = Integration<Controlled<V, T>, T>;

/// The method of an [`Adaptive`] run. It is ahead of the output by up to a step, and starts anew where a state is not that
/// which it gave last.
pub struct Controlled<V: Variable<T>, T: Real> {
    scheme: V,
    scene: <V::Model as Flow<T>>::FlowScene,
    tolerance: Tolerance<T>,
    /// Errors between these leave the step as it is.
    steady: (T, T),
    /// Of the outputs.
    h: T,
    /// The next step; 0 before the first.
    step: T,
    /// The error of the last accepted step.
    error: T,
    /// The accepted step: its start, its length, the time at its end with what rounding has taken from it, the state there.
    from: T,
    length: T,
    to: (T, T),
    end: FlatState<V::Model, T>,
    /// What was given last.
    given: Option<(T, FlatState<V::Model, T>)>,
}

/// Share of the step that the estimate allows.
const SAFETY: f64 = 0.9;
/// Exponents, times p, of the controller (Hairer and Wanner II, IV.2: 0.7 and 0.4 of the error and the one before).
const INTEGRAL: f64 = 0.7;
const PROPORTIONAL: f64 = 0.4;
/// Least and largest factor of the step.
const LEAST_FACTOR: f64 = 0.2;
const MOST_FACTOR: f64 = 5.0;
/// A step that could grow by up to this factor, or should shrink by up to that one, keeps its length where equal steps cost
/// less (Hairer and Wanner II, IV.8).
const STEADY: (f64, f64) = (1.2, 0.96);
/// Error below which one is as good as another.
const LEAST_ERROR: f64 = 1e-30;
/// Error that the controller takes for the one before the first.
const FIRST_ERROR: f64 = 1e-4;
/// Rejected steps in a row before the run is given up.
const MOST_REJECTED: u32 = 60;

impl<V: Variable<T>, T: Real> Adaptive<V, T> {
    /// The same run with another tolerance of a step.
    pub fn with_tolerance(mut self, tolerance: Tolerance<T>) -> Self {
        self.method.tolerance = tolerance;
        self
    }
}

impl<V: Variable<T>, T: Real> Method<T> for Controlled<V, T> {
    type Model = V::Model;

    fn new(parameters: &<V::Model as Model<T>>::Parameters, h: T) -> Self {
        let zero = T::constant(0.0);
        let scheme = V::new(parameters);
        Self {
            steady: steady(&scheme),
            scheme,
            scene: V::Model::flow_scene(parameters),
            tolerance: Tolerance::default(),
            h,
            step: zero,
            error: zero,
            from: zero,
            length: zero,
            to: (zero, zero),
            end: super::gauss::zeros::<V::Model, T>(),
            given: None,
        }
    }

    fn advance(
        &mut self,
        t: T,
        x: &mut FlatState<V::Model, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        let follows = self.given.is_some_and(|(time, state)| {
            time == t && state.as_ref().iter().zip(x.as_ref()).all(|(a, b)| a == b)
        });
        if !follows {
            self.begin(t, x, statistics);
        }
        let target = t + self.h;
        let mut iterations = 0;
        while (target - self.to.0) * self.h > T::constant(0.0) {
            match self.step(statistics) {
                Ok(made) => iterations += made,
                Err(fault) => {
                    self.given = None;
                    return Err(fault);
                }
            }
        }
        *x = if target == self.to.0 {
            self.end
        } else {
            self.scheme.at((target - self.from) / self.length)
        };
        self.given = Some((target, *x));
        Ok(Report::converged(iterations))
    }
}

/// The errors that lead to the factors of steady steps, at rest.
fn steady<V: Variable<T>, T: Real>(scheme: &V) -> (T, T) {
    let p = T::constant(scheme.order() as f64);
    let leading_to = |factor: f64| T::constant(SAFETY / factor).powf(p);
    (leading_to(STEADY.0), leading_to(STEADY.1))
}

impl<V: Variable<T>, T: Real> Controlled<V, T> {
    /// Makes another scheme of it, before the first step.
    pub(crate) fn change(&mut self, change: impl FnOnce(&mut V)) {
        change(&mut self.scheme);
        self.steady = steady(&self.scheme);
    }

    /// Starts at (t, x).
    fn begin(&mut self, t: T, x: &FlatState<V::Model, T>, statistics: &mut Statistics) {
        self.scheme.restart();
        self.to = (t, T::constant(0.0));
        self.end = *x;
        self.error = T::constant(FIRST_ERROR);
        self.step = self.first_step(t, x);
        statistics.flows += 2;
    }

    /// A first step of which the scheme's error is a hundredth of the tolerance, as an Euler step sees it (Hairer, Nørsett
    /// and Wanner I, II.4).
    fn first_step(&self, t: T, x: &FlatState<V::Model, T>) -> T {
        let [zero, hundredth, tiny] = [0.0, 0.01, 1e-6].map(T::constant);
        let norm = |v: &FlatState<V::Model, T>| {
            let scaled = v.as_ref().iter().zip(x.as_ref());
            scaled.fold(zero, |norm, (v, x)| {
                let size = v.abs() / self.tolerance.of(*x, *x);
                if size > norm { size } else { norm }
            })
        };
        let rate = rates::<V::Model, T>(&self.scene, t, x);
        let (d0, d1) = (norm(x), norm(&rate));
        let most = self.h.abs() * T::constant(1e3);
        let least = |a: T, b: T| if a < b { a } else { b };
        let forward = |h: T| if self.h > zero { h } else { -h };
        let h0 = if d0 > zero && d1 > zero {
            least(hundredth * d0 / d1, most)
        } else {
            tiny * most
        };
        let mut moved = *x;
        for (x, rate) in moved.as_mut().iter_mut().zip(rate.as_ref()) {
            *x = *x + forward(h0) * *rate;
        }
        let mut bend = rates::<V::Model, T>(&self.scene, t + forward(h0), &moved);
        for (bend, rate) in bend.as_mut().iter_mut().zip(rate.as_ref()) {
            *bend = *bend - *rate;
        }
        let d2 = norm(&bend) / h0;
        let size = if d1 > d2 { d1 } else { d2 };
        let p = T::constant(self.scheme.order() as f64);
        let h1 = if size.is_finite() && size > zero {
            (hundredth / size).powf(T::constant(1.0) / p)
        } else {
            most
        };
        forward(least(least(T::constant(100.0) * h0, h1), most))
    }

    /// One accepted step.
    fn step(&mut self, statistics: &mut Statistics) -> Result<usize, Fault> {
        let (t, one) = (self.to.0, T::constant(1.0));
        let p = T::constant(self.scheme.order() as f64);
        let mut iterations = 0;
        let mut last = None;
        for _ in 0..MOST_REJECTED {
            let h = self.step;
            let (end, rest) = compensated_sum(t, h + self.to.1);
            if end == t {
                break;
            }
            let tried = self
                .scheme
                .attempt(t, &self.end, h, &self.tolerance, statistics);
            match tried {
                Ok(attempt) if attempt.error <= one => {
                    iterations += attempt.iterations;
                    statistics.accepted += 1;
                    (self.from, self.length, self.to) = (t, h, (end, rest));
                    self.end = self.scheme.accept();
                    self.step = h * self.factor(attempt.error, p, last.is_some());
                    return Ok(iterations);
                }
                Ok(attempt) => {
                    iterations += attempt.iterations;
                    let factor = T::constant(SAFETY) * (one / attempt.error).powf(one / p);
                    // NaN, too.
                    let is_sound = factor > T::constant(LEAST_FACTOR);
                    self.step = h * if is_sound {
                        factor
                    } else {
                        T::constant(LEAST_FACTOR)
                    };
                    last = Some(None);
                }
                Err(fault) => {
                    self.step = h * T::constant(0.5);
                    last = Some(Some(fault));
                }
            }
            statistics.rejected += 1;
        }
        let short = Fault {
            failure: Failure::StepTooSmall,
            place: Place::State(0),
            value: self.step.abs().to_f64(),
        };
        Err(last.flatten().unwrap_or(short))
    }

    /// By what the step changes after one with that error.
    fn factor(&mut self, error: T, p: T, was_rejected: bool) -> T {
        let one = T::constant(1.0);
        let bounded = |x: T, least: f64, most: f64| {
            let (least, most) = (T::constant(least), T::constant(most));
            let x = if x > least { x } else { least };
            if x > most { most } else { x }
        };
        let error = bounded(error, LEAST_ERROR, 1.0);
        let before = core::mem::replace(&mut self.error, error);
        if V::PREFERS_EQUAL_STEPS && !was_rejected && error < self.steady.1 && error > self.steady.0
        {
            return one;
        }
        let power = |x: T, exponent: f64| x.powf(T::constant(exponent) / p);
        let factor =
            T::constant(SAFETY) * power(one / error, INTEGRAL) * power(before, PROPORTIONAL);
        bounded(
            factor,
            LEAST_FACTOR,
            if was_rejected { 1.0 } else { MOST_FACTOR },
        )
    }
}
