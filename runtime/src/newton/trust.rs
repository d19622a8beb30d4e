//! When quick steps end: what corrections have to show.

use crate::Settings;
use crate::Statistics;
use crate::model::System;
use crate::newton::Newton;
use crate::newton::rate::is_settled;
use crate::newton::rate::most_enough;
use crate::specimens::pendulum;
use crate::specimens::root::Evaluated;
use crate::specimens::root::Problem;
use crate::specimens::root::Root;

/// x² = 2
struct Root2;
impl Problem<1> for Root2 {
    fn evaluate([x]: [f64; 1]) -> Evaluated<1> {
        ([x * x - 2.0], [[2.0 * x]])
    }
}

/// Newton's method that has found corrections of any size to be enough.
fn credulous() -> Newton<Root<Root2, 1>, f64> {
    let mut newton = Newton::new(Settings::default());
    (newton.enough, newton.part) = ([1.0], [1.0]);
    newton
}

#[test]
fn a_surprising_correction_does_not_end_a_step() {
    let mut newton = credulous();
    (newton.first, newton.harmless) = ([1e-6], [1e-9]);
    assert!(newton.is_usual(&[1e-5]) && newton.is_usual(&[-1e-5]));
    assert!(!newton.is_usual(&[1e-4]) && !newton.is_usual(&[f64::NAN]));
    newton.first = [0.0];
    assert!(newton.is_usual(&[1e-10]) && !newton.is_usual(&[1e-8]));
}

#[test]
fn a_quick_step_ends_where_the_next_correction_would_be_nothing() {
    let mut newton = credulous();
    let mut statistics = Statistics::default();
    let mut quick = |start: f64| newton.solve_quickly(&(), &[start], &[start], &mut statistics);
    // 3, 1.83, 1.46, 1.415, 1.4142: four corrections are not enough.
    assert!(quick(3.0).is_none());
    // From here the third is.
    let (x, _) = quick(1.42).expect("a solution");
    assert!((x[0] - f64::sqrt(2.0)).abs() < 1e-15);
    assert_eq!(statistics.iterations, 4 + 3);
}

#[test]
fn what_was_enough_of_a_large_unknown_is_not_of_a_small_one() {
    let mut newton = credulous();
    (newton.enough, newton.part) = ([1e-9], [1e-9]);
    assert!(newton.is_enough(&[2.0], &[1.0], &[1e-9]));
    assert!(!newton.is_enough(&[1e-3], &[1e-4], &[1e-10]));
    assert!(!newton.is_enough(&[f64::NAN], &[f64::NAN], &[f64::NAN]));
}

#[test]
fn two_corrections_tell_the_next() {
    // e³/before² against a tenth of the tolerance.
    assert!(is_settled(1e-9, 1e-4, 1e-12));
    assert!(!is_settled(1e-6, 1e-4, 1e-12));
    // Too far away to tell.
    assert!(!is_settled(1e-9, 0.5, 1e-12));
    // A curvature of 1 leaves the square of a correction.
    let alone: f64 = most_enough(1e-12, false);
    assert!(alone * alone <= 1.0001e-13 && alone > 1e-7);
    // A kink leaves a share of it.
    assert!(most_enough(1e-12, true) <= 1e-12);
}

#[test]
fn corrections_in_closed_form_are_not_trusted_where_the_pivot_cancels() {
    // The determinant is 1 + h² c cos θ/4 for θ half way.
    let h = 0.5;
    for (c, is_trusted) in [(4.0 / (h * h), false), (1.0, true)] {
        let parameters = pendulum::Parameters {
            c,
            ..pendulum::Parameters::default()
        };
        let scene = <pendulum::Next as System<f64>>::scene(&parameters, h);
        let state = [std::f64::consts::PI, 0.0];
        let step = <pendulum::Next as System<f64>>::step(&scene, 0.0, &state);
        let mut newton = Newton::<pendulum::Next, f64>::new(Settings::default());
        let correction = newton.correction(&scene, &step, &state, &mut Statistics::default());
        assert_eq!(correction.is_some(), is_trusted, "{c}");
    }
}
