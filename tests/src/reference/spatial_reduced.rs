//! Eqs. 76 to 81: the 3D pendulum in its reduced attitude. State and unknowns (ω, Γ).

use super::{Form, Spatial, c, part, skew, stack, tile};
use crate::number::Number;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Eq. 77, which is Eq. 76 with its constants collected, for ω and Γ at k+1.
pub struct Next;

impl Form<6, 6> for Next {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_reduced";
    const FORM: &'static str = "next";

    fn residual<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        let q = Next77::new(p, h, s);
        let gamma = part::<T, 3, 6>(s, 3);
        let (omega, vertical) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&omega) * h;
        stack([
            q.c * omega - q.d * vertical + turn * p.inertia * omega + q.a,
            q.e * vertical + turn * (vertical + gamma) + q.b,
        ])
    }

    /// Eq. 79, as printed: ∂/∂ω of h S(ω) J ω is h S(ω) J − h S(J ω), that of h S(ω) Γ is −h S(Γ).
    fn jacobian<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Matrix6<T> {
        let q = Next77::new(p, h, s);
        let gamma = part::<T, 3, 6>(s, 3);
        let (omega, vertical) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&omega) * h;
        tile([
            [
                q.c - skew(&(p.inertia * omega)) * h + turn * p.inertia,
                -q.d,
            ],
            [-skew(&(vertical + gamma)) * h, q.e + turn],
        ])
    }

    fn guess<T: Number>(s: &Vector6<T>) -> Vector6<T> {
        *s
    }

    fn next<T: Number>(_: T, _: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        *x
    }
}

/// The printed abbreviations Q_A to Q_E.
struct Next77<T> {
    a: Vector3<T>,
    b: Vector3<T>,
    c: Matrix3<T>,
    d: Matrix3<T>,
    e: Matrix3<T>,
}

impl<T: Number> Next77<T> {
    fn new(p: &Spatial<T>, h: T, s: &Vector6<T>) -> Self {
        let (omega, gamma) = (part::<T, 3, 6>(s, 0), part::<T, 3, 6>(s, 3));
        let four = c::<T>(4.0);
        let momentum = p.inertia * omega;
        let turn = skew(&omega) * h;
        let d = p.weight * (c::<T>(2.0) * h);
        Next77 {
            a: turn * momentum - momentum * four - d * gamma,
            b: turn * gamma - gamma * four,
            c: p.inertia * four + turn * p.inertia - skew(&momentum) * h,
            d,
            e: Matrix3::<T>::identity() * four + turn,
        }
    }
}

/// Eq. 80, for Δω and ΔΓ.
pub struct Increment;

impl Form<6, 6> for Increment {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_reduced";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        let w = Increment80::new(p, h, s);
        let (omega, gamma) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&omega) * h;
        stack([
            w.w1 * omega + turn * p.inertia * omega - w.w5 * gamma + w.w2,
            -w.w6 * omega + w.w3 * gamma + turn * gamma + w.w4,
        ])
    }

    /// Eq. 81, as printed, by the same two rules as Eq. 79.
    fn jacobian<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Matrix6<T> {
        let w = Increment80::new(p, h, s);
        let (omega, gamma) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&omega) * h;
        tile([
            [
                w.w1 - skew(&(p.inertia * omega)) * h + turn * p.inertia,
                -w.w5,
            ],
            [-w.w6 - skew(&gamma) * h, turn + w.w3],
        ])
    }

    fn guess<T: Number>(_: &Vector6<T>) -> Vector6<T> {
        Vector6::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        s + x
    }
}

/// The printed abbreviations W₁ to W₆.
struct Increment80<T> {
    w1: Matrix3<T>,
    w2: Vector3<T>,
    w3: Matrix3<T>,
    w4: Vector3<T>,
    w5: Matrix3<T>,
    w6: Matrix3<T>,
}

impl<T: Number> Increment80<T> {
    fn new(p: &Spatial<T>, h: T, s: &Vector6<T>) -> Self {
        let (omega, gamma) = (part::<T, 3, 6>(s, 0), part::<T, 3, 6>(s, 3));
        let (two, four) = (c::<T>(2.0) * h, c::<T>(4.0));
        let momentum = p.inertia * omega;
        Increment80 {
            w1: p.inertia * four - skew(&momentum) * two + skew(&omega) * p.inertia * two,
            w2: (skew(&omega) * momentum - p.weight * gamma) * (four * h),
            w3: skew(&omega) * two + Matrix3::<T>::identity() * four,
            w4: skew(&omega) * gamma * (four * h),
            w5: p.weight * two,
            w6: skew(&gamma) * two,
        }
    }
}
