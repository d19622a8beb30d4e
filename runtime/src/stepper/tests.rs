//! The implicit stepper on the pendulum.

use crate::Real;
use crate::Settings;
use crate::Stepper;
use crate::specimens::pendulum::Next;
use crate::specimens::pendulum::Parameters;
use crate::specimens::pendulum::State;

const H: f64 = 0.01;
/// A step at which the extrapolated start is within rounding after one correction.
const SMALL: f64 = 0.005;

fn pendulum<T: Real + nalgebra::RealField>(unit: [f64; 2], h: f64) -> Stepper<Next, T> {
    let parameters = Parameters {
        unit: unit.map(T::constant),
        ..Parameters::default()
    };
    let start = <crate::specimens::pendulum::Model as crate::Model<T>>::start(&parameters);
    Stepper::new(parameters, start, T::constant(h)).unwrap()
}

fn advance(stepper: &mut Stepper<Next>, steps: u32) {
    for _ in 0..steps {
        stepper.step().unwrap();
    }
}

#[test]
fn a_pendulum_step_takes_one_iteration_once_its_start_is_known() {
    let mut stepper = pendulum::<f64>([1.0, 1.0], SMALL);
    advance(&mut stepper, 100);
    let before = stepper.statistics();
    // Convergence is measured anew by a second correction in every 64th step.
    advance(&mut stepper, 320);
    let statistics = stepper.statistics();
    assert_eq!(statistics.steps - before.steps, 320);
    let iterations = statistics.iterations - before.iterations;
    assert!((325..=330).contains(&iterations), "{iterations}");
    assert_eq!(statistics.residuals, before.residuals);
    assert_eq!(statistics.flows, 0);
}

/// One correction is enough only where it is: the state is as if iterated to the floor.
#[test]
fn a_step_of_one_iteration_is_as_good_as_one_to_the_floor() {
    let mut quick = pendulum::<f64>([1.0, 1.0], SMALL);
    let settings = Settings {
        tolerance: 0.0,
        ..Settings::default()
    };
    let mut exact = pendulum::<f64>([1.0, 1.0], SMALL).with_settings(settings);
    advance(&mut quick, 2000);
    advance(&mut exact, 2000);
    assert!(quick.statistics().iterations < 2200);
    assert!(exact.statistics().iterations > 3000);
    for (a, b) in quick.state_array().iter().zip(exact.state_array()) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

/// Iterations of each of the first 200 steps.
fn iterations(unit: [f64; 2]) -> std::vec::Vec<usize> {
    let mut stepper = pendulum::<f64>(unit, 0.1);
    let steps = 0..200;
    steps.map(|_| stepper.step().unwrap().iterations).collect()
}

#[test]
fn units_of_the_states_do_not_change_the_iterations() {
    let reference = iterations([1.0, 1.0]);
    for unit in [[1e8, 1e-8], [1e-8, 1e8], [1e8, 1e8], [1e-8, 1e-8]] {
        assert_eq!(iterations(unit), reference, "{unit:?}");
    }
}

#[test]
fn the_midpoint_rule_is_of_second_order() {
    let end = |h: f64, steps: u32| {
        let mut stepper = pendulum::<f64>([1.0, 1.0], h);
        advance(&mut stepper, steps);
        stepper.state().theta
    };
    let (coarse, middle, fine) = (end(0.04, 50), end(0.02, 100), end(0.01, 200));
    let order = ((coarse - middle) / (middle - fine)).log2();
    assert!((order - 2.0).abs() < 0.05, "{order}");
}

#[test]
fn a_negative_step_runs_backwards() {
    let mut there = pendulum::<f64>([1.0, 1.0], 0.1);
    advance(&mut there, 100);
    let mut back = Stepper::<Next>::new(Parameters::default(), there.state(), -0.1)
        .unwrap()
        .at(there.t())
        .unwrap();
    advance(&mut back, 100);
    assert_eq!(back.t(), 0.0);
    // The rule is symmetric; what is left is rounding, which the motion amplifies some tenfold.
    assert!((back.state().theta - 1.0).abs() < 1e-12);
    assert!((back.state().omega - 0.5).abs() < 1e-12);
}

#[test]
fn time_is_a_product_and_not_a_sum() {
    let mut stepper = pendulum::<f64>([1.0, 1.0], 0.1).at(2.0).unwrap();
    advance(&mut stepper, 1000);
    assert_eq!(stepper.t(), 2.0 + 1000.0 * 0.1);
    assert_eq!(stepper.steps(), 1000);
    assert_eq!(stepper.h(), 0.1);
}

#[test]
fn a_pendulum_at_rest_stays_there() {
    for (theta, omega) in [(0.0, 0.0), (std::f64::consts::PI, 0.0)] {
        let start = State { theta, omega };
        let mut stepper = Stepper::<Next>::new(Parameters::default(), start, H).unwrap();
        advance(&mut stepper, 100);
        assert!((stepper.state().theta - theta).abs() < 1e-12);
    }
}

#[test]
fn a_tolerance_of_zero_takes_the_step_to_the_floor() {
    let settings = Settings {
        tolerance: 0.0,
        ..Settings::default()
    };
    let mut stepper = pendulum::<f64>([1.0, 1.0], H).with_settings(settings);
    for _ in 0..1000 {
        assert!(stepper.step().unwrap().iterations <= 7);
    }
    assert!(stepper.statistics().at_floor > 900);
}

#[test]
fn single_precision_runs_as_well() {
    let mut single = pendulum::<f32>([1.0, 1.0], H);
    let mut double = pendulum::<f64>([1.0, 1.0], H);
    for _ in 0..100 {
        assert!(single.step().unwrap().iterations <= 4);
        double.step().unwrap();
    }
    assert!((f64::from(single.state().theta) - double.state().theta).abs() < 1e-5);
    assert!((f64::from(single.outputs().energy) - double.outputs().energy).abs() < 1e-4);
}

#[test]
fn many_steps_in_one_call_are_the_same_steps() {
    for count in [1, 17, 63, 64, 65, 1000] {
        let [mut together, mut apart] = [0; 2].map(|_| pendulum::<f64>([1.0, 1.0], H));
        for _ in 0..3 {
            together.advance(count).unwrap();
            advance(&mut apart, count as u32);
            assert_eq!(together.state_array(), apart.state_array(), "{count}");
            assert_eq!(together.statistics(), apart.statistics(), "{count}");
        }
    }
}

#[test]
fn a_step_that_fails_is_halved_until_it_does_not() {
    // Enough for a step of 0.1, not for one of 0.8.
    let settings = Settings {
        max_iterations: 3,
        halvings: 3,
        ..Settings::default()
    };
    let long = 0.8;
    let strict = Settings {
        halvings: 2,
        ..settings
    };
    let mut refused = pendulum::<f64>([1.0, 1.0], long).with_settings(strict);
    let start = *refused.state_array();
    assert_eq!(refused.step().unwrap_err().step, 0);
    assert_eq!(refused.state_array(), &start);
    assert_eq!(refused.statistics().halved, 0);

    let mut halved = pendulum::<f64>([1.0, 1.0], long).with_settings(settings);
    let mut short = pendulum::<f64>([1.0, 1.0], long / 8.0).with_settings(settings);
    halved.step().unwrap();
    advance(&mut short, 8);
    assert_eq!(halved.state_array(), short.state_array());
    assert_eq!((halved.steps(), halved.t()), (1, long));
    assert_eq!(
        (halved.statistics().halved, short.statistics().halved),
        (1, 0)
    );
}

#[test]
fn what_was_learnt_can_be_forgotten() {
    let mut stepper = pendulum::<f64>([1.0, 1.0], H);
    advance(&mut stepper, 20);
    let newton = &mut stepper.method.core.newton;
    assert!(newton.trusted(10) > 0);
    newton.forget();
    assert_eq!(newton.trusted(10), 0);
}
