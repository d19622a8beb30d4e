//! Steps are right although what was learned from earlier ones no longer holds.

use residua::erased::{AnySolver, Catalogued, Sample};
use residua::{
    Adaptive, Fleet, Model, Outcome, Settings, Strategy, System, Tolerance, VariableGauss,
};
use residua_models::dsl::{spatial_exponential, spatial_reduced, spatial_variational};
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

/// A rotation that nothing is solved for, by a rate that grows beyond what an angle can be known to.
mod spin {
    residua::model! {
        //! Spin-up.
        param λ = 0.6;
        state ω;
        state R: [2, 2];
        residual { Δω = h*λ*ω[k+1/2]; }
        update { R = R*exp(S(h*ω[k+1/2])); }
        solve for increment;
        start { ω = 1; R = I; }
    }
}

/// A state that is known to two digits after each step, although what is solved for has all.
mod magnified {
    residua::model! {
        //! Magnifier.
        param c = 1e14;
        state x;
        residual { Δx = h*cos(x[k+1/2]); }
        update { x = sin(c*x[k+1]); }
        solve for next, increment;
        start { x = 0.3; }
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

/// A block that rubs on the ground, sticks and slips, between two stops.
mod rubbing {
    residua::model! {
        //! Stick and slip.
        param μ = 3;
        param ε = 0.0001;
        param κ = 1000000;
        state x;
        state v;
        residual {
            Δx = h*v[k+1/2];
            Δv = h*(5*sin(3*t[k+1/2]) - 4*x[k+1/2] - μ*max(min(v[k+1/2]/ε, 1), -1)
                + κ*max(-0.2 - x[k+1/2], 0) - κ*max(x[k+1/2] - 0.2, 0));
        }
        solve for next, increment;
        start { x = 0; v = 1; }
    }
}

/// Friction by a normal force that is an unknown.
mod coulomb {
    residua::model! {
        //! Friction on a block with lift.
        param F = 5;
        state v;
        unknown N = 9.81;
        residual {
            Δv = h*(F*sin(t[k+1]) - 0.3*N*sign(v[k+1]));
            N = 9.81 + 0.2*v[k+1]^2;
        }
        solve for next, increment;
        start { v = 1; }
    }
}

/// A pendulum with dry friction in its joint: linear in both unknowns but for the jump.
mod joint {
    residua::model! {
        //! Dry joint.
        param c = 0.3;
        state θ;
        state ω;
        residual {
            Δθ = h*ω[k+1/2];
            Δω = -h*(9.81*sin(θ[k+1/2]) + c*sign(ω[k+1/2]));
        }
        solve for next, increment;
        start { θ = 1; ω = 0; }
    }
}

/// Two masses that rub on each other.
mod rubbed {
    residua::model! {
        //! Masses that rub on each other.
        param c = 0.3;
        state x: [2];
        state v: [2];
        residual {
            Δx = h*v[k+1/2];
            Δv = h*([sin(3*t[k+1/2]), 0] - 4*x[k+1/2] - c*[1, -1]*sign(v[k+1/2].x - v[k+1/2].y));
        }
        solve for next, increment;
        start { x = [0, 0]; v = [1, 0]; }
    }
}

/// Equations in order but for a jump in the first that the second decides over.
mod relay {
    residua::model! {
        //! A relay.
        param a = 2;
        state x;
        state v;
        residual {
            Δx = h*v[k+1];
            Δv = -h*a*sign(x[k+1]);
        }
        solve for next, increment;
        start { x = 1; v = 0; }
    }
}

/// A pendulum on a rod: the multiplier is known to ε/h² only, and no state follows from it.
mod rod {
    residua::model! {
        //! Pendulum with a constraint on its position.
        param g = 9.81;
        state q: [2];
        state v: [2];
        unknown λ = 0;
        residual {
            Δq = h*v[k+1];
            Δv = h*([0, -g] - λ*q);
            q[k+1].T*q[k+1] = 1;
        }
        solve for next, increment;
        start { q = [1, 0]; v = [0, 0]; }
    }
}

/// An equation that loses the digits of its terms before they get to the Jacobian, and a motion that follows from it.
mod drowned {
    residua::model! {
        //! A force among large terms that cancel.
        param c = 1;
        param a = 3;
        state x; state u;
        state y; state w;
        unknown λ = 0;
        residual {
            Δx = h*u[k+1/2];
            Δu = -4*h*x[k+1/2];
            (c + x[k+1])*a + 2*λ = c*a + x[k+1]*a + 2*sin(x[k+1]);
            Δy = h*w[k+1/2];
            Δw = h*(λ - y[k+1/2]);
        }
        solve for next, increment;
        start { x = 1; u = 0; y = 0.3; w = 0; }
    }
}

/// Springs between masses that are where they rest, by a scheme that knows the forces before.
mod chain {
    residua::model! {
        //! Chain of springs at rest.
        param κ = 1000;
        param L = 0.1;
        param stretch = 0;
        state x: [3];
        state v: [3];
        let f1 = κ*(x.y - x.x - L);
        let f2 = κ*(x.z - x.y - L);
        residual { Δv = h*[f1, f2 - f1, -f2]; }
        update { x = x + h*v[k+1]; }
        solve for next, increment;
        start { x = [0.1, 0.2, 0.3 + stretch]; v = [0, 0, 0]; }
    }
}

/// A thrust that balances the weight.
mod hover {
    residua::model! {
        //! Hovering.
        param m = 1.3;
        param thrust = 12.753;
        state z;
        state v;
        residual {
            Δz = h*v[k+1/2];
            m*Δv = h*(thrust - m*9.81 - 0.2*v[k+1/2]);
        }
        solve for next, increment;
        start { z = 0; v = 0; }
    }
}

/// A control that has reached its aim.
mod thermostat {
    residua::model! {
        //! Temperature under control.
        param aim = 20.1;
        state i;
        state T;
        residual {
            Δi = h*0.3*(aim + 273.15 - T[k+1/2]);
            ΔT = h*(2*(aim + 273.15 - T[k+1/2]) + i[k+1/2]);
        }
        solve for next, increment;
        start { i = 0; T = 293.25; }
    }
}

/// An ensemble of one, which is shown after each step.
fn fly(case: &Case, h: f64, steps: u64, observer: &(dyn Fn(Sample) + Sync)) -> Outcome {
    let fleet = Fleet {
        trajectories: 0..1,
        fill: &|_, parameters, start| {
            parameters.copy_from_slice(&case.parameters);
            start.copy_from_slice(&case.start);
        },
        h,
        t0: 0.0,
        steps,
        every: 1,
        settings: Settings::default(),
        observer: &|_, sample| observer(sample),
    };
    let outcomes = solver(case.model, "increment").fly(&fleet).expect("a run");
    outcomes[0]
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
        let outcome = fly(&case, h, 100, &|sample| {
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
        kinks::<rod::Increment>(),
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
        let outcome = fly(&case, 0.018, 40, &|sample| {
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
fn a_multiplier_that_is_not_known_to_all_digits_stops_no_run() {
    let case = Case::of_file(&rod::MODEL);
    for solver in case.model.solvers {
        for h in [0.01, 0.003, 0.001] {
            let steps = (4.0 / h) as u64;
            let mut length = 1.0_f64;
            let made = solver.simulate(&case.run(h, steps), &mut |sample| {
                length = sample.state[0].hypot(sample.state[1]);
                assert!((length - 1.0).abs() <= 4.0 * f64::EPSILON, "{length}");
                ControlFlow::Continue(())
            });
            let statistics = made.unwrap_or_else(|error| panic!("h = {h}: {error}"));
            assert_eq!(statistics.steps, steps);
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
        fly(&case, h, 80, &|sample| {
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

#[test]
fn a_rotation_that_cannot_be_known_is_refused() {
    let model: &'static Catalogued = &spin::MODEL;
    let case = Case::of_file(model);
    let mut last = 0.0;
    let outcome = solver(model, "increment").simulate(&case.run(0.1, 700), &mut |sample| {
        last = sample.state[0];
        ControlFlow::Continue(())
    });
    let message = outcome
        .expect_err("no angle is known to 1e-10 beyond 1e6")
        .to_string();
    assert!(
        message.contains("state R(1,1) at the end of the step is not known"),
        "{message}"
    );
    // It is looked at whenever the rate has grown 4 times.
    assert!(last < 4.1e7, "{last:e}");
    let shown = Mutex::new(0.0);
    let outcome = fly(&case, 0.1, 700, &|sample| {
        *shown.lock().expect("no panic") = sample.state[0];
    });
    assert!(outcome.error.is_some(), "in an ensemble");
    let last = shown.into_inner().expect("no panic");
    assert!((1e6..4.1e7).contains(&last), "{last:e} in an ensemble");
}

#[test]
fn a_state_that_its_update_magnifies_is_refused() {
    let case = Case::of_file(&magnified::MODEL);
    for solver in case.model.solvers {
        let outcome = solver.simulate(&case.run(0.1, 10), &mut |_| ControlFlow::Continue(()));
        let message = outcome.expect_err("two digits are left").to_string();
        let expected = "state x at the end of the step is not known";
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn terms_that_cancel_to_rounding_are_refused() {
    let mut expected = None;
    for exponent in 0..20 {
        let c = 10_f64.powi(exponent);
        let case = Case::with_parameters(&drowned::MODEL, vec![c, 3.0]);
        for solver in case.model.solvers {
            for strategy in [Strategy::Core, Strategy::Full] {
                let mut run = case.run(0.01, 200);
                run.settings.strategy = strategy;
                let mut last = Vec::new();
                let made = solver.simulate(&run, &mut |sample| {
                    last = sample.state.to_vec();
                    ControlFlow::Continue(())
                });
                match made {
                    Ok(_) => {
                        let off = last[2] - *expected.get_or_insert(last[2]);
                        assert!(off.abs() < 1e-6, "c = {c:e}: {off:e}");
                        assert!(exponent < 8, "c = {c:e}");
                    }
                    Err(error) => {
                        let message = error.to_string();
                        let expected =
                            "rounding of the terms of equation 3, `(c + x[k+1])*a + 2*λ = ";
                        assert!(message.contains(expected), "c = {c:e}: {message}");
                        assert!(exponent > 3, "c = {c:e}");
                    }
                }
            }
        }
        let outcome = fly(&case, 0.01, 200, &|_| {});
        match exponent {
            ..4 => assert!(outcome.error.is_none(), "c = {c:e}"),
            8.. => assert!(outcome.error.is_some(), "c = {c:e}"),
            _ => {}
        }
    }
}

#[test]
fn rest_is_no_lack_of_digits() {
    let stretched = Case::with_parameters(&chain::MODEL, vec![1000.0, 0.1, 0.01]);
    let cases = [
        Case::of_file(&chain::MODEL),
        stretched,
        Case::of_file(&hover::MODEL),
        Case::with_parameters(&hover::MODEL, vec![2.0, 19.62]),
        Case::of_file(&thermostat::MODEL),
        hanging(&spatial_variational::MODEL),
        hanging(&spatial_exponential::MODEL),
        hanging(&spatial_reduced::MODEL),
    ];
    for case in &cases {
        let name = case.model.description.name;
        for solver in case.model.solvers {
            let form = solver.solver().form;
            for strategy in [Strategy::Core, Strategy::Full] {
                let mut run = case.run(0.01, 300);
                run.settings.strategy = strategy;
                let made = solver.simulate(&run, &mut |_| ControlFlow::Continue(()));
                made.unwrap_or_else(|error| panic!("{name}, {form}, {strategy:?}: {error}"));
            }
        }
        let outcome = fly(case, 0.01, 300, &|_| {});
        assert!(outcome.error.is_none(), "{name}: {:?}", outcome.error);
    }
}

/// A 3D pendulum of this model at rest below its pivot, its centre on no axis.
fn hanging(model: &'static Catalogued) -> Case {
    let mut case = Case::of_file(model);
    let mut set = |name: &str, values: &[f64]| {
        let mut at = 0;
        for variable in model.description.parameters {
            let own = at..at + variable.rows * variable.cols;
            at = own.end;
            if variable.name == name {
                case.parameters[own].copy_from_slice(values);
            }
        }
    };
    set("ρ", &[0.2, 0.3, 0.6]);
    set("J", &[6.0, 0.0, 0.0, 0.0, 6.0, 0.0, 0.0, 0.0, 6.0]);
    let down = [0.2 / 0.7, 0.3 / 0.7, 0.6 / 0.7];
    case.start.fill(0.0);
    if case.start.len() == 6 {
        case.start[3..].copy_from_slice(&down);
        return case;
    }
    // R with that for its third row, the others by cross products.
    let [a, b, c] = down;
    let size = a.hypot(b);
    let first = [b / size, -a / size, 0.0];
    let second = [a * c / size, b * c / size, -size];
    let rows = [first, second, down].concat();
    let n = case.start.len();
    case.start[n - 9..].copy_from_slice(&rows);
    case
}

#[test]
fn stick_and_slip_between_stops_go_on() {
    for friction in [0.3, 3.0, 4.9] {
        for width in [1e-5, 1e-3] {
            let case = Case::with_parameters(&rubbing::MODEL, vec![friction, width, 1e6]);
            for solver in case.model.solvers {
                for h in [0.003, 0.02] {
                    let mut before: Option<(f64, [f64; 2])> = None;
                    let made = solver.simulate(&case.run(h, 1000), &mut |sample| {
                        let [x, v] = [sample.state[0], sample.state[1]];
                        if let Some((t, old)) = before {
                            let off = rubbed(&case.parameters, h, t, old, [x, v]);
                            assert!(off < 1e-9, "{friction} {width:e} {h}: {off:e} at {t}");
                        }
                        before = Some((sample.t, [x, v]));
                        ControlFlow::Continue(())
                    });
                    let statistics =
                        made.unwrap_or_else(|error| panic!("{friction} {width:e} {h}: {error}"));
                    assert_eq!(statistics.steps, 1000);
                }
            }
        }
    }
}

/// How far `new` is from where the step from `old` ends, found by bisection: the sum of forces falls with the speed.
fn rubbed(parameters: &[f64], h: f64, t: f64, old: [f64; 2], new: [f64; 2]) -> f64 {
    let &[friction, width, stiffness] = parameters else {
        panic!("three parameters")
    };
    // By the speed in the middle of the step.
    let excess = |v: f64| {
        let x = old[0] + h * v / 2.0;
        let stops = stiffness * ((-0.2 - x).max(0.0) - (x - 0.2).max(0.0));
        let push = 5.0 * (3.0 * (t + h / 2.0)).sin() - 4.0 * x;
        2.0 * (v - old[1]) - h * (push - friction * (v / width).clamp(-1.0, 1.0) + stops)
    };
    let (mut low, mut high) = (-1e3, 1e3);
    while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let v = 2.0 * high - old[1];
    let size = f64::max(old[1].abs(), new[1].abs()).max(1e-3);
    (new[1] - v).abs() / size
}

/// By how much a step misses the equations of a model with jumps.
type Miss = fn(&[f64], f64, f64, &[f64], &[f64]) -> f64;

/// −1, 0 or 1
fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

fn miss_of_coulomb(p: &[f64], h: f64, t: f64, old: &[f64], new: &[f64]) -> f64 {
    let normal = 9.81 + 0.2 * new[0] * new[0];
    new[0] - old[0] - h * (p[0] * (t + h).sin() - 0.3 * normal * sign(new[0]))
}

fn miss_of_joint(p: &[f64], h: f64, _t: f64, old: &[f64], new: &[f64]) -> f64 {
    let [angle, rate] = [0, 1].map(|i| (old[i] + new[i]) / 2.0);
    let turned = new[0] - old[0] - h * rate;
    turned.abs() + (new[1] - old[1] + h * (9.81 * angle.sin() + p[0] * sign(rate))).abs()
}

fn miss_of_rubbed(p: &[f64], h: f64, t: f64, old: &[f64], new: &[f64]) -> f64 {
    let [x, y, v, w] = [0, 1, 2, 3].map(|i| (old[i] + new[i]) / 2.0);
    let rubbing = p[0] * sign(v - w);
    let force = [
        (3.0 * (t + h / 2.0)).sin() - 4.0 * x - rubbing,
        rubbing - 4.0 * y,
    ];
    let rates = [v, w, force[0], force[1]];
    (0..4).map(|i| (new[i] - old[i] - h * rates[i]).abs()).sum()
}

fn miss_of_relay(p: &[f64], h: f64, _t: f64, old: &[f64], new: &[f64]) -> f64 {
    (new[0] - old[0] - h * new[1]).abs() + (new[1] - old[1] + h * p[0] * sign(new[0])).abs()
}

#[test]
fn jumps_in_unknowns_are_not_passed_over() {
    let models: [(&'static Catalogued, Miss); 4] = [
        (&coulomb::MODEL, miss_of_coulomb),
        (&joint::MODEL, miss_of_joint),
        (&rubbed::MODEL, miss_of_rubbed),
        (&relay::MODEL, miss_of_relay),
    ];
    for (model, miss) in models {
        let case = Case::of_file(model);
        for h in [0.1, 0.01] {
            let check = |what: &str, states: &[(f64, Vec<f64>)]| {
                let name = model.description.name;
                for pair in states.windows(2) {
                    let off = miss(&case.parameters, h, pair[0].0, &pair[0].1, &pair[1].1);
                    assert!(
                        off.abs() < 1e-11,
                        "{name}, {what}, {h}: {off:e} at {}",
                        pair[0].0
                    );
                }
                states.len() - 1
            };
            for solver in model.solvers {
                let mut states = Vec::new();
                // Where friction holds a body there is no solution.
                let _ = solver.simulate(&case.run(h, 500), &mut |sample| {
                    states.push((sample.t, sample.state.to_vec()));
                    ControlFlow::Continue(())
                });
                let form = solver.solver().form;
                let taken = check(form, &states);
                assert!(
                    taken >= 5,
                    "{}, {form}, {h}: {taken} steps",
                    model.description.name
                );
            }
            let shown = Mutex::new(vec![(0.0, case.start.clone())]);
            fly(&case, h, 500, &|sample| {
                let mut shown = shown.lock().expect("no panic");
                shown.push((sample.t, sample.state.to_vec()));
            });
            let mut states = shown.into_inner().expect("no panic");
            states.dedup_by(|a, b| a.0 == b.0);
            check("ensemble", &states);
        }
    }
}
