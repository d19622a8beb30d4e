//! Collocation on the pendulum.
use crate::Gauss;
use crate::Model as _;
use crate::specimens::pendulum::Model;
use crate::specimens::pendulum::Parameters;
#[test]
fn debug() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut run = Gauss::<Model, 8>::new(parameters, start, 0.055).unwrap();
    for _ in 0..900 {
        let r = run.step().unwrap();
        std::println!("{} {:?}", run.steps(), r.iterations);
    }
}
