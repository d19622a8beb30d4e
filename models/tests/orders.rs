//! Orders of convergence of the schemes that have names, as types and by name.

#[path = "support/body.rs"]
mod body;
#[path = "support/order.rs"]
mod order;

use body::asymmetric;
use order::distance;
use order::order_of;
use residua::Collocation;
use residua::Composed;
use residua::Ends;
use residua::Explicit;
use residua::Integration;
use residua::Method;
use residua::Pair;
use residua::Record;
use residua::Settings;
use residua::Statistics;
use residua::Tolerance;
use residua::Variable;
use residua::VariableGauss;
use residua::erased::Run;
use residua::erased::Scheme;
use residua_models::dsl::spatial_reduced::MODEL;
use residua_models::dsl::spatial_reduced::Model;
use residua_models::exact::Double;
use residua_models::exact::reference;
use std::ops::ControlFlow;

const END: f64 = 1.0;

/// What is next in h is below a hundredth.
const MOST_STEPS: u32 = 512;

/// The reference is good to 1e-27.
const LEAST_ERROR: f64 = 1e-26;

/// `None` where the step is too long for a solution.
fn state_after<S: Method<Double, Model = Model>>(steps: u32) -> Option<Vec<Double>> {
    let (parameters, start) = asymmetric::<Double>();
    let h = Double::from(END) / Double::from(f64::from(steps));
    let mut run = Integration::<S, Double>::new(parameters, start, h).unwrap();
    let outcome = run.advance(u64::from(steps));
    outcome.ok().map(|()| run.state_array().to_vec())
}

fn order<S: Method<Double, Model = Model>>(exact: &[Double]) -> f64 {
    order_of(MOST_STEPS, LEAST_ERROR, |steps| {
        state_after::<S>(steps).map_or(f64::INFINITY, |x| distance(&x, exact))
    })
}

type Midpoint = Collocation<Model, 1, Double>;

#[test]
fn orders_are_what_theory_says() {
    let (parameters, start) = asymmetric::<Double>();
    let exact = reference::<Model>(parameters, start, END, 1, None).unwrap();
    let exact = &exact[0];
    let orders = [
        ("rk4", 4.0, order::<Explicit<Model, Double>>(exact)),
        ("midpoint", 2.0, order::<Midpoint>(exact)),
        ("trapezoidal", 2.0, order::<Ends<Model, Double>>(exact)),
        ("gauss2", 4.0, order::<Collocation<Model, 2, Double>>(exact)),
        ("gauss3", 6.0, order::<Collocation<Model, 3, Double>>(exact)),
        ("gauss4", 8.0, order::<Collocation<Model, 4, Double>>(exact)),
        (
            "gauss5",
            10.0,
            order::<Collocation<Model, 5, Double>>(exact),
        ),
        (
            "gauss6",
            12.0,
            order::<Collocation<Model, 6, Double>>(exact),
        ),
        (
            "gauss7",
            14.0,
            order::<Collocation<Model, 7, Double>>(exact),
        ),
        (
            "gauss8",
            16.0,
            order::<Collocation<Model, 8, Double>>(exact),
        ),
        (
            "composition4",
            4.0,
            order::<Composed<Midpoint, 5, Double>>(exact),
        ),
        (
            "composition6",
            6.0,
            order::<Composed<Midpoint, 9, Double>>(exact),
        ),
        (
            "composition8",
            8.0,
            order::<Composed<Midpoint, 15, Double>>(exact),
        ),
    ];
    for (name, _, measured) in orders {
        println!("{name}: {measured}");
    }
    for (name, expected, measured) in orders {
        assert!((measured - expected).abs() < 0.25, "{name}: {measured}");
        let scheme = Scheme::named(name).unwrap();
        assert_eq!(scheme.order() as f64, expected, "{name}");
    }
}

/// Errors of some equal steps: that of the end of the run, the estimate of the first step, and that of the state in the middle
/// of it. `None` where the step is too long for a solution.
fn errors<V: Variable<Double, Model = Model>>(steps: u32, exact: &[Double]) -> Option<[f64; 3]> {
    let (parameters, start) = asymmetric::<Double>();
    let h = Double::from(END) / Double::from(f64::from(steps));
    let tolerance = Tolerance::both(Double::from(ROUNDING));
    let mut scheme = V::new(&parameters);
    let mut statistics = Statistics::default();
    let mut x = start.to_array();
    let [mut estimate, mut middle] = [0.0; 2];
    for k in 0..steps {
        let t = h * Double::from(f64::from(k));
        let tried = scheme.attempt(t, &x, h, &tolerance, &mut statistics).ok()?;
        x = scheme.accept();
        if k == 0 {
            estimate = tried.error.to_f64() * ROUNDING;
            let exact =
                reference::<Model>(parameters, start, (h / Double::from(2.0)).to_f64(), 1, None);
            middle = distance(&scheme.at(Double::from(0.5)), &exact.unwrap()[0]);
        }
    }
    Some([distance(&x, exact), estimate, middle])
}

/// Stages are solved to a tenth of it.
const ROUNDING: f64 = 1e-30;

/// The orders of these errors.
fn orders_of<V: Variable<Double, Model = Model>>(exact: &[Double]) -> [f64; 3] {
    [0, 1, 2].map(|i| {
        order_of(MOST_STEPS, LEAST_ERROR, |steps| {
            errors::<V>(steps, exact).map_or(f64::INFINITY, |e| e[i])
        })
    })
}

/// Dormand and Prince: 5, 5, and 4 between steps, which is 5 for a single one. Gauss: 2 S, 2 S − 1, and 2 S between steps, too.
#[test]
fn orders_of_variable_steps_are_what_theory_says() {
    let (parameters, start) = asymmetric::<Double>();
    let exact = reference::<Model>(parameters, start, END, 1, None).unwrap();
    let exact = &exact[0];
    let all = [
        ("dopri5", [5, 5, 5], orders_of::<Pair<Model, Double>>(exact)),
        ("gauss3", [6, 5, 7], by_gauss::<3>(exact)),
        ("gauss4", [8, 7, 9], by_gauss::<4>(exact)),
        ("gauss5", [10, 9, 11], by_gauss::<5>(exact)),
        ("gauss6", [12, 11, 13], by_gauss::<6>(exact)),
        ("gauss7", [14, 13, 15], by_gauss::<7>(exact)),
        ("gauss8", [16, 15, 17], by_gauss::<8>(exact)),
    ];
    for (name, _, measured) in all {
        println!("{name}: {measured:?}");
    }
    for (name, expected, measured) in all {
        for (expected, measured) in expected.into_iter().zip(measured) {
            let off = measured - f64::from(expected);
            assert!(off.abs() < 0.25, "{name}: {measured} for {expected}");
        }
        let within = Scheme::named(name).unwrap().within(Tolerance::both(1e-9));
        assert_eq!(within.unwrap().order(), expected[1] as usize, "{name}");
    }
}

fn by_gauss<const S: usize>(exact: &[Double]) -> [f64; 3] {
    orders_of::<VariableGauss<Model, S, Double>>(exact)
}

/// One compiled function takes any number of stages: the same numbers as the method of that many stages, to the last bit.
#[test]
fn names_run_what_is_measured() {
    fn typed<S: Method<f64, Model = Model>>() -> Vec<f64> {
        let (parameters, start) = asymmetric::<f64>();
        let mut run = Integration::<S, f64>::new(parameters, start, 0.05).unwrap();
        run.advance(20).unwrap();
        run.state_array().to_vec()
    }
    let (parameters, start) = asymmetric::<f64>();
    let (parameters, start) = (parameters.to_array(), start.to_array());
    let run = Run {
        parameters: &parameters,
        start: &start,
        h: 0.05,
        t0: 0.0,
        steps: 20,
        every: 0,
        settings: Settings::default(),
    };
    type Rule = Collocation<Model, 1, f64>;
    let all = [
        ("rk4", typed::<Explicit<Model, f64>>()),
        ("midpoint", typed::<Rule>()),
        ("trapezoidal", typed::<Ends<Model, f64>>()),
        ("gauss2", typed::<Collocation<Model, 2, f64>>()),
        ("gauss3", typed::<Collocation<Model, 3, f64>>()),
        ("gauss4", typed::<Collocation<Model, 4, f64>>()),
        ("gauss5", typed::<Collocation<Model, 5, f64>>()),
        ("gauss6", typed::<Collocation<Model, 6, f64>>()),
        ("gauss7", typed::<Collocation<Model, 7, f64>>()),
        ("gauss8", typed::<Collocation<Model, 8, f64>>()),
        ("composition4", typed::<Composed<Rule, 5, f64>>()),
        ("composition6", typed::<Composed<Rule, 9, f64>>()),
        ("composition8", typed::<Composed<Rule, 15, f64>>()),
    ];
    for (name, typed) in &all {
        let mut last = Vec::new();
        let scheme = Scheme::named(name).unwrap();
        let outcome = MODEL.flow.unwrap().simulate(scheme, &run, &mut |sample| {
            last = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        outcome.unwrap();
        assert_eq!(&last, typed, "{name}");
    }
    // All but those that choose their steps.
    assert_eq!(all.len() + 1, Scheme::names().count());
}
