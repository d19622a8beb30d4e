//! The explicit method on the pendulum, and on a flow that blows up.

use crate::Failure;
use crate::Model as _;
use crate::Place;
use crate::RungeKutta4;
use crate::specimens::pendulum::Model;
use crate::specimens::pendulum::Parameters;
use crate::specimens::pendulum::State;

fn end(h: f64, steps: u32) -> f64 {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut run = RungeKutta4::<Model>::new(parameters, start, h).unwrap();
    for _ in 0..steps {
        assert_eq!(run.step().unwrap().iterations, 0);
    }
    assert_eq!(run.statistics().flows, 4 * u64::from(steps));
    run.state().theta
}

#[test]
fn the_method_is_of_fourth_order() {
    let (coarse, middle, fine) = (end(0.04, 50), end(0.02, 100), end(0.01, 200));
    let order = ((coarse - middle) / (middle - fine)).log2();
    assert!((order - 4.0).abs() < 0.1, "{order}");
}

#[test]
fn a_state_that_overflows_is_a_failure() {
    let start = State {
        theta: 1.0,
        omega: f64::MAX,
    };
    let parameters = Parameters::default();
    let mut run = RungeKutta4::<Model>::new(parameters, start, 10.0).unwrap();
    let error = run.step().unwrap_err();
    assert_eq!(error.fault.failure, Failure::NotFinite);
    assert_eq!(error.fault.place, Place::State(0));
    assert_eq!(run.state(), start);
    assert_eq!(run.t(), 0.0);
}
