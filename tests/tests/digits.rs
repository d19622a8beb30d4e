//! What has too few digits is refused, and what rests or balances is not.

use residua::Strategy;
use residua::erased::Catalogued;
use residua_models::dsl::{spatial_exponential, spatial_reduced, spatial_variational};
use residua_tests::case::{Case, Tested, solver};
use std::ops::ControlFlow;
use std::sync::Mutex;

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
    let outcome = case.fly(0.1, 700, &|sample| {
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
        let outcome = case.fly(0.01, 200, &|_| {});
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
        let outcome = case.fly(0.01, 300, &|_| {});
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
