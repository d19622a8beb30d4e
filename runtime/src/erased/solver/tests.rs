//! The pendulum behind trait objects gives what it gives under its own types.

use super::Point;
use crate::specimens::pendulum::MODEL;

const AT: Point = Point {
    parameters: &[9.81, 1.0, 1.0],
    h: 0.1,
    t: 0.0,
    state: &[1.0, 0.5],
};
const X: [f64; 2] = [1.2, -0.3];

#[test]
fn a_solver_is_known_by_its_form() {
    assert_eq!(MODEL.solvers[0].solver().form, "next");
}

#[test]
fn residual_and_next_state_are_those_of_the_equations() {
    let mut out = [f64::NAN; 2];
    MODEL.solvers[0].guess(&AT, &mut out);
    assert_eq!(out, [1.0, 0.5]);
    MODEL.solvers[0].residual(&AT, &X, &mut out);
    assert_eq!(out[0], (1.2 - 1.0) - 0.05 * (0.5 - 0.3));
    assert_eq!(out[1], (-0.3 - 0.5) + 0.1 * 9.81 * f64::sin(1.1));
    MODEL.solvers[0].next(&AT, &X, &mut out);
    assert_eq!(out, X);
}

#[cfg(feature = "dual")]
#[test]
fn the_jacobian_is_the_derivative_of_the_residual() {
    let (mut generated, mut dual) = ([f64::NAN; 4], [f64::NAN; 4]);
    MODEL.solvers[0].jacobian(&AT, &X, &mut generated);
    MODEL.solvers[0].dual_jacobian(&AT, &X, &mut dual);
    assert_eq!(generated[..3], [1.0, -0.05, 0.05 * 9.81 * f64::cos(1.1)]);
    for (generated, dual) in generated.iter().zip(dual) {
        assert!((generated - dual).abs() < 1e-15);
    }
}

#[test]
#[should_panic(expected = "2 values")]
fn a_slice_of_the_wrong_length_is_a_bug_of_the_caller() {
    MODEL.solvers[0].residual(&AT, &X[..1], &mut [0.0; 2]);
}
