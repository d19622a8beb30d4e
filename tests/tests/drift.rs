//! How far the energy of a long run strays: rounding only, growing as √t, once sums of increments are compensated.
//!
//! The long version: `cargo test --release -p residua-tests --test drift -- --ignored --nocapture`.

use residua::{Model, Settings, Stepper};
use residua_models::dsl::planar_reduced as pendulum;

/// The paper's finer step, s.
const H: f64 = 0.01;

/// Steps between looks at the energy.
const EVERY: u64 = 100;

/// The root mean square of the error of the energy, J, of the planar pendulum let go at ω = 1 rad/s, after so many
/// steps; as often as the number of steps doubles.
fn errors(compensated: bool, steps: &[u64]) -> Vec<f64> {
    let parameters = pendulum::Parameters::default();
    let start = <pendulum::Model as Model<f64>>::start(&parameters);
    let settings = Settings {
        compensated,
        ..Settings::default()
    };
    let stepper = Stepper::<pendulum::Increment>::new(parameters, start, H).expect("a valid run");
    let mut stepper = stepper.with_settings(settings);
    let energy = stepper.outputs().energy;
    let (mut squares, mut looks) = (0.0, 0.0);
    let mut errors = Vec::new();
    for &count in steps {
        while stepper.steps() < count {
            stepper.step().expect("Newton converges");
            if stepper.steps().is_multiple_of(EVERY) {
                squares += (stepper.outputs().energy - energy).powi(2);
                looks += 1.0;
            }
        }
        errors.push(f64::sqrt(squares / looks));
    }
    errors
}

/// Without compensation the state is rounded to 2⁻⁵³ of itself in every step; with it, the increment is, which is a
/// hundred times smaller.
#[test]
fn a_million_compensated_steps_keep_the_energy_to_rounding() {
    let [compensated] = errors(true, &[1_000_000])[..] else {
        unreachable!()
    };
    let [plain] = errors(false, &[1_000_000])[..] else {
        unreachable!()
    };
    // Two units in the last place of the energy, −11.5 J.
    assert!(compensated < 4e-15, "{compensated:e}");
    assert!(plain > 20.0 * compensated, "{plain:e} {compensated:e}");
}

#[test]
#[ignore = "1e8 steps take some ten seconds"]
fn a_hundred_million_compensated_steps_keep_the_energy_to_5e_14() {
    let steps: Vec<u64> = (0..=10).map(|i| 100_000_000 >> (10 - i)).collect();
    let errors = errors(true, &steps);
    for (steps, error) in steps.iter().zip(&errors) {
        println!("{steps:>9} steps: rms energy error {error:.2e} J");
    }
    assert!(errors[10] < 5e-14, "{:e}", errors[10]);
}
