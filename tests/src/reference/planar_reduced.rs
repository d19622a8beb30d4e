//! Eqs. 49 to 53: the planar pendulum in its reduced attitude. State and unknowns (ω, Γ).

use super::{Form, Planar, c, part, plane_axis, quarter_turn};
use crate::number::Number;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

/// Eq. 49, for ω and Γ at k+1.
pub struct Next;

impl Form<3, 3> for Next {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_reduced";
    const FORM: &'static str = "next";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector3<T>, x: &Vector3<T>) -> Vector3<T> {
        let (gamma, gamma_next) = (part::<T, 2, 3>(s, 1), part::<T, 2, 3>(x, 1));
        let sum = gamma_next + gamma;
        equations(
            c::<T>(2.0) * p.inertia * (x[0] - s[0]) + h * p.weight * sum.x,
            (gamma_next - gamma) * c::<T>(4.0) + quarter_turn::<T>() * sum * (h * (x[0] + s[0])),
        )
    }

    /// Eq. 50, as printed: the product h (ω[k+1] + ω) S₁ (Γ[k+1] + Γ) has one factor in each unknown.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector3<T>, x: &Vector3<T>) -> Matrix3<T> {
        let sum = part::<T, 2, 3>(x, 1) + part::<T, 2, 3>(s, 1);
        blocks(p, h, x[0] + s[0], &sum)
    }

    fn guess<T: Number>(s: &Vector3<T>) -> Vector3<T> {
        *s
    }

    fn next<T: Number>(_: T, _: &Vector3<T>, x: &Vector3<T>) -> Vector3<T> {
        *x
    }
}

/// Eq. 52, for Δω and ΔΓ.
pub struct Increment;

impl Form<3, 3> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_reduced";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector3<T>, x: &Vector3<T>) -> Vector3<T> {
        let change = part::<T, 2, 3>(x, 1);
        let sum = part::<T, 2, 3>(s, 1) * c::<T>(2.0) + change;
        equations(
            c::<T>(2.0) * p.inertia * x[0] + h * p.weight * sum.x,
            change * c::<T>(4.0) + quarter_turn::<T>() * sum * (h * (c::<T>(2.0) * s[0] + x[0])),
        )
    }

    /// Eq. 53, as printed: Eq. 50 with 2ω + Δω and 2Γ + ΔΓ for the sums.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector3<T>, x: &Vector3<T>) -> Matrix3<T> {
        let sum = part::<T, 2, 3>(s, 1) * c::<T>(2.0) + part::<T, 2, 3>(x, 1);
        blocks(p, h, c::<T>(2.0) * s[0] + x[0], &sum)
    }

    fn guess<T: Number>(_: &Vector3<T>) -> Vector3<T> {
        Vector3::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector3<T>, x: &Vector3<T>) -> Vector3<T> {
        s + x
    }
}

/// [[2J, h m g l e₁ᵀ], [h S₁ Γ, 4I + h ω S₁]] for the sums ω and Γ of both ends.
fn blocks<T: Number>(p: &Planar<T>, h: T, omega: T, gamma: &Vector2<T>) -> Matrix3<T> {
    let turn = quarter_turn::<T>();
    let mut j = Matrix3::<T>::zeros();
    j[(0, 0)] = c::<T>(2.0) * p.inertia;
    let gravity = plane_axis::<T>(0).transpose() * (h * p.weight);
    j.fixed_view_mut::<1, 2>(0, 1).copy_from(&gravity);
    let by_omega = turn * gamma * h;
    j.fixed_view_mut::<2, 1>(1, 0).copy_from(&by_omega);
    let by_gamma = Matrix2::<T>::identity() * c::<T>(4.0) + turn * (h * omega);
    j.fixed_view_mut::<2, 2>(1, 1).copy_from(&by_gamma);
    j
}

fn equations<T: Number>(momentum: T, attitude: Vector2<T>) -> Vector3<T> {
    Vector3::new(momentum, attitude.x, attitude.y)
}
