//! Eqs. 62 to 65: the planar pendulum in its Lie algebra. State and unknowns (ω, θ).

use super::{Form, Planar, c, plane_axis, quarter_turn, rotation};
use crate::number::Number;
use nalgebra::{Matrix2, Vector2};

/// Eq. 62, for ω and θ at k+1.
pub struct Next;

impl Form<2, 2> for Next {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_algebra";
    const FORM: &'static str = "next";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        let half = rotation(x[1] / c::<T>(2.0)) * rotation(s[1] / c::<T>(2.0));
        Vector2::new(
            p.inertia * (x[0] - s[0]) + h * p.weight * lever(&half),
            c::<T>(2.0) * (x[1] - s[1]) - h * (x[0] + s[0]),
        )
    }

    /// Eq. 64, corrected: d exp(S(θ/2))/dθ = ½ S₁ exp(S(θ/2)). The S₁ is missing in print.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        let turned =
            quarter_turn::<T>() * rotation(x[1] / c::<T>(2.0)) * rotation(s[1] / c::<T>(2.0));
        Matrix2::new(
            p.inertia,
            h * p.weight / c::<T>(2.0) * lever(&turned),
            -h,
            c::<T>(2.0),
        )
    }

    fn guess<T: Number>(s: &Vector2<T>) -> Vector2<T> {
        *s
    }

    fn next<T: Number>(_: T, _: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        *x
    }
}

/// Eq. 63, for Δω and Δθ.
pub struct Increment;

impl Form<2, 2> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_algebra";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        let half = rotation(s[1]) * rotation(x[1] / c::<T>(2.0));
        Vector2::new(
            p.inertia * x[0] + h * p.weight * lever(&half),
            c::<T>(2.0) * x[1] - c::<T>(2.0) * h * s[0] - h * x[0],
        )
    }

    /// Eq. 65, corrected: d exp(S(Δθ/2))/dΔθ = ½ exp(S(Δθ/2)) S₁. The S₁ is missing in print.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        let turned = rotation(s[1]) * rotation(x[1] / c::<T>(2.0)) * quarter_turn::<T>();
        Matrix2::new(
            p.inertia,
            h * p.weight / c::<T>(2.0) * lever(&turned),
            -h,
            c::<T>(2.0),
        )
    }

    fn guess<T: Number>(_: &Vector2<T>) -> Vector2<T> {
        Vector2::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        s + x
    }
}

/// e₂ᵀ A e₁
fn lever<T: Number>(a: &Matrix2<T>) -> T {
    (plane_axis::<T>(1).transpose() * a * plane_axis::<T>(0)).x
}
