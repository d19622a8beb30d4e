//! Eqs. 82 and 83: the 3D pendulum on the complete Lie group. State and unknowns (ω, Γ₁, Γ₂, Γ₃).

use super::{Form, Spatial, c, part, skew, stack, tile};
use crate::number::Number;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

/// Eq. 82, for Δω, ΔΓ₁, ΔΓ₂ and ΔΓ₃.
pub struct Increment;

impl Form<12, 12> for Increment {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_group";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(
        p: &Spatial<T>,
        h: T,
        s: &SVector<T, 12>,
        x: &SVector<T, 12>,
    ) -> SVector<T, 12> {
        let k = Known::new(p, h, s);
        let omega = part::<T, 3, 12>(x, 0);
        let turn = skew(&omega) * h;
        let momentum = k.t1 * omega + turn * p.inertia * omega - k.t3 * part(x, 9) + k.t2;
        let kinematics = |row: usize| -> Vector3<T> {
            let gamma = part::<T, 3, 12>(s, 3 * row);
            let change = part::<T, 3, 12>(x, 3 * row);
            let constant = skew(&part(s, 0)) * gamma * (c::<T>(4.0) * h);
            (k.t4 + turn) * change - skew(&gamma) * (c::<T>(2.0) * h) * omega + constant
        };
        stack([momentum, kinematics(3), kinematics(2), kinematics(1)])
    }

    /// Eq. 83, as printed: its columns belong to ω, Γ₁, Γ₂, Γ₃, its rows to ω, Γ₃, Γ₂, Γ₁. S(a)b = −S(b)a
    /// gives the first column; Γ₃ alone meets gravity; Z = T₄ + h S(Δω) acts on each Γ by itself.
    fn jacobian<T: Number>(
        p: &Spatial<T>,
        h: T,
        s: &SVector<T, 12>,
        x: &SVector<T, 12>,
    ) -> SMatrix<T, 12, 12> {
        let k = Known::new(p, h, s);
        let omega = part::<T, 3, 12>(x, 0);
        let turn = skew(&omega) * h;
        let by_omega = |row: usize| {
            let (gamma, change) = (part::<T, 3, 12>(s, 3 * row), part::<T, 3, 12>(x, 3 * row));
            -skew(&change) * h - skew(&gamma) * (c::<T>(2.0) * h)
        };
        let momentum = k.t1 + turn * p.inertia - skew(&(p.inertia * omega)) * h;
        let (o, z) = (Matrix3::zeros(), k.t4 + turn);
        tile([
            [momentum, o, o, -k.t3],
            [by_omega(3), o, o, z],
            [by_omega(2), o, z, o],
            [by_omega(1), z, o, o],
        ])
    }

    fn guess<T: Number>(_: &SVector<T, 12>) -> SVector<T, 12> {
        SVector::zeros()
    }

    fn next<T: Number>(_: T, s: &SVector<T, 12>, x: &SVector<T, 12>) -> SVector<T, 12> {
        s + x
    }
}

/// The printed abbreviations T₁ to T₄; T₅ to T₁₀ are the same two formulas for each Γ.
struct Known<T> {
    t1: Matrix3<T>,
    t2: Vector3<T>,
    t3: Matrix3<T>,
    t4: Matrix3<T>,
}

impl<T: Number> Known<T> {
    fn new(p: &Spatial<T>, h: T, s: &SVector<T, 12>) -> Self {
        let (omega, vertical) = (part::<T, 3, 12>(s, 0), part::<T, 3, 12>(s, 9));
        let (two, four) = (c::<T>(2.0) * h, c::<T>(4.0));
        let momentum = p.inertia * omega;
        Known {
            t1: p.inertia * four + skew(&omega) * p.inertia * two - skew(&momentum) * two,
            t2: (skew(&omega) * momentum - p.weight * vertical) * (four * h),
            t3: p.weight * two,
            t4: Matrix3::<T>::identity() * four + skew(&omega) * two,
        }
    }
}
