//! Orders of convergence, in double-double numbers: between errors that are not yet hᵖ and such that are rounding lie twenty
//! digits, enough for order 16.

#[path = "support/body.rs"]
mod body;

use body::asymmetric;
use body::distance;
use residua::Collocation;
use residua::Composed;
use residua::Ends;
use residua::Explicit;
use residua::Integration;
use residua::Method;
use residua::Record;
use residua::Settings;
use residua::erased::Run;
use residua::erased::Scheme;
use residua_models::dsl::spatial_reduced::MODEL;
use residua_models::dsl::spatial_reduced::Model;
use residua_models::exact::Double;
use residua_models::exact::reference;
use std::ops::ControlFlow;

/// Errors from here on are proportional to hᵖ: 1e-31 of rounding, in a thousand steps and in a motion that stretches it by
/// ten.
const LEAST_ERROR: f64 = 1e-26;

/// The most steps of low orders: there, what is next in h is a thousandth.
const MOST_STEPS: u32 = 256;

const END: f64 = 1.0;

/// `None` where the step is too long for a solution.
fn state_after<S: Method<Double, Model = Model>>(steps: u32) -> Option<Vec<Double>> {
    let (parameters, start) = asymmetric::<Double>();
    let h = Double::from(END) / Double::from(f64::from(steps));
    let mut run = Integration::<S, Double>::new(parameters, start, h).unwrap();
    let outcome = run.advance(u64::from(steps));
    outcome.ok().map(|()| run.state_array().to_vec())
}

/// The slope of the error between the shortest step whose error is none of rounding and twice that step.
fn order<S: Method<Double, Model = Model>>(exact: &[Double]) -> f64 {
    let error = |steps| state_after::<S>(steps).map_or(f64::INFINITY, |x| distance(&x, exact));
    let (mut steps, mut coarse, mut order) = (4, error(4), f64::NAN);
    while steps < MOST_STEPS {
        steps *= 2;
        let fine = error(steps);
        if fine < LEAST_ERROR {
            break;
        }
        order = (coarse / fine).log2();
        coarse = fine;
    }
    order
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
    let all = [
        typed::<Collocation<Model, 1, f64>>(),
        typed::<Collocation<Model, 2, f64>>(),
        typed::<Collocation<Model, 3, f64>>(),
        typed::<Collocation<Model, 4, f64>>(),
        typed::<Collocation<Model, 5, f64>>(),
        typed::<Collocation<Model, 6, f64>>(),
        typed::<Collocation<Model, 7, f64>>(),
        typed::<Collocation<Model, 8, f64>>(),
    ];
    for (i, typed) in all.iter().enumerate() {
        let mut last = Vec::new();
        let scheme = Scheme::Gauss { stages: i + 1 };
        let outcome = MODEL.flow.unwrap().simulate(scheme, &run, &mut |sample| {
            last = sample.state.to_vec();
            ControlFlow::Continue(())
        });
        outcome.unwrap();
        assert_eq!(&last, typed, "{scheme:?}");
    }
}
