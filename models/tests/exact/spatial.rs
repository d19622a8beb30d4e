//! The reference of the 3D pendulum: against thirty digits, and against what its motions must keep.

use residua_models::exact::Double;
use residua_models::exact::FreeBody;
use residua_models::exact::Invalid;
use residua_models::exact::PlanarPendulum;
use residua_models::exact::SpatialPendulum;
use residua_models::exact::SpatialState;
use residua_models::exact::rotation;
use serde_json::Value;

use crate::REFERENCE;
use crate::list;
use crate::text;

static FREE_BODY: &str = include_str!("data/free_body.json");

fn decimal(value: &Value) -> Double {
    text(value).parse().unwrap()
}

fn decimals<const N: usize>(value: &Value) -> [Double; N] {
    let numbers: Vec<Double> = list(value).iter().map(decimal).collect();
    numbers.try_into().unwrap()
}

/// Rx(π/3) Ry(π/4) Rz(π/9), the start of every scene on file.
fn start() -> [[Double; 3]; 3] {
    rotation([3.0, 4.0, 9.0].map(|part| Double::PI / part))
}

/// States, and R among them by rows, are the `f64` nearest to the digits on file, but for a unit where the digits
/// lie half-way. No tolerance on top: the reference claims 1e-18.
fn assert_samples(pendulum: &SpatialPendulum<Double>, samples: &Value) {
    let omega0 = decimals(&list(samples)[0]["omega"]);
    let times: Vec<f64> = list(samples)
        .iter()
        .map(|s| decimal(&s["t"]).to_f64())
        .collect();
    let solution = pendulum.solve(omega0, start(), &times).unwrap();
    assert!(solution.error <= 1e-18, "{:e}", solution.error);
    for (state, sample) in solution.states.iter().zip(list(samples)) {
        let rows: [Vec<Double>; 3] =
            core::array::from_fn(|i| list(&sample["R"][i]).iter().map(decimal).collect());
        let expected = rows.concat();
        let expected = decimals::<3>(&sample["omega"]).into_iter().chain(expected);
        let found = state.omega.iter().chain(state.attitude.as_flattened());
        for (found, expected) in found.zip(expected) {
            let error = (Double::from(*found) - expected).to_f64().abs();
            let half_a_unit = f64::EPSILON / 2.0 * expected.to_f64().abs();
            assert!(
                error <= half_a_unit + solution.error,
                "t = {}: {error:e}",
                sample["t"]
            );
        }
    }
}

#[test]
fn states_are_the_nearest_to_the_reference_of_the_paper() {
    let reference: Value = serde_json::from_str(REFERENCE).unwrap();
    for name in ["paper", "asym_m10"] {
        let scene = &reference["spatial"][name];
        let p: [Double; 14] = decimals(&scene["parameters"]);
        let pendulum = SpatialPendulum {
            m: p[0],
            j: [[p[1], p[2], p[3]], [p[4], p[5], p[6]], [p[7], p[8], p[9]]],
            rho: [p[10], p[11], p[12]],
            g: p[13],
        };
        assert_samples(&pendulum, &scene["samples"]);
    }
}

#[test]
fn states_are_the_nearest_to_those_of_a_body_that_tumbles() {
    let scene: Value = serde_json::from_str(FREE_BODY).unwrap();
    let [j1, j2, j3] = decimals(&scene["j"]);
    let pendulum = SpatialPendulum {
        m: Double::from(10.0),
        g: Double::ZERO,
        j: diagonal([j1, j2, j3]),
        rho: [Double::ZERO, Double::ZERO, "0.7".parse().unwrap()],
    };
    assert_samples(&pendulum, &scene["samples"]);
}

fn diagonal<T: Copy + From<f64>>([a, b, c]: [T; 3]) -> [[T; 3]; 3] {
    let zero = T::from(0.0);
    [[a, zero, zero], [zero, b, zero], [zero, zero, c]]
}

/// Rounding of a state to `f64`, and of start and data before it, in a scalar of size `scale`.
fn rounded(scale: f64) -> f64 {
    4.0 * f64::EPSILON * scale
}

fn largest_change(states: &[SpatialState], of: impl Fn(&SpatialState) -> f64) -> f64 {
    let first = of(&states[0]);
    states
        .iter()
        .map(|state| (of(state) - first).abs())
        .fold(0.0, f64::max)
}

#[test]
fn a_top_keeps_energy_vertical_momentum_and_spin() {
    let top = SpatialPendulum {
        m: 1.5,
        g: 9.81,
        j: diagonal([0.4, 0.4, 0.15]),
        rho: [0.0, 0.0, -0.3],
    };
    let attitude = start().map(|row| row.map(Double::to_f64));
    let solution = top
        .solve([0.5, -1.0, 25.0], attitude, &[0.0, 1.0, 5.0, 20.0])
        .unwrap();
    let states = &solution.states;
    assert!(largest_change(states, |s| top.energy(s)) <= rounded(0.15 * 25.0 * 25.0));
    assert!(largest_change(states, |s| top.vertical_momentum(s)) <= rounded(0.15 * 25.0));
    assert_eq!(largest_change(states, |s| top.spin_momentum(s)), 0.0);
    // It does move meanwhile.
    assert!(largest_change(states, |s| s.attitude[2][2]) > 0.1);
}

#[test]
fn a_free_body_keeps_energy_and_momentum_and_turns_as_euler_says() {
    // An axis of each kind, moments in every order, one full inertia's worth of digits.
    let cases = [
        ([1.0, 2.0, 3.0], [0.01, 5.0, 0.01]),
        ([1.0, 2.0, 3.0], [5.0, 0.3, -0.2]),
        ([2.0, 1.0, 3.0], [-0.2, 0.3, -5.0]),
        ([3.0, 2.0, 1.0], [1.0, -2.0, 0.7]),
        ([2.0, 3.0, 1.0], [4.0, 1e-6, 1e-6]),
        ([3.0, 1.0, 2.0], [-1.0, 2.0, 3.0]),
        ([1.0, 3.0, 2.0], [-1.0, -2.0, 3.0]),
        ([1.3, 1.3, 2.0], [-1.0, -2.0, 3.0]),
        ([1.0, 2.0, 2.0], [-1.0, -2.0, 3.0]),
    ];
    let attitude = diagonal([1.0, 1.0, 1.0]);
    for (j, omega0) in cases {
        let body = SpatialPendulum {
            m: 1.0,
            g: 0.0,
            j: diagonal(j),
            rho: [0.0; 3],
        };
        let times = [0.0, 0.5, 2.0, 9.0, 30.0];
        let solution = body.solve(omega0, attitude, &times).unwrap();
        let states = &solution.states;
        let momentum = body.momentum_squared(&states[0]);
        assert!(largest_change(states, |s| body.energy(s)) <= rounded(body.energy(&states[0])));
        assert!(largest_change(states, |s| body.momentum_squared(s)) <= rounded(momentum));

        let euler = FreeBody::new(j, omega0).unwrap();
        for (state, t) in states.iter().zip(times) {
            let omega = euler.at(t);
            for (a, b) in omega.iter().zip(state.omega) {
                // Each is rounded once.
                assert!(
                    (a - b).abs() <= f64::EPSILON * b.abs() + solution.error,
                    "{j:?}, {omega0:?}, t = {t}: {omega:?} {state:?}"
                );
            }
        }
    }
}

#[test]
fn turning_about_one_axis_is_the_planar_pendulum() {
    // About e₁ with ρ below: Γ₃ = (0, sin θ, cos θ), gravity along +e₃.
    let pendulum = SpatialPendulum {
        m: 2.0,
        g: 9.81,
        j: diagonal([0.48, 0.7, 0.9]),
        rho: [0.0, 0.0, 0.6],
    };
    let planar = PlanarPendulum::new(2.0, 0.48, 0.6, 9.81, 0.0, 9.8).unwrap();
    let times = [0.5, 3.0, 20.0];
    let solution = pendulum
        .solve([9.8, 0.0, 0.0], diagonal([1.0, 1.0, 1.0]), &times)
        .unwrap();
    for (state, t) in solution.states.iter().zip(times) {
        let exact = planar.at(t);
        assert!(
            (state.omega[0] - exact.omega).abs()
                <= f64::EPSILON * exact.omega.abs() + solution.error
        );
        assert!((state.attitude[2][1] - exact.theta.sin()).abs() <= rounded(1.0));
    }
}

#[test]
fn halved_accuracy_is_seen_in_the_error() {
    // The error that is reported bounds what a much shorter interval between outputs brings out.
    let pendulum = SpatialPendulum {
        m: 10.0,
        g: 9.81,
        j: diagonal([1.0, 2.8, 2.0]),
        rho: [0.0, 0.1, 0.7],
    };
    let (omega0, attitude) = ([0.5, -0.5, 0.4], diagonal([1.0, 1.0, 1.0]));
    let once = pendulum.solve(omega0, attitude, &[5.0]).unwrap();
    let times: Vec<f64> = (1..=320).map(|i| f64::from(i) / 64.0).collect();
    let often = pendulum.solve(omega0, attitude, &times).unwrap();
    assert_eq!(once.states[0], *often.states.last().unwrap());
    assert!(once.error <= 1e-18 && often.error <= 1e-18);
}

#[test]
fn bad_data_are_named() {
    let good = SpatialPendulum {
        m: 1.0,
        g: 9.81,
        j: diagonal([1.0, 1.0, 1.0]),
        rho: [0.0, 0.0, 1.0],
    };
    let attitude = diagonal([1.0, 1.0, 1.0]);
    let solve = |p: SpatialPendulum, times: &[f64]| p.solve([0.0; 3], attitude, times).unwrap_err();
    let heavy = SpatialPendulum {
        m: f64::NAN,
        ..good
    };
    assert!(matches!(
        solve(heavy, &[1.0]),
        Invalid::NotFinite { name: "m", .. }
    ));
    let flat = SpatialPendulum {
        j: diagonal([1.0, 1.0, 0.0]),
        ..good
    };
    assert!(matches!(solve(flat, &[1.0]), Invalid::NotPositive { .. }));
    let mut skew = good;
    skew.j[0][1] = 0.1;
    assert_eq!(solve(skew, &[1.0]), Invalid::NotSymmetric);
    assert_eq!(
        solve(good, &[1.0, 0.5]),
        Invalid::TimesNotAscending { value: 0.5 }
    );
    assert!(
        good.solve([0.0; 3], attitude, &[])
            .unwrap()
            .states
            .is_empty()
    );
}
