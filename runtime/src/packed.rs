//! Several numbers in one, and what the machine has to compute with them.

use core::array;
use core::ops::Add;
use core::ops::Div;
use core::ops::Mul;
use core::ops::Neg;
use core::ops::Sub;

#[cfg(feature = "ensemble")]
use pulp::Arch;
#[cfg(feature = "ensemble")]
use pulp::Simd;
#[cfg(feature = "ensemble")]
use pulp::WithSimd;

use crate::lanes::Lanes;
use crate::scalar::Real;
use crate::scalar::Scalar;

/// `N` numbers of type `T` that generated code computes with at a time.
pub trait Pack<T, const N: usize>: Scalar {
    /// From the numbers.
    fn pack(numbers: [T; N]) -> Self;
    /// The numbers.
    fn numbers(&self) -> &[T; N];
    /// The numbers, to be changed.
    fn numbers_mut(&mut self) -> &mut [T; N];
}

/// A number that comes in packs: `f64` in [`Lanes`], which the compiler makes vector instructions of, `f32` and others one
/// by one in [`Each`].
pub trait Packed: Real {
    /// Numbers, packed.
    type Pack<const N: usize>: Pack<Self, N>;
    /// Runs `work`, where the feature `ensemble` is on in the widest instructions of the machine.
    fn work<W: Work<Self>>(work: W) -> W::Output;
}

/// What is to be computed.
pub trait Work<T> {
    /// Its result.
    type Output;
    /// Computes it.
    fn run<A: Arithmetic<T>>(self, arithmetic: A) -> Self::Output;
}

/// Arithmetic on rows of eight numbers.
pub trait Arithmetic<T>: Copy {
    /// Σⱼ columnsⱼ xⱼ, from the first to the last.
    fn combine(self, columns: &[[T; 8]; 8], x: &[T; 8]) -> [T; 8];
    /// Σ aⱼ bₙ₋ⱼ, 1 < j < n − 1, lane by lane, with bᵢ in `b[i + BEFORE]`. All before b₂ is zero, and all after aₙ₋₂ finite.
    fn inner<L: Rows<T>>(self, a: &[L], b: &[L], n: usize) -> L;
    /// a b + c, lane by lane.
    fn multiply_add<L: Rows<T>>(self, a: &L, b: &L, c: &L) -> L;
}

/// Rows of eight numbers.
pub trait Rows<T>: AsRef<[[T; 8]]> + AsMut<[[T; 8]]> + Copy {}

impl<T: Copy, const N: usize> Rows<T> for [[T; 8]; N] {}

/// Zeros that stand before a series, so that sums can take products four at a time.
pub const BEFORE: usize = 2;

/// Products that are summed apart from each other.
const APART: usize = 4;

/// One number after the other, products rounded.
#[derive(Debug, Clone, Copy)]
pub struct Plain;

impl<T: Scalar> Arithmetic<T> for Plain {
    #[inline(always)]
    fn combine(self, columns: &[[T; 8]; 8], x: &[T; 8]) -> [T; 8] {
        let mut sums = columns[0].map(|a| a * x[0]);
        for (column, x) in columns.iter().zip(x).skip(1) {
            for (sum, a) in sums.iter_mut().zip(column) {
                *sum = *sum + *a * *x;
            }
        }
        sums
    }

    #[inline(always)]
    fn inner<L: Rows<T>>(self, a: &[L], b: &[L], n: usize) -> L {
        let mut sums = a[0];
        for (row, sums) in sums.as_mut().iter_mut().enumerate() {
            for (lane, sum) in sums.iter_mut().enumerate() {
                let other = |j: usize| b[n - j + BEFORE].as_ref()[row][lane];
                let terms = (2..n.saturating_sub(1)).map(|j| a[j].as_ref()[row][lane] * other(j));
                *sum = terms.fold(T::constant(0.0), |sum, term| sum + term);
            }
        }
        sums
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
impl<S: Simd> Arithmetic<f64> for Vectors<S> {
    #[inline(always)]
    fn combine(self, columns: &[[f64; 8]; 8], x: &[f64; 8]) -> [f64; 8] {
        let Self(simd) = self;
        let mut sums = [0.0; 8];
        let (parts, _) = S::as_mut_simd_f64s(&mut sums);
        for (i, part) in parts.iter_mut().enumerate() {
            let column = |j: usize| S::as_simd_f64s(&columns[j]).0[i];
            let mut sum = simd.mul_f64s(column(0), simd.splat_f64s(x[0]));
            for (j, x) in x.iter().enumerate().skip(1) {
                sum = simd.mul_add_f64s(column(j), simd.splat_f64s(*x), sum);
            }
            *part = sum;
        }
        sums
    }

    #[inline(always)]
    fn inner<L: Rows<f64>>(self, a: &[L], b: &[L], n: usize) -> L {
        let Self(simd) = self;
        let mut sums = a[0];
        for (row, sums) in sums.as_mut().iter_mut().enumerate() {
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
        sums
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

impl<const N: usize> Pack<f64, N> for Lanes<N> {
    #[inline(always)]
    fn pack(numbers: [f64; N]) -> Self {
        Self(numbers)
    }

    #[inline(always)]
    fn numbers(&self) -> &[f64; N] {
        &self.0
    }

    #[inline(always)]
    fn numbers_mut(&mut self) -> &mut [f64; N] {
        &mut self.0
    }
}

#[cfg(feature = "ensemble")]
struct OnVectors<W>(W);

#[cfg(feature = "ensemble")]
impl<W: Work<f64>> WithSimd for OnVectors<W> {
    type Output = W::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> W::Output {
        self.0.run(Vectors(simd))
    }
}

impl Packed for f64 {
    type Pack<const N: usize> = Lanes<N>;

    #[cfg(feature = "ensemble")]
    #[inline]
    fn work<W: Work<f64>>(work: W) -> W::Output {
        Arch::new().dispatch(OnVectors(work))
    }

    #[cfg(not(feature = "ensemble"))]
    #[inline]
    fn work<W: Work<f64>>(work: W) -> W::Output {
        work.run(Plain)
    }
}

impl Packed for f32 {
    type Pack<const N: usize> = Each<f32, N>;

    #[inline]
    fn work<W: Work<f32>>(work: W) -> W::Output {
        work.run(Plain)
    }
}

/// `N` numbers, computed with one by one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Each<T, const N: usize>(pub [T; N]);

impl<T: Scalar, const N: usize> Each<T, N> {
    fn map(self, f: impl FnMut(T) -> T) -> Self {
        Self(self.0.map(f))
    }

    fn with(self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        Self(array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

macro_rules! with_each {
    ($($trait:ident $function:ident)*) => {
        $(
            impl<T: Scalar, const N: usize> $trait for Each<T, N> {
                type Output = Self;
                fn $function(self, other: Self) -> Self {
                    self.with(other, $trait::$function)
                }
            }
        )*
    };
}

with_each! { Add add Sub sub Mul mul Div div }

impl<T: Scalar, const N: usize> Neg for Each<T, N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

macro_rules! each {
    ($($function:ident)*) => {
        $(
            fn $function(self) -> Self {
                self.map(Scalar::$function)
            }
        )*
    };
}

impl<T: Scalar, const N: usize> Scalar for Each<T, N> {
    fn constant(value: f64) -> Self {
        Self([T::constant(value); N])
    }

    each! { sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs sign }

    fn atan2(self, x: Self) -> Self {
        self.with(x, Scalar::atan2)
    }

    fn powf(self, exponent: Self) -> Self {
        self.with(exponent, Scalar::powf)
    }

    fn stumpff(self, n: u32) -> Self {
        self.map(|s| s.stumpff(n))
    }
}

impl<T: Scalar, const N: usize> Pack<T, N> for Each<T, N> {
    fn pack(numbers: [T; N]) -> Self {
        Self(numbers)
    }

    fn numbers(&self) -> &[T; N] {
        &self.0
    }

    fn numbers_mut(&mut self) -> &mut [T; N] {
        &mut self.0
    }
}
