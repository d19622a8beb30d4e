use std::string::String;
use std::string::ToString;
use std::sync::Mutex;
use std::vec;
use std::vec::Vec;

use super::Ensemble;
use super::Fleet;
use super::Outcome;
use super::WIDTH;
use crate::erased::Sample;
use crate::settings::Settings;
use crate::specimens::pendulum::Next;
use crate::specimens::pendulum::Parameters;
use crate::specimens::pendulum::State;
use crate::stepper::Stepper;

const H: f64 = 0.01;

/// How far a lane may be from a stepper after a thousand steps: rounding of numbers up to 40, grown as fast as time
/// and a hundred times more where the pendulum nearly stands on its head.
const AGREEMENT: f64 = 1e-10;

/// From a gentle swing to several turns a second.
fn start(trajectory: usize) -> State {
    let theta = 0.1 + 0.037 * trajectory as f64;
    let omega = 0.3 * (trajectory % 7) as f64;
    State { theta, omega }
}

/// What is left of a trajectory.
#[derive(Debug, Clone, PartialEq)]
struct End {
    /// To the last bit.
    state: [u64; 2],
    step: u64,
    iterations: u64,
    error: Option<String>,
}

impl End {
    fn state(&self) -> [f64; 2] {
        self.state.map(f64::from_bits)
    }
}

/// Runs the trajectories of `numbers` one by one in this order, so many to a group as come one after the other.
fn run_with(
    numbers: &[usize],
    steps: u64,
    h: f64,
    start: &(dyn Fn(usize) -> State + Sync),
) -> (Vec<End>, Vec<Outcome>) {
    let runs: Vec<_> = numbers
        .iter()
        .map(|i| (Parameters::default(), start(*i)))
        .collect();
    let shown = Mutex::new(vec![([0, 0], 0, 0); numbers.len()]);
    let observer = |trajectory: usize, sample: Sample| {
        let state = [sample.state[0].to_bits(), sample.state[1].to_bits()];
        let what = (state, sample.step, sample.statistics.iterations);
        shown.lock().unwrap()[trajectory] = what;
    };
    let outcomes = Ensemble::<Next>::NEW
        .run(&runs, h, steps, &observer)
        .unwrap();
    let shown = shown.into_inner().unwrap();
    let ends = shown
        .into_iter()
        .zip(&outcomes)
        .map(|((state, step, iterations), outcome)| End {
            state,
            step,
            iterations,
            error: outcome.error.map(|error| error.to_string()),
        });
    (ends.collect(), outcomes)
}

fn run(numbers: &[usize], steps: u64) -> Vec<End> {
    run_with(numbers, steps, H, &start).0
}

#[test]
fn trajectories_are_those_of_a_stepper() {
    let numbers: Vec<usize> = (0..70).collect();
    let (ends, outcomes) = run_with(&numbers, 1000, H, &start);
    for (i, (end, outcome)) in ends.iter().zip(&outcomes).enumerate() {
        let mut stepper = Stepper::<Next>::new(Parameters::default(), start(i), H).unwrap();
        for _ in 0..1000 {
            stepper.step().unwrap();
        }
        for (a, b) in end.state().iter().zip(stepper.state_array()) {
            assert!((a - b).abs() <= AGREEMENT, "{i}: {a} {b}");
        }
        assert_eq!((outcome.alone, outcome.statistics.steps), (0, 1000));
        // One correction a step, and some more in the first sixteen and in every thirty-second.
        assert!(outcome.statistics.iterations < 1100, "{i}: {outcome:?}");
    }
}

#[test]
fn no_trajectory_depends_on_its_group() {
    let numbers: Vec<usize> = (0..70).collect();
    let together = run(&numbers, 300);
    let reversed: Vec<usize> = numbers.iter().rev().copied().collect();
    let mut backwards = run(&reversed, 300);
    backwards.reverse();
    assert_eq!(together, backwards);
    for (i, end) in together.iter().enumerate() {
        assert_eq!(*end, run(&[i], 300)[0]);
    }
}

#[test]
fn no_trajectory_depends_on_the_threads() {
    let numbers: Vec<usize> = (0..5 * WIDTH + 3).collect();
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| run(&numbers, 200))
    };
    let one = with(1);
    assert_eq!(one, with(2));
    assert_eq!(one, with(4));
}

/// One start that overflows, one that is none, one that is out of reach of the sine of lanes.
fn far(trajectory: usize) -> State {
    match trajectory {
        3 => State {
            theta: 1.0,
            omega: f64::MAX,
        },
        5 => State {
            theta: f64::NAN,
            omega: 0.0,
        },
        9 => State {
            theta: 2e6,
            omega: 1.0,
        },
        _ => start(trajectory),
    }
}

#[test]
fn who_fails_leaves_the_others_alone() {
    let numbers: Vec<usize> = (0..12).collect();
    let undisturbed = run(&numbers, 500);
    let (ends, outcomes) = run_with(&numbers, 500, H, &far);
    for (i, (a, b)) in undisturbed.iter().zip(&ends).enumerate() {
        if ![3, 5, 9].contains(&i) {
            assert_eq!(a, b, "{i}");
        }
    }
    let failed = ends[3].error.as_ref().expect("a failed step");
    assert!(failed.starts_with("step "), "{failed}");
    let refused = ends[5].error.as_ref().expect("no start");
    assert!(refused.contains("θ"), "{refused}");
    // Out of reach of lanes is not out of reach.
    assert_eq!((ends[9].step, outcomes[9].alone), (500, 500));
    let mut stepper = Stepper::<Next>::new(Parameters::default(), far(9), H).unwrap();
    for _ in 0..500 {
        stepper.step().unwrap();
    }
    // One unit in the last place of 2·10⁶ is 2·10⁻¹⁰, and a turn multiplies it.
    for (a, b) in ends[9].state().iter().zip(stepper.state_array()) {
        assert!((a - b).abs() <= 1e-6, "{a} {b}");
    }
}

#[test]
fn states_are_shown_when_asked_for() {
    let steps = Mutex::new(Vec::new());
    let fill = |_: usize, parameters: &mut [f64], state: &mut [f64]| {
        parameters.copy_from_slice(&[9.81, 1.0, 1.0]);
        state.copy_from_slice(&[1.0, 0.5]);
    };
    let observer = |trajectory: usize, sample: Sample| {
        let when = (trajectory, sample.step, sample.t);
        steps.lock().unwrap().push(when);
    };
    let fleet = Fleet {
        trajectories: 7..8,
        fill: &fill,
        h: 0.5,
        t0: 2.0,
        steps: 5,
        every: 2,
        settings: Settings::default(),
        observer: &observer,
    };
    Ensemble::<Next>::NEW.fly(&fleet).unwrap();
    let expected = [(7, 0, 2.0), (7, 2, 3.0), (7, 4, 4.0), (7, 5, 4.5)];
    assert_eq!(steps.into_inner().unwrap(), expected);
}

#[test]
fn steps_and_times_must_be_numbers() {
    let fleet = |h, t0| {
        let fill = |_: usize, _: &mut [f64], _: &mut [f64]| {};
        Ensemble::<Next>::NEW.fly(&Fleet {
            trajectories: 0..0,
            fill: &fill,
            h,
            t0,
            steps: 1,
            every: 0,
            settings: Settings::default(),
            observer: &|_, _| {},
        })
    };
    assert!(fleet(0.01, 0.0).is_ok());
    for (h, t0) in [(0.0, 0.0), (f64::NAN, 0.0), (0.01, f64::INFINITY)] {
        assert!(fleet(h, t0).is_err());
    }
}
