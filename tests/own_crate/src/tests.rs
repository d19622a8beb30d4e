//! The solver in this crate is a solver like those in the catalogue.

use crate::STEP;
use crate::pendulum::{Increment, MODEL, Model, Next, Parameters, State};
use residua::{Model as _, Stepper};

/// What 500 Newton solves to rounding may add up to, relative.
const ROUNDING: f64 = 1e-10;

fn after_five_seconds(parameters: Parameters) -> State {
    let start = Model::start(&parameters);
    let mut stepper = Stepper::<Increment>::new(parameters, start, STEP).unwrap();
    for _ in 0..500 {
        stepper.step().unwrap();
    }
    stepper.state()
}

#[test]
fn both_forms_take_the_same_steps() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut next = Stepper::<Next>::new(parameters, start, STEP).unwrap();
    for _ in 0..500 {
        next.step().unwrap();
    }
    let (a, b) = (next.state(), after_five_seconds(parameters));
    assert!((a.theta - b.theta).abs() < ROUNDING);
    assert!((a.omega - b.omega).abs() < ROUNDING);
}

#[test]
fn energy_stays_near_its_start() {
    let parameters = Parameters::default();
    let energy = |state| Model::outputs(&parameters, STEP, 0.0, &state).energy;
    let (start, end) = (
        energy(Model::start(&parameters)),
        energy(after_five_seconds(parameters)),
    );
    // The midpoint rule keeps the energy of a pendulum to O(h²): (h √(g/l))²/24 of its variation.
    assert!((end - start).abs() < 1e-3 * start.abs(), "{start} {end}");
}

#[test]
fn parameters_of_the_file_can_be_changed() {
    let long = Parameters {
        l: 2.4,
        ..Parameters::default()
    };
    assert_ne!(
        after_five_seconds(long).theta,
        after_five_seconds(Parameters::default()).theta
    );
}

#[test]
fn the_model_describes_itself() {
    assert_eq!(MODEL.description.name, "pendulum");
    assert_eq!(MODEL.description.states[0].name, "θ");
}
