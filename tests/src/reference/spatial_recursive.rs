//! Eqs. 69 to 73: the 3D pendulum, recursive. State (ω, R by rows), unknowns (Δω, X).

use super::{Form, Spatial, c, part, skew, stack, tile};
use crate::number::Number;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};

/// Eq. 70, for Δω and X = FᵀRᵀe₃.
pub struct Increment;

impl Form<12, 6> for Increment {
    type Scene<T: Number> = Spatial<T>;
    const MODEL: &'static str = "spatial_recursive";
    const FORM: &'static str = "increment";

    fn residual<T: Number>(p: &Spatial<T>, h: T, s: &SVector<T, 12>, x: &Vector6<T>) -> Vector6<T> {
        let k = Known::new(p, h, s);
        let (change, vertical) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&change) * h;
        let momentum = k.k1 * change + turn * p.inertia * change - k.k4 * vertical + k.k2;
        let attitude = k.k6 * vertical + turn * vertical + turn * k.k3 + k.k5;
        stack([momentum, attitude])
    }

    /// Eq. 73, as printed. S(a)b = −S(b)a turns ∂/∂Δω of h S(Δω) J Δω into h S(Δω) J − h S(J Δω) and that of
    /// h S(Δω)(X + K₃) into −h S(X + K₃).
    fn jacobian<T: Number>(
        p: &Spatial<T>,
        h: T,
        s: &SVector<T, 12>,
        x: &Vector6<T>,
    ) -> SMatrix<T, 6, 6> {
        let k = Known::new(p, h, s);
        let (change, vertical) = (part::<T, 3, 6>(x, 0), part::<T, 3, 6>(x, 3));
        let turn = skew(&change) * h;
        let momentum = k.k1 + turn * p.inertia - skew(&(p.inertia * change)) * h;
        tile([
            [momentum, -k.k4],
            [-skew(&(vertical + k.k3)) * h, k.k6 + turn],
        ])
    }

    fn guess<T: Number>(s: &SVector<T, 12>) -> Vector6<T> {
        stack([Vector3::zeros(), part(s, 9)])
    }

    /// R advances by the Cayley map of S(h ω[k+1/2]/2): the rotation F with 2(F − I) = h (F + I) S(ω[k+1/2]).
    fn next<T: Number>(h: T, s: &SVector<T, 12>, x: &Vector6<T>) -> SVector<T, 12> {
        let change = part::<T, 3, 6>(x, 0);
        let omega = part::<T, 3, 12>(s, 0);
        let eta = (omega + change / c::<T>(2.0)) * (h / c::<T>(2.0));
        let r = attitude(s) * cayley(&eta);
        let mut next = SVector::<T, 12>::zeros();
        next.fixed_rows_mut::<3>(0).copy_from(&(omega + change));
        for i in 0..3 {
            let row = r.row(i).transpose();
            next.fixed_rows_mut::<3>(3 + 3 * i).copy_from(&row);
        }
        next
    }
}

/// The printed abbreviations K₁ to K₆.
struct Known<T> {
    k1: Matrix3<T>,
    k2: Vector3<T>,
    k3: Vector3<T>,
    k4: Matrix3<T>,
    k5: Vector3<T>,
    k6: Matrix3<T>,
}

impl<T: Number> Known<T> {
    fn new(p: &Spatial<T>, h: T, s: &SVector<T, 12>) -> Self {
        let two = c::<T>(2.0) * h;
        let omega = part::<T, 3, 12>(s, 0);
        let k3 = part::<T, 3, 12>(s, 9);
        let momentum = p.inertia * omega;
        let k4 = p.weight * two;
        Known {
            k1: p.inertia * c::<T>(4.0) - skew(&momentum) * two + skew(&omega) * p.inertia * two,
            k2: skew(&omega) * momentum * (c::<T>(4.0) * h) - k4 * k3,
            k3,
            k4,
            k5: skew(&omega) * k3 * two - k3 * c::<T>(4.0),
            k6: Matrix3::<T>::identity() * c::<T>(4.0) + skew(&omega) * two,
        }
    }
}

fn attitude<T: Number>(s: &SVector<T, 12>) -> Matrix3<T> {
    Matrix3::from_row_slice(&s.as_slice()[3..12])
}

/// cay(S(η)) = ((1 − ηᵀη) I + 2 S(η) + 2 η ηᵀ)/(1 + ηᵀη), Eq. 22.
fn cayley<T: Number>(eta: &Vector3<T>) -> Matrix3<T> {
    let square = (eta.transpose() * eta).x;
    let even = Matrix3::<T>::identity() * (T::one() - square);
    let odd = (skew(eta) + eta * eta.transpose()) * c::<T>(2.0);
    (even + odd) / (T::one() + square)
}
