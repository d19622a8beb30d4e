//! What every scheme does on every model that has a `flow`: nothing here names a model but where its motion is special.

use residua::Tolerance;
use residua::erased::AnyFlow;
use residua::erased::Scheme;
use residua_models::CATALOGUE;
use residua_tests::case::Case;
use residua_tests::points::Points;
use std::ops::ControlFlow;

/// All models with a flow, with varied parameters and large motions.
fn cases(seed: u64) -> Vec<(&'static str, Case, &'static dyn AnyFlow)> {
    let mut points = Points::new(seed);
    let entries = CATALOGUE.iter();
    let cases = entries.filter_map(|entry| {
        let flow = entry.catalogued.flow?;
        // Scenes rely on zeros that a varied start does not have.
        let case = match entry.catalogued.description.scene {
            Some(_) => Case::of_file(entry.catalogued),
            None => Case::varied(entry.catalogued, &mut points).kicked(&mut points),
        };
        Some((entry.name(), case, flow))
    });
    cases.collect()
}

fn end(case: &Case, flow: &dyn AnyFlow, scheme: Scheme, h: f64, steps: u64) -> Vec<f64> {
    let mut last = Vec::new();
    let outcome = flow.simulate(scheme, &case.run(h, steps, 0), &mut |sample| {
        last = sample.state.to_vec();
        ControlFlow::Continue(())
    });
    let name = case.model.description.name;
    outcome.unwrap_or_else(|error| panic!("{name} by {scheme:?}: {error}"));
    last
}

/// Largest difference, relative where values are above one. Not a number counts as infinite.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let relative = |(a, b): (&f64, &f64)| (a - b).abs() / b.abs().max(1.0);
    let worst = |s: f64, d: f64| if d.is_nan() { f64::INFINITY } else { s.max(d) };
    a.iter().zip(b).map(relative).fold(0.0, worst)
}

const END: f64 = 0.25;

/// Every scheme converges to the same motion, that of two stages more and steps eight times shorter: up to a hundred
/// times hᵖ where h counts in times of the motion, a tenth of a second.
#[test]
fn all_schemes_integrate_all_flows() {
    for (name, case, flow) in cases(21) {
        let truth = end(&case, flow, Scheme::Gauss { stages: 8 }, END / 80.0, 80);
        for scheme in Scheme::names().filter_map(Scheme::named) {
            let off = distance(&end(&case, flow, scheme, END / 100.0, 100), &truth);
            let bound = f64::max(
                1e-8,
                100.0 * (END / 100.0 / 0.1_f64).powi(scheme.order() as i32),
            );
            assert!(off <= bound, "{name} by {}: {off:e}", scheme.name());
        }
    }
}

/// A run within a tolerance ends that near to the truth: errors of steps add up over some tens of steps, and neighbouring
/// motions part by up to ten times in this time.
#[test]
fn adaptive_runs_keep_to_their_tolerance() {
    let mut named = Vec::new();
    for name in ["gauss3", "gauss5", "gauss8", "dopri5"] {
        named.push(Scheme::named(name).unwrap());
    }
    for (name, case, flow) in cases(22) {
        let truth = end(&case, flow, Scheme::Gauss { stages: 8 }, END / 160.0, 160);
        for scheme in &named {
            for tolerance in [1e-5, 1e-8, 1e-11] {
                let within = scheme.within(Tolerance::both(tolerance)).unwrap();
                // Two outputs: the first lies within a step.
                let off = distance(&end(&case, flow, within, END / 3.0, 3), &truth);
                assert!(off <= 200.0 * tolerance, "{name}, {within:?}: {off:e}");
            }
        }
    }
}

/// Outputs between the ends of steps are as exact as these.
#[test]
fn outputs_between_steps_are_as_exact() {
    for (name, case, flow) in cases(23) {
        for scheme in ["gauss4", "gauss8", "dopri5"] {
            let scheme = Scheme::named(scheme).unwrap();
            let within = scheme.within(Tolerance::both(1e-9)).unwrap();
            let ends = [1, 97].map(|parts| end(&case, flow, within, END / parts as f64, parts));
            let off = distance(&ends[0], &ends[1]);
            assert!(off <= 2e-7, "{name}, {within:?}: {off:e}");
        }
    }
}

/// log₂ of the ratio of errors is the order, until rounding is near.
#[test]
fn orders_are_what_theory_says() {
    let model = residua_models::find("spatial_reduced").unwrap().catalogued;
    let mut points = Points::new(24);
    let case = Case::varied(model, &mut points).kicked(&mut points);
    let flow = model.flow.unwrap();
    let truth = end(&case, flow, Scheme::Gauss { stages: 8 }, 1.0 / 400.0, 400);
    for scheme in Scheme::names().filter_map(Scheme::named) {
        if matches!(scheme, Scheme::Adaptive { .. }) {
            continue;
        }
        let error = |steps: u64| {
            let found = end(&case, flow, scheme, 1.0 / steps as f64, steps);
            distance(&found, &truth)
        };
        // From where errors are 1e-2 and fall, to where a twelfth of their digits is rounding.
        let mut orders = Vec::new();
        let mut steps = 20;
        let mut before = f64::NAN;
        while steps <= 5120 {
            let now = error(steps);
            if now < 1e-12 {
                break;
            }
            if before < 1e-4 {
                orders.push((before / now).log2());
            }
            before = now;
            steps *= 2;
        }
        println!("{} {orders:.2?}", scheme.name());
        let last = orders.last().copied().unwrap_or(f64::NAN);
        let expected = scheme.order() as f64;
        assert!(
            (last - expected).abs() <= 0.25,
            "{}: {orders:?}",
            scheme.name()
        );
    }
}
