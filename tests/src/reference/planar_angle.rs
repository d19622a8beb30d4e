//! Eqs. 42 to 46: the planar pendulum in its angle. State and unknowns (ω, θ).

use super::{Form, Planar, c};
use crate::number::Number;
use nalgebra::{Matrix2, Vector2};

/// Eq. 42, for ω and θ at k+1.
pub struct Next;

impl Form<2, 2> for Next {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_angle";
    const FORM: &'static str = "next";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        let (sin, _) = ((x[1] + s[1]) / c::<T>(2.0)).sin_cos();
        Vector2::new(
            p.inertia * (x[0] - s[0]) + h * p.weight * sin,
            c::<T>(2.0) * (x[1] - s[1]) - h * (x[0] + s[0]),
        )
    }

    /// Eq. 43, as printed: the mean angle (θ[k+1] + θ)/2 moves by half of θ[k+1], hence the ½ before the cosine.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        let (_, cos) = ((x[1] + s[1]) / c::<T>(2.0)).sin_cos();
        Matrix2::new(p.inertia, h * p.weight * cos / c::<T>(2.0), -h, c::<T>(2.0))
    }

    fn guess<T: Number>(s: &Vector2<T>) -> Vector2<T> {
        *s
    }

    fn next<T: Number>(_: T, _: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        *x
    }
}

/// Eq. 45, for Δω and Δθ.
pub struct Increment;

impl Form<2, 2> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_angle";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        let (sin, _) = (s[1] + x[1] / c::<T>(2.0)).sin_cos();
        Vector2::new(
            p.inertia * x[0] + h * p.weight * sin,
            c::<T>(2.0) * x[1] - c::<T>(2.0) * h * s[0] - h * x[0],
        )
    }

    /// Eq. 46, as printed: d(θ + Δθ/2)/dΔθ = ½, and the rest is linear.
    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        let (_, cos) = (s[1] + x[1] / c::<T>(2.0)).sin_cos();
        Matrix2::new(p.inertia, h * p.weight * cos / c::<T>(2.0), -h, c::<T>(2.0))
    }

    fn guess<T: Number>(_: &Vector2<T>) -> Vector2<T> {
        Vector2::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        s + x
    }
}
