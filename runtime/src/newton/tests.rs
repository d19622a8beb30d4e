//! Newton's method on problems with known roots and known ways to fail.

use crate::Failure;
use crate::Place;
use crate::Report;
use crate::Settings;
use crate::StepError;
use crate::Stepper;
use crate::Success;
use crate::description::Unknown;
use crate::specimens::root::Evaluated;
use crate::specimens::root::Flat;
use crate::specimens::root::Problem;
use crate::specimens::root::Root;

/// The default settings.
const DEFAULT: Settings = Settings {
    tolerance: 1e-12,
    max_iterations: 50,
    max_growths: 4,
    strategy: crate::Strategy::Core,
    compensated: true,
    halvings: 0,
};

/// Runs one "step" from `start` to the root.
macro_rules! solve {
    ($problem:ty, $start:expr, $settings:expr) => {{
        let start = Flat($start);
        let stepper = Stepper::<Root<$problem, _>>::new(Flat([]), start, 1.0).unwrap();
        let mut stepper = stepper.with_settings($settings);
        let outcome: Result<Report, StepError> = stepper.step();
        if outcome.is_err() {
            assert_eq!(stepper.state(), start, "a failed step moved the state");
            assert_eq!(stepper.steps(), 0);
        }
        (stepper.state().0, outcome)
    }};
}

/// x² + y² = 5, x y = 2 with the root (2, 1).
struct Circle;
impl Problem<2> for Circle {
    fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
        let r = [x * x + y * y - 5.0, x * y - 2.0];
        (r, [[2.0 * x, 2.0 * y], [y, x]])
    }
}

#[test]
fn corrections_shrink_quadratically() {
    let (root, outcome) = solve!(Circle, [3.0, 0.5], DEFAULT);
    let report = outcome.unwrap();
    assert!((root[0] - 2.0).abs() < 1e-15 && (root[1] - 1.0).abs() < 1e-15);
    assert_eq!(report.success, Success::Converged);
    assert_eq!(report.iterations, 6);
}

#[test]
fn a_tolerance_of_zero_ends_at_the_floor() {
    let settings = Settings {
        tolerance: 0.0,
        ..DEFAULT
    };
    let (root, outcome) = solve!(Cubic, [1.0], settings);
    let report = outcome.unwrap();
    assert!((root[0] - f64::cbrt(2.0)).abs() <= f64::EPSILON);
    assert!(report.iterations <= 8, "{report:?}");
}

#[test]
fn a_tolerance_that_is_nan_ends_at_the_floor_too() {
    let settings = Settings {
        tolerance: f64::NAN,
        ..DEFAULT
    };
    let (root, outcome) = solve!(Cubic, [1.0], settings);
    assert_eq!(outcome.unwrap().success, Success::AtFloor);
    assert!((root[0] - f64::cbrt(2.0)).abs() <= f64::EPSILON);
}

/// x³ = 2
struct Cubic;
impl Problem<1> for Cubic {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x * x * x - 2.0], [[3.0 * x * x]])
    }
}

/// x³ = 2 with a Jacobian twice too large: the error halves per iteration.
struct WrongJacobian;
impl Problem<1> for WrongJacobian {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x * x * x - 2.0], [[6.0 * x * x]])
    }
}

#[test]
fn a_wrong_jacobian_converges_linearly_and_not_to_a_wrong_root() {
    let (root, outcome) = solve!(WrongJacobian, [1.3], DEFAULT);
    assert!((root[0] - f64::cbrt(2.0)).abs() < 2.0 * DEFAULT.tolerance);
    assert_eq!(outcome.unwrap().iterations, 35);
}

/// x² + 1 = 0 has no real root; Newton's method wanders for ever.
struct NoRoot;
impl Problem<1> for NoRoot {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x * x + 1.0], [[2.0 * x]])
    }
}

#[test]
fn wandering_stalls_at_the_iteration_limit() {
    let (_, outcome) = solve!(NoRoot, [0.3], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::Stalled);
    assert_eq!(error.history.iterations(), DEFAULT.max_iterations);
    assert_eq!(error.history.sizes().len(), 12);
}

#[test]
fn no_iterations_allowed_is_a_stall() {
    let settings = Settings {
        max_iterations: 0,
        ..DEFAULT
    };
    let (_, outcome) = solve!(Cubic, [1.0], settings);
    assert_eq!(outcome.unwrap_err().fault.failure, Failure::Stalled);
}

/// atan x = 0: from |x| > 1.39 every correction is larger than the one before.
struct Arctangent;
impl Problem<1> for Arctangent {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x.atan()], [[1.0 / (1.0 + x * x)]])
    }
}

#[test]
fn corrections_that_overshoot_are_shortened() {
    for start in [1.3, 1.5, -40.0, 1e6] {
        let (root, outcome) = solve!(Arctangent, [start], DEFAULT);
        assert!(outcome.is_ok(), "{start}: {outcome:?}");
        assert!(root[0].abs() < 1e-12, "{start}: {root:?}");
    }
}

/// atan x + 2 = 0 has no root, and every correction is larger than the one before.
struct Beyond;
impl Problem<1> for Beyond {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x.atan() + 2.0], [[1.0 / (1.0 + x * x)]])
    }
}

#[test]
fn growing_corrections_are_divergence() {
    let (_, outcome) = solve!(Beyond, [0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::Diverged);
    assert_eq!(error.history.iterations(), 1 + DEFAULT.max_growths);
}

/// √x = 0.1 from where the root is infinitely steep.
struct Upright;
impl Problem<1> for Upright {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x.sqrt() - 0.1], [[0.5 / x.sqrt()]])
    }
}

#[test]
fn an_infinite_slope_is_no_convergence() {
    let (_, outcome) = solve!(Upright, [0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::Singular);
    assert_eq!(error.history.iterations(), 0);
    let (root, outcome) = solve!(Upright, [1e-6], DEFAULT);
    assert!(
        outcome.is_ok() && (root[0] - 0.01).abs() < 1e-13,
        "{root:?}"
    );
}

/// Dry friction that is steep about rest, and a push: whole corrections go from one side of the steep piece to the other.
struct Friction;
impl Problem<1> for Friction {
    fn evaluate([v]: [f64; 1]) -> Evaluated<1> {
        let (force, slope) = match v / 1e-4 {
            x if x.abs() > 1.0 => (x.signum(), 0.0),
            x => (x, 1e4),
        };
        ([v - 0.3 + 0.5 * force], [[1.0 + 0.5 * slope]])
    }
}

#[test]
fn corrections_between_the_pieces_of_friction_end() {
    for start in [-1.0, 0.0, 2e-4, 1.0] {
        let (root, outcome) = solve!(Friction, [start], DEFAULT);
        assert!(outcome.is_ok(), "{start}: {outcome:?}");
        // v (1 + 0.5·10⁴) = 0.3
        assert!((root[0] - 0.3 / 5001.0).abs() < 1e-16, "{start}: {root:?}");
    }
}

/// x = 10⁷ + 0.003 − 0.01 sign(x − 10⁷) has no root: the sign flips before x gets there.
struct Jump;
impl Problem<1> for Jump {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        let offset = x - 1e7;
        ([offset - 0.003 + 0.01 * offset.signum()], [[1.0]])
    }
}

#[test]
fn corrections_small_beside_a_large_unknown_are_no_success() {
    let (_, outcome) = solve!(Jump, [1e7 + 0.003], DEFAULT);
    assert!(outcome.is_err(), "{:?}", outcome.unwrap());
}

/// x − 1 + 0.01 (tanh(2·10¹³ (x − 1)) + 2) = 0 with the root 0.99. At x = 1 it is so steep that Newton's
/// correction is 10⁻¹³.
struct Steep;
impl Problem<1> for Steep {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        let tanh = (2e13 * (x - 1.0)).tanh();
        let r = x - 1.0 + 0.01 * (tanh + 2.0);
        ([r], [[1.0 + 2e11 * (1.0 - tanh * tanh)]])
    }
}

#[test]
fn a_first_correction_within_the_tolerance_is_checked() {
    let (root, outcome) = solve!(Steep, [1.0], DEFAULT);
    assert!(
        outcome.is_err() || (root[0] - 0.99).abs() < 1e-9,
        "{root:?}"
    );
}

/// Flat at 1, which sends the iteration off to −10¹⁸; from there it comes back to 0, which is no solution: −3 is.
struct FarAndBack;
impl Problem<1> for FarAndBack {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        match x {
            x if x > 0.5 => ([1.0], [[1e-18]]),
            x if x < -1e6 => ([x], [[1.0]]),
            _ => ([x * x * x + 27.0], [[3.0 * x * x + 20.0]]),
        }
    }
}

#[test]
fn coming_back_from_far_away_is_no_convergence() {
    let (root, outcome) = solve!(FarAndBack, [1.0], DEFAULT);
    outcome.unwrap();
    assert!((root[0] + 3.0).abs() < 1e-9, "{root:?}");
}

/// √x = 1, without a value for x < 0.
struct SquareRoot;
impl Problem<1> for SquareRoot {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x.sqrt() - 1.0], [[0.5 / x.sqrt()]])
    }
}

#[test]
fn a_start_that_fails_falls_back_to_the_guess() {
    let mut stepper = Stepper::<Root<SquareRoot, _>>::new(Flat([]), Flat([2.5]), 1.0).unwrap();
    stepper.step().unwrap();
    // The first step moved by −1.5, so the second starts from −0.5, fails, and starts again from the root.
    let before = stepper.statistics().iterations;
    let report = stepper.step().unwrap();
    assert_eq!(report.iterations, 1);
    assert_eq!(stepper.statistics().iterations, before + 2);
    assert!((stepper.state().0[0] - 1.0).abs() <= f64::EPSILON);
}

/// x + y = 1 twice over.
struct Dependent;
impl Problem<2> for Dependent {
    fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
        ([x + y - 1.0, 2.0 * (x + y) - 3.0], [[1.0, 1.0], [2.0, 2.0]])
    }
}

#[test]
fn dependent_equations_are_singular() {
    let (_, outcome) = solve!(Dependent, [0.0, 0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::Singular);
    assert_eq!(error.fault.place, Place::Equation(1));
    assert_eq!(error.fault.value, -3.0);
    assert_eq!(error.history.iterations(), 0);
}

/// Converges in all rows but one, which turns NaN in the second iteration.
struct LateNaN;
impl Problem<3> for LateNaN {
    fn evaluate([x, y, z]: [f64; 3]) -> Evaluated<3> {
        let j = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        ([x, y + 1.0 + y.sqrt(), z], j)
    }
}

#[test]
fn nan_in_one_row_is_not_dropped() {
    let (_, outcome) = solve!(LateNaN, [0.0, 0.0, 0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::NotFinite);
    assert_eq!(error.fault.place, Place::Equation(1));
    assert!(error.fault.value.is_nan());
    assert_eq!(error.history.iterations(), 1);
}

/// A finite residual whose Jacobian holds a NaN outside the pivots.
struct NaNJacobian;
impl Problem<2> for NaNJacobian {
    fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
        ([x - 1.0, y - 1.0], [[1.0, f64::NAN], [0.0, 1.0]])
    }
}

#[test]
fn nan_in_the_jacobian_is_not_dropped() {
    let (_, outcome) = solve!(NaNJacobian, [0.0, 0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::NotFinite);
    assert_eq!(error.fault.place, Place::Unknown(0));
}

/// J = 0 in all but rounding: the correction overflows.
struct Overflow;
impl Problem<1> for Overflow {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x + 1e10], [[1e-305]])
    }
}

#[test]
fn an_infinite_correction_is_not_finite() {
    let (_, outcome) = solve!(Overflow, [0.0], DEFAULT);
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::NotFinite);
    assert_eq!(error.fault.place, Place::Unknown(0));
    assert_eq!(error.fault.value, f64::NEG_INFINITY);
}

/// Two forces on a lever: the first carries the whole weight, the second vanishes. Sums of the two are
/// 2⁻⁵² apart and torques nearly twice as far, so that no sum gives the torque exactly, and the second force
/// jumps between two rounding errors.
struct IdleForce;
impl Problem<2> for IdleForce {
    const UNKNOWNS: &'static [Unknown] = &[force("F"), force("G")];
    fn evaluate([f, g]: [f64; 2]) -> Evaluated<2> {
        let (weight, arm) = (1.05, 1.9);
        let torque = f64::next_up(weight * arm);
        let r = [f - weight, (f + g) * arm - torque];
        (r, [[1.0, 0.0], [arm, arm]])
    }
}

const fn force(name: &'static str) -> Unknown {
    Unknown {
        name,
        len: 1,
        measure: None,
        told: false,
    }
}

#[test]
fn rounding_errors_in_a_vanishing_unknown_are_no_failure() {
    let (root, outcome) = solve!(IdleForce, [0.0, 0.0], DEFAULT);
    assert_eq!(outcome.unwrap().success, Success::AtFloor);
    assert!(root[1].abs() <= f64::EPSILON);
}

/// x² = 0: Newton's method halves the error of a double root, relative to a scale that halves too unless
/// the state it starts from gives one.
struct DoubleRoot;
impl Problem<1> for DoubleRoot {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x * x], [[2.0 * x]])
    }
}

#[test]
fn a_double_root_takes_an_iteration_per_bit() {
    let (root, outcome) = solve!(DoubleRoot, [1.0], DEFAULT);
    assert_eq!(outcome.unwrap().iterations, 40);
    assert!(root[0] <= DEFAULT.tolerance);
}

/// Nothing solves it, however small the residual: it stays.
struct Stays;
impl Problem<1> for Stays {
    fn evaluate(_x: [f64; 1]) -> Evaluated<1> {
        ([1e-11], [[1.0]])
    }
}

#[test]
fn small_corrections_are_no_floor_where_the_residual_is_no_rounding() {
    let (_, outcome) = solve!(Stays, [1.0], DEFAULT);
    assert_eq!(outcome.unwrap_err().fault.failure, Failure::Diverged);
}

/// Two equations that are one but for the last digits: rounding moves the unknowns by a twentieth.
struct Parallel;
impl Problem<2> for Parallel {
    fn evaluate(_x: [f64; 2]) -> Evaluated<2> {
        ([0.0, 5e-15], [[1.0, 1.0], [1.0, 1.0 + 1e-13]])
    }
}

#[test]
fn a_residual_of_rounding_is_no_floor_where_unknowns_have_no_digits() {
    let (_, outcome) = solve!(Parallel, [1.0, 1.0], DEFAULT);
    let fault = outcome.unwrap_err().fault;
    assert_eq!(
        (fault.failure, fault.place),
        (Failure::Loose, Place::Unknown(0))
    );
    assert!((0.01..0.2).contains(&fault.value), "{}", fault.value);
}

/// A residual without a value, and no Jacobian to speak of.
struct Nowhere;
impl Problem<1> for Nowhere {
    fn evaluate(_x: [f64; 1]) -> Evaluated<1> {
        ([f64::NAN], [[0.0]])
    }
}

#[test]
fn a_residual_without_a_value_comes_before_a_singular_jacobian() {
    let (_, outcome) = solve!(Nowhere, [1.0], DEFAULT);
    assert_eq!(outcome.unwrap_err().fault.failure, Failure::NotFinite);
}
