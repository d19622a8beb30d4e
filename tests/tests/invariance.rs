//! Results depend neither on the units that data are given in, nor on the frame, nor on factors of the equations.

use residua::{Catalogued, Strategy};
use residua_models::{CATALOGUE, Entry, find};
use residua_tests::case::{Case, Tested, solver};
use residua_tests::points::Points;
use residua_tools::stress::{self, Kind, in_other_frames, in_other_units};
use std::ops::ControlFlow;

const STEP: f64 = 0.01;
const STEPS: u64 = 200;

/// A run as the stress tests have it.
fn stressed(case: &Case, start: &[f64], h: f64) -> stress::Case {
    stress::Case {
        kind: Kind::Random,
        parameters: case.parameters.clone(),
        start: start.to_vec(),
        h,
    }
}

/// All data of a run in other units or frames.
type Elsewhere = fn(&Entry, &mut dyn Iterator<Item = &stress::Case>) -> Vec<stress::Case>;

/// Where each solver of `entry` ends in other units or frames, and where it should: its end at home, put into these.
fn ends(entry: &'static Entry, elsewhere: Elsewhere) -> Vec<(Vec<f64>, Vec<f64>)> {
    let model: &Catalogued = entry.catalogued;
    let home = Case::varied(model, &mut Points::new(7));
    let mut ends = Vec::new();
    for &solver in model.solvers {
        let end = home.last_state(solver, STEP, STEPS);
        let several = |start: &[f64]| -> Vec<stress::Case> {
            let case = stressed(&home, start, STEP);
            elsewhere(entry, &mut [&case, &case, &case, &case].into_iter())
        };
        for (departure, expected) in several(&home.start).into_iter().zip(several(&end)) {
            let case = Case {
                model,
                parameters: departure.parameters,
                start: departure.start,
            };
            let found = case.last_state(solver, departure.h, STEPS);
            ends.push((found, expected.start));
        }
    }
    ends
}

/// Factors of 2 round nothing. But pivots are chosen by the size of entries next to others of another unit: an elimination
/// that takes them in another order rounds otherwise, and errors grow over a motion, by less than 1e4 within 2 s of these.
#[test]
fn other_units_change_rounding_at_most() {
    let (mut identical, mut compared) = (0, 0);
    for entry in CATALOGUE {
        for (found, expected) in ends(entry, |entry, cases| in_other_units(entry, cases)) {
            assert_close(entry.name(), &found, &expected);
            identical += usize::from(found == expected);
            compared += 1;
        }
    }
    assert!(
        compared > 100 && 10 * identical > 9 * compared,
        "{identical} of {compared}"
    );
}

fn assert_close(name: &str, found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        let off = (found - expected).abs();
        assert!(
            off <= 1e4 * f64::EPSILON * expected.abs().max(1e-3),
            "{name}: {off:e} of {expected}"
        );
    }
}

/// A turned frame rounds otherwise, and errors grow over a motion: by less than 1e4 within 2 s of these.
#[test]
fn other_frames_see_the_same_motion() {
    for name in ["spatial_reduced", "spatial_recursive", "spatial_group"] {
        let entry = find(name).unwrap();
        let ends = ends(entry, |entry, cases| in_other_frames(entry, cases));
        assert_eq!(ends.len(), 4 * entry.catalogued.solvers.len());
        for (found, expected) in ends {
            assert_close(name, &found, &expected);
        }
    }
}

/// A spring pendulum.
mod plain {
    residua::model! {
        //! Spring pendulum in polar coordinates, by the midpoint rule.
        param c: 1/s^2 = 40;
        param l: m = 1;
        param g: m/s^2 = 9.81;
        state r: m;
        state θ: rad;
        state p: m/s;
        state L: m^2/s;
        residual {
            Δr - h*p[k+1/2] = 0;
            r[k+1/2]^2*Δθ - h*L[k+1/2] = 0;
            Δp - h*(L[k+1/2]^2/r[k+1/2]^3 - c*(r[k+1/2] - l) + g*cos(θ[k+1/2])) = 0;
            ΔL + h*g*r[k+1/2]*sin(θ[k+1/2]) = 0;
        }
        solve for next, increment;
        start { r = l; θ = 1.2; p = 0; L = 0; }
    }
}

/// The same with a factor before each equation.
mod scaled {
    residua::model! {
        //! Spring pendulum in polar coordinates, by the midpoint rule, with factors.
        param c: 1/s^2 = 40;
        param l: m = 1;
        param g: m/s^2 = 9.81;
        state r: m;
        state θ: rad;
        state p: m/s;
        state L: m^2/s;
        residual {
            1e9*(Δr - h*p[k+1/2]) = 0;
            1e-7*(r[k+1/2]^2*Δθ - h*L[k+1/2]) = 0;
            -3e12*(Δp - h*(L[k+1/2]^2/r[k+1/2]^3 - c*(r[k+1/2] - l) + g*cos(θ[k+1/2]))) = 0;
            1e-15*(ΔL + h*g*r[k+1/2]*sin(θ[k+1/2])) = 0;
        }
        solve for next, increment;
        start { r = l; θ = 1.2; p = 0; L = 0; }
    }
}

/// Factors round otherwise; errors grow by less than 1e4 within 2 s of this motion. Neither takes more iterations.
#[test]
fn factors_of_equations_do_not_matter() {
    let run = |model: &'static Catalogued, form: &str, strategy| {
        let case = Case::of_file(model);
        let mut run = case.unobserved(STEP, STEPS);
        run.settings.strategy = strategy;
        let mut end = Vec::new();
        let statistics = solver(model, form).simulate(&run, &mut |sample| {
            end = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        (end, statistics.expect("a run").iterations)
    };
    for form in ["next", "increment"] {
        for strategy in [Strategy::Core, Strategy::Full] {
            let (expected, iterations) = run(&plain::MODEL, form, strategy);
            let (found, scaled) = run(&scaled::MODEL, form, strategy);
            assert!(scaled.abs_diff(iterations) <= 2, "{scaled} {iterations}");
            assert_close(form, &found, &expected);
        }
    }
}
