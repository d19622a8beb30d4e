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
    /// Σⱼ columnsⱼ xⱼ
    fn combine(self, columns: &[[T; 8]; 8], x: &[T; 8]) -> [T; 8];
}

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
            let product = |j: usize| simd.mul_f64s(column(j), simd.splat_f64s(x[j]));
            // Two sums, for each addition waits for the one before.
            let (mut even, mut odd) = (product(0), product(1));
            for j in [2, 4, 6] {
                even = simd.mul_add_f64s(column(j), simd.splat_f64s(x[j]), even);
                odd = simd.mul_add_f64s(column(j + 1), simd.splat_f64s(x[j + 1]), odd);
            }
            *part = simd.add_f64s(even, odd);
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

    each! { sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs sign positive }

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
