//! Collocation on the pendulum.

use crate::Adaptive;
use crate::Failure;
use crate::Gauss;
use crate::Model as _;
use crate::Stepper;
use crate::Tolerance;
use crate::VariableGauss;
use crate::specimens::pendulum::Model;
use crate::specimens::pendulum::Next;
use crate::specimens::pendulum::Parameters;
use crate::specimens::pendulum::State;

/// One stage is the midpoint rule that the specimen's equations print. Newton's tolerance there is 1e-12, and neighbouring
/// motions part by less than ten times in a hundred steps.
#[test]
fn one_stage_is_the_midpoint_rule() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut gauss = Gauss::<Model, 1>::new(parameters, start, 0.02).unwrap();
    let mut printed = Stepper::<Next>::new(parameters, start, 0.02).unwrap();
    for _ in 0..100 {
        gauss.step().unwrap();
        printed.step().unwrap();
        let (a, b) = (gauss.state(), printed.state());
        assert!((a.theta - b.theta).abs() <= 1e-11, "{a:?} {b:?}");
        assert!((a.omega - b.omega).abs() <= 1e-11, "{a:?} {b:?}");
    }
}

/// Each step rounds its increments, h |f| of up to one, and nothing else adds up: the energy, −4.9, walks at random, not
/// further than four times ε √n. A trend of a tenth of an ε per step would be four times that.
#[test]
fn the_energy_has_no_trend() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut run = Gauss::<Model, 8>::new(parameters, start, 0.1).unwrap();
    let before = run.outputs().energy;
    for step in 1..=20_000 {
        run.step().unwrap();
        let off = (run.outputs().energy - before).abs();
        let bound = 4.0 * f64::EPSILON * f64::sqrt(f64::from(step)).max(8.0);
        assert!(off <= bound, "step {step}: {off:e}");
    }
}

/// Single precision ends where double precision does, to a hundred of its ε.
#[test]
fn single_precision_works_as_well() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let mut double = Gauss::<Model, 4>::new(parameters, start, 0.05).unwrap();
    let parameters = Parameters::<f32>::default();
    let start = State::<f32> {
        theta: 1.0,
        omega: 0.5,
    };
    let mut single = Gauss::<Model, 4, f32>::new(parameters, start, 0.05).unwrap();
    for _ in 0..20 {
        double.step().unwrap();
        single.step().unwrap();
    }
    let off = (double.state().theta - f64::from(single.state().theta)).abs();
    assert!(off <= 100.0 * f64::from(f32::EPSILON), "{off:e}");
}

/// A pendulum of 10⁴ rad/s in steps of 0.01 s: sweeps cannot contract, Newton's method keeps the quadratic energy of small
/// swings, here of 1e-3 rad, of which the cubic force is 1e-7.
#[test]
fn stiff_steps_go_by_newton() {
    let parameters = Parameters {
        c: 1e8,
        ..Parameters::default()
    };
    let start = State {
        theta: 1e-3,
        omega: 0.0,
    };
    let size = |state: State| state.omega * state.omega / 1e8 + state.theta * state.theta;
    let mut run = Gauss::<Model, 3>::new(parameters, start, 0.01).unwrap();
    for _ in 0..200 {
        run.step().unwrap();
        let ratio = size(run.state()) / size(start);
        assert!((ratio - 1.0).abs() < 1e-5, "{ratio}");
    }
    assert!(run.statistics().jacobians > 0);
}

#[test]
fn failures_have_types() {
    let start = State {
        theta: 1.0,
        omega: f64::MAX,
    };
    let parameters = Parameters::default();
    let mut run = Gauss::<Model, 2>::new(parameters, start, 10.0).unwrap();
    let error = run.step().unwrap_err();
    assert!(
        matches!(error.fault.failure, Failure::NotFinite | Failure::Stages),
        "{error}"
    );
    assert_eq!((run.state(), run.t()), (start, 0.0));
    let mut run = Adaptive::<VariableGauss<Model, 4, f64>>::new(parameters, start, 10.0).unwrap();
    assert!(run.step().is_err());
    assert_eq!(run.state(), start);
}

/// Other outputs of the same motion, and backwards to where it began.
#[test]
fn a_run_within_a_tolerance_comes_back() {
    let parameters = Parameters::default();
    let start = Model::start(&parameters);
    let tolerance = Tolerance::both(1e-10);
    let run = |state: State, h: f64, steps: u32| {
        let run = Adaptive::<VariableGauss<Model, 6, f64>>::new(parameters, state, h).unwrap();
        let mut run = run.with_tolerance(tolerance);
        for _ in 0..steps {
            run.step().unwrap();
        }
        run.state()
    };
    let (once, often) = (run(start, 2.0, 1), run(start, 0.01, 200));
    assert!(
        (once.theta - often.theta).abs() <= 1e-8,
        "{once:?} {often:?}"
    );
    let back = run(often, -0.5, 4);
    assert!((back.theta - start.theta).abs() <= 1e-8, "{back:?}");
}
