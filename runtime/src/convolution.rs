//! Sums of products of two series, many pairs of series at a time.

#[cfg(feature = "ensemble")]
use pulp::NullaryFnOnce;
#[cfg(feature = "ensemble")]
use pulp::Simd;
#[cfg(feature = "ensemble")]
use pulp::x86::V3;

use crate::scalar::Real;
use crate::scalar::Scalar;

/// Rows of four numbers.
pub trait Rows<T>: AsRef<[[T; 4]]> + AsMut<[[T; 4]]> + Copy {}

impl<T: Copy, const N: usize> Rows<T> for [[T; 4]; N] {}

/// Zeros that stand before a series, so that sums can take products four at a time.
pub const BEFORE: usize = 2;

/// Products that are summed apart from each other: none waits for the one before it.
#[cfg(feature = "ensemble")]
const APART: usize = 4;

/// A number of which rows are computed with at a time.
pub trait Convolved: Real {
    /// Runs `work`, where the feature `ensemble` is on in vectors of the machine.
    fn convolve<W: Convolutions<Self>>(work: W);
}

/// What is to be computed.
pub trait Convolutions<T> {
    /// Computes it.
    fn run<A: Convolve<T>>(self, arithmetic: A);
}

/// Arithmetic on rows.
pub trait Convolve<T>: Copy {
    /// Σ aⱼ bₙ₋ⱼ, 1 < j < n − 1, lane by lane, with bᵢ in `b[i + BEFORE]`. All before b₂ is zero, and all after aₙ₋₂ finite.
    fn inner<L: Rows<T>>(self, a: &[L], b: &[L], n: usize, zeros: L) -> L;
    /// a b + c, lane by lane.
    fn multiply_add<L: Rows<T>>(self, a: &L, b: &L, c: &L) -> L;
}

/// One number after the other, products rounded.
#[derive(Clone, Copy, Debug)]
pub struct Each;

impl<T: Scalar> Convolve<T> for Each {
    #[inline(always)]
    fn inner<L: Rows<T>>(self, a: &[L], b: &[L], n: usize, mut zeros: L) -> L {
        for (row, sums) in zeros.as_mut().iter_mut().enumerate() {
            for (lane, sum) in sums.iter_mut().enumerate() {
                for j in 2..n.saturating_sub(1) {
                    *sum = *sum + a[j].as_ref()[row][lane] * b[n - j + BEFORE].as_ref()[row][lane];
                }
            }
        }
        zeros
    }

    #[inline(always)]
    fn multiply_add<L: Rows<T>>(self, a: &L, b: &L, c: &L) -> L {
        let mut sums = *c;
        let factors = a.as_ref().iter().zip(b.as_ref());
        for (sums, (a, b)) in sums.as_mut().iter_mut().zip(factors) {
            for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
                *sum = *sum + *a * *b;
            }
        }
        sums
    }
}

/// Vectors of the machine, sums of products rounded once where it can.
#[cfg(feature = "ensemble")]
#[derive(Clone, Copy)]
struct Vectors<S>(S);

#[cfg(feature = "ensemble")]
impl<S: Simd> Convolve<f64> for Vectors<S> {
    #[inline(always)]
    fn inner<L: Rows<f64>>(self, a: &[L], b: &[L], n: usize, mut zeros: L) -> L {
        let Self(simd) = self;
        for (row, sums) in zeros.as_mut().iter_mut().enumerate() {
            let (parts, _) = S::as_mut_simd_f64s(sums);
            for (i, part) in parts.iter_mut().enumerate() {
                let part_of = |x: &L| S::as_simd_f64s(&x.as_ref()[row]).0[i];
                let mut apart = [simd.splat_f64s(0.0); APART];
                let mut j = 2;
                while j + 1 < n {
                    for (k, sum) in apart.iter_mut().enumerate() {
                        let (a, b) = (&a[j + k], &b[n + BEFORE - j - k]);
                        *sum = simd.mul_add_f64s(part_of(a), part_of(b), *sum);
                    }
                    j += APART;
                }
                let [first, second, third, fourth] = apart;
                let halves = [simd.add_f64s(first, second), simd.add_f64s(third, fourth)];
                *part = simd.add_f64s(halves[0], halves[1]);
            }
        }
        zeros
    }

    #[inline(always)]
    fn multiply_add<L: Rows<f64>>(self, a: &L, b: &L, c: &L) -> L {
        let Self(simd) = self;
        let mut sums = *c;
        let factors = a.as_ref().iter().zip(b.as_ref());
        for (sums, (a, b)) in sums.as_mut().iter_mut().zip(factors) {
            let (parts, _) = S::as_mut_simd_f64s(sums);
            let factors = S::as_simd_f64s(a).0.iter().zip(S::as_simd_f64s(b).0);
            for (part, (a, b)) in parts.iter_mut().zip(factors) {
                *part = simd.mul_add_f64s(*a, *b, *part);
            }
        }
        sums
    }
}

/// [`Convolutions`] for `Simd::vectorize`.
#[cfg(feature = "ensemble")]
struct OnVectors<W>(W, V3);

#[cfg(feature = "ensemble")]
impl<W: Convolutions<f64>> NullaryFnOnce for OnVectors<W> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.0.run(Vectors(self.1));
    }
}

impl Convolved for f64 {
    /// In vectors of four: models have few products, and what longer vectors save they lose at both ends.
    #[inline]
    fn convolve<W: Convolutions<f64>>(work: W) {
        #[cfg(feature = "ensemble")]
        if let Some(simd) = V3::try_new() {
            return simd.vectorize(OnVectors(work, simd));
        }
        work.run(Each);
    }
}

impl Convolved for f32 {
    #[inline]
    fn convolve<W: Convolutions<f32>>(work: W) {
        work.run(Each);
    }
}
