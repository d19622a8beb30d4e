//! What the schemes keep, on the planar pendulum, whose |Γ|² and energy are both quadratic.

use residua::Collocation;
use residua::Composed;
use residua::Integration;
use residua::Method;
use residua::Model as _;
use residua::Trapezoidal;
use residua_models::dsl::planar_reduced::Model;
use residua_models::dsl::planar_reduced::Parameters;

/// Steps of a run: ten minutes of motion.
const STEPS: u32 = 30_000;
const STEP: f64 = 0.02;

/// Rounding of a walk of n steps, √n ε, of which four times is seldom exceeded; the energy sums up terms of up to three times
/// its size.
fn rounding(step: u32) -> f64 {
    let steps = f64::from(step).max(64.0);
    4.0 * 3.0 * f64::EPSILON * steps.sqrt()
}

/// The largest errors of |Γ|² and energy, relative to what `rounding` allows, over the run.
fn worst<S: Method<f64, Model = Model>>() -> [f64; 2] {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut run = Integration::<S, f64>::new(parameters, start, STEP).unwrap();
    let before = run.outputs();
    let mut worst = [0.0_f64; 2];
    for step in 1..=STEPS {
        run.step().unwrap();
        let now = run.outputs();
        let errors = [
            now.norm_squared - before.norm_squared,
            (now.energy - before.energy) / before.energy,
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            *worst = worst.max(error.abs() / rounding(step));
        }
    }
    worst
}

/// Collocation at the points of Gauss, and what is composed of it, keeps them at rounding, which walks without a trend: a
/// tenth of an ε per step would be ten times what is allowed.
#[test]
fn gauss_keeps_quadratic_invariants() {
    let all = [
        ("midpoint", worst::<Collocation<Model, 1, f64>>()),
        ("gauss2", worst::<Collocation<Model, 2, f64>>()),
        ("gauss4", worst::<Collocation<Model, 4, f64>>()),
        ("gauss8", worst::<Collocation<Model, 8, f64>>()),
        (
            "composition4",
            worst::<Composed<Collocation<Model, 1, f64>, 5, f64>>(),
        ),
    ];
    for (name, [norm, energy]) in all {
        assert!(norm <= 1.0 && energy <= 1.0, "{name}: {norm} {energy}");
    }
}

/// The trapezoidal rule does not, but is conjugate to one that does: what it loses in one swing comes back, and the last
/// swings are no worse than the first.
#[test]
fn the_trapezoidal_rule_has_no_trend() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut run = Trapezoidal::<Model>::new(parameters, start, STEP).unwrap();
    let before = run.outputs().norm_squared;
    // Ten parts of the run.
    let mut largest = [0.0_f64; 10];
    for part in &mut largest {
        for _ in 0..STEPS / 10 {
            run.step().unwrap();
            *part = part.max((run.outputs().norm_squared - before).abs());
        }
    }
    let [first, .., last] = largest;
    // h²ω²/8 and some.
    assert!(first > 1e-6 && first < 1e-2, "{largest:?}");
    assert!((last / first - 1.0).abs() < 0.01, "{largest:?}");
}
