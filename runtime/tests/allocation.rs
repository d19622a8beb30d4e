//! A step allocates nothing, whether it succeeds or fails.

use residua::Adaptive;
use residua::Gauss;
use residua::Model as _;
use residua::RungeKutta4;
use residua::Settings;
use residua::Stepper;
use residua::VariableGauss;

use pendulum::Model;
use pendulum::Next;
use pendulum::Parameters;

#[path = "../src/specimens/pendulum.rs"]
#[allow(dead_code, reason = "this test needs no catalogue")]
#[allow(missing_docs, reason = "it stands for a generated module")]
mod pendulum;

const STEPS: u64 = 100;

#[test]
fn steps_do_not_allocate() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let counted = allocation_counter::measure(|| {
        let mut implicit = Stepper::<Next>::new(parameters, start, 0.01).unwrap();
        let mut explicit = RungeKutta4::<Model>::new(parameters, start, 0.01).unwrap();
        let mut gauss = Gauss::<Model, 8>::new(parameters, start, 0.01).unwrap();
        let mut adaptive =
            Adaptive::<VariableGauss<Model, 8, f64>>::new(parameters, start, 0.01).unwrap();
        for _ in 0..STEPS {
            implicit.step().unwrap();
            explicit.step().unwrap();
            gauss.step().unwrap();
            adaptive.step().unwrap();
        }
        assert_eq!(implicit.steps(), STEPS);
    });
    assert_eq!(counted.count_total, 0);
}

#[test]
fn failed_steps_do_not_allocate() {
    let settings = Settings {
        max_iterations: 1,
        ..Settings::default()
    };
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let counted = allocation_counter::measure(|| {
        let stepper = Stepper::<Next>::new(parameters, start, 0.01).unwrap();
        assert!(stepper.with_settings(settings).step().is_err());
    });
    assert_eq!(counted.count_total, 0);
}

#[test]
fn the_counter_counts() {
    let counted = allocation_counter::measure(|| drop(std::hint::black_box(Box::new(1))));
    assert_eq!(counted.count_total, 1);
}
