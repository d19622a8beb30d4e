//! Messages, word for word.

use std::string::ToString;

use crate::Failure;
use crate::Fault;
use crate::History;
use crate::InvalidRun;
use crate::Model;
use crate::Place;
use crate::RungeKutta4;
use crate::StepError;
use crate::Stepper;
use crate::specimens::pendulum;

fn message(failure: Failure, place: Place, value: f64, iterations: usize) -> std::string::String {
    let description = <pendulum::Model as Model<f64>>::DESCRIPTION;
    let mut history = History::default();
    (0..iterations).for_each(|_| history.push(1.0));
    let error = StepError {
        fault: Fault {
            failure,
            place,
            value,
        },
        step: 17,
        t: 0.17,
        history,
        description,
        solver: Some(&description.solvers[0]),
    };
    error.to_string()
}

#[test]
fn failures_name_time_and_equation() {
    assert_eq!(
        message(Failure::Diverged, Place::Equation(1), -3.21e4, 6),
        "step 17 at t = 0.17: Newton diverged after 6 iterations; \
         largest residual -3.2e4 in equation 2, `der(ω) + c*sin(θ[k+1/2]) = 0` (line 8)"
    );
    assert_eq!(
        message(Failure::Stalled, Place::Equation(0), 1.0, 50),
        "step 17 at t = 0.17: Newton stalled after 50 iterations; \
         largest residual 1.0e0 in equation 1, `der(θ) - ω[k+1/2] = 0` (line 7)"
    );
    assert_eq!(
        message(Failure::Singular, Place::Equation(0), 2.0, 1),
        "step 17 at t = 0.17: the Jacobian became singular after 1 iteration; \
         largest residual 2.0e0 in equation 1, `der(θ) - ω[k+1/2] = 0` (line 7)"
    );
}

#[test]
fn what_has_too_few_digits_is_named() {
    assert_eq!(
        message(Failure::Loose, Place::Unknown(1), 2.6e-10, 50),
        "step 17 at t = 0.17: unknown ω[k+1] is not known: the equations hold to rounding, and that moves it by 2.6e-10 of its \
         size"
    );
    assert_eq!(
        message(Failure::Unresolved, Place::Equation(1), 0.0, 3),
        "step 17 at t = 0.17: rounding of the unknowns changes equation 2, `der(ω) + c*sin(θ[k+1/2]) = 0` (line 8): they are \
         too large for numbers of so few digits"
    );
    assert_eq!(
        message(Failure::Drowned, Place::Equation(1), 0.0123, 3),
        "step 17 at t = 0.17: rounding of the terms of equation 2, `der(ω) + c*sin(θ[k+1/2]) = 0` (line 8) moves the state by \
         1.2e-2 of its size"
    );
    assert_eq!(
        message(Failure::Drowned, Place::State(0), f64::INFINITY, 3),
        "step 17 at t = 0.17: rounding of the terms of state θ at the end of the step is all that moves the state"
    );
    assert_eq!(
        message(Failure::Drowned, Place::State(0), 3.0, 3),
        "step 17 at t = 0.17: rounding of the terms of state θ at the end of the step moves the state by 3.0e0 of its size"
    );
}

#[test]
fn what_is_undetermined_is_named() {
    assert_eq!(
        message(Failure::Undetermined, Place::State(0), 3.21e7, 3),
        "step 17 at t = 0.17: state θ at the end of the step is not known: on its way from the unknowns, rounding grows 3.2e7 \
         times; a shorter step may do"
    );
}

#[test]
fn what_is_not_finite_is_named() {
    assert_eq!(
        message(Failure::NotFinite, Place::Equation(0), f64::NAN, 0),
        "step 17 at t = 0.17: equation 1, `der(θ) - ω[k+1/2] = 0` (line 7), is NaN after 0 iterations"
    );
    assert_eq!(
        message(Failure::NotFinite, Place::Unknown(1), f64::INFINITY, 2),
        "step 17 at t = 0.17: unknown ω[k+1] is inf after 2 iterations"
    );
    assert_eq!(
        message(Failure::NotFinite, Place::State(0), f64::NAN, 3),
        "step 17 at t = 0.17: state θ at the end of the step is NaN after 3 iterations"
    );
}

#[test]
fn only_the_last_corrections_are_kept() {
    let mut history = History::default();
    (0..20).for_each(|i| history.push(f64::from(i)));
    assert_eq!(history.iterations(), 20);
    assert!(history.sizes().iter().copied().eq((8u8..20).map(f32::from)));
}

/// What `run` refuses.
fn refused(theta: f64, c: f64, h: f64, t0: f64) -> std::string::String {
    let parameters = pendulum::Parameters { c, unit: [1.0; 2] };
    let start = pendulum::State { theta, omega: 0.0 };
    let implicit = Stepper::<pendulum::Next>::new(parameters, start, h).and_then(|run| run.at(t0));
    let explicit =
        RungeKutta4::<pendulum::Model>::new(parameters, start, h).and_then(|run| run.at(t0));
    let error: InvalidRun = implicit.err().expect("an invalid run");
    assert_eq!(
        explicit.err().expect("the same").to_string(),
        error.to_string()
    );
    error.to_string()
}

#[test]
fn runs_start_with_finite_numbers_only() {
    let (ok, nan, inf) = (1.0, f64::NAN, f64::INFINITY);
    let step = "expected a finite number other than 0";
    assert_eq!(
        refused(ok, ok, 0.0, ok),
        std::format!("step h is 0, {step}")
    );
    assert_eq!(
        refused(ok, ok, nan, ok),
        std::format!("step h is NaN, {step}")
    );
    assert_eq!(
        refused(ok, ok, -inf, ok),
        std::format!("step h is -inf, {step}")
    );
    assert_eq!(
        refused(ok, inf, ok, ok),
        "parameter c is inf, expected a finite number"
    );
    assert_eq!(
        refused(nan, ok, ok, ok),
        "start value θ is NaN, expected a finite number"
    );
    assert_eq!(
        refused(ok, ok, ok, nan),
        "start time is NaN, expected a finite number"
    );
    assert_eq!(
        refused(ok, ok, 1e-3, 1e16),
        "a step of 0.001 does not change the start time 1e16: it is less than rounding of it"
    );
}
