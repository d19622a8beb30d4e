//! Eqs. 86 and 87: the 3D pendulum in its Cardan angles. State and unknowns (ω, θx, θy, θz).
//!
//! With P = Rᵀ of each turn half way, Eq. 86 prints the vertical Px Py Pz e₃ and the turn
//! Δθx e₁ + Δθy Px e₂ + Δθz Px Py e₃, which belong to R = Rz Ry Rx, and Eq. 87 is the right derivative of
//! that. For R = Rx Ry Rz (Eqs. 10, 15 and the first and last line of Eq. 84) they are Pz Py Px e₃ and
//! Δθx Pz Py e₁ + Δθy Pz e₂ + Δθz e₃: both orders are here, [`Increment`] and [`Printed`].

use super::{Form, Spatial, axis, c, part, skew, stack, tile};
use crate::number::Number;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// Eq. 86 for R = Rx Ry Rz, for Δω and the increments of the angles.
pub struct Increment;

/// Eq. 86 as printed, which is that of R = Rz Ry Rx.
pub struct Printed;

impl Form<6, 6> for Increment {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_cardan";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        let [px, py, pz] = half_turns(s, x);
        let [e1, e2, e3] = [axis::<T>(0), axis::<T>(1), axis::<T>(2)];
        let vertical = pz * py * px * e3;
        let turn = pz * py * e1 * x[3] + pz * e2 * x[4] + e3 * x[5];
        equations(p, h, s, x, &vertical, &turn)
    }

    /// Eq. 87 rederived: dP/dΔθ = −½ S(e) P = −½ P S(e) for each turn P, put in its place in the product.
    fn jacobian<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Matrix6<T> {
        let [px, py, pz] = half_turns(s, x);
        let [e1, e2, e3] = [axis::<T>(0), axis::<T>(1), axis::<T>(2)];
        let vertical = [
            pz * py * skew(&e1) * px * e3,
            pz * skew(&e2) * py * px * e3,
            skew(&e3) * pz * py * px * e3,
        ];
        let turn = [
            pz * py * e1 * -c::<T>(2.0),
            pz * (skew(&e2) * py * e1 * x[3] - e2 * c::<T>(2.0)),
            skew(&e3) * pz * (py * e1 * x[3] + e2 * x[4]) - e3 * c::<T>(2.0),
        ];
        blocks(p, h, s, x, vertical, turn)
    }

    fn guess<T: Number>(_: &Vector6<T>) -> Vector6<T> {
        Vector6::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        s + x
    }
}

impl Form<6, 6> for Printed {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_cardan";
    const FORM: &'static str = "as printed";

    fn residual<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        let [px, py, pz] = half_turns(s, x);
        let [e1, e2, e3] = [axis::<T>(0), axis::<T>(1), axis::<T>(2)];
        let vertical = px * py * pz * e3;
        let turn = e1 * x[3] + px * e2 * x[4] + px * py * e3 * x[5];
        equations(p, h, s, x, &vertical, &turn)
    }

    /// Eq. 87 as printed, U₁₂ to U₂₄ in their printed order.
    fn jacobian<T: Number>(p: &Spatial<T>, h: T, s: &Vector6<T>, x: &Vector6<T>) -> Matrix6<T> {
        let [px, py, pz] = half_turns(s, x);
        let [e1, e2, e3] = [axis::<T>(0), axis::<T>(1), axis::<T>(2)];
        let vertical = [
            skew(&e1) * px * py * pz * e3,
            px * py * skew(&e2) * pz * e3,
            px * py * pz * skew(&e3) * e3,
        ];
        let turn = [
            skew(&e1) * px * (e2 * x[4] + py * e3 * x[5]) - e1 * c::<T>(2.0),
            px * (py * skew(&e2) * e3 * x[5] - e2 * c::<T>(2.0)),
            px * py * e3 * -c::<T>(2.0),
        ];
        blocks(p, h, s, x, vertical, turn)
    }

    fn guess<T: Number>(_: &Vector6<T>) -> Vector6<T> {
        Vector6::zeros()
    }

    fn next<T: Number>(_: T, s: &Vector6<T>, x: &Vector6<T>) -> Vector6<T> {
        s + x
    }
}

/// K Δω + h S(Δω) J Δω + 4h S(ω) J ω − 4h m g S(ρ) vertical and 2hω + hΔω − 2 turn.
fn equations<T: Number>(
    p: &Spatial<T>,
    h: T,
    s: &Vector6<T>,
    x: &Vector6<T>,
    vertical: &Vector3<T>,
    turn: &Vector3<T>,
) -> Vector6<T> {
    let (omega, change) = (part::<T, 3, 6>(s, 0), part::<T, 3, 6>(x, 0));
    let gyroscopic = skew(&omega) * p.inertia * omega - p.weight * vertical;
    stack([
        stiffness(p, h, &omega) * change
            + skew(&change) * p.inertia * change * h
            + gyroscopic * (c::<T>(4.0) * h),
        omega * (c::<T>(2.0) * h) + change * h - turn * c::<T>(2.0),
    ])
}

/// The Jacobian from −2 ∂vertical/∂Δθ and −2 ∂turn/∂Δθ, one column per angle.
fn blocks<T: Number>(
    p: &Spatial<T>,
    h: T,
    s: &Vector6<T>,
    x: &Vector6<T>,
    vertical: [Vector3<T>; 3],
    turn: [Vector3<T>; 3],
) -> Matrix6<T> {
    let (omega, change) = (part::<T, 3, 6>(s, 0), part::<T, 3, 6>(x, 0));
    let momentum =
        stiffness(p, h, &omega) + skew(&change) * p.inertia * h - skew(&(p.inertia * change)) * h;
    let gravity = p.weight * (c::<T>(2.0) * h);
    tile([
        [momentum, gravity * Matrix3::from_columns(&vertical)],
        [Matrix3::<T>::identity() * h, Matrix3::from_columns(&turn)],
    ])
}

/// The printed K = 4J + 2h S(ω) J − 2h S(J ω).
fn stiffness<T: Number>(p: &Spatial<T>, h: T, omega: &Vector3<T>) -> Matrix3<T> {
    let two = c::<T>(2.0) * h;
    p.inertia * c::<T>(4.0) + skew(omega) * p.inertia * two - skew(&(p.inertia * omega)) * two
}

/// Rxᵀ, Ryᵀ and Rzᵀ at θ + Δθ/2.
fn half_turns<T: Number>(s: &Vector6<T>, x: &Vector6<T>) -> [Matrix3<T>; 3] {
    let (o, i) = (T::zero(), T::one());
    let [x, y, z] = [3, 4, 5].map(|k| (s[k] + x[k] / c::<T>(2.0)).sin_cos());
    [
        Matrix3::new(i, o, o, o, x.1, x.0, o, -x.0, x.1),
        Matrix3::new(y.1, o, -y.0, o, i, o, y.0, o, y.1),
        Matrix3::new(z.1, z.0, o, -z.0, z.1, o, o, o, i),
    ]
}
