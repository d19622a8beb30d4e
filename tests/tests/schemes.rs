//! What every scheme does on every model that has a `flow`: nothing here names a model but where its motion is special.

use residua::Tolerance;
use residua::erased::AnyFlow;
use residua::erased::Scheme;
use residua_models::CATALOGUE;
use residua_models::find;
use residua_tests::case::Case;
use residua_tests::case::Tested;
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
    let outcome = flow.simulate(scheme, &case.unobserved(h, steps), &mut |sample| {
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

/// A spring a million times as stiff as its mass, in steps ten times longer than its period allows sweeps: Newton's method
/// takes them, and the slow swing is that of a rod.
#[test]
fn a_stiff_spring_swings_like_a_rod() {
    let model = residua_models::find("elastic").unwrap().catalogued;
    let mut case = Case::of_file(model);
    let position = model
        .description
        .parameters
        .iter()
        .position(|p| p.name == "c");
    case.parameters[position.unwrap()] = 1e6;
    // r = l and p = 0 leave the spring to start at rest, and it stretches by g/c = 1e-5: so far off is the rod.
    let flow = model.flow.unwrap();
    let rod = residua_models::find("planar_angle").unwrap().catalogued;
    let mut rigid = Case::of_file(rod);
    for (parameter, value) in rod.description.parameters.iter().zip(&mut rigid.parameters) {
        *value = if parameter.name == "g" { 9.81 } else { 1.0 };
    }
    rigid.start = vec![0.0, 1.2];
    let truth = end(
        &rigid,
        rod.flow.unwrap(),
        Scheme::Gauss { stages: 8 },
        0.02,
        50,
    );
    let mut statistics = None;
    let mut last = Vec::new();
    for stages in [1, 3] {
        let outcome = flow.simulate(
            Scheme::Gauss { stages },
            &case.unobserved(0.01, 100),
            &mut |sample| {
                last = sample.state.to_vec();
                statistics = Some(sample.statistics);
                ControlFlow::Continue(())
            },
        );
        outcome.unwrap_or_else(|error| panic!("{error}"));
        assert!((last[1] - truth[1]).abs() < 1e-3, "{last:?} {truth:?}");
    }
    assert!(
        statistics.is_some_and(|s| s.jacobians > 0),
        "{statistics:?}"
    );
}

/// A spring that shivers 159 times a second, in steps of a tenth and of a thousandth of a second: its length is what carries
/// the mass, and the slow swing is followed to the order of the scheme.
#[test]
fn gauss_schemes_follow_the_slow_motion_of_a_stiff_flow() {
    let entry = find("elastic_stiff").expect("a scene");
    let case = Case::of_file(entry.catalogued);
    let flow = entry.catalogued.flow.expect("a flow");
    let series = entry.catalogued.series.expect("a series");
    let mut truth = Vec::new();
    let run = case.unobserved(1.0, 1);
    let outcome = series.simulate_within(&run, Tolerance::both(1e-12), &mut |sample| {
        truth = sample.state.to_vec();
        ControlFlow::Continue(())
    });
    outcome.expect("a run");
    for (stages, long) in [(2, 1e-4), (3, 1e-7), (6, 1e-8)] {
        for (steps, bound) in [(10, long), (1000, 1e-8)] {
            let found = end(
                &case,
                flow,
                Scheme::Gauss { stages },
                1.0 / steps as f64,
                steps,
            );
            let off = (found[1] - truth[1]).abs().max((found[3] - truth[3]).abs());
            assert!(off <= bound, "gauss{stages}, {steps} steps: {off:e}");
        }
    }
}
