//! Long runs of the paper's pendulums against reference states of thirty digits.

use residua_tests::case::{self, Case, Tested};
use residua_tests::reference_data::{Scene, Truth};
use std::ops::ControlFlow;

const PLANAR: [(&str, &[&str]); 6] = [
    ("planar_angle", &["next", "increment"]),
    ("planar_reduced", &["next", "increment"]),
    ("planar_recursive", &["increment"]),
    ("planar_group", &["next", "increment"]),
    ("planar_algebra", &["next", "increment"]),
    ("planar_cayley", &["next", "increment"]),
];

const SPATIAL: [(&str, &[&str]); 6] = [
    ("spatial_recursive", &["increment"]),
    ("spatial_reduced", &["next", "increment"]),
    ("spatial_group", &["increment"]),
    ("spatial_cardan", &["increment"]),
    ("spatial_exponential", &["next", "increment"]),
    ("spatial_variational", &["increment"]),
];

/// `truth` in the states of a model.
fn state_of(model: &str, truth: &Truth) -> Vec<f64> {
    let (omega, r) = (&truth.omega, &truth.attitude);
    let rest = match model {
        "planar_angle" | "planar_algebra" => vec![truth.angle],
        "planar_reduced" => r[2..4].to_vec(),
        "planar_cayley" => vec![(truth.angle / 4.0).tan()],
        "spatial_reduced" => r[6..9].to_vec(),
        "spatial_cardan" => vec![(-r[5]).atan2(r[8]), r[2].asin(), (-r[1]).atan2(r[0])],
        _ => r.clone(),
    };
    [omega.as_slice(), &rest].concat()
}

/// Angular velocity and direction of gravity in the body frame: what every model has.
fn motion_of(model: &str, state: &[f64]) -> Vec<f64> {
    let dimension = if model.starts_with("planar") { 1 } else { 3 };
    let (omega, rest) = state.split_at(dimension);
    let vertical = match model {
        "planar_angle" | "planar_algebra" => vec![rest[0].sin(), rest[0].cos()],
        "planar_cayley" => {
            let (sin, cos) = (4.0 * rest[0].atan()).sin_cos();
            vec![sin, cos]
        }
        "spatial_cardan" => {
            let [x, y, z] = [0, 1, 2].map(|i| rest[i].sin_cos());
            // The third row of Rx Ry Rz.
            vec![
                x.0 * z.0 - x.1 * y.0 * z.1,
                x.0 * z.1 + x.1 * y.0 * z.0,
                x.1 * y.1,
            ]
        }
        _ => rest[rest.len() - dimension.max(2)..].to_vec(),
    };
    [omega, &vertical].concat()
}

fn case(model: &str, scene: &Scene) -> Case {
    Case {
        model: residua_models::find(model)
            .expect("in the catalogue")
            .catalogued,
        parameters: scene.parameters.clone(),
        start: state_of(model, scene.truth(0.0)),
    }
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let difference = |(a, b): (&f64, &f64)| (a - b).abs();
    let largest = a.iter().zip(b).map(difference).fold(0.0, f64::max);
    assert!(largest.is_finite() && a.iter().chain(b).all(|v| v.is_finite()));
    largest
}

/// Largest error of the motion at time `t`, in `steps_per_second` steps a second.
fn error(model: &str, form: &str, scene: &Scene, t: f64, steps_per_second: u32) -> f64 {
    let case = case(model, scene);
    let per_second = f64::from(steps_per_second);
    let solver = case::solver(case.model, form);
    let last = case.last_state(solver, 1.0 / per_second, (t * per_second) as u64);
    let truth = state_of(model, scene.truth(t));
    largest_difference(&motion_of(model, &last), &motion_of(model, &truth))
}

/// Halving the step divides the error by 4.0 ± 0.2.
fn second_order(model: &str, form: &str, scene: &Scene, t: f64, steps_per_second: u32) {
    let coarse = error(model, form, scene, t, steps_per_second);
    let fine = error(model, form, scene, t, 2 * steps_per_second);
    let ratio = coarse / fine;
    assert!(
        (ratio - 4.0).abs() <= 0.2,
        "{model} {form} at t = {t}: {coarse:e} / {fine:e} = {ratio}"
    );
}

#[test]
fn planar_models_are_of_second_order() {
    for scene in ["w0_1", "w0_9p8"].map(Scene::planar) {
        for (model, forms) in PLANAR {
            for form in forms {
                second_order(model, form, &scene, 10.0, 100);
            }
        }
    }
}

#[test]
fn spatial_models_are_of_second_order() {
    for scene in ["paper", "asym_m10"].map(Scene::spatial) {
        for (model, forms) in SPATIAL {
            for form in forms {
                second_order(model, form, &scene, 10.0, 100);
            }
        }
    }
}

/// The whole time of the paper's runs, at steps so fine that the error is in proportion to h² to the end.
#[test]
#[cfg_attr(debug_assertions, ignore = "takes minutes without optimisation")]
fn the_complete_group_is_of_second_order_over_the_whole_run() {
    for scene in ["w0_1", "w0_9p8"].map(Scene::planar) {
        second_order("planar_group", "increment", &scene, 50.0, 400);
    }
    for scene in ["paper", "asym_m10"].map(Scene::spatial) {
        second_order("spatial_group", "increment", &scene, 100.0, 800);
    }
}

/// Runs of `forms` differ by `bound` at most. They solve the same equations in other unknowns, so only the
/// rounding of each step tells them apart, as far as the motion lets it grow.
fn same_trajectory(forms: &[(&str, &str)], scene: &Scene, bound: f64) {
    let runs = forms.iter().map(|(model, form)| {
        let case = case(model, scene);
        let last = case.last_state(case::solver(case.model, form), 0.02, 500);
        motion_of(model, &last)
    });
    let runs: Vec<_> = runs.collect();
    for (run, form) in runs.iter().zip(forms) {
        let difference = largest_difference(run, &runs[0]);
        assert!(difference <= bound, "{form:?}: {difference:e}");
    }
}

#[test]
fn planar_midpoint_forms_give_one_trajectory() {
    for scene in ["w0_1", "w0_9p8"].map(Scene::planar) {
        let attitude = [
            ("planar_reduced", "next"),
            ("planar_reduced", "increment"),
            ("planar_recursive", "increment"),
            ("planar_group", "next"),
            ("planar_group", "increment"),
        ];
        same_trajectory(&attitude, &scene, 1e-11);
        let angle = [
            ("planar_angle", "next"),
            ("planar_angle", "increment"),
            ("planar_algebra", "next"),
            ("planar_algebra", "increment"),
        ];
        same_trajectory(&angle, &scene, 1e-11);
    }
}

#[test]
fn spatial_midpoint_forms_give_one_trajectory() {
    let attitude = [
        ("spatial_reduced", "next"),
        ("spatial_reduced", "increment"),
        ("spatial_recursive", "increment"),
        ("spatial_group", "increment"),
    ];
    for scene in ["paper", "asym_m10"].map(Scene::spatial) {
        same_trajectory(&attitude, &scene, 1e-10);
    }
}

/// The continuous equations of every model are those of the reference: Runge–Kutta of fourth order comes
/// within 1e-7 in a thousand steps a second.
#[test]
fn flows_meet_the_reference() {
    let planar = PLANAR.map(|(model, _)| (model, Scene::planar("w0_9p8")));
    let spatial = SPATIAL.map(|(model, _)| (model, Scene::spatial("asym_m10")));
    for (model, scene) in planar.into_iter().chain(spatial) {
        let case = case(model, &scene);
        let flow = case.model.flow.expect("has a flow");
        let mut last = Vec::new();
        flow.simulate(
            residua::erased::Scheme::RungeKutta4,
            &case.unobserved(0.001, 10_000),
            &mut |sample| {
                last = sample.state.to_vec();
                ControlFlow::Continue(())
            },
        )
        .expect("runs");
        let truth = motion_of(model, &state_of(model, scene.truth(10.0)));
        let error = largest_difference(&motion_of(model, &last), &truth);
        assert!(error < 1e-7, "{model}: {error:e}");
    }
}
