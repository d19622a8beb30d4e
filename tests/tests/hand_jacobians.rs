//! The Jacobians written by hand are the derivatives of the residuals written by hand, found by running the
//! residuals on dual numbers. What the generated Jacobians are compared with stands on its own feet.

use approx::assert_abs_diff_eq;
use nalgebra::SVector;
use num_dual::Dual64;
use residua_tests::measured::Measured;
use residua_tests::number::Number;
use residua_tests::points::{Points, RandomPoint};
use residua_tests::reference::{
    Form, Scene, planar_algebra, planar_angle, planar_cayley, planar_group, planar_recursive,
    planar_reduced, spatial_cardan, spatial_group, spatial_recursive, spatial_reduced,
};

/// Operations on the longest path to an entry, in both evaluations together.
const OPERATIONS: f64 = 64.0;

fn lift<T: Number, const N: usize>(values: &[f64]) -> SVector<T, N> {
    SVector::from_iterator(values.iter().map(|&v| T::constant(v)))
}

fn scene<F: Form<M, N>, T: Number, const M: usize, const N: usize>(
    point: &RandomPoint,
) -> F::Scene<T> {
    let parameters: Vec<T> = point.parameters.iter().map(|&v| T::constant(v)).collect();
    F::Scene::from_slice(&parameters)
}

/// Compares at 200 points, to n ε/2 times the size of each entry's terms.
fn derivative_of_residual<F: Form<M, N>, const M: usize, const N: usize>() {
    let mut points = Points::new(20);
    for _ in 0..200 {
        let point = match F::MODEL.starts_with("planar") {
            true => points.planar(M, N),
            false => points.spatial(M, N),
        };
        let h = Measured::constant(point.h);
        let (state, x) = (lift(&point.state), lift(&point.x));
        let hand = F::jacobian::<Measured>(&scene::<F, _, M, N>(&point), h, &state, &x);
        for column in 0..N {
            let mut x = lift::<Dual64, N>(&point.x);
            x[column].eps = 1.0;
            let (scene, state) = (scene::<F, _, M, N>(&point), lift(&point.state));
            let dual = F::residual::<Dual64>(&scene, point.h.into(), &state, &x);
            for row in 0..N {
                let entry = hand[(row, column)];
                let bound = OPERATIONS * f64::EPSILON / 2.0 * entry.size;
                assert_abs_diff_eq!(dual[row].eps, entry.value, epsilon = bound);
            }
        }
    }
}

#[test]
fn planar() {
    derivative_of_residual::<planar_angle::Next, 2, 2>();
    derivative_of_residual::<planar_angle::Increment, 2, 2>();
    derivative_of_residual::<planar_reduced::Next, 3, 3>();
    derivative_of_residual::<planar_reduced::Increment, 3, 3>();
    derivative_of_residual::<planar_recursive::Increment, 5, 5>();
    derivative_of_residual::<planar_group::Next, 5, 5>();
    derivative_of_residual::<planar_group::Increment, 5, 5>();
    derivative_of_residual::<planar_algebra::Next, 2, 2>();
    derivative_of_residual::<planar_algebra::Increment, 2, 2>();
    derivative_of_residual::<planar_cayley::Next, 2, 2>();
    derivative_of_residual::<planar_cayley::Increment, 2, 2>();
}

#[test]
fn spatial() {
    derivative_of_residual::<spatial_recursive::Increment, 12, 6>();
    derivative_of_residual::<spatial_reduced::Next, 6, 6>();
    derivative_of_residual::<spatial_reduced::Increment, 6, 6>();
    derivative_of_residual::<spatial_group::Increment, 12, 12>();
    derivative_of_residual::<spatial_cardan::Increment, 6, 6>();
    // Eq. 87 as printed is the derivative of Eq. 86 as printed; it is Eq. 86 that has the wrong order of turns.
    derivative_of_residual::<spatial_cardan::Printed, 6, 6>();
}
