//! What elimination leaves, and what happens where it cannot be trusted.

use residua::Failure;
use residua::Stepper;
use residua::System;

/// z enters the first equation linearly and is eliminated, but where y = 1 the divisor y − 1 vanishes although
/// the equations are regular there: y stays 1 and z obeys the second.
mod vanishing_divisor {
    use residua::model;
    model! {
        state y;
        state z;
        residual {
            (y[k+1] - 1)*z[k+1] + exp(y[k+1]) - exp(1) = 0;
            z[k+1] + sin(z[k+1]) = z + sin(y[k+1]);
        }
        solve for next;
        start { y = 1; z = 0.5; }
    }
}

/// Everything is linear: nothing is left to iterate on.
mod linear {
    use residua::model;
    model! {
        param a = 0.5;
        state x;
        state y;
        residual {
            Δx = h*y[k+1/2];
            Δy = -h*(x[k+1/2] + a*y[k+1/2]);
        }
        solve for next, increment;
        start { x = 1; y = 0; }
    }
}

/// No root exists, whatever is eliminated.
mod rootless {
    use residua::model;
    model! {
        state x;
        state y;
        residual {
            Δx = h*y[k+1];
            y[k+1]^2 + 1 + (x[k+1] - h*y[k+1] - x) = 0;
        }
        solve for next;
        start { x = 1; y = 0.3; }
    }
}

/// Four unknowns, none of them linear, in all equations: pivots are chosen where A is that of the file.
mod pivots {
    use residua::model;
    model! {
        param A: [4, 4] = [[4, 1, 1, 1], [1, 4, 1, 1], [1, 1, 4, 1], [1, 1, 1, 4]];
        state x: [4];
        let cubes = [x(1)^3, x(2)^3, x(3)^3, x(4)^3];
        let y = x[k+1];
        let next_cubes = [y(1)^3, y(2)^3, y(3)^3, y(4)^3];
        residual { A*(y + next_cubes - x - cubes) + h*x[k+1/2] = 0; }
        solve for next;
        start { x = [1, 0.9, 0.8, 0.7]; }
    }
}

fn start<M: residua::Model<f64>>() -> (M::Parameters, M::State) {
    let parameters = M::Parameters::default();
    (parameters, M::start(&parameters))
}

#[test]
fn a_vanishing_divisor_falls_back_to_all_unknowns() {
    use vanishing_divisor::{Model, Next, NextCore, State};
    const { assert!(<Next as System<f64>>::HAS_CORE) };
    let (parameters, start) = start::<Model>();
    let mut stepper = Stepper::<Next>::new(parameters, start, 0.1).unwrap();
    for _ in 0..5 {
        let before: State = stepper.state();
        stepper.step().unwrap();
        let State { y, z, .. } = stepper.state();
        assert!((y - 1.0).abs() < 1e-12, "{y}");
        assert!((z + z.sin() - before.z - y.sin()).abs() < 1e-12, "{z}");
    }
    assert_eq!(stepper.statistics().fallbacks, 5);
    // Beside the divisor's zero, terms of size 2 leave 1e-9: rounding grows two thousand million times.
    let scene = <NextCore as System<f64>>::scene(&parameters, 0.1);
    let step = <NextCore as System<f64>>::step(&scene, 0.0, &[1.0, 0.5]);
    let growth = <NextCore as System<f64>>::growth(&scene, &step, &[1.0 + 1e-9]);
    assert!((1e9..1e10).contains(&growth), "{growth:e}");
}

#[test]
fn a_linear_model_has_nothing_to_iterate_on() {
    use linear::{Increment, IncrementCore, Model, Next};
    let none: <IncrementCore as System<f64>>::Unknowns = [];
    assert_eq!(none, []);
    let (parameters, start) = start::<Model>();
    let mut next = Stepper::<Next>::new(parameters, start, 0.1).unwrap();
    let mut increment = Stepper::<Increment>::new(parameters, start, 0.1).unwrap();
    // x⁺ = (I − h A/2)⁻¹ (I + h A/2) x with A = [[0, 1], [−1, −a]].
    let (h, a) = (0.1, 0.5);
    let (p, q) = (1.0 + h * a / 2.0, h / 2.0);
    let determinant = p + q * q;
    let (mut x, mut y) = (1.0, 0.0);
    for _ in 0..100 {
        let (b, c) = (x + q * y, y - q * (x + a * y));
        (x, y) = ((p * b + q * c) / determinant, (c - q * b) / determinant);
        next.step().unwrap();
        increment.step().unwrap();
    }
    for state in [next.state_array(), increment.state_array()] {
        assert!((state[0] - x).abs() < 1e-14 && (state[1] - y).abs() < 1e-14);
    }
    assert_eq!(next.statistics().fallbacks, 0);
}

#[test]
fn a_failure_is_that_of_all_unknowns() {
    use rootless::{Model, Next};
    let (parameters, start) = start::<Model>();
    let mut stepper = Stepper::<Next>::new(parameters, start, 0.1).unwrap();
    let error = stepper.step().unwrap_err();
    assert_ne!(error.fault.failure, Failure::NotFinite);
    assert!(error.to_string().contains("(line "), "{error}");
    assert_eq!(stepper.statistics().fallbacks, 1);
    assert_eq!(stepper.state(), start);
}

/// Unknowns of the core, as the blocks of the core say.
fn core_size<S: System<f64>>() -> usize {
    <S::Core as System<f64>>::UNKNOWNS
        .iter()
        .map(|u| u.len)
        .sum()
}

#[test]
fn cores_are_as_small_as_they_can_be() {
    use residua_models::dsl;
    assert_eq!(core_size::<dsl::planar_angle::Next>(), 1);
    assert_eq!(core_size::<dsl::planar_reduced::Increment>(), 1);
    assert_eq!(core_size::<dsl::planar_group::Next>(), 1);
    assert_eq!(core_size::<dsl::planar_recursive::Increment>(), 1);
    assert_eq!(core_size::<dsl::spatial_reduced::Next>(), 3);
    assert_eq!(core_size::<dsl::spatial_recursive::Increment>(), 3);
    assert_eq!(core_size::<dsl::spatial_group::Increment>(), 3);
    assert_eq!(core_size::<dsl::elastic::Increment>(), 2);
    assert_eq!(core_size::<dsl::double_planar::Increment>(), 2);
}

/// With an A that has no diagonal, the pivots chosen at build time are h/2 beside entries of 10⁸: every correction says
/// so and is not used.
#[test]
fn a_small_pivot_is_not_divided_by() {
    use pivots::{Model, Next};
    const { assert!(<Next as System<f64>>::HAS_CORRECTION) };
    let (mut parameters, start) = start::<Model>();
    let growth = |parameters| {
        let scene = <Next as System<f64>>::scene(&parameters, 0.1);
        let step = <Next as System<f64>>::step(&scene, 0.0, &start.x);
        <Next as System<f64>>::correction(&scene, &step, &start.x).1
    };
    assert!(growth(parameters) < 100.0);
    parameters.A = [
        [0.0, 1e8, 0.0, 0.0],
        [1e8, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1e8],
        [0.0, 0.0, 1e8, 0.0],
    ];
    let found = growth(parameters);
    assert!(found.is_nan() || found > 1e6, "{found:e}");

    let mut stepper = Stepper::<Next>::new(parameters, start, 0.1).unwrap();
    for _ in 0..200 {
        let before = stepper.state().x;
        stepper.step().unwrap();
        let now = stepper.state().x;
        // Row i of this A picks the other component of the pair.
        for (i, j) in [(0, 1), (1, 0), (2, 3), (3, 2)] {
            let grown = now[j] + now[j].powi(3) - before[j] - before[j].powi(3);
            let r = grown + 0.05e-8 * (now[i] + before[i]);
            assert!(r.abs() < 1e-14, "{r:e}");
        }
    }
}
