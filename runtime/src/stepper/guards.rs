//! What a solved step must still fulfil before its state is taken.

use crate::Failure;
use crate::Place;
use crate::Report;
use crate::Settings;
use crate::Statistics;
use crate::StepError;
use crate::Stepper;
use crate::description::Unknown;
use crate::specimens::root::Evaluated;
use crate::specimens::root::Flat;
use crate::specimens::root::Problem;
use crate::specimens::root::Root;
use crate::stepper::Solver;
use std::string::ToString;

/// x = 2, whatever the step before.
fn two(x: [f64; 1]) -> Evaluated<1> {
    ([x[0] - 2.0], [[1.0]])
}

/// One step from 0.
fn one_step<P: Problem<1>>() -> (Stepper<Root<P, 1>>, Result<Report, StepError>) {
    let mut stepper = Stepper::<Root<P, 1>>::new(Flat([]), Flat([0.0]), 1.0).unwrap();
    let outcome = stepper.step();
    (stepper, outcome)
}

/// An unknown that has a value, and a state that has none.
struct NoState;
impl Problem<1> for NoState {
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        two(x)
    }
    fn next(_known: [f64; 1], x: [f64; 1]) -> [f64; 1] {
        [(1.0 - x[0]).sqrt()]
    }
}

#[test]
fn a_state_without_a_value_is_not_taken() {
    let (stepper, outcome) = one_step::<NoState>();
    let fault = outcome.unwrap_err().fault;
    assert_eq!(
        (fault.failure, fault.place),
        (Failure::NotFinite, Place::State(0))
    );
    assert_eq!(stepper.state_array(), &[0.0]);
    assert_eq!(stepper.steps(), 0);
}

/// An unknown that was divided by what is rounding.
struct Divided;
impl Problem<1> for Divided {
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        two(x)
    }
    fn growth() -> f64 {
        1e7
    }
}

#[test]
fn what_is_eliminated_by_a_pivot_of_rounding_is_not_trusted() {
    let (_, outcome) = one_step::<Divided>();
    assert_eq!(outcome.unwrap_err().fault.failure, Failure::Singular);
}

/// A state that is a small difference of what the unknown tells.
struct Difference;
impl Problem<1> for Difference {
    const UNKNOWNS: &'static [Unknown] = &[Unknown {
        name: "F",
        len: 1,
        measure: None,
        told: false,
    }];
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        two(x)
    }
    fn next(_known: [f64; 1], x: [f64; 1]) -> [f64; 1] {
        [x[0] - (2.0 - 1e-9)]
    }
}

#[test]
fn a_state_that_is_a_difference_of_large_unknowns_is_not_known() {
    let (_, outcome) = one_step::<Difference>();
    let fault = outcome.unwrap_err().fault;
    assert_eq!(
        (fault.failure, fault.place),
        (Failure::Undetermined, Place::State(0))
    );
    assert!((1e9..4e9).contains(&fault.value), "{}", fault.value);
}

/// An unknown that is not the state, but tells it.
struct Told;
impl Problem<1> for Told {
    const UNKNOWNS: &'static [Unknown] = Difference::UNKNOWNS;
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        two(x)
    }
}

#[test]
fn a_state_that_has_grown_is_looked_at_again() {
    let mut solver = Solver::<Root<Told, 1>, f64>::new(&Flat([]), 1.0);
    assert!(!solver.is_within_reach(&[1e-9]));
    let (mut state, mut statistics) = ([0.0], Statistics::default());
    let step = solver.advance(0.0, &mut state, &mut [0.0], &mut statistics, |_, _| Ok(()));
    assert!(step.is_ok() && state == [2.0]);
    assert!(solver.is_within_reach(&[-7.9]) && !solver.is_within_reach(&[8.1]));
    assert!(!solver.is_within_reach(&[f64::NAN]));
}

/// sin x = 0 where the next number is 16 radians away: every correction is small beside x.
struct Wave;
impl Problem<1> for Wave {
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        ([x[0].sin()], [[x[0].cos()]])
    }
}

#[test]
fn equations_that_rounding_makes_others_are_refused() {
    let mut stepper = Stepper::<Root<Wave, 1>>::new(Flat([]), Flat([1e17]), 1.0).unwrap();
    let outcome = stepper.step();
    let error = outcome.unwrap_err();
    assert_eq!(error.fault.failure, Failure::Unresolved);
    assert_eq!(error.fault.place, Place::Equation(0));
    assert_eq!(stepper.state_array(), &[1e17]);
    let message = "rounding of the unknowns changes equation 1, `r(x) = 0` (line 3): they are too large for numbers of so few digits";
    assert!(error.to_string().ends_with(message), "{error}");
}

/// A core that solves its own equation and misses those of the system.
struct Missed;
impl Problem<1> for Missed {
    const HAS_CORE: bool = true;
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        two(x)
    }
    fn next(_known: [f64; 1], x: [f64; 1]) -> [f64; 1] {
        [x[0] + 1e-6]
    }
}

#[test]
fn a_core_that_misses_an_equation_is_given_up() {
    let (stepper, outcome) = one_step::<Missed>();
    assert!(outcome.is_ok());
    assert_eq!(stepper.statistics().fallbacks, 1);
}

/// Increments of a quarter of what rounds away.
struct Creeping;
impl Problem<1> for Creeping {
    const IS_INCREMENT: bool = true;
    fn evaluate(x: [f64; 1]) -> Evaluated<1> {
        ([x[0] - 0.25 * f64::EPSILON], [[1.0]])
    }
}

#[test]
fn increments_that_round_away_add_up_all_the_same() {
    let mut ends = [true, false].map(|compensated| {
        let settings = Settings {
            compensated,
            ..Settings::default()
        };
        let stepper = Stepper::<Root<Creeping, 1>>::new(Flat([]), Flat([1.0]), 1.0).unwrap();
        let mut stepper = stepper.with_settings(settings);
        (0..4000).for_each(|_| assert!(stepper.step().is_ok()));
        stepper.state_array()[0] - 1.0
    });
    ends.iter_mut().for_each(|end| *end /= f64::EPSILON);
    assert!((ends[0] - 1000.0).abs() <= 1.0, "{ends:?}");
    assert_eq!(ends[1], 0.0);
}
