//! Eqs. 58 to 60: the planar pendulum on the complete Lie group. State and unknowns (ω, Γa, Γb).

use super::{Form, Planar, c, part, plane_axis, quarter_turn};
use crate::number::Number;
use nalgebra::{Matrix2, SMatrix, SVector, Vector2};

/// Eq. 58, for ω, Γa and Γb at k+1.
pub struct Next;

impl Form<5, 5> for Next {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_group";
    const FORM: &'static str = "next";

    fn residual<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SVector<T, 5> {
        equations(p, h, &(x - s), &(x + s))
    }

    /// Eq. 60, as printed.
    fn jacobian<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SMatrix<T, 5, 5> {
        blocks(p, h, &((x + s) / c::<T>(2.0)))
    }

    fn guess<T: Number>(s: &SVector<T, 5>) -> SVector<T, 5> {
        *s
    }

    fn next<T: Number>(_: T, _: &SVector<T, 5>, x: &SVector<T, 5>) -> SVector<T, 5> {
        *x
    }
}

/// Eq. 59, for Δω, ΔΓa and ΔΓb.
pub struct Increment;

impl Form<5, 5> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_group";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SVector<T, 5> {
        equations(p, h, x, &(s * c::<T>(2.0) + x))
    }

    /// Eq. 60, as printed.
    fn jacobian<T: Number>(
        p: &Planar<T>,
        h: T,
        s: &SVector<T, 5>,
        x: &SVector<T, 5>,
    ) -> SMatrix<T, 5, 5> {
        blocks(p, h, &(s + x / c::<T>(2.0)))
    }

    fn guess<T: Number>(_: &SVector<T, 5>) -> SVector<T, 5> {
        SVector::zeros()
    }

    fn next<T: Number>(_: T, s: &SVector<T, 5>, x: &SVector<T, 5>) -> SVector<T, 5> {
        s + x
    }
}

/// The equations in the difference and the sum of both ends.
fn equations<T: Number>(
    p: &Planar<T>,
    h: T,
    difference: &SVector<T, 5>,
    sum: &SVector<T, 5>,
) -> SVector<T, 5> {
    let kinematics = |i: usize| -> Vector2<T> {
        let turn = quarter_turn::<T>() * part::<T, 2, 5>(sum, i) * (h * sum[0]);
        part::<T, 2, 5>(difference, i) * c::<T>(4.0) + turn
    };
    let (a, b) = (kinematics(1), kinematics(3));
    let momentum = c::<T>(2.0) * p.inertia * difference[0] + h * p.weight * sum[3];
    SVector::from([momentum, a.x, a.y, b.x, b.y])
}

/// Eq. 60 at the mean of both ends. h (ω[k+1] + ω) S₁ (Γ[k+1] + Γ) differentiates to h S₁ 2Γ[k+1/2] by ω and
/// to 2h ω[k+1/2] S₁ by Γ; gravity acts on e₁ᵀΓb alone.
fn blocks<T: Number>(p: &Planar<T>, h: T, mean: &SVector<T, 5>) -> SMatrix<T, 5, 5> {
    let turn = quarter_turn::<T>() * (c::<T>(2.0) * h);
    let by_gamma = Matrix2::<T>::identity() * c::<T>(4.0) + turn * mean[0];
    let mut j = SMatrix::<T, 5, 5>::zeros();
    j[(0, 0)] = c::<T>(2.0) * p.inertia;
    let gravity = plane_axis::<T>(0).transpose() * (h * p.weight);
    j.fixed_view_mut::<1, 2>(0, 3).copy_from(&gravity);
    for i in [1, 3] {
        let by_omega = turn * part::<T, 2, 5>(mean, i);
        j.fixed_view_mut::<2, 1>(i, 0).copy_from(&by_omega);
        j.fixed_view_mut::<2, 2>(i, i).copy_from(&by_gamma);
    }
    j
}
