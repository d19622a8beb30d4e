//! Symmetric compositions of symmetric steps.

use super::Collocated;
use super::Collocation;
use super::extended::Extended;
use crate::description::Solver;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Model;
use crate::packed::Packed;
use crate::report::History;
use crate::report::Report;
use crate::report::Statistics;
use crate::scalar::Real;

/// A run by Φ_h = Ψ_{γₛh} ∘ … ∘ Ψ_{γ₁h} with the step Ψ of `M`, a symmetric method of order 2 such as a midpoint rule, and
/// γᵢ = γₛ₊₁₋ᵢ: of order 4 for `S` = 5, 6 for 9 and 8 for 15. Symmetric; what every Ψ keeps, whatever the step, is kept.
///
/// Source: Hairer, Lubich and Wanner, *Geometric Numerical Integration*, V.3.2.
pub type Composition<M, const S: usize, T = f64> = Integration<Composed<M, S, T>, T>;

/// The method of a [`Composition`].
pub struct Composed<M, const S: usize, T> {
    steps: [M; S],
    /// When each of them starts, after the first.
    starts: [T; S],
    /// How many of them are taken.
    n: usize,
    /// The one that was tried last.
    last: usize,
}

/// γ₁, …, γ₃ of 5 (Suzuki 1990): 1/(4 − ∛4) and −∛4/(4 − ∛4).
const FOURTH: [Extended; 3] = [
    digits(414_490_771_794_375.0, 737_142_354_062_860.0),
    digits(414_490_771_794_375.0, 737_142_354_062_860.0),
    digits(-657_963_087_177_502.0, -948_569_416_251_440.0),
];

/// γ₁, …, γ₅ of 9 (Kahan and Li 1997; *Geometric Numerical Integration*, V.3.2, equation 3.11).
const SIXTH: [Extended; 5] = [
    digits(392_161_444_007_314.0, 139_279_250_560_000.0),
    digits(332_599_136_789_359.0, 438_599_748_640_000.0),
    digits(-706_246_172_557_639.0, -359_809_964_820_000.0),
    digits(82_213_596_293_550.0, 800_231_490_450_000.0),
    digits(798_543_990_934_829.0, 963_398_950_350_000.0),
];

/// γ₁, …, γ₈ of 15 (Suzuki and Umeno 1993, McLachlan 1995; *Geometric Numerical Integration*, V.3.2, equation 3.12).
const EIGHTH: [Extended; 8] = [
    digits(741_670_364_350_612.0, 953_448_227_800_000.0),
    digits(-409_100_825_800_031.0, -593_997_300_100_000.0),
    digits(190_754_710_296_238.0, 379_953_876_260_000.0),
    digits(-573_862_471_116_082.0, -266_656_387_730_000.0),
    digits(299_064_181_303_655.0, 923_844_463_540_000.0),
    digits(334_624_918_245_298.0, 183_784_957_980_000.0),
    digits(315_293_092_396_766.0, 596_632_056_660_000.0),
    digits(-796_887_939_352_916.0, -354_019_788_840_000.0),
];

/// A number of up to 30 digits behind the point, fifteen and fifteen.
const fn digits(first: f64, second: f64) -> Extended {
    let unit = Extended::new(1e15);
    let second = Extended::new(second).div(unit);
    Extended::new(first).add(second).div(unit)
}

/// γ₁, …, γₙ h of 5, 9 or 15 steps, and when they start.
fn substeps<T: Real, const S: usize>(n: usize, h: T) -> ([T; S], [T; S]) {
    let half: &[Extended] = match n {
        5 => &FOURTH,
        9 => &SIXTH,
        _ => &EIGHTH,
    };
    let (mut lengths, mut starts) = ([h; S], [h; S]);
    let mut before = Extended::ZERO;
    for i in 0..n {
        let gamma = half[usize::min(i, n - 1 - i)];
        (lengths[i], starts[i]) = (gamma.to::<T>() * h, before.to::<T>() * h);
        before = before.add(gamma);
    }
    (lengths, starts)
}

impl<M: Collocated<T>, T: Packed> Composition<Collocation<M, 1, T>, 15, T> {
    /// The same run with the order 4, 6 or 8: one compiled function for all.
    pub(crate) fn with_order(mut self, order: usize) -> Self {
        let n = match order {
            0..=4 => 5,
            5 | 6 => 9,
            _ => 15,
        };
        let (lengths, starts) = substeps::<T, 15>(n, self.h());
        let method = &mut self.method;
        for (step, length) in method.steps.iter_mut().zip(lengths) {
            step.h = length;
        }
        (method.starts, method.n) = (starts, n);
        self
    }
}

impl<M: Method<T>, T: Real, const S: usize> Method<T> for Composed<M, S, T> {
    type Model = M::Model;

    fn new(parameters: &<Self::Model as Model<T>>::Parameters, h: T) -> Self {
        const { assert!(matches!(S, 5 | 9 | 15), "5, 9 or 15 steps") };
        let (lengths, starts) = substeps::<T, S>(S, h);
        Self {
            steps: lengths.map(|length| M::new(parameters, length)),
            starts,
            n: S,
            last: 0,
        }
    }

    fn advance(
        &mut self,
        t: T,
        state: &mut FlatState<Self::Model, T>,
        statistics: &mut Statistics,
    ) -> Result<Report, Fault> {
        let (before, mut iterations) = (*state, 0);
        let mut report = Report::converged(0);
        let steps = self.steps[..self.n].iter_mut().zip(self.starts);
        for (i, (step, start)) in steps.enumerate() {
            self.last = i;
            match step.advance(t + start, state, statistics) {
                Ok(made) => report = made,
                Err(fault) => {
                    *state = before;
                    return Err(fault);
                }
            }
            iterations += report.iterations;
        }
        report.iterations = iterations;
        Ok(report)
    }

    fn history(&self) -> History {
        self.steps[self.last].history()
    }

    fn solver() -> Option<&'static Solver> {
        M::solver()
    }
}

#[cfg(test)]
mod tests {
    use super::EIGHTH;
    use super::Extended;
    use super::FOURTH;
    use super::SIXTH;

    /// Necessary for order p of a symmetric composition: Σγ = 1 and Σγᵏ = 0 for odd k < p (*Geometric Numerical Integration*,
    /// V.3.2). A coefficient is given to half of its last digit, 30 of them at order 4 and 26 at orders 6 and 8, and up to fifteen are summed up, each to the
    /// seventh power at most, which multiplies what it is off by 7.
    #[test]
    fn sums_of_odd_powers_vanish() {
        let all = [
            (&FOURTH[..], 4, 5e-31),
            (&SIXTH[..], 6, 5e-27),
            (&EIGHTH[..], 8, 5e-27),
        ];
        for (half, order, last_digit) in all {
            for k in (1..order).step_by(2) {
                let power = |x: Extended| (0..k).fold(Extended::ONE, |p, _| p.mul(x));
                let (middle, rest) = half.split_last().expect("a middle");
                let sum = rest.iter().fold(power(*middle), |sum, gamma| {
                    let power = power(*gamma);
                    sum.add(power).add(power)
                });
                let expected = if k == 1 { 1.0 } else { 0.0 };
                let off = sum.sub(Extended::new(expected)).hi.abs();
                assert!(
                    off < 7.0 * 15.0 * last_digit,
                    "order {order}, power {k}: {off:e}"
                );
            }
        }
    }
}
