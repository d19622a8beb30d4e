//! Eqs. 54 to 56: the planar pendulum, recursive. State (ω, R by rows), unknowns (Δω, Γa, Γb).

use super::{Form, Planar, c, part, plane_axis};
use crate::number::Number;
use nalgebra::{Matrix2, SMatrix, SVector};

/// Eq. 55, for Δω and the columns of the rotation of one step.
pub struct Increment;

impl Form<5, 5> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_recursive";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SVector<T, 5> {
        let (e1, e2) = (plane_axis::<T>(0), plane_axis::<T>(1));
        let (a, b) = (part::<T, 2, 5>(x, 1), part::<T, 2, 5>(x, 3));
        let turn = h * (c::<T>(2.0) * s[0] + x[0]);
        let torque = (e2.transpose() * attitude(s) * (a + e1)).x * (h * p.weight);
        let first = a * c::<T>(4.0) - b * turn - e1 * c::<T>(4.0) - e2 * turn;
        let second = b * c::<T>(4.0) + a * turn - e2 * c::<T>(4.0) + e1 * turn;
        let momentum = c::<T>(2.0) * p.inertia * x[0] + torque;
        SVector::from([momentum, first.x, first.y, second.x, second.y])
    }

    /// Eq. 56, corrected. ∂/∂Δω of −h(2ω + Δω)(Γb + e₂) is −h(Γb + e₂), printed h(Γb − e₂); and the
    /// derivative of 4Γa by Γa is 4I, printed 4(1, 1), likewise in the other three places.
    fn jacobian<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SMatrix<T, 5, 5> {
        let (e1, e2) = (plane_axis::<T>(0), plane_axis::<T>(1));
        let (a, b) = (part::<T, 2, 5>(x, 1), part::<T, 2, 5>(x, 3));
        let turn = Matrix2::<T>::identity() * (h * (c::<T>(2.0) * s[0] + x[0]));
        let four = Matrix2::<T>::identity() * c::<T>(4.0);
        let mut j = SMatrix::<T, 5, 5>::zeros();
        j[(0, 0)] = c::<T>(2.0) * p.inertia;
        let gravity = e2.transpose() * attitude(s) * (h * p.weight);
        j.fixed_view_mut::<1, 2>(0, 1).copy_from(&gravity);
        j.fixed_view_mut::<2, 1>(1, 0).copy_from(&((b + e2) * -h));
        j.fixed_view_mut::<2, 2>(1, 1).copy_from(&four);
        j.fixed_view_mut::<2, 2>(1, 3).copy_from(&-turn);
        j.fixed_view_mut::<2, 1>(3, 0).copy_from(&((a + e1) * h));
        j.fixed_view_mut::<2, 2>(3, 1).copy_from(&turn);
        j.fixed_view_mut::<2, 2>(3, 3).copy_from(&four);
        j
    }

    fn guess<T: Number>(_: &SVector<T, 5>) -> SVector<T, 5> {
        let (o, i) = (T::zero(), T::one());
        SVector::from([o, i, o, o, i])
    }

    fn next<T: Number>(_: T, s: &SVector<T, 5>, x: &SVector<T, 5>) -> SVector<T, 5> {
        let r = attitude(s) * Matrix2::from_columns(&[part::<T, 2, 5>(x, 1), part(x, 3)]);
        SVector::from([s[0] + x[0], r.m11, r.m12, r.m21, r.m22])
    }
}

fn attitude<T: Number>(s: &SVector<T, 5>) -> Matrix2<T> {
    Matrix2::new(s[1], s[2], s[3], s[4])
}
