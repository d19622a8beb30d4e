//! Friction, stops and relays: no step passes over a jump, and Newton's method gets from one piece to another.

use residua::erased::Catalogued;
use residua_tests::case::{Case, Tested};
use std::ops::ControlFlow;
use std::sync::Mutex;

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

/// Functions of which derivatives say that they are linear, or nothing at all.
mod collapsed {
    residua::model! {
        //! Functions with simple derivatives.
        param c = 2;
        state x: [3];
        state v: [3];
        residual {
            Δx = h*v[k+1/2];
            Δv = h*([1, 1, 1] - x[k+1/2]) - h*[
                0.3*atan2(v[k+1/2].x, c*v[k+1/2].x),
                atan(tan(2*x[k+1/2].y)),
                cos(x[k+1].z)^2 + sin(x[k+1].z)^2 + atan2(x[k+1].z, x[k+1].z)];
        }
        solve for next, increment;
        start { x = [1, 0.7, 1]; v = [0.2, 1, -1]; }
    }
}

/// A tank that is empty, where the outflow is infinitely steep.
mod tank {
    residua::model! {
        //! Filling a tank.
        param q = 1;
        state x;
        residual { Δx = h*(q - sqrt(x[k+1])); }
        solve for next, increment;
        start { x = 0; }
    }
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

fn miss_of_collapsed(p: &[f64], h: f64, _t: f64, old: &[f64], new: &[f64]) -> f64 {
    let middle = |i: usize| (old[i] + new[i]) / 2.0;
    let force = [
        0.3 * middle(3).atan2(p[0] * middle(3)),
        (2.0 * middle(1)).tan().atan(),
        1.0 + new[2].atan2(new[2]),
    ];
    let miss = |i: usize| {
        let turned = (new[i] - old[i] - h * middle(i + 3)).abs();
        turned + (new[i + 3] - old[i + 3] - h * (1.0 - middle(i) - force[i])).abs()
    };
    (0..3).map(miss).sum()
}

fn miss_of_tank(p: &[f64], h: f64, _t: f64, old: &[f64], new: &[f64]) -> f64 {
    new[0] - old[0] - h * (p[0] - new[0].sqrt())
}

#[test]
fn an_infinite_slope_is_no_convergence() {
    let mut case = Case::of_file(&tank::MODEL);
    for solver in case.model.solvers {
        let made = solver.simulate(&case.run(0.1, 10), &mut |_| ControlFlow::Continue(()));
        let message = made.expect_err("no slope").to_string();
        assert!(
            message.contains("the Jacobian became singular"),
            "{message}"
        );
    }
    assert!(case.fly(0.1, 10, &|_| {}).error.is_some());
    case.start[0] = 1e-3;
    assert!(case.fly(0.1, 10, &|_| {}).error.is_none());
}

#[test]
fn jumps_in_unknowns_are_not_passed_over() {
    let models: [(&'static Catalogued, Miss); 6] = [
        (&coulomb::MODEL, miss_of_coulomb),
        (&joint::MODEL, miss_of_joint),
        (&rubbed::MODEL, miss_of_rubbed),
        (&relay::MODEL, miss_of_relay),
        (&collapsed::MODEL, miss_of_collapsed),
        (&tank::MODEL, miss_of_tank),
    ];
    for (model, miss) in models {
        let mut case = Case::of_file(model);
        if case.start == [0.0] {
            // Not empty.
            case.start[0] = 1e-3;
        }
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
            case.fly(h, 500, &|sample| {
                let mut shown = shown.lock().expect("no panic");
                shown.push((sample.t, sample.state.to_vec()));
            });
            let mut states = shown.into_inner().expect("no panic");
            states.dedup_by(|a, b| a.0 == b.0);
            check("ensemble", &states);
        }
    }
}
