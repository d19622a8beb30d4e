//! The stage equations by functional sweeps, the stages side by side.

use core::ops::Range;

use super::Collocated;
use super::Stages;
use super::coefficients::LANES;
use super::coefficients::Row;
use super::coefficients::shifted;
use super::within_digits;
use crate::description::Variable;
use crate::integration::FlatState;
use crate::model::Flow;
use crate::model::Model;
use crate::packed::Arithmetic;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::packed::Work;

/// Sweeps in which the change does not shrink before the sweeps are given up. Fewer give up on a bad start.
const MOST_GROWTHS: u32 = 2;

/// Sweeps before they are given up, in double precision: there, Newton's method costs less.
const MOST_SWEEPS: u32 = 60;

/// Sweeps over which changes are summed up and rates are measured: an error may take two to come back to where it was. With one, rates
/// vary too much to foretell how many sweeps the rest takes.
const PAIR: u32 = 2;

/// By how much the change of the last sweep may exceed what the rate foretold.
const SURPRISE: f64 = 8.0;

/// Variables that are renewed one after the other; more take longer to compile, and those that have no more to do with
/// each other than attitude and angular velocity gain nothing.
const BLOCKS: usize = 4;

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
        let guess = *self.guess;
        let x = self.x.as_ref();
        let times = T::Pack::<LANES>::pack(self.times);
        let (mut stages, mut increments) = (Aligned(*self.known), Aligned(*self.known));
        let (stages, increments) = (&mut stages.0, &mut increments.0);
        for (stage, x) in stages.as_mut().iter_mut().zip(x) {
            let sums = arithmetic.combine(&guess, stage.numbers());
            *stage = T::Pack::pack(shifted(*x, sums));
        }

        let mut renewal = Renewal {
            arithmetic,
            mu: *self.mu,
            hb: self.hb,
            x,
            weights: self.weights.as_ref(),
            squares: [T::constant(0.0); LANES],
            is_measured: true,
        };
        let [zero, half, one] = [0.0, 0.5, 1.0].map(T::constant);
        let most = within_digits::<T>(MOST_SWEEPS);
        let (mut sweeps, mut growths) = (0, 0);
        // Sweeps to the next look at the changes, and those since the last that are looked at.
        let (mut next_look, mut is_last) = (PAIR, false);
        let mut before: Option<T> = None;
        let mut expected = zero;
        loop {
            if is_last {
                let rates = match self.alone {
                    None => M::flow(self.scene, times, stages),
                    Some(scene) => one_by_one::<M, T>(scene, &self.times, stages),
                };
                for (to, rate) in self.rates.as_mut().iter_mut().zip(rates.as_ref()) {
                    *to = T::Pack::pack(product(rate.numbers(), &renewal.hb));
                }
                if let Some((columns, spectrum)) = self.spectrum {
                    let increments = core::hint::black_box(self.rates.as_ref());
                    let (columns, mut squares) = (*columns, [zero; LANES]);
                    for (row, weight) in increments.iter().zip(renewal.weights) {
                        let coefficients = arithmetic.combine(&columns, row.numbers());
                        for (square, coefficient) in squares.iter_mut().zip(coefficients) {
                            let size = coefficient * *weight;
                            *square = *square + size * size;
                        }
                    }
                    *spectrum = squares;
                }
                return (End::Converged, sweeps);
            }
            renewal.is_measured = next_look <= PAIR;
            match self.alone {
                None => {
                    renewal.block::<M, 0>(self.scene, times, increments, stages);
                    renewal.block::<M, 1>(self.scene, times, increments, stages);
                    renewal.block::<M, 2>(self.scene, times, increments, stages);
                    renewal.block::<M, 3>(self.scene, times, increments, stages);
                }
                Some(scene) => {
                    let rates = one_by_one::<M, T>(scene, &self.times, stages);
                    renewal.rows::<M>(0..x.len(), &rates, increments, stages);
                }
            }
            sweeps += 1;
            next_look -= 1;
            if next_look > 0 {
                continue;
            }

            let squares = core::mem::replace(&mut renewal.squares, [zero; LANES]);
            let change = squares.iter().fold(zero, |sum, s| sum + *s).sqrt();
            if !change.is_finite() {
                return (End::NotFinite, sweeps);
            }
            next_look = PAIR;
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

/// Where whole vectors are, no line of the cache is crossed.
#[repr(align(64))]
struct Aligned<X>(X);

/// How the stages become those of the next sweep: variable by variable, each from the newest of the others, so that what two
/// variables owe each other comes back to the first in one sweep and not in two (Gauss–Seidel).
struct Renewal<'a, T: Packed, A> {
    arithmetic: A,
    mu: [Row<T>; LANES],
    /// h bᵢ
    hb: Row<T>,
    x: &'a [T],
    weights: &'a [T],
    /// By stage, the squares of what changes where that is measured.
    squares: Row<T>,
    is_measured: bool,
}

impl<T: Packed, A: Arithmetic<T>> Renewal<'_, T, A> {
    /// Renews variable `B`, if there is one. Of its rates no more is computed than its own.
    #[inline(always)]
    fn block<M: Collocated<T>, const B: usize>(
        &mut self,
        scene: &<M as Flow<T::Pack<LANES>>>::FlowScene,
        times: T::Pack<LANES>,
        increments: &mut Stages<M, T>,
        stages: &mut Stages<M, T>,
    ) {
        let block = const { block(<M as Model<T>>::DESCRIPTION.states, B) };
        if let Some((start, end)) = block {
            let rates = M::flow(scene, times, stages);
            self.rows::<M>(start..end, &rates, increments, stages);
        }
    }

    /// Renews the rows `part`.
    #[inline(always)]
    fn rows<M: Collocated<T>>(
        &mut self,
        part: Range<usize>,
        rates: &Stages<M, T>,
        increments: &mut Stages<M, T>,
        stages: &mut Stages<M, T>,
    ) {
        let (rates, stages) = (rates.as_ref(), stages.as_mut());
        for i in part.clone() {
            increments.as_mut()[i] = T::Pack::pack(product(rates[i].numbers(), &self.hb));
        }
        // Numbers of a row are wanted in all lanes of a vector: loads do that in passing, shuffles would take half of the
        // time, so they had better be in memory.
        let increments = core::hint::black_box(&*increments).as_ref();
        for i in part {
            let sums = self.arithmetic.combine(&self.mu, increments[i].numbers());
            let moved = shifted(self.x[i], sums);
            if self.is_measured {
                let before = stages[i].numbers();
                for (square, (moved, before)) in
                    self.squares.iter_mut().zip(moved.iter().zip(before))
                {
                    let change = (*moved - *before) * self.weights[i];
                    *square = *square + change * change;
                }
            }
            stages[i] = T::Pack::pack(moved);
        }
    }
}

/// The rows of variable `b`; the last of [`BLOCKS`] has those of all others.
const fn block(states: &[Variable], b: usize) -> Option<(usize, usize)> {
    if b >= states.len() {
        return None;
    }
    let (mut start, mut end, mut i) = (0, 0, 0);
    while i < states.len() {
        let size = states[i].rows * states[i].cols;
        if i < b {
            start += size;
        }
        if i <= b || b + 1 == BLOCKS {
            end += size;
        }
        i += 1;
    }
    Some((start, end))
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
