//! The paper's discrete equations and their Jacobians (Sun, Bai, Ge and Xia 2022), derived by hand and
//! written with nalgebra blocks; one file per group of equations. Nothing here comes from the generator.
//!
//! Where the paper is misprinted the file says so and has what follows from its equations of motion.

pub mod nalgebra_step;
pub mod planar_algebra;
pub mod planar_angle;
pub mod planar_cayley;
pub mod planar_group;
pub mod planar_recursive;
pub mod planar_reduced;
pub mod spatial_cardan;
pub mod spatial_group;
pub mod spatial_recursive;
pub mod spatial_reduced;

use crate::number::Number;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

/// A discrete equation of motion by hand: state of `M` numbers, `N` unknowns, in the order of the model file.
pub trait Form<const M: usize, const N: usize> {
    /// The parameters: [`Planar`] or [`Spatial`].
    type Scene<T: Number>: Scene<T>;
    /// The stem of the model file.
    const MODEL: &'static str;
    /// `next` or `increment`.
    const FORM: &'static str;
    /// r(x)
    fn residual<T: Number>(
        scene: &Self::Scene<T>,
        h: T,
        state: &SVector<T, M>,
        x: &SVector<T, N>,
    ) -> SVector<T, N>;
    /// ∂r/∂x
    fn jacobian<T: Number>(
        scene: &Self::Scene<T>,
        h: T,
        state: &SVector<T, M>,
        x: &SVector<T, N>,
    ) -> SMatrix<T, N, N>;
    /// The first guess of the unknowns.
    fn guess<T: Number>(state: &SVector<T, M>) -> SVector<T, N>;
    /// The state after the step.
    fn next<T: Number>(h: T, state: &SVector<T, M>, x: &SVector<T, N>) -> SVector<T, M>;
}

/// Parameters that can be read in the order of the model file.
pub trait Scene<T> {
    /// Reads them.
    fn from_slice(values: &[T]) -> Self;
}

/// Parameters of the planar pendulum.
#[derive(Clone, Debug)]
pub struct Planar<T> {
    /// J, about the pivot, kg m²
    pub inertia: T,
    /// m g l, N m
    pub weight: T,
}

impl<T: Number> Scene<T> for Planar<T> {
    /// m, J, l, g
    fn from_slice(values: &[T]) -> Self {
        Planar {
            inertia: values[1],
            weight: values[0] * values[3] * values[2],
        }
    }
}

/// Parameters of the 3D pendulum.
#[derive(Clone, Debug)]
pub struct Spatial<T> {
    /// J, about the pivot, kg m²
    pub inertia: Matrix3<T>,
    /// m g S(ρ), N m
    pub weight: Matrix3<T>,
}

impl<T: Number> Scene<T> for Spatial<T> {
    /// m, J by rows, ρ, g
    fn from_slice(values: &[T]) -> Self {
        Spatial {
            inertia: Matrix3::from_row_slice(&values[1..10]),
            weight: skew(&Vector3::from_column_slice(&values[10..13])) * (values[0] * values[13]),
        }
    }
}

/// The number `value` in the arithmetic at hand.
pub fn c<T: Number>(value: f64) -> T {
    T::constant(value)
}

/// S(1), the quarter turn of the plane.
pub fn quarter_turn<T: Number>() -> Matrix2<T> {
    Matrix2::new(T::zero(), -T::one(), T::one(), T::zero())
}

/// exp(S(angle)), the rotation of the plane.
pub fn rotation<T: Number>(angle: T) -> Matrix2<T> {
    let (sin, cos) = angle.sin_cos();
    Matrix2::new(cos, -sin, sin, cos)
}

/// S(v), the matrix of v ×.
pub fn skew<T: Number>(v: &Vector3<T>) -> Matrix3<T> {
    let o = T::zero();
    Matrix3::new(o, -v[2], v[1], v[2], o, -v[0], -v[1], v[0], o)
}

/// The unit vector of the plane along axis `i`, counted from 0.
pub fn plane_axis<T: Number>(i: usize) -> Vector2<T> {
    Vector2::ith(i, T::one())
}

/// The unit vector of space along axis `i`, counted from 0.
pub fn axis<T: Number>(i: usize) -> Vector3<T> {
    Vector3::ith(i, T::one())
}

/// The `L` numbers of `v` from `start` on.
pub fn part<T: Number, const L: usize, const N: usize>(
    v: &SVector<T, N>,
    start: usize,
) -> SVector<T, L> {
    v.fixed_rows::<L>(start).into_owned()
}

/// The vector of these blocks below each other, N = 3 B.
pub fn stack<T: Number, const B: usize, const N: usize>(blocks: [Vector3<T>; B]) -> SVector<T, N> {
    let mut v = SVector::<T, N>::zeros();
    for (i, block) in blocks.iter().enumerate() {
        v.fixed_rows_mut::<3>(3 * i).copy_from(block);
    }
    v
}

/// The matrix of these rows of blocks, N = 3 B.
pub fn tile<T: Number, const B: usize, const N: usize>(
    rows: [[Matrix3<T>; B]; B],
) -> SMatrix<T, N, N> {
    let mut m = SMatrix::<T, N, N>::zeros();
    for (i, row) in rows.iter().enumerate() {
        for (k, block) in row.iter().enumerate() {
            m.fixed_view_mut::<3, 3>(3 * i, 3 * k).copy_from(block);
        }
    }
    m
}
