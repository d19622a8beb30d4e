//! The stage equations by functional sweeps, the stages side by side.

use super::Collocated;
use super::Stages;
use super::coefficients::LANES;
use super::coefficients::Row;
use super::coefficients::shifted;
use super::within_digits;
use crate::integration::FlatState;
use crate::model::Flow;
use crate::packed::Arithmetic;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::packed::Work;

/// Sweeps in which the change does not shrink before the sweeps are given up. Fewer give up on a bad start.
const MOST_GROWTHS: u32 = 2;

/// Sweeps before they are given up, in double precision: there, Newton's method costs less.
const MOST_SWEEPS: u32 = 60;

/// Sweeps over which changes are summed up and rates are measured: where positions move momenta and these move positions,
/// it takes two for an error to come back to where it was.
const PAIR: u32 = 2;

/// By how much the change of the last sweep may exceed what the rate foretold.
const SURPRISE: f64 = 8.0;

/// Sweeps X ← x + h A f(X), until by their rate no more than 1 is left of the error of x + h Σ bᵢ f(Xᵢ), as `weights`
/// measure it.
///
/// The change is measured in the first two pairs of sweeps, of which the rate of contraction follows and with it the number
/// of sweeps that the rest takes, and in the last pair, which must confirm it (Hairer, Lubich and Wanner, *Geometric
/// Numerical Integration*, VIII.6, sweep until the change is rounding; what is left then has a sign, and is here made
/// so small that it does not add up).
pub(super) struct Sweeps<'a, M: Collocated<T>, T: Packed> {
    pub(super) scene: &'a <M as Flow<T::Pack<LANES>>>::FlowScene,
    /// For a flow that only one stage at a time can be computed of.
    pub(super) alone: Option<&'a <M as Flow<T>>::FlowScene>,
    pub(super) times: Row<T>,
    /// h bᵢ
    pub(super) hb: Row<T>,
    pub(super) mu: &'a [Row<T>; LANES],
    /// From `known` to a first guess.
    pub(super) guess: &'a [Row<T>; LANES],
    /// h bᵢ f(Xᵢ) of the step before.
    pub(super) known: &'a Stages<M, T>,
    pub(super) x: &'a FlatState<M, T>,
    pub(super) weights: &'a FlatState<M, T>,
    /// A change that may be all rounding.
    pub(super) floor: T,
    /// Overwritten with h bᵢ f(Xᵢ).
    pub(super) rates: &'a mut Stages<M, T>,
    /// Columns from the rates to their Legendre coefficients, and where the squares of their sizes go, if they are wanted.
    pub(super) spectrum: Option<(&'a [Row<T>; LANES], &'a mut Row<T>)>,
}

/// How sweeps ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    /// As wanted.
    Converged,
    /// They do not contract, or too slowly.
    Slow,
    /// A stage is infinite or not a number.
    NotFinite,
}

impl<M: Collocated<T>, T: Packed> Work<T> for Sweeps<'_, M, T> {
    type Output = (End, u32);

    #[inline(always)]
    fn run<A: Arithmetic<T>>(self, arithmetic: A) -> (End, u32) {
        let (mu, guess, hb) = (*self.mu, *self.guess, self.hb);
        let (x, weights) = (self.x.as_ref(), self.weights.as_ref());
        let times = T::Pack::<LANES>::pack(self.times);
        let mut stages = *self.known;
        for (stage, x) in stages.as_mut().iter_mut().zip(x) {
            let sums = arithmetic.combine(&guess, stage.numbers());
            *stage = T::Pack::pack(shifted(*x, sums));
        }

        let [zero, half, one] = [0.0, 0.5, 1.0].map(T::constant);
        let most = within_digits::<T>(MOST_SWEEPS);
        let (mut sweeps, mut growths) = (0, 0);
        // Sweeps to the next look at the changes, and those since the last that are looked at.
        let (mut next_look, mut is_last) = (PAIR, false);
        let mut squares = [zero; LANES];
        let mut before: Option<T> = None;
        let mut expected = zero;
        loop {
            let rates = match self.alone {
                None => M::flow(self.scene, times, &stages),
                Some(scene) => one_by_one::<M, T>(scene, &self.times, &stages),
            };
            if is_last {
                for (to, rate) in self.rates.as_mut().iter_mut().zip(rates.as_ref()) {
                    *to = T::Pack::pack(product(rate.numbers(), &hb));
                }
                if let Some((columns, squares)) = self.spectrum {
                    let increments = core::hint::black_box(self.rates.as_ref());
                    *squares = [zero; LANES];
                    for (row, weight) in increments.iter().zip(weights) {
                        let coefficients = arithmetic.combine(columns, row.numbers());
                        for (square, coefficient) in squares.iter_mut().zip(coefficients) {
                            let size = coefficient * *weight;
                            *square = *square + size * size;
                        }
                    }
                }
                return (End::Converged, sweeps);
            }
            let mut increments = rates;
            for row in increments.as_mut() {
                *row = T::Pack::pack(product(row.numbers(), &hb));
            }
            // Numbers of a row are wanted in all lanes of a vector: loads do that in passing, shuffles would take half of the
            // time, so they had better be in memory.
            let increments = core::hint::black_box(&increments);
            let is_measured = next_look <= PAIR;
            let rows = stages.as_mut().iter_mut().zip(increments.as_ref());
            for ((stage, increment), (x, weight)) in rows.zip(x.iter().zip(weights)) {
                let sums = arithmetic.combine(&mu, increment.numbers());
                let moved = shifted(*x, sums);
                if is_measured {
                    for (i, square) in squares.iter_mut().enumerate() {
                        let change = (moved[i] - stage.numbers()[i]) * *weight;
                        *square = *square + change * change;
                    }
                }
                *stage = T::Pack::pack(moved);
            }
            sweeps += 1;
            next_look -= 1;
            if next_look > 0 {
                continue;
            }

            let change = squares.iter().fold(zero, |sum, s| sum + *s).sqrt();
            if !change.is_finite() {
                return (End::NotFinite, sweeps);
            }
            (squares, next_look) = ([zero; LANES], PAIR);
            let Some(former) = before.replace(change) else {
                continue;
            };
            if expected > zero {
                // The check of what the rate has foretold.
                is_last = change <= expected || change <= self.floor;
                expected = zero;
                growths += u32::from(!is_last);
            } else if change < former {
                let rate = change / former;
                let mut left = change * rate / (one - rate);
                let mut more = 0;
                while left > one && more < most {
                    left = left * rate;
                    more += PAIR;
                }
                let is_rounding = change <= self.floor && rate > half;
                is_last = more == 0 || is_rounding;
                if sweeps + more > most && !is_last {
                    return (End::Slow, sweeps);
                }
                next_look = u32::max(more, PAIR);
                expected = (0..more / PAIR).fold(T::constant(SURPRISE) * change, |e, _| e * rate);
            } else {
                is_last = change <= self.floor;
                growths += u32::from(!is_last);
            }
            if growths > MOST_GROWTHS {
                return (End::Slow, sweeps);
            }
        }
    }
}

#[inline(always)]
fn product<T: Packed>(a: &Row<T>, b: &Row<T>) -> Row<T> {
    let mut product = *a;
    for (a, b) in product.iter_mut().zip(b) {
        *a = *a * *b;
    }
    product
}

/// The rates of all stages, one stage after the other.
#[cold]
#[inline(never)]
fn one_by_one<M: Collocated<T>, T: Packed>(
    scene: &<M as Flow<T>>::FlowScene,
    times: &Row<T>,
    stages: &Stages<M, T>,
) -> Stages<M, T> {
    let mut rates = *stages;
    let mut x = super::zeros::<M, T>();
    for (i, t) in times.iter().enumerate() {
        for (x, stage) in x.as_mut().iter_mut().zip(stages.as_ref()) {
            *x = stage.numbers()[i];
        }
        let rate = crate::scheme::rates::<M, T>(scene, *t, &x);
        for (to, rate) in rates.as_mut().iter_mut().zip(rate.as_ref()) {
            to.numbers_mut()[i] = *rate;
        }
    }
    rates
}
