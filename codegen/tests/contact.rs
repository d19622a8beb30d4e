//! A one-sided force is nothing at all where there is no contact, however stiff it is and however it is written.

use num_rational::BigRational;
use num_traits::ToPrimitive;
use residua_codegen::Analysis;
use residua_codegen::analyse;
use residua_codegen::ast::Form;
use residua_codegen::compile;
use residua_codegen::dag::Dag;
use residua_codegen::dag::Leaf;
use residua_codegen::dag::NodeId;
use residua_codegen::dag::Number;
use residua_codegen::dag::Rate;
use residua_codegen::schedule::Op;
use residua_codegen::schedule::ValueId;
use residua_codegen::source::lex;
use residua_codegen::stage::stage;
use residua_codegen::system::System;

/// A mass that falls onto the ground `e`.
fn model(statements: &str, force: &str) -> String {
    format!(
        "param m: kg = 0.3; param g: m/s^2 = 9.81; param kk: N/m = 1e9; param e: m = 0.1;
         state x: m; state v: m/s;
         {statements}
         residual {{ Δx = h*v[k+1/2]; m*Δv = -h*m*g + h*({force}); }}
         solve for next, increment;
         start {{ x = 1; v = 0; }}"
    )
}

/// Seven tenths of how far the mass is below the ground.
const DEPTH: &str = "0.7*(e - x[k+1/2])";

/// The ways to write the force at this depth.
fn ways() -> Vec<String> {
    let forces = [
        "kk*(abs(d) + d)/2",
        "kk*(d + abs(d))/2",
        "kk*(abs(d) - -d)/2",
        "kk*(abs(-d) + d)/2",
        "(abs(d) + d)*kk/2",
        "-kk*(-d - abs(d))/2",
        "kk*max(0, d)",
        "kk*max(d, 0)",
        "-kk*min(0, -d)",
        "-kk*min(-d, 0)",
    ];
    let inline = forces.map(|force| model("", &force.replace('d', &format!("({DEPTH})"))));
    let named = forces.map(|force| model(&format!("let d = {DEPTH};"), force));
    let upwards = model("let y = 0.7*(x[k+1/2] - e);", "kk*(abs(y) - y)/2");
    inline.into_iter().chain(named).chain([upwards]).collect()
}

fn analysis(text: &str) -> Analysis {
    match analyse("contact", lex(text).expect("lexes")) {
        Ok(analysis) => analysis,
        Err(errors) => panic!("{text}: {errors}"),
    }
}

/// How far above the ground the mass is, after half a step.
const HEIGHTS: [f64; 4] = [1e-12, 1e-9, 0.123, 7.7];

/// Numbers with no short binary form, the mass `above` the ground after half a step; its velocity takes it there, too.
fn point(form: Form, above: f64, stiffness: f64) -> impl Fn(Leaf) -> f64 {
    let ground = 0.1 / 3.0;
    let known = ground + above / 3.0;
    let next = 2.0 * (ground + above) - known;
    move |leaf| match leaf {
        Leaf::Parameter(0) => 0.3,
        Leaf::Parameter(1) => 9.81,
        Leaf::Parameter(2) => stiffness,
        Leaf::Parameter(_) => ground,
        Leaf::StepSize => 1e-3,
        Leaf::State(0) => known,
        Leaf::State(_) => 0.7,
        Leaf::Unknown(0) if form == Form::Next => next,
        Leaf::Unknown(0) => next - known,
        _ => 0.71,
    }
}

/// The values of nodes, and again as emitted code computes them.
fn values(dag: &Dag, roots: &[NodeId], leaf: impl Fn(Leaf) -> f64) -> Vec<f64> {
    let schedule = stage(dag, &[("all", Rate::Iteration, roots.to_vec())]);
    let mut known: Vec<f64> = Vec::new();
    for value in &schedule.values {
        known.push(computed(&value.op, &known, &leaf));
    }
    let kernel = schedule.kernel("all").expect("the only one");
    let emitted = kernel.roots.iter().map(|root| known[root.index()]);
    let plain = dag.tape(roots).evaluate(&leaf);
    plain.into_iter().chain(emitted).collect()
}

fn number(exact: &BigRational) -> f64 {
    exact.to_f64().expect("a number")
}

fn computed(op: &Op, known: &[f64], leaf: impl Fn(Leaf) -> f64) -> f64 {
    let at = |value: &ValueId| known[value.index()];
    match op {
        Op::Constant(c) => number(c),
        Op::Pi => std::f64::consts::PI,
        Op::Leaf(input) => leaf(*input),
        Op::Sum(terms) => terms.iter().map(|(c, v)| number(c) * at(v)).sum(),
        Op::Product {
            coefficient,
            numerator,
            denominator,
        } => {
            let above: f64 = numerator.iter().map(at).product();
            number(coefficient) * above / denominator.iter().map(at).product::<f64>()
        }
        Op::Call(function, arguments) => {
            f64::call(*function, at(&arguments[0]), arguments.get(1).map(at))
        }
    }
}

/// The residual and all that follows from it.
fn roots(system: &System) -> Vec<NodeId> {
    [system.residual.clone(), system.derived()].concat()
}

/// The derivative of the second equation by the first unknown, which the force alone has.
fn by_height(system: &System) -> NodeId {
    let mut entries = system.jacobian.iter();
    let entry = entries.find(|entry| (entry.row, entry.col) == (1, 0));
    entry.expect("a force").node
}

#[test]
fn above_the_ground_there_is_no_force() {
    let free = analysis(&model("", "0"));
    for text in ways() {
        let analysis = analysis(&text);
        for (system, free) in analysis.systems.iter().zip(&free.systems) {
            for above in HEIGHTS {
                let at = |stiffness| point(system.form, above, stiffness);
                let [stiff, soft] = [1e9, 0.0].map(|k| values(&system.dag, &roots(system), at(k)));
                assert_eq!(stiff, soft, "{above}: {text}");
                let [own, without] = [system, free].map(|s| values(&s.dag, &s.residual, at(1e9)));
                assert_eq!(own, without, "{above}: {text}");
            }
        }
    }
}

#[test]
fn above_the_ground_the_force_has_no_derivative() {
    for text in ways() {
        for system in analysis(&text).systems {
            let force = by_height(&system);
            for above in HEIGHTS {
                let leaf = point(system.form, above, 1e9);
                assert_eq!(values(&system.dag, &[force], leaf), [0.0; 2], "{text}");
            }
            let below = point(system.form, -0.01, 1e9);
            let slope = values(&system.dag, &[force], below)[1];
            assert!(
                (slope / (0.7 * 1e-3 * 1e9 / 2.0) - 1.0).abs() < 1e-12,
                "{text}"
            );
        }
    }
}

#[test]
fn below_it_the_force_is_that_of_a_spring() {
    let spring = analysis(&model("", &format!("kk*{DEPTH}")));
    for text in ways() {
        for (system, spring) in analysis(&text).systems.iter().zip(&spring.systems) {
            let leaf = || point(system.form, -0.01, 1e9);
            let found = values(&system.dag, &system.residual, leaf());
            let expected = values(&spring.dag, &spring.residual, leaf());
            for (found, expected) in found.iter().zip(&expected) {
                let most = 1e-9 * (1.0 + expected.abs());
                assert!((found - expected).abs() <= most, "{text}");
            }
        }
    }
}

/// The same with other terms between.
fn apart() -> Vec<String> {
    let forces = [
        "kk*(abs(e - x[k+1/2]) - x[k+1/2] + e)/2",
        "kk*(g*h^2 + 0.7*e + 0.7*abs(x[k+1/2] - e) - 0.7*x[k+1/2])/2",
        "kk*(v*h + max(x[k+1/2] - e, 0) - x[k+1/2] + e)",
    ];
    forces.map(|force| model("", force)).to_vec()
}

#[test]
fn every_way_is_emitted_as_the_same_function() {
    for text in ways().into_iter().chain(apart()) {
        let code = compile("contact", lex(&text).expect("lexes"));
        let code = code.unwrap_or_else(|errors| panic!("{errors}")).to_string();
        assert!(code.contains(". positive ()"), "{text}");
        assert!(!code.contains(". abs ()"), "{text}");
    }
}

/// Newton's method has to know: in either form, of all unknowns and of what is iterated on.
#[test]
fn every_way_is_emitted_as_a_kink() {
    let kinks = |text: &str| {
        let code = compile("contact", lex(text).expect("lexes"));
        let code = code.unwrap_or_else(|errors| panic!("{errors}")).to_string();
        code.matches("HAS_KINKS : bool = true").count()
    };
    for text in ways() {
        assert_eq!(kinks(&text), 4, "{text}");
    }
    assert_eq!(kinks(&model("", "0")), 0);
}

#[test]
fn what_is_one_function_is_printed_so_and_reads_back() {
    let ways = [
        "max(x, 0)",
        "max(0, x)",
        "(x + abs(x))/2",
        "-min(0, -x)",
        "x - min(x, 0)",
    ];
    let observed = ways.iter().enumerate();
    let observed: Vec<_> = observed
        .map(|(i, w)| format!("observe o{i} = {w};"))
        .collect();
    let text = format!(
        "state x; {} residual {{ Δx = 0; }} start {{ x = 1; }}",
        observed.join(" ")
    );
    let equations = analysis(&text).equations;
    for node in &equations.outputs {
        assert_eq!(node, &equations.outputs[0]);
        assert_eq!(equations.dag.text(*node, |_| "x".into()), "max(x, 0)");
    }
}

#[test]
fn largest_and_smallest_are_what_they_are() {
    let text = "state x; state y; observe a = max(x, y); observe b = min(x, y); observe c = max(x, y) + min(x, y);
        residual { Δx = 0; Δy = 0; } start { x = 1; y = 1; }";
    let equations = analysis(text).equations;
    for (x, y) in [
        (1.5, -0.25),
        (-3.0, 2.0),
        (0.0, 0.5),
        (2.0, 2.0),
        (-1.0, -0.5),
    ] {
        let leaf = |leaf| if leaf == Leaf::State(0) { x } else { y };
        let found = equations.dag.tape(&equations.outputs).evaluate(leaf);
        assert_eq!(found, [f64::max(x, y), f64::min(x, y), x + y], "{x} {y}");
    }
}
