//! Emitted code compiles without a warning, whatever the model calls things, and computes what it should.

use residua::erased::AnySolver;
use residua::{Model as _, Record as _, System};
use residua_tests::case::Case;
use residua_tests::case::Tested;

/// Names that Rust or the emitted code has other plans for; the golden file shows what becomes of them.
#[deny(warnings, clippy::all, clippy::pedantic)]
pub mod names {
    use residua::model;
    include!("../../codegen/tests/golden/names.model");
}

/// A scene of the other golden model.
#[deny(warnings, clippy::all, clippy::pedantic)]
pub mod swing {
    use residua::scene;
    include!("../../codegen/tests/golden/swing.scene");
}

#[test]
fn a_scene_has_the_fields_that_are_left() {
    let parameters = swing::Parameters { m: 1.0, J: 2.0 };
    let start: swing::State<f64> = swing::Model::start(&parameters);
    let expected = [0.0, 0.75_f64.sqrt(), 0.5];
    for (found, expected) in start.to_array().iter().zip(expected) {
        assert!((found - expected).abs() <= f64::EPSILON);
    }
    let swing::Outputs { theta } = swing::Model::outputs(&parameters, 0.1, 0.0, &start);
    assert!((theta - std::f64::consts::FRAC_PI_3).abs() <= 2.0 * f64::EPSILON);
}

#[test]
fn awkward_names_are_fields() {
    let parameters = names::Parameters::<f64>::default();
    assert_eq!((parameters.r#type, parameters.T), (1.0, 2.0));
    assert_eq!((parameters.Model, parameters.None), (5.0, 6.0));
    assert_eq!(parameters.unused, [0.0, 0.0, 0.0, 1.0 / 3.0]);
    assert_eq!(parameters.M, [[4.0, 1.0], [1.0, 4.0]]);
    let back = names::Parameters::from_array(parameters.to_array());
    assert_eq!(back, parameters);
    let start: names::State<f64> = names::Model::start(&parameters);
    assert_eq!((start.x, start.r, start.Next), ([1.0, 2.0], 0.0, 1.0 / 7.0));
}

/// The decimals of the file are rounded once, to the nearest double.
#[test]
fn numbers_are_the_nearest_doubles() {
    let parameters = names::Parameters::<f64>::default();
    let decimal: f64 = "3.14".parse().expect("a number");
    assert_eq!(parameters.almost_pi, decimal);
    assert_eq!(parameters.a_x, 8.0);
}

/// The sums of the two functions are the same sums, so they agree to the last bit.
#[test]
fn both_residuals_are_the_same_number() {
    let case = Case::of_file(&names::MODEL);
    let solver: &dyn AnySolver = names::MODEL.solvers[0];
    let x = [0.3, -0.2, 0.1, 0.7];
    let mut alone = [0.0; 4];
    solver.residual(&case.at(0.1, &case.start), &x, &mut alone);
    let parameters = names::Parameters::default();
    let scene = <names::Increment as System<f64>>::scene(&parameters, 0.1);
    let state: names::State<f64> = names::Model::start(&parameters);
    let step = <names::Increment as System<f64>>::step(&scene, 0.0, &state.to_array());
    let (mut together, mut jacobian) = <names::Increment as System<f64>>::zeros();
    names::Increment::residual_and_jacobian(&scene, &step, &x, &mut together, &mut jacobian);
    assert_eq!(alone, together);
}

/// Row 3 by hand: r = ΔNext·Model − h n⁴/(1 + n²) with n = Next + ΔNext.
#[test]
fn quotient_and_its_derivative_are_right() {
    let case = Case::of_file(&names::MODEL);
    let solver: &dyn AnySolver = names::MODEL.solvers[0];
    let (h, delta) = (0.1, 0.7);
    let x = [0.3, -0.2, 0.1, delta];
    let (mut r, mut j) = ([0.0; 4], [0.0; 16]);
    solver.residual(&case.at(h, &case.start), &x, &mut r);
    solver.jacobian(&case.at(h, &case.start), &x, &mut j);
    let n: f64 = 1.0 / 7.0 + delta;
    let below = 1.0 + n * n;
    approx::assert_relative_eq!(
        r[3],
        5.0 * delta - h * n.powi(4) / below,
        max_relative = 1e-14
    );
    let slope = h * (4.0 * n.powi(3) * below - 2.0 * n.powi(5)) / (below * below);
    approx::assert_relative_eq!(j[15], 5.0 - slope, max_relative = 1e-14);
}
