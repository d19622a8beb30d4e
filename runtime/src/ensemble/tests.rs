use std::sync::Mutex;
use std::vec;
use std::vec::Vec;

use super::Ensemble;
use super::Fleet;
use super::Outcome;
use crate::erased::Sample;
use crate::settings::Settings;
use crate::specimens::pendulum::Next;
use crate::specimens::pendulum::Parameters;
use crate::specimens::pendulum::State;
use crate::stepper::Stepper;

const H: f64 = 0.01;

/// Starts from a gentle swing to several turns a second.
fn start(trajectory: usize) -> State {
    let theta = 0.1 + 0.037 * trajectory as f64;
    let omega = 0.3 * (trajectory % 7) as f64;
    State { theta, omega }
}

fn ends(count: usize, steps: u64) -> (Vec<[f64; 2]>, Vec<Outcome>) {
    let runs: Vec<_> = (0..count).map(|i| (Parameters::default(), start(i))).collect();
    let ends = Mutex::new(vec![[0.0; 2]; count]);
    let observer = |trajectory: usize, sample: Sample| {
        ends.lock().unwrap()[trajectory] = [sample.state[0], sample.state[1]];
    };
    let outcomes = Ensemble::<Next>::NEW.run(&runs, H, steps, &observer).unwrap();
    (ends.into_inner().unwrap(), outcomes)
}

#[test]
fn trajectories_are_those_of_a_stepper() {
    let (ends, outcomes) = ends(70, 1000);
    for (i, (end, outcome)) in ends.iter().zip(&outcomes).enumerate() {
        let mut stepper = Stepper::<Next>::new(Parameters::default(), start(i), H).unwrap();
        for _ in 0..1000 {
            stepper.step().unwrap();
        }
        std::println!("{i} {end:?} {:?} {outcome:?} {:?}", stepper.state_array(), stepper.statistics());
        for (a, b) in end.iter().zip(stepper.state_array()) {
            assert!((a - b).abs() <= 1e-11, "{i}: {a} {b}");
        }
    }
}
