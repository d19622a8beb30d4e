//! Runs of the pendulum behind trait objects.

use core::ops::ControlFlow;
use std::string::ToString;
use std::vec::Vec;

use super::Run;
use crate::Catalogued;
use crate::RunError;
use crate::Settings;
use crate::erased::Scheme;
use crate::specimens::pendulum::MODEL;

const RUN: Run = Run {
    parameters: &[9.81, 1.0, 1.0],
    start: &[1.0, 0.5],
    h: 0.1,
    t0: 1.0,
    steps: 7,
    every: 3,
    settings: Settings {
        tolerance: 1e-12,
        max_iterations: 50,
        max_growths: 4,
        strategy: crate::Strategy::Core,
        compensated: true,
        halvings: 0,
    },
};

/// The steps that `run` shows, by Newton's method and by Runge–Kutta.
fn shown(run: &Run) -> [Vec<u64>; 2] {
    let (mut implicit, mut explicit) = (Vec::new(), Vec::new());
    let result = MODEL.solvers[0].simulate(run, &mut |sample| {
        assert_eq!(sample.t, run.t0 + sample.step as f64 * run.h);
        assert_eq!(sample.statistics.steps, sample.step);
        implicit.push(sample.step);
        ControlFlow::Continue(())
    });
    assert_eq!(result.unwrap().steps, run.steps);
    let result = MODEL
        .flow
        .unwrap()
        .simulate(Scheme::RungeKutta4, run, &mut |sample| {
            explicit.push(sample.step);
            ControlFlow::Continue(())
        });
    assert_eq!(result.unwrap().flows, 4 * run.steps);
    [implicit, explicit]
}

#[test]
fn start_and_end_are_always_shown() {
    assert_eq!(shown(&RUN), [[0, 3, 6, 7], [0, 3, 6, 7]]);
    assert_eq!(shown(&Run { every: 0, ..RUN }), [[0, 7], [0, 7]]);
    assert_eq!(shown(&Run { every: 7, ..RUN }), [[0, 7], [0, 7]]);
    assert_eq!(shown(&Run { steps: 0, ..RUN }), [[0], [0]]);
}

#[test]
fn an_observer_may_end_a_run() {
    let statistics = MODEL.solvers[0].simulate(&RUN, &mut |sample| match sample.step {
        3 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    assert_eq!(statistics.unwrap().steps, 3);
}

fn refused(run: &Run) -> std::string::String {
    let mut observer = |_: super::Sample| unreachable!("an invalid run has no states");
    let implicit = MODEL.solvers[0].simulate(run, &mut observer).unwrap_err();
    let explicit = MODEL
        .flow
        .unwrap()
        .simulate(Scheme::RungeKutta4, run, &mut observer)
        .unwrap_err();
    assert!(matches!(implicit, RunError::Invalid(_)));
    assert_eq!(implicit.to_string(), explicit.to_string());
    implicit.to_string()
}

#[test]
fn runs_that_cannot_start_are_refused() {
    let (parameters, start) = (&[9.81, 1.0, f64::NAN], &[1.0]);
    let finite = "expected a finite number";
    assert_eq!(
        refused(&Run { parameters, ..RUN }),
        std::format!("parameter unit.y is NaN, {finite}")
    );
    assert_eq!(
        refused(&Run { start, ..RUN }),
        "expected 2 start values, found 1"
    );
    let parameters = &parameters[..2];
    assert_eq!(
        refused(&Run { parameters, ..RUN }),
        "expected 3 parameters, found 2"
    );
}

#[test]
fn a_step_that_fails_ends_the_run() {
    let settings = Settings {
        max_iterations: 1,
        ..RUN.settings
    };
    let mut steps = Vec::new();
    let outcome = MODEL.solvers[0].simulate(&Run { settings, ..RUN }, &mut |sample| {
        steps.push(sample.step);
        ControlFlow::Continue(())
    });
    assert!(matches!(outcome, Err(RunError::Step(_))));
    assert_eq!(steps, [0]);
}

#[test]
fn defaults_and_outputs_go_through_slices() {
    let (mut parameters, mut start, mut energy) = ([f64::NAN; 3], [f64::NAN; 2], [f64::NAN]);
    MODEL.model.defaults(&mut parameters);
    MODEL.model.start(&parameters, &mut start);
    MODEL
        .model
        .outputs(&parameters, 0.1, 0.0, &start, &mut energy);
    assert_eq!((parameters, start), ([9.81, 1.0, 1.0], [1.0, 0.5]));
    assert_eq!(energy, [0.125 - 9.81 * f64::cos(1.0)]);
    let mut rates = [f64::NAN; 2];
    MODEL
        .flow
        .unwrap()
        .flow(&parameters, 0.0, &start, &mut rates);
    assert_eq!(rates, [0.5, -9.81 * f64::sin(1.0)]);
}

#[test]
fn a_stub_has_nothing() {
    static STUB: Catalogued = Catalogued::stub("broken");
    assert!(STUB.solvers.is_empty() && STUB.flow.is_none());
    STUB.model.start(&[], &mut []);
}
