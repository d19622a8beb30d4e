//! Eq. 66, corrected, in Eqs. 62 and 63: the planar pendulum through the Cayley map. State and unknowns
//! (ω, η) with η = tan(θ/4).

use super::{Form, Planar, c, plane_axis, quarter_turn};
use crate::number::Number;
use nalgebra::{Matrix2, Vector2};

/// For ω and η at k+1.
pub struct Next;

impl Form<2, 2> for Next {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_cayley";
    const FORM: &'static str = "next";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        equations(p, h, s, &(x - s), x)
    }

    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        derivative(p, h, s, x)
    }

    fn guess<T: Number>(s: &Vector2<T>) -> Vector2<T> {
        *s
    }

    fn next<T: Number>(_: T, _: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        *x
    }
}

/// For Δω and Δη.
pub struct Increment;

impl Form<2, 2> for Increment {
    type Scene<T: Number> = Planar<T>;
    const MODEL: &'static str = "planar_cayley";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        equations(p, h, s, x, &(s + x))
    }

    fn jacobian<T: Number>(p: &Planar<T>, h: T, s: &Vector2<T>, x: &Vector2<T>) -> Matrix2<T> {
        derivative(p, h, s, &(s + x))
    }

    fn guess<T: Number>(_: &Vector2<T>) -> Vector2<T> {
        Vector2::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector2<T>, x: &Vector2<T>) -> Vector2<T> {
        s + x
    }
}

/// J Δω + h m g l e₂ᵀ cay(S(η[k+1])) cay(S(η)) e₁ and 8Δη − h (1 + η[k+1] η)(ω[k+1] + ω).
fn equations<T: Number>(
    p: &Planar<T>,
    h: T,
    now: &Vector2<T>,
    change: &Vector2<T>,
    next: &Vector2<T>,
) -> Vector2<T> {
    let half = cayley(next[1]) * cayley(now[1]);
    Vector2::new(
        p.inertia * change[0] + h * p.weight * lever(&half),
        c::<T>(8.0) * change[1] - h * (T::one() + next[1] * now[1]) * (next[0] + now[0]),
    )
}

/// cay(S(η)) turns by 2 atan η, so d cay(S(η))/dη = 2/(1 + η²) S₁ cay(S(η)); the kinematics are bilinear.
fn derivative<T: Number>(p: &Planar<T>, h: T, now: &Vector2<T>, next: &Vector2<T>) -> Matrix2<T> {
    let rate = c::<T>(2.0) / (T::one() + next[1] * next[1]);
    let turned = quarter_turn::<T>() * cayley(next[1]) * cayley(now[1]);
    Matrix2::new(
        p.inertia,
        h * p.weight * rate * lever(&turned),
        -h * (T::one() + next[1] * now[1]),
        c::<T>(8.0) - h * now[1] * (next[0] + now[0]),
    )
}

/// cay(S(η)) = ((1 − η²) I + 2 S(η))/(1 + η²)
fn cayley<T: Number>(eta: T) -> Matrix2<T> {
    let square = eta * eta;
    let even = Matrix2::<T>::identity() * (T::one() - square);
    (even + quarter_turn::<T>() * (c::<T>(2.0) * eta)) / (T::one() + square)
}

/// e₂ᵀ A e₁
fn lever<T: Number>(a: &Matrix2<T>) -> T {
    (plane_axis::<T>(1).transpose() * a * plane_axis::<T>(0)).x
}
