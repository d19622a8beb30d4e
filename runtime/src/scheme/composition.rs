//! Symmetric compositions of symmetric steps.

use core::array;

use crate::description::Solver;
use crate::error::Fault;
use crate::integration::FlatState;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Model;
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
}

/// γ₁, …, γ₃ of 5 (Suzuki 1990): 1/(4 − ∛4) and −∛4/(4 − ∛4).
const FOURTH: [f64; 3] = [
    0.414_490_771_794_375_737_142_354_062_86,
    0.414_490_771_794_375_737_142_354_062_86,
    -0.657_963_087_177_502_948_569_416_251_44,
];

/// γ₁, …, γ₅ of 9 (Kahan and Li 1997; *Geometric Numerical Integration*, V.3.2, equation 3.11).
const SIXTH: [f64; 5] = [
    0.392_161_444_007_314_139_279_250_56,
    0.332_599_136_789_359_438_599_748_64,
    -0.706_246_172_557_639_359_809_964_82,
    0.082_213_596_293_550_800_231_490_45,
    0.798_543_990_934_829_963_398_950_35,
];

/// γ₁, …, γ₈ of 15 (Suzuki and Umeno 1993, McLachlan 1995; *Geometric Numerical Integration*, V.3.2, equation 3.12).
const EIGHTH: [f64; 8] = [
    0.741_670_364_350_612_953_448_227_80,
    -0.409_100_825_800_031_593_997_300_10,
    0.190_754_710_296_238_379_953_876_26,
    -0.573_862_471_116_082_266_656_387_73,
    0.299_064_181_303_655_923_844_463_54,
    0.334_624_918_245_298_183_784_957_98,
    0.315_293_092_396_766_596_632_056_66,
    -0.796_887_939_352_916_354_019_788_84,
];

/// γ₁, …, γₛ.
fn gammas<const S: usize>() -> [f64; S] {
    let half: &[f64] = match S {
        5 => &FOURTH,
        9 => &SIXTH,
        _ => &EIGHTH,
    };
    array::from_fn(|i| half[usize::min(i, S - 1 - i)])
}

impl<M: Method<T>, T: Real, const S: usize> Method<T> for Composed<M, S, T> {
    type Model = M::Model;

    fn new(parameters: &<Self::Model as Model<T>>::Parameters, h: T) -> Self {
        const { assert!(matches!(S, 5 | 9 | 15), "5, 9 or 15 steps") };
        let gammas = gammas::<S>();
        Self {
            steps: gammas.map(|gamma| M::new(parameters, T::constant(gamma) * h)),
            starts: array::from_fn(|i| T::constant(gammas[..i].iter().sum()) * h),
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
        for (step, start) in self.steps.iter_mut().zip(self.starts) {
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
        self.steps[0].history()
    }

    fn solver() -> Option<&'static Solver> {
        M::solver()
    }
}
