//! The linear system of one Newton correction.

use nalgebra::ArrayStorage;
use nalgebra::Const;
use nalgebra::DimMin;
use nalgebra::RealField;
use nalgebra::SMatrix;
use nalgebra::SVector;

use crate::model::System;
use crate::scalar::Real;

/// A square matrix that linear systems can be solved with: `[[T; N]; N]`, rows first, N ≤ 127.
pub trait SquareMatrix<T>: Copy {
    /// `[T; N]`
    type Vector;
    /// x with A·x = b, by LU decomposition with row pivoting; `None` if a pivot is exactly 0.
    fn solve(&self, b: &Self::Vector) -> Option<Self::Vector>;
    /// The N·N entries row by row.
    fn entries(&self) -> &[T];
}

impl<T, const N: usize> SquareMatrix<T> for [[T; N]; N]
where
    T: Real + RealField,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    type Vector = [T; N];

    fn solve(&self, b: &[T; N]) -> Option<[T; N]> {
        // nalgebra stores columns first, so our rows are its columns.
        let matrix = SMatrix::from_data(ArrayStorage(*self)).transpose();
        let mut x = SVector::from(*b);
        matrix.lu().solve_mut(&mut x).then(|| x.into())
    }

    fn entries(&self) -> &[T] {
        self.as_flattened()
    }
}

/// A [`System`] whose Newton corrections can be computed. Nothing implements it by hand: every system with
/// `[T; N]` unknowns and a `[[T; N]; N]` Jacobian has it.
pub trait Solvable<T: Real>:
    System<T, Jacobian: SquareMatrix<T, Vector = <Self as System<T>>::Unknowns>>
{
}

impl<T: Real, S> Solvable<T> for S
where
    S: System<T>,
    S::Jacobian: SquareMatrix<T, Vector = S::Unknowns>,
{
}

#[cfg(test)]
mod tests;
