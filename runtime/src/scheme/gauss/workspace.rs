//! Collocation with any number of stages and any step.

use super::Collocated;
use super::Flat;
use super::Stages;
use super::coefficients::Coefficients;
use super::coefficients::LANES;
use super::coefficients::Row;
use super::coefficients::scaled;
use super::coefficients::shifted;
use super::larger;
use super::newton::Corrections;
use super::newton::Square;
use super::packed_parameters;
use super::sweeps::End;
use super::sweeps::Sweeps;
use super::zeros;
use crate::compensated::compensated_sums;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::integration::require_finite;
use crate::model::Flow;
use crate::model::Model;
use crate::model::Record;
use crate::packed::Pack;
use crate::packed::Packed;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;
use crate::scalar::Scalar;
use crate::settings::LEFTOVER;
use crate::settings::ROUNDING;

/// Most steps by Newton's method after one that sweeps could not solve: 1 after the first, twice as many each time that
/// sweeps fail again, half as many each time that they do not. More try sweeps too seldom where stiffness passes, fewer too
/// often where it does not.
const STIFF_STEPS: u32 = 64;

/// The stage equations were not solved.
const STAGES: Fault = Fault {
    failure: Failure::Stages,
    place: Place::State(0),
    value: 0.0,
};

/// The workspace of a step.
pub(crate) struct Core<M: Collocated<T>, T: Packed> {
    pub(super) coefficients: Coefficients<T>,
    pub(super) scene: <M as Flow<T>>::FlowScene,
    pub(super) packed: <M as Flow<T::Pack<LANES>>>::FlowScene,
    /// h cᵢ and h bᵢ of the step `h`.
    pub(super) h: T,
    pub(super) hc: Row<T>,
    pub(super) hb: Row<T>,
    /// h bᵢ f(Xᵢ) of the step that was taken last, of length `taken`; 0 if none was.
    pub(super) known: Stages<M, T>,
    pub(super) taken: T,
    /// From `known` to a first guess for a step of `ratio` times its length.
    pub(super) guess: [Row<T>; LANES],
    pub(super) ratio: T,
    /// h bᵢ f(Xᵢ)
    pub(super) rates: Stages<M, T>,
    /// Squares of the sizes of its Legendre coefficients, where they are wanted.
    pub(super) spectrum: Row<T>,
    pub(super) wants_spectrum: bool,
    /// Σᵢ h bᵢ f(Xᵢ)
    pub(super) change: Flat<M, T>,
    /// What the sums of increments have lost to rounding.
    pub(super) lost: Flat<M, T>,
    /// For stiff steps.
    pub(super) jacobian: Square<M, T>,
    pub(super) has_jacobian: bool,
    /// Steps to be solved by Newton's method before sweeps are tried again.
    pub(super) stiff: u32,
    /// So many after the next step that sweeps cannot solve.
    pub(super) patience: u32,
}

impl<M: Collocated<T>, T: Packed> Core<M, T> {
    pub(crate) fn new(
        parameters: &<M as Model<T>>::Parameters,
        coefficients: Coefficients<T>,
    ) -> Self {
        let (zero, row) = (T::constant(0.0), [T::constant(0.0); LANES]);
        let many = packed_parameters::<M, T>(parameters);
        let mut known = <M as Model<T::Pack<LANES>>>::start(&many).to_array();
        known.as_mut().fill(T::Pack::constant(0.0));
        Self {
            coefficients,
            scene: <M as Flow<T>>::flow_scene(parameters),
            packed: <M as Flow<T::Pack<LANES>>>::flow_scene(&many),
            h: zero,
            hc: row,
            hb: row,
            known,
            taken: zero,
            guess: [row; LANES],
            ratio: zero,
            rates: known,
            spectrum: row,
            wants_spectrum: false,
            change: zeros::<M, T>(),
            lost: zeros::<M, T>(),
            jacobian: [known; 2],
            has_jacobian: false,
            stiff: 0,
            patience: 1,
        }
    }

    /// There is a step to start from.
    pub(crate) fn has_past(&self) -> bool {
        self.taken != T::constant(0.0)
    }

    /// The last step was solved by Newton's method.
    pub(super) fn is_stiff(&self) -> bool {
        self.stiff > 0
    }

    /// Starts anew.
    pub(crate) fn forget(&mut self) {
        self.taken = T::constant(0.0);
    }

    /// The next step starts at `from` of the last one and has `ratio` times its length.
    pub(super) fn follow(&mut self, from: T, ratio: T) {
        self.ratio = ratio;
        self.h = ratio * self.taken;
        self.hc = scaled(self.h, self.coefficients.c);
        self.hb = self.coefficients.weights(self.h);
        self.guess = self.coefficients.extrapolation(from, ratio);
    }

    /// The same again.
    pub(super) fn copy(&self) -> Self {
        Self { ..*self }
    }

    /// A step that is exact to rounding.
    pub(crate) fn advance(
        &mut self,
        t: T,
        x: &mut Flat<M, T>,
        h: T,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        if !self.has_past() {
            self.begin(t, x, h, statistics);
        }
        let enough = T::constant(LEFTOVER) * T::EPSILON;
        let weights = self.weights(x, enough);
        let floor = T::constant(ROUNDING / LEFTOVER);
        let sweeps = self.solve(t, x, h, &weights, floor, statistics)?;
        let (sum, lost) = compensated_sums(x, &self.change, &self.lost);
        require_finite(&sum)?;
        (*x, self.lost) = (sum, lost);
        self.take();
        Ok(Report::converged(sweeps as usize))
    }

    /// The inverse of `share` of each variable's size, or of its change in the last step.
    #[inline]
    fn weights(&self, x: &Flat<M, T>, share: T) -> Flat<M, T> {
        let zero = T::constant(0.0);
        let mut weights = *x;
        let mut end = 0;
        for variable in <M as Model<T>>::DESCRIPTION.states {
            let block = end..end + variable.rows * variable.cols;
            end = block.end;
            let mut size = zero;
            for i in block.clone() {
                size = larger(size, x.as_ref()[i].abs());
                size = larger(size, self.change.as_ref()[i].abs());
            }
            let weight = if size > zero {
                T::constant(1.0) / (share * size)
            } else {
                zero
            };
            weights.as_mut()[block].fill(weight);
        }
        weights
    }

    /// Solves the stage equations; the step is taken by [`Core::take`].
    pub(crate) fn solve(
        &mut self,
        t: T,
        x: &Flat<M, T>,
        h: T,
        weights: &Flat<M, T>,
        floor: T,
        statistics: &mut Statistics,
    ) -> Result<u32, Fault> {
        self.prepare(h);
        let (mut end, mut sweeps) = match self.stiff {
            0 => self.sweep(t, x, weights, floor, false),
            _ => (End::Slow, 0),
        };
        if end == End::Converged {
            self.patience = (self.patience / 2).max(1);
        }
        let mut all = sweeps;
        if end == End::NotFinite {
            // Stages may be beyond what vectors can compute with, where numbers are not.
            self.begin(t, x, h, statistics);
            (end, sweeps) = self.sweep(t, x, weights, floor, true);
            all += sweeps;
        }
        if end == End::Slow {
            (end, sweeps) = self.correct(t, x, weights, floor, statistics);
            self.stiff = match self.stiff {
                _ if end != End::Converged => 0,
                0 => {
                    let more = (2 * self.patience).min(STIFF_STEPS);
                    core::mem::replace(&mut self.patience, more)
                }
                more => more - 1,
            };
        }
        statistics.iterations += u64::from(all);
        statistics.flows += u64::from(all + 1) * self.coefficients.stages as u64;
        let mut numbers = self.rates.as_ref().iter().enumerate();
        match end {
            End::Converged => {
                let sums = self.change.as_mut().iter_mut().zip(self.rates.as_ref());
                for (sum, rates) in sums {
                    *sum = total(rates.numbers());
                }
                Ok(sweeps)
            }
            End::NotFinite => Err(numbers
                .find_map(|(i, row)| {
                    let value = row.numbers().iter().find(|value| !value.is_finite())?;
                    Some(Fault {
                        failure: Failure::NotFinite,
                        place: Place::State(i),
                        value: value.to_f64(),
                    })
                })
                .unwrap_or(STAGES)),
            End::Slow => Err(STAGES),
        }
    }

    /// Newton's method, with the sizes of the Legendre coefficients where they are wanted.
    #[cold]
    fn correct(
        &mut self,
        t: T,
        x: &Flat<M, T>,
        weights: &Flat<M, T>,
        floor: T,
        statistics: &mut Statistics,
    ) -> (End, u32) {
        let mut corrections = Corrections::<M, T> {
            scene: &self.packed,
            stages: self.coefficients.stages,
            t,
            times: shifted(t, self.hc),
            hb: self.hb,
            mu: &self.coefficients.mu,
            x,
            weights,
            floor,
            change: &self.change,
            jacobian: &mut self.jacobian,
            is_known: &mut self.has_jacobian,
            rates: &mut self.rates,
        };
        let solved = corrections.run(statistics);
        if self.wants_spectrum {
            for k in 0..self.coefficients.stages {
                let columns = &self.coefficients.legendre;
                let rows = self.rates.as_ref().iter().zip(weights.as_ref());
                self.spectrum[k] = rows.fold(T::constant(0.0), |sum, (row, weight)| {
                    let terms = columns.iter().zip(row.numbers());
                    let value = terms.fold(T::constant(0.0), |sum, (p, l)| sum + p[k] * *l);
                    let size = value * *weight;
                    sum + size * size
                });
            }
        }
        solved
    }

    fn sweep(
        &mut self,
        t: T,
        x: &Flat<M, T>,
        weights: &Flat<M, T>,
        floor: T,
        is_alone: bool,
    ) -> (End, u32) {
        let wants_spectrum = self.wants_spectrum;
        T::work(Sweeps::<M, T> {
            scene: &self.packed,
            alone: is_alone.then_some(&self.scene),
            times: shifted(t, self.hc),
            hb: self.hb,
            mu: &self.coefficients.mu,
            guess: &self.guess,
            known: &self.known,
            x,
            weights,
            floor,
            rates: &mut self.rates,
            spectrum: wants_spectrum.then_some((&self.coefficients.legendre, &mut self.spectrum)),
        })
    }

    /// Computes what depends on the step and its ratio to the last one.
    #[inline]
    fn prepare(&mut self, h: T) {
        let zero = T::constant(0.0);
        if h != self.h {
            self.h = h;
            self.hc = scaled(h, self.coefficients.c);
            self.hb = self.coefficients.weights(h);
        }
        if self.taken != zero && h != self.ratio * self.taken {
            self.ratio = h / self.taken;
            self.guess = self
                .coefficients
                .extrapolation(T::constant(1.0), self.ratio);
        }
    }

    /// Starts from the rates at x.
    pub(crate) fn begin(&mut self, t: T, x: &Flat<M, T>, h: T, statistics: &mut Statistics) {
        self.taken = T::constant(0.0);
        self.ratio = T::constant(0.0);
        self.prepare(h);
        let rates = crate::scheme::rates::<M, T>(&self.scene, t, x);
        statistics.flows += 1;
        self.guess = self.coefficients.mu;
        self.change = rates;
        let rows = self.known.as_mut().iter_mut().zip(self.change.as_mut());
        for (known, change) in rows {
            let rate = *change;
            *known = T::Pack::pack(scaled(rate, self.hb));
            *change = h * rate;
        }
    }

    /// The solved step becomes the one to start from.
    #[inline]
    pub(crate) fn take(&mut self) {
        self.known = self.rates;
        self.taken = self.h;
    }
}

/// Σ, pair by pair.
#[inline]
fn total<T: Real>(row: &Row<T>) -> T {
    let [a, b, c, d, e, f, g, h] = *row;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
}
