//! Taylor series: coefficients, orders, tolerances, and what has none.

#[path = "support/body.rs"]
mod body;
#[path = "support/order.rs"]
mod order;

use body::asymmetric;
use order::distance;
use order::order_of;
use residua::Record;
use residua::Series;
use residua::Settings;
use residua::Tolerance;
use residua::erased::Run;
use residua::erased::Scheme;
use residua::taylor::AdaptiveTaylor;
use residua::taylor::Expansion;
use residua::taylor::MOST_ORDER;
use residua::taylor::TaylorSeries;
use residua_models::CATALOGUE;
use residua_models::dsl;
use residua_models::exact::Double;
use residua_models::exact::reference;
use residua_models::values;
use std::ops::ControlFlow;

/// Every function and operation that has a recurrence, and the time. Of 1/3 and 1/9 one must be the square of the other, to
/// all digits.
mod functions {
    residua::model! {
        param a: 1 = 0.75;
        param τ: s = 1;
        state x: 1;
        state y: 1;
        state u: [20] 1;
        flow {
            τ*der(x) = y + 0.1*sin(t/τ);
            τ*der(y) = -x + 0.2*x^2;
            τ*der(u) = [
                sin(x*y),
                cos(x + y^2),
                tan(x/3),
                asin(x/3),
                acos(y/4),
                atan(x/3 - y),
                atan2(x, 2 + y),
                sinh(x),
                cosh(y),
                tanh(x + 1),
                exp(x*y),
                log(3 + x),
                sqrt(2 + y),
                (3 + x)^a,
                (3 + x)^y,
                a^x,
                x^3/(2 + y),
                a/((3 + x)*(2 + y)^2),
                t*x/τ,
                exp(-t/τ)*u(1) + pi];
        }
        residual { Δx = 0; Δy = 0; Δu = 0; }
        solve for next;
        start { x = 0.3; y = 0.4; u = [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]; }
    }
}

/// What is left over of f(t, x) − ẋ with x the polynomial, relative to ẋ, at a time that is small against the radius of
/// convergence: an order that is off by δ shows as δ·2⁻ⁿ·n at least.
fn defect<M: Series<Double>>(theta: f64, unit: f64, t: f64) -> f64 {
    let parameters = M::Parameters::default();
    let start = M::start(&parameters).to_array();
    let mut expansion = Expansion::<M, Double>::new(&parameters, MOST_ORDER);
    let number = Double::from;
    expansion.expand(number(t), &start, number(unit));
    let change = expansion.change(number(theta));
    let mut x = start;
    for (x, change) in x.as_mut().iter_mut().zip(change.as_ref()) {
        *x = *x + *change;
    }
    let at = number(t) + number(unit) * number(theta);
    let rates = M::flow(&M::flow_scene(&parameters), at, &x);
    let mut worst = 0.0_f64;
    for (i, rate) in rates.as_ref().iter().enumerate() {
        let mut slope = number(0.0);
        for (n, x) in expansion.coefficients().iter().enumerate().skip(1).rev() {
            slope = slope * number(theta) + x.as_ref()[i] * number(n as f64);
        }
        let defect = (*rate - slope / number(unit)).abs().to_f64();
        worst = worst.max(defect / (1.0 + rate.abs().to_f64()));
    }
    worst
}

/// (1/128)²⁴ is left out, and double-double numbers round to 1e-31.
#[test]
fn the_series_of_every_function_fulfils_its_equation() {
    let defect = defect::<functions::Model>(0.5, 1.0 / 64.0, 0.7);
    assert!(defect < 1e-26, "{defect:e}");
}

/// Each catalogued flow, at a time that is short for it.
#[test]
fn the_series_of_every_model_fulfils_its_equation() {
    macro_rules! check {
        ($($name:ident)*) => {
            $({
                let defect = defect::<dsl::$name::Model>(0.5, 1.0 / 256.0, 0.0);
                assert!(defect < 1e-26, "{}: {defect:e}", stringify!($name));
            })*
        };
    }
    check! {
        double_planar elastic lattice planar_algebra planar_angle planar_cayley planar_group planar_recursive planar_reduced
        spatial_cardan spatial_cardan_zyx spatial_exponential spatial_group spatial_recursive spatial_reduced
        spatial_variational spherical
    }
}

#[test]
fn every_flow_has_a_series_or_a_reason() {
    for entry in CATALOGUE {
        let catalogued = entry.catalogued;
        let is_told = catalogued.series.is_some() != catalogued.description.no_series.is_some();
        assert_eq!(is_told, catalogued.flow.is_some(), "{}", entry.name());
    }
}

/// Against Gauss collocation of order 12: another method with another code.
#[test]
fn models_run_as_with_gauss_collocation() {
    for entry in CATALOGUE {
        let catalogued = entry.catalogued;
        let (Some(series), Some(flow)) = (catalogued.series, catalogued.flow) else {
            continue;
        };
        let parameters = values::defaults(catalogued);
        let start = values::start(catalogued, &parameters);
        let run = Run {
            parameters: &parameters,
            start: &start,
            h: 1.0 / 256.0,
            t0: 0.0,
            steps: 128,
            every: 0,
            settings: Settings::default(),
        };
        let mut ends = [start.clone(), start.clone(), start.clone()];
        let [fixed, adaptive, gauss] = &mut ends;
        let into = |end: &mut Vec<f64>, state: &[f64]| {
            *end = state.to_vec();
            ControlFlow::Continue(())
        };
        series
            .simulate(&run, 18, &mut |s| into(fixed, s.state))
            .unwrap();
        let tolerance = Tolerance::both(1e-13);
        series
            .simulate_within(&run, tolerance, &mut |s| into(adaptive, s.state))
            .unwrap();
        let scheme = Scheme::Gauss { stages: 6 };
        flow.simulate(scheme, &run, &mut |s| into(gauss, s.state))
            .unwrap();
        for other in [&ends[0], &ends[1]] {
            for (a, b) in other.iter().zip(&ends[2]) {
                // Rounding, and what the stages of Gauss are solved to.
                assert!(
                    (a - b).abs() < 1e-10 * (1.0 + b.abs()),
                    "{}: {ends:?}",
                    entry.name()
                );
            }
        }
    }
}

fn end(order: usize, steps: u32, until: f64) -> Vec<Double> {
    let (parameters, start) = asymmetric::<Double>();
    let h = Double::from(until) / Double::from(f64::from(steps));
    let run = TaylorSeries::<dsl::spatial_reduced::Model, Double>::new(parameters, start, h);
    let mut run = run.unwrap().with_order(order);
    for _ in 0..steps {
        run.step().unwrap();
    }
    run.state().to_array().to_vec()
}

/// Twenty times what double-double numbers round a step of a short series to.
const LEAST_ERROR: f64 = 1e-30;

/// The error of a single step is proportional to hᵖ⁺¹. In a run the errors of its steps may cancel, of some orders so far
/// that the next in h is seen longer than there are digits.
#[test]
fn orders_are_those_asked_for() {
    for order in 1..=MOST_ORDER {
        let error = |steps: u32| {
            let until = 1.0 / f64::from(steps);
            distance(&end(order, 1, until), &end(MOST_ORDER, 16, until))
        };
        let measured = order_of(2048, LEAST_ERROR, error) - 1.0;
        println!("taylor{order}: {measured}");
        assert!(
            (measured - order as f64).abs() < 0.25,
            "{order}: {measured}"
        );
    }
}

/// The errors of all steps add up: T = 4 is some 60 steps, and the motion stretches them by less than 10.
#[test]
fn runs_within_tolerances_end_within_them() {
    let (parameters, start) = asymmetric::<Double>();
    let exact = reference::<dsl::spatial_reduced::Model>(parameters, start, 0.5, 8, None).unwrap();
    for tolerance in [1e-5, 1e-7, 1e-9, 1e-11, 1e-13] {
        let (parameters, start) = asymmetric::<f64>();
        let run = AdaptiveTaylor::<dsl::spatial_reduced::Model>::new(parameters, start, 0.5);
        let mut run = run.unwrap().with_tolerance(Tolerance::both(tolerance));
        let mut worst = 0.0_f64;
        for exact in &exact {
            run.step().unwrap();
            for (x, exact) in run.state_array().iter().zip(exact) {
                worst = worst.max((x - exact.to_f64()).abs());
            }
        }
        assert!(worst < 600.0 * tolerance, "{tolerance:e}: {worst:e}");
        assert!(
            worst > 1e-4 * tolerance,
            "{tolerance:e} is wasted: {worst:e}"
        );
        assert_eq!(run.statistics().rejected, 0);
    }
}

/// Two tolerances, 28 digits.
#[test]
fn the_reference_is_good_to_28_digits() {
    let (parameters, start) = asymmetric::<Double>();
    let ends = [None, Some(1e-29)].map(|tolerance| {
        let run = reference::<dsl::spatial_reduced::Model>(parameters, start, 1.0, 1, tolerance);
        run.unwrap().remove(0)
    });
    let apart = distance(&ends[0], &ends[1]);
    assert!(apart < 1e-27, "{apart:e}");
}

/// x' = −x backwards overflows; a run that failed goes on from another state.
#[test]
fn a_failed_step_leaves_nothing_behind() {
    let (parameters, start) = asymmetric::<f64>();
    let run = TaylorSeries::<dsl::spatial_reduced::Model>::new(parameters, start, 1e60);
    let mut run = run.unwrap();
    assert!(run.step().is_err());
    assert_eq!(run.state_array(), &start.to_array());
    let run = AdaptiveTaylor::<dsl::spatial_reduced::Model>::new(parameters, start, -0.25);
    let mut back = run.unwrap().with_tolerance(Tolerance::both(1e-12));
    back.step().unwrap();
    let run = AdaptiveTaylor::<dsl::spatial_reduced::Model>::new(parameters, back.state(), 0.25);
    let mut forth = run.unwrap().with_tolerance(Tolerance::both(1e-12));
    forth.step().unwrap();
    for (a, b) in forth.state_array().iter().zip(start.to_array()) {
        assert!((a - b).abs() < 1e-10);
    }
}

#[test]
fn what_has_no_series_says_why() {
    let text = |flow: &str| {
        let text = format!(
            "param τ: s = 1; state x: 1; flow {{ τ*der(x) = {flow}; }} residual {{ Δx = 0; }} solve for next; start {{ x = 1; }}"
        );
        residua_codegen::compile("kink", text.parse().unwrap())
            .unwrap()
            .to_string()
    };
    for (flow, word) in [
        ("abs(x)", "kink"),
        ("sign(x)", "jumps"),
        ("max(x, 1)", "kink"),
    ] {
        let code = text(flow);
        assert!(
            code.contains(word) && !code.contains("mod series"),
            "{flow}"
        );
    }
    assert!(text("sin(x)").contains("mod series"));
}
