//! The closed form of the planar pendulum: against thirty digits, and against its own equation.

use residua_models::exact::Invalid;
use residua_models::exact::PlanarPendulum;
use residua_models::exact::Regime;
use serde_json::Value;

use crate::REFERENCE;
use crate::list;
use crate::text;

static CASES: &str = include_str!("data/planar.json");

/// The pendulum of the paper.
const PAPER: [f64; 4] = [2.0, 0.48, 0.6, 9.81];

fn paper(theta0: f64, omega0: f64) -> PlanarPendulum {
    let [m, j, l, g] = PAPER;
    PlanarPendulum::new(m, j, l, g, theta0, omega0).unwrap()
}

fn from_decimals(numbers: &[&str]) -> PlanarPendulum {
    let [m, j, l, g, theta0, omega0] = *numbers else {
        panic!("six numbers, not {numbers:?}")
    };
    PlanarPendulum::from_decimals(m, j, l, g, theta0, omega0).unwrap()
}

fn from_floats(numbers: &[&str]) -> PlanarPendulum {
    let n: Vec<f64> = numbers
        .iter()
        .map(|number| number.parse().unwrap())
        .collect();
    PlanarPendulum::new(n[0], n[1], n[2], n[3], n[4], n[5]).unwrap()
}

/// The states are the `f64` nearest to the digits on file: bit for bit, no tolerance.
fn assert_samples(name: &str, pendulum: &PlanarPendulum, samples: &Value) {
    for sample in list(samples) {
        let t: f64 = text(&sample["t"]).parse().unwrap();
        let state = pendulum.at(t);
        let expected: [f64; 2] = ["theta", "omega"].map(|key| text(&sample[key]).parse().unwrap());
        assert_eq!([state.theta, state.omega], expected, "{name} at t = {t}");
    }
}

#[test]
fn states_are_the_nearest_to_the_reference_of_the_paper() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for (name, omega0) in [("w0_1", "1"), ("w0_9p8", "9.8")] {
        let scene = &reference["planar"][name];
        let mut numbers: Vec<&str> = list(&scene["parameters"]).iter().map(text).collect();
        numbers.extend(["0", omega0]);
        assert_samples(name, &from_decimals(&numbers), &scene["samples"]);
    }
}

#[test]
fn states_are_the_nearest_to_taylor_series_in_every_regime() {
    let cases: Value = serde_json::from_str(CASES).unwrap();
    let mut seen = Vec::new();
    for (name, case) in cases["cases"].as_object().unwrap() {
        let numbers: Vec<&str> = list(&case["parameters"]).iter().map(text).collect();
        let pendulum = match text(&case["numbers"]) {
            "decimal" => from_decimals(&numbers),
            _ => from_floats(&numbers),
        };
        assert_samples(name, &pendulum, &case["samples"]);
        seen.push(pendulum.regime());
    }
    for regime in [Regime::Swinging, Regime::Separatrix, Regime::Rotating] {
        assert!(seen.contains(&regime), "{regime:?} has no case");
    }
}

/// What the nearest `f64` to 9.81, 0.48, 0.6 and 9.8 costs: Δx = Σ |∂x/∂p| |p| 2⁻⁵³ by the chain of first order,
/// the derivatives from differences of the closed form itself.
#[test]
fn rounded_data_move_the_state_by_their_condition_and_no_more() {
    let decimals = from_decimals(&["2", "0.48", "0.6", "9.81", "0", "9.8"]);
    let numbers = [PAPER[0], PAPER[1], PAPER[2], PAPER[3], 0.0, 9.8];
    let build = |n: [f64; 6]| PlanarPendulum::new(n[0], n[1], n[2], n[3], n[4], n[5]).unwrap();
    let rounded = build(numbers);
    for t in [1.0, 10.0, 50.0] {
        let (theta, exact) = (rounded.at(t).theta, decimals.at(t).theta);
        let mut condition = 0.0;
        for i in 0..6 {
            // Small enough for first order, large against the rounding of the two states.
            let relative = 1e-9;
            let mut moved = numbers;
            moved[i] *= 1.0 + relative;
            condition += ((build(moved).at(t).theta - theta) / relative).abs();
        }
        let bound = condition * f64::EPSILON / 2.0 + 4.0 * f64::EPSILON * theta.abs();
        let error = (theta - exact).abs();
        assert!(error <= bound, "t = {t}: {error:e} > {bound:e}");
    }
}

#[test]
fn both_equilibria_rest() {
    let hanging = paper(0.0, 0.0);
    assert_eq!(hanging.regime(), Regime::Hanging);
    assert_eq!((hanging.at(9.0).theta, hanging.at(9.0).omega), (0.0, 0.0));
    assert_eq!((hanging.period(), hanging.amplitude()), (None, None));

    let pi = "3.14159265358979323846264338327950288";
    let upright = from_decimals(&["2", "0.48", "0.6", "9.81", pi, "0"]);
    assert_eq!(upright.regime(), Regime::Upright);
    assert_eq!(upright.at(1e6).theta, core::f64::consts::PI);
    assert_eq!(upright.at(1e6).omega, 0.0);

    // The nearest f64 to π is not π: released there, the pendulum falls.
    let falling = paper(core::f64::consts::PI, 0.0);
    assert_eq!(falling.regime(), Regime::Swinging);
    assert!(falling.at(8.0).theta < 3.0);
}

#[test]
fn the_separatrix_is_the_gudermannian() {
    // θ = 4 atan(e^{2 t}) − π for Ω = 2, ω₀ = 4.
    let pendulum = PlanarPendulum::new(1.0, 1.0, 1.0, 4.0, 0.0, 4.0).unwrap();
    assert_eq!(pendulum.regime(), Regime::Separatrix);
    assert_eq!(pendulum.period(), None);
    for t in [-2.0f64, -0.25, 0.5, 3.0] {
        let theta = 4.0 * (2.0 * t).exp().atan() - core::f64::consts::PI;
        // Of this formula in f64.
        let rounding = 8.0 * f64::EPSILON;
        assert!((pendulum.at(t).theta - theta).abs() <= rounding * core::f64::consts::PI);
    }
    assert_eq!(pendulum.at(1e9).theta, core::f64::consts::PI);
    assert_eq!(pendulum.at(1e9).omega, 0.0);
}

/// Starts in every regime: swinging, barely and almost all round; rotating either way; turns away from 0.
const STARTS: [[f64; 2]; 8] = [
    [0.0, 1e-3],
    [0.0, 1.0],
    [-2.5, 3.0],
    [9.0, 4.0],
    [0.0, 9.904_544],
    [0.0, 9.904_545],
    [1.0, -14.0],
    [-8.0, 30.0],
];

#[test]
fn the_motion_starts_where_it_is_said_to() {
    for [theta0, omega0] in STARTS {
        let state = paper(theta0, omega0).at(0.0);
        assert_eq!([state.theta, state.omega], [theta0, omega0]);
    }
}

#[test]
fn energy_is_constant_to_rounding() {
    let [m, j, l, g] = PAPER;
    for [theta0, omega0] in STARTS {
        let pendulum = paper(theta0, omega0);
        for t in [-7.0, 0.3, 2.0, 11.0] {
            let state = pendulum.at(t);
            let energy = j * state.omega.powi(2) / 2.0 - m * g * l * state.theta.cos();
            // Each state is off by half a unit in its last place, the formula by as much per operation.
            let scale = j * state.omega.powi(2) + m * g * l * (1.0 + state.theta.abs());
            let difference = (energy - pendulum.energy()).abs();
            assert!(
                difference <= 3.0 * f64::EPSILON * scale,
                "{theta0}, {omega0}, t = {t}: {difference:e}"
            );
        }
    }
}

#[test]
fn the_motion_repeats_after_a_period() {
    for [theta0, omega0] in STARTS {
        let pendulum = paper(theta0, omega0);
        let period = pendulum.period().unwrap();
        let turn = match pendulum.regime() {
            Regime::Rotating => omega0.signum() * core::f64::consts::TAU,
            _ => 0.0,
        };
        let later = pendulum.at(period);
        // Half a unit of the period, times the speed and the acceleration there; and of the state.
        let acceleration = PAPER[0] * PAPER[2] * PAPER[3] / PAPER[1];
        let late = period * f64::EPSILON / 2.0;
        let theta_error = (later.theta - theta0 - turn).abs();
        assert!(
            theta_error
                <= late * omega0.abs() * 2.0 + 2.0 * f64::EPSILON * (theta0.abs() + turn.abs())
        );
        let omega_error = (later.omega - omega0).abs();
        assert!(omega_error <= late * acceleration * 2.0 + f64::EPSILON * omega0.abs());
        // The peak of a swing is met a quarter of a period after the lowest point.
        if theta0 == 0.0 && pendulum.regime() == Regime::Swinging {
            let peak = pendulum.at(period / 4.0).theta;
            let amplitude = pendulum.amplitude().unwrap();
            assert!((peak - amplitude).abs() <= 2.0 * f64::EPSILON * amplitude);
        }
    }
}

#[test]
fn time_runs_backwards_as_forwards() {
    for [theta0, omega0] in STARTS {
        let (forwards, backwards) = (paper(theta0, omega0), paper(theta0, -omega0));
        let mirrored = paper(-theta0, -omega0);
        for t in [0.1, 1.7, 8.0] {
            let (ahead, back, mirror) = (forwards.at(t), backwards.at(-t), mirrored.at(t));
            assert_eq!([ahead.theta, ahead.omega], [back.theta, -back.omega]);
            assert_eq!([ahead.theta, ahead.omega], [-mirror.theta, -mirror.omega]);
        }
    }
}

#[test]
fn the_motion_solves_the_equation() {
    let [m, j, l, g] = PAPER;
    for [theta0, omega0] in STARTS {
        let pendulum = paper(theta0, omega0);
        let h = 1.0 / 4096.0;
        for t in [-3.0, 0.7, 5.2] {
            let [before, now, after] = [t - h, t, t + h].map(|t| pendulum.at(t));
            let slope = |a: f64, b: f64| (b - a) / (2.0 * h);
            // h²/6 times a third derivative, of order Ω³ ω; rounding over h is below.
            let rate = (m * g * l / j).sqrt() + omega0.abs();
            let tolerance = h * h * rate.powi(3) * (1.0 + rate);
            assert!((slope(before.theta, after.theta) - now.omega).abs() <= tolerance);
            let acceleration = -m * g * l / j * now.theta.sin();
            assert!((slope(before.omega, after.omega) - acceleration).abs() <= tolerance * rate);
        }
    }
}

#[test]
fn bad_data_are_named() {
    let [m, j, l, g] = PAPER;
    let not_positive = PlanarPendulum::new(0.0, j, l, g, 0.0, 1.0).unwrap_err();
    assert_eq!(
        not_positive,
        Invalid::NotPositive {
            name: "m",
            value: 0.0
        }
    );
    let not_finite = PlanarPendulum::new(m, j, l, g, 0.0, f64::INFINITY).unwrap_err();
    assert_eq!(
        not_finite.to_string(),
        "omega0 is inf, expected a finite number"
    );
    let not_decimal = PlanarPendulum::from_decimals("2", "x", "1", "1", "0", "0").unwrap_err();
    assert_eq!(not_decimal, Invalid::NotDecimal { name: "j" });
}
