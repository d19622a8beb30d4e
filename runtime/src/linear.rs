//! The linear system of one Newton correction.

use nalgebra::ArrayStorage;
use nalgebra::Const;
use nalgebra::DimMin;
use nalgebra::RealField;
use nalgebra::SMatrix;
use nalgebra::SVector;

use crate::model::System;
use crate::scalar::Real;

/// Largest system that is solved by the plain elimination below: up to here it costs a third to a half of
/// nalgebra's decomposition, which does not unroll, and beyond no less.
const UNROLLED: usize = 5;

/// A square matrix that linear systems can be solved with: `[[T; N]; N]`, rows first, N ≤ 127.
pub trait SquareMatrix<T>: Copy {
    /// `[T; N]`
    type Vector;
    /// x with A·x = b, by LU decomposition with pivots chosen among rows, each measured by its own largest entry, so that
    /// the units of the equations do not matter; `None` if a pivot is exactly 0.
    fn solve(&self, b: &Self::Vector) -> Option<Self::Vector>;
    /// The N·N entries row by row.
    fn entries(&self) -> &[T];
    /// Row `i`; empty beyond the last.
    fn row(&self, i: usize) -> &[T];
}

impl<T, const N: usize> SquareMatrix<T> for [[T; N]; N]
where
    T: Real + RealField,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    type Vector = [T; N];

    fn solve(&self, b: &[T; N]) -> Option<[T; N]> {
        if N <= UNROLLED {
            return eliminate(*self, *b);
        }
        let (mut rows, mut x) = (*self, *b);
        for ((row, weight), b) in rows.iter_mut().zip(weights(self)).zip(&mut x) {
            row.iter_mut().for_each(|entry| *entry *= weight);
            *b *= weight;
        }
        // nalgebra stores columns first, so our rows are its columns.
        let matrix = SMatrix::from_data(ArrayStorage(rows)).transpose();
        let mut x = SVector::from(x);
        matrix.lu().solve_mut(&mut x).then(|| x.into())
    }

    fn entries(&self) -> &[T] {
        self.as_flattened()
    }

    fn row(&self, i: usize) -> &[T] {
        self.get(i).map_or(&[], |row| row)
    }
}

/// What brings the largest entry of each row to 1; 1 for rows of zeros.
fn weights<T: Real, const N: usize>(a: &[[T; N]; N]) -> [T; N] {
    let (zero, one) = (T::constant(0.0), T::constant(1.0));
    a.map(|row| {
        let largest = row.iter().fold(zero, |most, entry| {
            if entry.abs() > most {
                entry.abs()
            } else {
                most
            }
        });
        let weight = one / largest;
        // Nor where the largest is so small that there is no such number.
        if weight.is_finite() { weight } else { one }
    })
}

/// x with A·x = b by Gaussian elimination with scaled row pivoting (Golub and Van Loan, *Matrix Computations*, 3.5.2); `None`
/// if a pivot is exactly 0.
#[expect(clippy::needless_range_loop, reason = "indices as in the textbook")]
fn eliminate<T: Real, const N: usize>(mut a: [[T; N]; N], mut b: [T; N]) -> Option<[T; N]> {
    let zero = T::constant(0.0);
    let mut weights = weights(&a);
    for k in 0..N {
        let (mut pivot, mut most) = (k, a[k][k].abs() * weights[k]);
        for i in k + 1..N {
            let size = a[i][k].abs() * weights[i];
            if size > most {
                (pivot, most) = (i, size);
            }
        }
        // What it is already, said so that nothing needs to be checked.
        let pivot = pivot.min(N - 1);
        if a[pivot][k] == zero {
            return None;
        }
        a.swap(k, pivot);
        b.swap(k, pivot);
        weights.swap(k, pivot);
        let inverse = T::constant(1.0) / a[k][k];
        for i in k + 1..N {
            let factor = a[i][k] * inverse;
            for j in k + 1..N {
                a[i][j] = a[i][j] - factor * a[k][j];
            }
            b[i] = b[i] - factor * b[k];
        }
    }
    for k in (0..N).rev() {
        for j in k + 1..N {
            b[k] = b[k] - a[k][j] * b[j];
        }
        b[k] = b[k] / a[k][k];
    }
    Some(b)
}

/// A [`System`] whose Newton corrections can be computed. Nothing implements it by hand: every system with
/// `[T; N]` unknowns and a `[[T; N]; N]` Jacobian has it.
pub trait Correctable<T: Real>:
    System<T, Jacobian: SquareMatrix<T, Vector = <Self as System<T>>::Unknowns>>
{
}

impl<T: Real, S> Correctable<T> for S
where
    S: System<T>,
    S::Jacobian: SquareMatrix<T, Vector = S::Unknowns>,
{
}

/// A [`System`] that a [`Stepper`](crate::Stepper) can solve, itself and by its core. Nothing implements it by hand.
pub trait Solvable<T: Real>: Correctable<T> + System<T, Core: Correctable<T>> {}

impl<T: Real, S> Solvable<T> for S where S: Correctable<T> + System<T, Core: Correctable<T>> {}

#[cfg(test)]
mod tests;
