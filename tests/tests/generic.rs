//! What holds for every model in the catalogue, whatever it is: a new file is tested without a line here.

use nalgebra::{DMatrix, DVector};
use residua::Strategy;
use residua::erased::{AnySolver, Catalogued, Scheme};
use residua_models::CATALOGUE;
use residua_models::values::total;
use residua_tests::case::Case;
use residua_tests::case::Tested;
use residua_tests::points::Points;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Random points per solver.
const POINTS: usize = 50;

/// Calls `check` with every solver of every model.
fn for_every_solver(check: impl Fn(&'static Catalogued, &'static dyn AnySolver, &str)) {
    assert!(!CATALOGUE.is_empty());
    for entry in CATALOGUE {
        for solver in entry.catalogued.solvers {
            let what = format!("{} ({})", entry.name(), solver.solver().form);
            check(entry.catalogued, *solver, &what);
        }
    }
}

fn unknowns(solver: &dyn AnySolver) -> usize {
    solver.solver().unknowns.iter().map(|u| u.len).sum()
}

/// A state, a step and unknowns near those of a real step, but on no constraint and no solution.
fn anywhere(case: &Case, solver: &dyn AnySolver, points: &mut Points) -> (f64, Vec<f64>, Vec<f64>) {
    let h = 0.05 + 0.02 * points.numbers(1)[0];
    let scatter = |values: &mut [f64], points: &mut Points| {
        let by = points.numbers(values.len());
        values.iter_mut().zip(by).for_each(|(v, by)| *v += 0.2 * by);
    };
    let mut state = case.start.clone();
    scatter(&mut state, points);
    let mut x = vec![0.0; unknowns(solver)];
    solver.guess(&case.at(h, &state), &mut x);
    scatter(&mut x, points);
    (h, state, x)
}

/// |a − b| ≤ tolerance · the largest entry of the row, at every entry.
fn assert_rows_close(what: &str, n: usize, a: &[f64], b: &[f64], tolerance: f64) {
    for (i, (a, b)) in a.chunks(n).zip(b.chunks(n)).enumerate() {
        let scale = a.iter().chain(b).fold(0.0_f64, |s, v| s.max(v.abs()));
        for (k, (a, b)) in a.iter().zip(b).enumerate() {
            let difference = (a - b).abs();
            assert!(
                difference <= tolerance * scale,
                "{what}: entry ({i}, {k}) is {a}, expected {b}"
            );
        }
    }
}

/// Both are exact up to rounding. Terms larger than their sum by up to some hundreds leave 1e-12 of a row.
#[test]
fn jacobian_agrees_with_dual_numbers() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(1);
        for _ in 0..POINTS {
            let case = Case::varied(model, &mut points);
            let (h, state, x) = anywhere(&case, solver, &mut points);
            let n = x.len();
            let (mut j, mut dual) = (vec![0.0; n * n], vec![0.0; n * n]);
            solver.jacobian(&case.at(h, &state), &x, &mut j);
            solver.dual_jacobian(&case.at(h, &state), &x, &mut dual);
            assert_rows_close(what, n, &j, &dual, 1e-12);
        }
    });
}

/// Central differences with a step of ∛ε leave an error of about ε^(2/3) = 4e-11 in a function of order one;
/// third derivatives and row scales take two to three digits of that.
#[test]
fn jacobian_agrees_with_central_differences() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(2);
        for _ in 0..POINTS {
            let case = Case::varied(model, &mut points);
            let (h, state, x) = anywhere(&case, solver, &mut points);
            let n = x.len();
            let (mut j, mut differences) = (vec![0.0; n * n], vec![0.0; n * n]);
            solver.jacobian(&case.at(h, &state), &x, &mut j);
            for column in 0..n {
                let step = f64::EPSILON.cbrt() * x[column].abs().max(1.0);
                let residual_at = |value: f64| {
                    let (mut moved, mut r) = (x.clone(), vec![0.0; n]);
                    moved[column] = value;
                    solver.residual(&case.at(h, &state), &moved, &mut r);
                    r
                };
                let (above, below) = (x[column] + step, x[column] - step);
                let (up, down) = (residual_at(above), residual_at(below));
                for row in 0..n {
                    differences[row * n + column] = (up[row] - down[row]) / (above - below);
                }
            }
            assert_rows_close(what, n, &j, &differences, 1e-7);
        }
    });
}

/// Newton's method in its plainest form, to the rounding floor.
fn solve(case: &Case, solver: &dyn AnySolver, h: f64) -> Vec<f64> {
    let n = unknowns(solver);
    let at = case.at(h, &case.start);
    let (mut x, mut r, mut j) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n]);
    solver.guess(&at, &mut x);
    for _ in 0..12 {
        solver.residual(&at, &x, &mut r);
        solver.jacobian(&at, &x, &mut j);
        let lu = DMatrix::from_row_slice(n, n, &j).lu();
        let correction = lu.solve(&DVector::from_column_slice(&r)).expect("regular");
        x.iter_mut().zip(&correction).for_each(|(x, d)| *x -= d);
    }
    x
}

/// The stepper ends where plain Newton ends, and there the residual is rounding: ε of what each unknown
/// contributes to it, a hundred times over for the operations and for constants that cancel.
#[test]
fn residual_vanishes_at_the_accepted_step() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(3);
        for _ in 0..POINTS {
            let case = Case::varied(model, &mut points).kicked(&mut points);
            let h = 0.01;
            let x = solve(&case, solver, h);
            let (n, at) = (x.len(), case.at(h, &case.start));
            let (mut r, mut j) = (vec![0.0; n], vec![0.0; n * n]);
            solver.residual(&at, &x, &mut r);
            solver.jacobian(&at, &x, &mut j);
            let largest = |values: &[f64]| values.iter().fold(1.0_f64, |s, v| s.max(v.abs()));
            let size = largest(&x).max(largest(&case.start));
            for (i, r) in r.iter().enumerate() {
                let row: f64 = j[i * n..(i + 1) * n].iter().map(|v| v.abs()).sum();
                let bound = 100.0 * f64::EPSILON * row * size;
                assert!(r.abs() <= bound, "{what}: r[{i}] = {r:e} > {bound:e}");
            }
            let mut expected = vec![0.0; case.start.len()];
            solver.next(&at, &x, &mut expected);
            let stepped = case.last_state(solver, h, 1);
            let close = distance(&stepped, &expected);
            assert!(close <= 1e-12, "{what}: {close:e} from plain Newton");
        }
    });
}

/// Every step of a run, whatever its starting value and however few corrections it took, ends where plain Newton
/// ends from the same state: Newton's tolerance is 1e-12 of unknowns of up to ten, and the condition of a step (angles
/// near the edge of their chart) costs another digit.
#[test]
fn no_step_is_left_unconverged() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(9);
        for h in [0.002, 0.005, 0.01] {
            let varied = Case::varied(model, &mut points).kicked(&mut points);
            for mut case in [Case::of_file(model), varied] {
                let states = case.states(solver, h, 300);
                for (k, pair) in states.windows(2).enumerate() {
                    case.start.clone_from(&pair[0]);
                    let x = solve(&case, solver, h);
                    let mut expected = vec![0.0; case.start.len()];
                    solver.next(&case.at(h, &case.start), &x, &mut expected);
                    let off = distance(&pair[1], &expected);
                    assert!(off <= 1e-10, "{what}, h = {h}: step {k} is {off:e} off");
                }
            }
        }
    });
}

/// Largest difference, relative where values are above one. Not a number counts as infinite.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let relative = |(a, b): (&f64, &f64)| (a - b).abs() / b.abs().max(1.0);
    let worst = |s: f64, d: f64| if d.is_nan() { f64::INFINITY } else { s.max(d) };
    a.iter().zip(b).map(relative).fold(0.0, worst)
}

/// How far a run ends from its start that goes as many steps back as forth.
fn way_back(case: &Case, solver: &dyn AnySolver, steps: u64) -> f64 {
    let mut turned = case.clone();
    turned.start = case.last_state(solver, 0.01, steps);
    distance(&turned.last_state(solver, -0.01, steps), &case.start)
}

/// Equations that are the same with h < 0 and the ends of the step exchanged lead back to the start: where one step does, so do a
/// hundred, to rounding that the motion stretches by less than a thousand.
#[test]
fn symmetric_equations_find_the_way_back() {
    let symmetric = AtomicUsize::new(0);
    for_every_solver(|model, solver, what| {
        let case = Case::varied(model, &mut Points::new(12)).kicked(&mut Points::new(13));
        if way_back(&case, solver, 1) < 1e-12 {
            symmetric.fetch_add(1, Ordering::Relaxed);
            let off = way_back(&case, solver, 100);
            assert!(off < 1e-10, "{what}: {off:e}");
        }
    });
    assert!(symmetric.load(Ordering::Relaxed) >= 12, "{symmetric:?}");
}

/// The largest departure of each invariant from its start over half a second.
fn drifts(case: &Case, solver: &dyn AnySolver, steps: u64) -> Vec<f64> {
    let h = 0.5 / steps as f64;
    let start = case.outputs(h, 0.0, &case.start);
    let mut drifts = vec![0.0; start.len()];
    for state in case.states(solver, h, steps) {
        let outputs = case.outputs(h, 0.0, &state);
        for (k, drift) in drifts.iter_mut().enumerate() {
            *drift = f64::max(*drift, distance(&outputs[k..=k], &start[k..=k]));
        }
    }
    drifts
}

/// Rounding that a few hundred steps leave in an invariant, relative to its value or to one.
const EXACT: f64 = 1e-11;

/// The models that come with the project are of second order; one of first order is welcome beside them.
const SECOND_ORDER: [&str; 16] = [
    "double_planar",
    "elastic",
    "planar_algebra",
    "planar_angle",
    "planar_cayley",
    "planar_group",
    "planar_recursive",
    "planar_reduced",
    "spatial_cardan",
    "spatial_cardan_zyx",
    "spatial_exponential",
    "spatial_group",
    "spatial_recursive",
    "spatial_reduced",
    "spatial_variational",
    "spherical",
];

/// What halving the step divides an error by at least: 2ᵖ, less a tenth where the steps are not yet small.
fn least_ratio(model: &Catalogued) -> f64 {
    let is_second = SECOND_ORDER.contains(&model.description.name);
    if is_second { 3.7 } else { 1.8 }
}

/// Every invariant is kept to rounding, or its error falls with the order of the model: halving the step
/// divides it by 2ᵖ, or by a quarter less where the steps are not yet small.
#[test]
fn invariants_are_exact_or_fall_with_the_step() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(4);
        let case = Case::varied(model, &mut points).kicked(&mut points);
        let (coarse, fine) = (drifts(&case, solver, 200), drifts(&case, solver, 400));
        let mut k = 0;
        for output in model.description.outputs {
            for _ in 0..output.variable.rows * output.variable.cols {
                let ok = coarse[k] <= EXACT
                    || fine[k] <= EXACT
                    || coarse[k] / fine[k] >= 0.8 * least_ratio(model);
                let name = output.variable.name;
                assert!(
                    ok || !output.invariant,
                    "{what}: {name} drifts by {:e}, by {:e} with half the step",
                    coarse[k],
                    fine[k]
                );
                k += 1;
            }
        }
    });
}

/// The change of the state after half a second when the step is halved, and halved again, falls by 2ᵖ each
/// time; a method of higher order falls faster.
#[test]
fn steps_converge() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(5);
        let case = Case::varied(model, &mut points).kicked(&mut points);
        let after = |steps: u64| case.last_state(solver, 0.5 / steps as f64, steps);
        let (coarse, medium, fine) = (after(200), after(400), after(800));
        let ratio = distance(&coarse, &medium) / distance(&medium, &fine);
        assert!(ratio >= least_ratio(model), "{what}: {ratio}");
    });
}

/// The discrete equations approximate the continuous ones of the same file.
#[test]
fn steps_converge_to_the_flow() {
    for_every_solver(|model, solver, what| {
        let Some(flow) = model.flow else { return };
        let mut points = Points::new(6);
        let case = Case::varied(model, &mut points).kicked(&mut points);
        let mut truth = Vec::new();
        flow.simulate(
            Scheme::RungeKutta4,
            &case.unobserved(0.5 / 4000.0, 4000),
            &mut |sample| {
                truth = sample.state.to_vec();
                ControlFlow::Continue(())
            },
        )
        .unwrap_or_else(|error| panic!("{what}: {error}"));
        let error = |steps: u64| {
            let last = case.last_state(solver, 0.5 / steps as f64, steps);
            distance(&last, &truth)
        };
        let (coarse, fine) = (error(200), error(400));
        assert!(
            coarse < 0.1 && coarse / fine >= least_ratio(model),
            "{what}: {coarse:e}, {fine:e}"
        );
    });
}

/// Iterating on the core takes the same steps as iterating on all unknowns, and is never given up: over 500 steps
/// of a varied model, what differs is Newton's tolerance times how fast neighbouring motions part.
#[test]
fn the_core_takes_the_steps_of_all_unknowns() {
    for_every_solver(|model, solver, what| {
        let mut points = Points::new(8);
        for _ in 0..3 {
            let case = Case::varied(model, &mut points).kicked(&mut points);
            let mut ends = [Vec::new(), Vec::new()];
            for (strategy, end) in [Strategy::Core, Strategy::Full].into_iter().zip(&mut ends) {
                let mut run = case.unobserved(0.0025, 500);
                run.settings.strategy = strategy;
                let outcome = solver.simulate(&run, &mut |sample| {
                    *end = sample.state.to_vec();
                    ControlFlow::Continue(())
                });
                let statistics = outcome.unwrap_or_else(|error| panic!("{what}: {error}"));
                assert_eq!(statistics.fallbacks, 0, "{what}, {strategy:?}");
            }
            let difference = distance(&ends[0], &ends[1]);
            assert!(difference <= 1e-9, "{what}: {difference:e}");
        }
    });
}

/// Two forms of one text step alike.
#[test]
fn forms_give_one_trajectory() {
    for entry in CATALOGUE {
        let mut points = Points::new(7);
        let case = Case::varied(entry.catalogued, &mut points).kicked(&mut points);
        let ends = entry.catalogued.solvers.iter();
        let ends: Vec<_> = ends.map(|s| case.last_state(*s, 0.005, 100)).collect();
        for end in &ends {
            let difference = distance(end, &ends[0]);
            assert!(difference <= 1e-11, "{}: {difference:e}", entry.name());
        }
    }
}

/// Start values are numbers, and where a model names a Gram matrix or a norm, it starts at I or 1.
#[test]
fn start_values_honour_constraints() {
    for entry in CATALOGUE {
        let description = entry.catalogued.description;
        let case = Case::of_file(entry.catalogued);
        assert!(case.start.iter().all(|v| v.is_finite()), "{}", entry.name());
        let outputs = case.outputs(0.01, 0.0, &case.start);
        assert!(outputs.iter().all(|v| v.is_finite()), "{}", entry.name());
        let mut k = 0;
        for output in description.outputs {
            let n = total(std::slice::from_ref(&output.variable));
            let is_constraint = ["gram", "norm_squared"].contains(&output.variable.name);
            for value in outputs[k..k + n].iter().filter(|_| is_constraint) {
                let off = value.abs().min((value - 1.0).abs());
                assert!(
                    off <= 8.0 * f64::EPSILON,
                    "{}: {} starts at {value}",
                    entry.name(),
                    output.variable.name
                );
            }
            k += n;
        }
    }
}
