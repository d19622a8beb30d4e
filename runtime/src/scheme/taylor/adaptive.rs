//! Taylor series of which the step follows from their last two coefficients.

use super::Expansion;
use super::MOST_ORDER;
use super::root;
use crate::compensated::compensated_sum;
use crate::compensated::compensated_sums;
use crate::convolution::Convolved;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::integration::require_finite;
use crate::model::Series;
use crate::report::Report;
use crate::report::Statistics;
use crate::scheme::Tolerance;

/// The most that a step may be longer than the one before it. Larger trusts coefficients further that rounding has reached;
/// smaller takes more steps to find the first length.
const GROWTH: f64 = 8.0;

/// Part of the step that the estimate allows. Less wins digits, more risks them.
const SAFETY: f64 = 0.95;

/// The order for loose tolerances. An order costs much the same wherever it is, as its sums are in lanes, and the estimate of
/// a step costs as much as some orders: on the pendulums, lower ones take up to half as long again at errors of 10⁻³.
const LEAST_ORDER: usize = 18;

/// A run of the continuous equations of the model `M` by their Taylor series, with steps as long as a tolerance allows. The
/// `h` of the run is the interval of its output, which comes from the series itself.
///
/// The last two terms of a step are within the tolerance: |xₙ,ᵢ| hⁿ ≤ absolute + relative |x₀,ᵢ| for n = p − 1 and p. A step is
/// found before it is taken, so none is rejected. The order is p = ⌈−¾ ln relative⌉ + 1, or 18 if that is less: between that of least work where
/// work is as p² (Jorba and Zou, *Experiment. Math.* 14 (2005), section 3.2: −½ ln ε + 1) and where it is as p (−ln ε), as
/// sums in lanes have it.
pub type AdaptiveTaylor<M, T = f64> = Integration<Adaptive<M, T>, T>;

/// The method of an [`AdaptiveTaylor`].
pub struct Adaptive<M: Series<T>, T: Convolved> {
    expansion: Expansion<M, T>,
    /// The interval of the output.
    h: T,
    tolerance: Tolerance<T>,
    /// 1/n
    roots: [f64; MOST_ORDER + 1],
    piece: Option<Piece<FlatState<M, T>, T>>,
}

/// What is known of the motion: the series at `start`, good for `length`.
#[derive(Clone, Copy)]
struct Piece<X, T> {
    start: T,
    /// What rounding has taken from `start`.
    rest: T,
    length: T,
    /// What the next series should be good for, by this one.
    next: T,
    /// The unit of time of the next series.
    planned: T,
    /// What the sums of steps have lost of the state at `start` to rounding.
    lost: X,
    /// The state that was given out last: what the next call has to start from.
    given: X,
}

impl<M: Series<T>, T: Convolved> AdaptiveTaylor<M, T> {
    /// The same run with other tolerances and the order that is least work for them.
    pub fn with_tolerance(mut self, tolerance: Tolerance<T>) -> Self {
        let method = &mut self.method;
        method.tolerance = tolerance;
        method.expansion.set_order(order_for(&tolerance));
        method.piece = None;
        self
    }

    /// The same run with another order, 2 to [`MOST_ORDER`].
    pub fn with_order(mut self, order: usize) -> Self {
        self.method.expansion.set_order(order.max(2));
        self.method.piece = None;
        self
    }
}

/// ⌈−¾ ln ε⌉ + 1, and no less than [`LEAST_ORDER`].
fn order_for<T: Convolved>(tolerance: &Tolerance<T>) -> usize {
    let relative = tolerance.relative.to_f64();
    let ln = root::log2(relative.max(f64::MIN_POSITIVE)) * core::f64::consts::LN_2;
    let order = -0.75 * ln + 1.0;
    // Towards zero, and the least for NaN.
    (order as usize + 1).clamp(LEAST_ORDER, MOST_ORDER)
}

impl<M: Series<T>, T: Convolved> Method<T> for Adaptive<M, T> {
    type Model = M;

    fn new(parameters: &M::Parameters, h: T) -> Self {
        let tolerance = Tolerance::default();
        Self {
            expansion: Expansion::new(parameters, order_for(&tolerance)),
            h,
            tolerance,
            roots: core::array::from_fn(|n| 1.0 / n.max(1) as f64),
            piece: None,
        }
    }

    fn advance(
        &mut self,
        t: T,
        x: &mut FlatState<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        let mut piece = match self.piece.take() {
            Some(piece) if piece.given.as_ref() == x.as_ref() => piece,
            Some(_) | None => self.begin(t, x, statistics)?,
        };
        let end = t + self.h;
        while is_beyond(piece.until(end), piece.length) {
            piece = self.proceed(&piece, statistics)?;
        }
        let theta = piece.until(end) / self.expansion.unit();
        let change = self.expansion.change(theta);
        let start = self.expansion.coefficients()[0];
        let (sum, _) = compensated_sums(&start, &change, &piece.lost);
        require_finite(&sum)?;
        *x = sum;
        piece.given = *x;
        self.piece = Some(piece);
        Ok(Report::converged(0))
    }
}

impl<X, T: Convolved> Piece<X, T> {
    /// The time to `t`.
    fn until(&self, t: T) -> T {
        t - self.start - self.rest
    }
}

/// |a| > |b|
fn is_beyond<T: Convolved>(a: T, b: T) -> bool {
    a.abs() > b.abs()
}

impl<M: Series<T>, T: Convolved> Adaptive<M, T> {
    /// The series at a new start.
    #[cold]
    fn begin(
        &mut self,
        t: T,
        x: &FlatState<M, T>,
        statistics: &mut Statistics,
    ) -> Result<Piece<FlatState<M, T>, T>, Fault> {
        let mut lost = *x;
        lost.as_mut().fill(T::constant(0.0));
        let mut unit = self.h;
        // Coefficients that overflow ask for a smaller unit of time.
        for _ in 0..ATTEMPTS {
            self.expansion.forget();
            self.expansion.expand(t, x, unit);
            statistics.flows += 1;
            let size = self.size();
            if size < LARGEST {
                break;
            }
            unit = unit * T::constant(SHRINK);
        }
        let (_, length) = self.lengths(t)?;
        self.expansion.forget();
        // Once more in units of its length: far from it, the estimate is rough.
        self.expansion.expand(t, x, length);
        statistics.flows += 1;
        self.piece_at((t, T::constant(0.0)), *x, lost)
    }

    /// The series at the end of `piece`.
    #[inline]
    fn proceed(
        &mut self,
        piece: &Piece<FlatState<M, T>, T>,
        statistics: &mut Statistics,
    ) -> Result<Piece<FlatState<M, T>, T>, Fault> {
        let unit = self.expansion.unit();
        let change = match piece.length == unit {
            true => self.expansion.increment(),
            false => self.expansion.change(piece.length / unit),
        };
        let start = self.expansion.coefficients()[0];
        let (x, lost) = compensated_sums(&start, &change, &piece.lost);
        require_finite(&x)?;
        let (t, rest) = compensated_sum(piece.start, piece.length + piece.rest);
        self.expansion.expand(t, &x, piece.planned);
        statistics.flows += 1;
        statistics.accepted += 1;
        let mut made = self.piece_at((t, rest), piece.given, lost)?;
        // By the series before, so that nothing waits for an estimate; by this one where that was too bold.
        if made.length == self.expansion.unit() {
            made.planned = piece.next;
        }
        Ok(made)
    }

    fn piece_at(
        &self,
        (start, rest): (T, T),
        given: FlatState<M, T>,
        lost: FlatState<M, T>,
    ) -> Result<Piece<FlatState<M, T>, T>, Fault> {
        let (length, next) = self.lengths(start)?;
        Ok(Piece {
            start,
            rest,
            length,
            next,
            planned: next,
            lost,
            given,
        })
    }

    /// How far from `t` the series is used, and the next one should be. That is one unit of time where the series is good
    /// for it, so that the state at its end needs no estimate.
    #[inline(always)]
    fn lengths(&self, t: T) -> Result<(T, T), Fault> {
        let unit = self.expansion.unit();
        let size = self.size();
        // Near 1, both roots are the same; far from it, the one that gives less.
        let highest = self.expansion.order();
        let order = if size < 1.0 { highest } else { highest - 1 };
        let theta = root::root(size, self.roots[order]).min(GROWTH);
        let next = unit * T::constant(theta * SAFETY);
        let length = if size <= 1.0 {
            unit
        } else {
            unit * T::constant(theta)
        };
        if size.is_finite() && length.is_finite() && t + length != t && t + next != t {
            return Ok((length, next));
        }
        Err(Fault {
            failure: Failure::StepTooSmall,
            place: Place::State(0),
            value: length.abs().to_f64(),
        })
    }

    /// The larger of the last two terms as a multiple of the tolerance, in the largest component. NaN stays.
    #[inline(always)]
    fn size(&self) -> f64 {
        let coefficients = self.expansion.coefficients();
        let p = self.expansion.order();
        let mut largest = 0.0;
        for i in 0..coefficients[0].as_ref().len() {
            let x = coefficients[0].as_ref()[i];
            let scale = T::constant(1.0) / self.tolerance.of(x, x);
            for n in [p - 1, p] {
                let size = (coefficients[n].as_ref()[i].abs() * scale).to_f64();
                largest = if size <= largest { largest } else { size };
            }
        }
        largest
    }
}

/// Units of time that are tried for a first series.
const ATTEMPTS: usize = 40;
/// By what the unit of time shrinks.
const SHRINK: f64 = 1.0 / 64.0;
/// Sizes of terms beyond which the unit of time is no measure.
const LARGEST: f64 = 1e100;
