//! Steps are right although what was learned from earlier ones no longer holds.

use residua::erased::AnySolver;
use residua::{Adaptive, Model, System, Tolerance, VariableGauss};
use residua_models::dsl::spatial_reduced;
use residua_tests::case::{Case, Tested, solver};
use std::ops::ControlFlow;
use std::sync::Mutex;

/// A linear oscillator, until something stiff and curved passes within a few steps.
mod kick {
    residua::model! {
        //! Kicked oscillator.
        param a = 10000;
        param τ = 21.5;
        state x;
        state v;
        residual {
            Δx = h*v[k+1/2];
            Δv = h*(-x[k+1/2] - a*exp(-(t[k+1/2] - τ)^2)*x[k+1/2]^3 + 3*sin(10*t[k+1/2]));
        }
        solve for increment;
        start { x = 0; v = 1; }
    }
}

/// A state that shrinks to a third and less in each step: what was a small correction once is a large one soon.
mod dwindle {
    residua::model! {
        //! Dwindling cubic.
        param q = 0.4;
        param c = 0.3;
        state x;
        residual {
            x[k+1]^3 + x^2*x[k+1]*0.01 + x[k+1]^2*x*c = q*(1 + 0.5*sin(5*t))*x^3;
        }
        solve for next, increment;
        start { x = 1; }
    }
}

/// A growing oscillation that reaches a stiff stop.
mod stop {
    residua::model! {
        //! One-sided spring.
        param e = 19.256512742837604;
        state x;
        state v;
        residual {
            Δx = h*v[k+1];
            Δv = -h*(100*x[k+1] - 10*v[k+1] + 1000000*(abs(x[k+1] - e) + x[k+1] - e)/2);
        }
        solve for increment;
        start { x = 1; v = 0; }
    }
}

/// A ball on a stiff spring, which it touches for a hundredth of a second.
mod ball {
    residua::model! {
        //! Bouncing ball.
        param κ = 100000;
        state x;
        state v;
        flow { der(x) = v; der(v) = -9.81 + κ*max(-x, 0); }
        residual {
            Δx = h*v[k+1/2];
            Δv = h*(-9.81 + κ*max(-x[k+1/2], 0));
        }
        start { x = 1; v = 0; }
    }
}

/// An oscillator with a limit that it does not reach.
mod limited {
    residua::model! {
        //! Limited force.
        param most = 1;
        state x;
        state v;
        residual {
            Δx = h*v[k+1/2];
            Δv = -h*min(max(x[k+1/2], -most), most);
        }
        start { x = 0.9; v = 0; }
    }
}

/// The states of a run, and the one after each step that corrections judged one by one lead to.
fn steps(solver: &dyn AnySolver, case: &Case, h: f64, steps: u64) -> Vec<(Vec<f64>, Vec<f64>)> {
    let mut states: Vec<(f64, Vec<f64>)> = Vec::new();
    solver
        .simulate(&case.run(h, steps), &mut |sample| {
            states.push((sample.t, sample.state.to_vec()));
            ControlFlow::Continue(())
        })
        .expect("a run");
    compare(solver, case, h, &states)
}

/// The same of states that are known: each step is made once more by itself.
fn compare(
    solver: &dyn AnySolver,
    case: &Case,
    h: f64,
    states: &[(f64, Vec<f64>)],
) -> Vec<(Vec<f64>, Vec<f64>)> {
    let pairs = states.windows(2);
    pairs
        .map(|pair| {
            let mut run = case.run(h, 1);
            (run.t0, run.start) = (pair[0].0, &pair[0].1);
            run.settings.tolerance = 0.0;
            let mut alone = Vec::new();
            let made = solver.simulate(&run, &mut |sample| {
                alone = sample.state.to_vec();
                ControlFlow::Continue(())
            });
            made.expect("a step");
            (pair[1].1.clone(), alone)
        })
        .collect()
}

/// Newton's tolerance, in units of the state.
fn assert_right(pairs: &[(Vec<f64>, Vec<f64>)], what: &str) {
    for (step, (found, expected)) in pairs.iter().enumerate() {
        let size = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).abs();
            assert!(off <= 2e-12 * size, "{what}, step {step}: {off:e}");
        }
    }
}

/// Size of the kick, when it comes, and a step by which it is over within a few.
const KICKS: [(f64, f64, f64); 4] = [
    (1e4, 21.5, 0.5),
    (100.0, 8.5, 0.1),
    (10.0, 9.0, 0.1),
    (1.0, 10.0, 0.3),
];

#[test]
fn a_kick_is_not_solved_as_what_was_before_it() {
    for (a, time, h) in KICKS {
        let case = Case::with_parameters(&kick::MODEL, vec![a, time]);
        let solver = solver(case.model, "increment");
        assert_right(&steps(solver, &case, h, 100), &format!("a = {a}"));
        let shown = Mutex::new(Vec::new());
        let outcome = case.fly(h, 100, &|sample| {
            let mut shown = shown.lock().expect("no panic");
            shown.push((sample.t, sample.state.to_vec()));
        });
        assert!(outcome.error.is_none(), "a = {a}");
        let states = shown.into_inner().expect("no panic");
        let pairs = compare(solver, &case, h, &states);
        assert_right(&pairs, &format!("a = {a}, in an ensemble"));
    }
}

#[test]
fn equations_with_kinks_are_told_from_others() {
    // The growth of rounding in an elimination is measured by |x|, which is no kink of theirs.
    let has_kinks = [
        kinks::<stop::Increment>(),
        kinks::<kick::Increment>(),
        kinks::<spatial_reduced::Increment>(),
    ];
    assert_eq!(has_kinks, [[true; 2], [false; 2], [false; 2]]);
}

/// Whether a system has kinks, and its core.
fn kinks<S: System<f64>>() -> [bool; 2] {
    [S::HAS_KINKS, S::Core::HAS_KINKS]
}

#[test]
fn a_kink_between_the_last_iterate_and_the_solution_is_seen() {
    // A stop that is off by so much from where the body gets to without it.
    for i in -30..30 {
        let e = 19.256_512_742_837_604 * (1.0 + 3e-10 * f64::from(i));
        let case = Case::with_parameters(&stop::MODEL, vec![e]);
        let solver = solver(case.model, "increment");
        assert_right(&steps(solver, &case, 0.018, 40), &format!("e = {e}"));
        let shown = Mutex::new(Vec::new());
        let outcome = case.fly(0.018, 40, &|sample| {
            let mut shown = shown.lock().expect("no panic");
            shown.push((sample.t, sample.state.to_vec()));
        });
        assert!(outcome.error.is_none(), "e = {e}");
        let states = shown.into_inner().expect("no panic");
        let pairs = compare(solver, &case, 0.018, &states);
        assert_right(&pairs, &format!("e = {e}, in an ensemble"));
    }
}

#[test]
fn a_limit_that_is_not_reached_changes_nothing() {
    let end = |most: f64| {
        let case = Case::with_parameters(&limited::MODEL, vec![most]);
        case.last_state(solver(case.model, "increment"), 0.1, 100)
    };
    for most in [1e9, 1e17, 1e200] {
        assert_eq!(end(most), end(1.0), "{most:e}");
    }
}

/// The energy after some bounces, of which the estimate of the error sees no more than a kink.
fn bounced<const S: usize>(tolerance: f64) -> f64 {
    let parameters = ball::Parameters::default();
    let start = ball::Model::start(&parameters);
    let run = Adaptive::<VariableGauss<ball::Model, S, f64>>::new(parameters, start, 1.2);
    let mut run = run
        .expect("a run")
        .with_tolerance(Tolerance::both(tolerance));
    run.step().expect("a step");
    let ball::State { x, v } = run.state();
    let depth = f64::max(-x, 0.0);
    v * v / 2.0 + 9.81 * x + parameters.kappa * depth * depth / 2.0
}

#[test]
fn steps_of_a_tolerance_do_not_pass_over_kinks() {
    for tolerance in [1e-5, 1e-6, 1e-7, 1e-9] {
        let energies = [
            bounced::<3>(tolerance),
            bounced::<5>(tolerance),
            bounced::<8>(tolerance),
        ];
        for energy in energies {
            assert!((energy - 9.81).abs() < 5e-3, "{tolerance:e}: {energies:?}");
        }
    }
}

#[test]
fn a_state_that_dwindles_is_solved_to_its_own_size() {
    for (q, h) in [(0.30625, 0.1), (0.8, 0.37), (0.4725, 0.01)] {
        let case = Case::with_parameters(&dwindle::MODEL, vec![q, 0.3]);
        for solver in case.model.solvers {
            let pairs = steps(*solver, &case, h, 80);
            assert_relative(&pairs, &format!("q = {q}"));
        }
        let shown = Mutex::new(Vec::new());
        case.fly(h, 80, &|sample| {
            let mut shown = shown.lock().expect("no panic");
            shown.push((sample.t, sample.state.to_vec()));
        });
        let states = shown.into_inner().expect("no panic");
        let pairs = compare(solver(case.model, "increment"), &case, h, &states);
        assert_relative(&pairs, &format!("q = {q}, in an ensemble"));
    }
}

/// Newton's tolerance, in units of each state itself.
fn assert_relative(pairs: &[(Vec<f64>, Vec<f64>)], what: &str) {
    for (step, (found, expected)) in pairs.iter().enumerate() {
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).abs();
            let shown = off / expected.abs();
            assert!(
                off <= 4e-12 * expected.abs(),
                "{what}, step {step}: {shown:e}"
            );
        }
    }
}
