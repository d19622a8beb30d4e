//! A scene takes the steps of its model: nothing is left out that matters.

use nalgebra::{DMatrix, DVector};
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use residua::erased::Catalogued;
use residua::{Component, InvalidRun, RunError, Strategy};
use residua_codegen::dag::{Leaf, NodeId, Tape};
use residua_codegen::source::{lex, read_source};
use residua_codegen::system::System;
use residua_codegen::{Analysis, Scene, analyse, analyse_scene};
use residua_models::{CATALOGUE, Entry, SCENES, find};
use residua_tests::case::{Case, Tested, solver};
use std::ops::ControlFlow;

/// Steps of the comparisons.
const STEPS: u64 = 10_000;

fn names(variables: &'static [residua::description::Variable]) -> Vec<String> {
    let len: usize = variables.iter().map(|v| v.rows * v.cols).sum();
    let component = |position| Component {
        variables,
        position,
    };
    (0..len).map(|i| component(i).to_string()).collect()
}

/// The model of a scene with the scene's parameters and start, and for each component of the scene's state its
/// position in the model's.
fn whole(scene: &'static Catalogued) -> (Case, Vec<usize>) {
    let given = scene.description.scene.expect("a scene");
    let model = find(given.model).expect("its model").catalogued;
    let mut case = Case::of_file(model);
    let mut offset = 0;
    for parameter in model.description.parameters {
        let n = parameter.rows * parameter.cols;
        if let Some(fixed) = given.fixed.iter().find(|f| f.name == parameter.name) {
            case.parameters[offset..offset + n].copy_from_slice(fixed.values);
        }
        offset += n;
    }
    let mut case = Case::with_parameters(model, case.parameters);
    let all = names(model.description.states);
    let position = |name: &String| all.iter().position(|n| n == name).expect(name);
    let own: Vec<usize> = names(scene.description.states)
        .iter()
        .map(position)
        .collect();
    for (value, &i) in Case::of_file(scene).start.iter().zip(&own) {
        case.start[i] = *value;
    }
    (case, own)
}

fn size(values: &[f64]) -> f64 {
    values.iter().fold(1.0, |size, v| size.max(v.abs()))
}

/// The largest difference of two runs, the second one's components being picked, relative to its states; infinite where
/// one is no number.
fn furthest(found: &[Vec<f64>], expected: &[Vec<f64>], picked: &[usize]) -> f64 {
    let mut worst: f64 = 0.0;
    for (found, expected) in found.iter().zip(expected) {
        let expected: Vec<f64> = picked.iter().map(|&i| expected[i]).collect();
        for (a, b) in found.iter().zip(&expected) {
            let off = (a - b).abs() / size(&expected);
            worst = worst.max(if off.is_nan() { f64::INFINITY } else { off });
        }
    }
    worst
}

/// Over ten thousand steps both accumulate rounding in their own way, up to ε a step at worst, and the motion magnifies it:
/// about the middle axis of a free body exponentially. How far that leads is seen on the model itself, from a start that is
/// 16 ε off; ten thousand random roundings are a hundred of one.
#[test]
fn scenes_take_the_steps_of_their_models() {
    assert!(SCENES.len() >= 5);
    for entry in SCENES {
        let scene = entry.catalogued;
        let h = scene.description.scene.expect("a scene").step;
        let (case, own) = whole(scene);
        let form = scene.solvers[0].solver().form;
        let expected = case.states(solver(case.model, form), h, STEPS);
        let found = Case::of_file(scene).states(scene.solvers[0], h, STEPS);
        assert_eq!(found.len(), expected.len());
        let mut moved = case;
        for x in &mut moved.start {
            *x *= 1.0 + 16.0 * f64::EPSILON;
        }
        let moved = moved.states(solver(moved.model, form), h, STEPS);
        let all: Vec<usize> = (0..expected[0].len()).collect();
        let worst = furthest(&found, &expected, &own);
        let bound = 1e-11 + 10.0 * furthest(&moved, &expected, &all);
        eprintln!("{}: {worst:e} of {bound:e}", entry.name());
        assert!(worst <= bound, "{}: {worst:e} of {bound:e}", entry.name());
    }
}

/// What a scene iterates on takes the steps of all its unknowns and is never given up.
#[test]
fn the_core_of_a_scene_takes_the_steps_of_all_its_unknowns() {
    for entry in SCENES {
        let scene = entry.catalogued;
        let case = Case::of_file(scene);
        let h = scene.description.scene.expect("a scene").step;
        let mut ends = [Vec::new(), Vec::new()];
        for (strategy, end) in [Strategy::Core, Strategy::Full].into_iter().zip(&mut ends) {
            let mut run = case.unobserved(h, 1000);
            run.settings.strategy = strategy;
            let outcome = scene.solvers[0].simulate(&run, &mut |sample| {
                *end = sample.state.to_vec();
                ControlFlow::Continue(())
            });
            let statistics = outcome.unwrap_or_else(|error| panic!("{}: {error}", entry.name()));
            assert_eq!(statistics.fallbacks, 0, "{}, {strategy:?}", entry.name());
        }
        let off = ends[0].iter().zip(&ends[1]).map(|(a, b)| (a - b).abs());
        let off = off.fold(0.0, f64::max) / size(&ends[1]);
        assert!(off <= 1e-10, "{}: {off:e}", entry.name());
    }
}

/// A solver evaluated by the generator's own oracle, by Newton's method in its plainest form.
struct Oracle {
    parameters: Vec<f64>,
    guess: Tape,
    equations: Tape,
    next: Tape,
    jacobian: Vec<(usize, usize)>,
    n: usize,
}

impl Oracle {
    fn new(system: &System, parameters: Vec<f64>) -> Self {
        let entries = system.jacobian.iter().map(|e| e.node);
        let equations: Vec<NodeId> = system.residual.iter().copied().chain(entries).collect();
        Oracle {
            parameters,
            guess: system.dag.tape(&system.guess),
            equations: system.dag.tape(&equations),
            next: system.dag.tape(&system.next),
            jacobian: system.jacobian.iter().map(|e| (e.row, e.col)).collect(),
            n: system.residual.len(),
        }
    }

    fn step(&self, h: f64, t: f64, state: &[f64]) -> Vec<f64> {
        let at = |tape: &Tape, x: &[f64]| {
            tape.evaluate(|leaf| match leaf {
                Leaf::Parameter(i) => self.parameters[i],
                Leaf::StepSize => h,
                Leaf::Time => t,
                Leaf::State(i) => state[i],
                Leaf::Unknown(i) => x[i],
                Leaf::Variation(_) => f64::NAN,
            })
        };
        let mut x = at(&self.guess, &[]);
        for _ in 0..8 {
            let values = at(&self.equations, &x);
            let mut j = DMatrix::zeros(self.n, self.n);
            for (&(row, col), value) in self.jacobian.iter().zip(&values[self.n..]) {
                j[(row, col)] = *value;
            }
            let r = DVector::from_column_slice(&values[..self.n]);
            let Some(correction) = j.lu().solve(&r) else {
                return vec![f64::NAN; state.len()];
            };
            x.iter_mut().zip(&correction).for_each(|(x, d)| *x -= d);
            if correction.amax() <= 1e-14 * size(&x) {
                break;
            }
        }
        at(&self.next, &x)
    }
}

/// A value as the language writes it.
fn written(values: &[f64], cols: usize) -> String {
    let list = |values: &[f64]| {
        let numbers: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
        format!("[{}]", numbers.join(", "))
    };
    match (values, cols) {
        ([scalar], _) => format!("{scalar:?}"),
        (vector, 1) => list(vector),
        (matrix, cols) => {
            let rows: Vec<String> = matrix.chunks(cols).map(list).collect();
            format!("[{}]", rows.join(", "))
        }
    }
}

/// A scene without `keep`, and one with some: of its parameters some are fixed, some at 0, and of its rates some
/// begin at 0.
fn random_scene(model: &Entry, analysis: &Analysis, rng: &mut StdRng) -> (String, String) {
    let values = analysis.equations.dag.evaluate(|_| f64::NAN);
    let mut text = format!("model {}; step 0.001; until 10;\n", model.name());
    for parameter in &analysis.model.parameters {
        let variable = &parameter.variable;
        let own = variable.offset..variable.offset + variable.shape.len();
        let nodes = analysis.equations.defaults[own].iter();
        let factor = rng.random_range(0.8..1.2);
        let values: Vec<f64> = nodes.map(|n| factor * values[n.index()]).collect();
        let name = &variable.name.display;
        if name == "g" && rng.random_bool(0.2) {
            text += "fix g = 0;\n";
        } else if rng.random_bool(0.7) {
            text += &format!("fix {name} = {};\n", written(&values, variable.shape.cols));
        }
    }
    text += "start {";
    for state in &analysis.model.states {
        let variable = &state.variable;
        if variable.symbols.contains("/s") {
            let component = |_| match rng.random_bool(0.5) {
                true => 0.0,
                false => rng.random_range(-1.0..1.0),
            };
            let values: Vec<f64> = (0..variable.shape.len()).map(component).collect();
            let value = written(&values, variable.shape.cols);
            text += &format!(" {} = {value};", variable.name.display);
        }
    }
    let form = analysis.model.forms[rng.random_range(0..analysis.model.forms.len())];
    text += &format!(" }}\nform {};\n", form.keyword());
    let states = analysis.model.states.iter().map(|s| &s.variable);
    let outputs = analysis.model.outputs.iter().map(|o| &o.variable);
    let all: Vec<&str> = states
        .chain(outputs)
        .map(|v| v.name.display.as_str())
        .collect();
    let kept = all[rng.random_range(0..all.len())];
    let keep = format!("{text}keep {kept};\n");
    (text, keep)
}

fn analysed(text: &str) -> Result<Scene, String> {
    let read = |model: &str| Ok(find(model).expect("a model").source.to_owned());
    analyse_scene("random", lex(text).expect("tokens"), &read).map_err(|e| e.to_string())
}

fn start(scene: &Scene) -> Vec<f64> {
    let defaults = defaults(scene);
    let values = scene.equations.dag.evaluate(|leaf| match leaf {
        Leaf::Parameter(i) => defaults[i],
        _ => f64::NAN,
    });
    let nodes = scene.equations.start.iter();
    nodes.map(|n| values[n.index()]).collect()
}

fn defaults(scene: &Scene) -> Vec<f64> {
    let values = scene.equations.dag.evaluate(|_| f64::NAN);
    let nodes = scene.equations.defaults.iter();
    nodes.map(|n| values[n.index()]).collect()
}

/// What random scenes have in common with their models, and what they are rid of.
#[derive(Default)]
struct Tally {
    scenes: usize,
    unfit: usize,
    zeros: usize,
    dropped: usize,
    split: usize,
}

/// Runs a random scene and its model side by side from the same start.
fn compare(model: &Entry, analysis: &Analysis, rng: &mut StdRng, steps: u64, tally: &mut Tally) {
    let (all, some) = random_scene(model, analysis, rng);
    let (everything, scene) = match (analysed(&all), analysed(&some)) {
        (Ok(everything), Ok(scene)) => (everything, scene),
        (Err(error), _) | (_, Err(error)) => {
            assert!(error.contains("nothing that is kept"), "{error}\n{some}");
            tally.unfit += 1;
            return;
        }
    };
    let mut parameters = {
        let values = analysis.equations.dag.evaluate(|_| f64::NAN);
        let nodes = analysis.equations.defaults.iter();
        nodes.map(|n| values[n.index()]).collect::<Vec<f64>>()
    };
    for (name, fixed) in &scene.receipt.fixed {
        let mut all = analysis.model.parameters.iter();
        let found = all.find(|p| p.variable.name.display == *name);
        let offset = found.expect("a parameter").variable.offset;
        parameters[offset..offset + fixed.len()].copy_from_slice(fixed);
    }
    let form = scene.system.form;
    let mut systems = analysis.systems.iter();
    let system = systems.find(|s| s.form == form).expect("the form");
    let (full, special) = (
        Oracle::new(system, parameters),
        Oracle::new(&scene.system, defaults(&scene)),
    );
    let names = |model: &residua_codegen::model::Model| -> Vec<String> {
        let name = |v: &residua_codegen::model::Variable, i: usize| match v.shape.cols {
            1 => format!("{}{}", v.name.display, v.component_suffix(i)),
            cols => format!("{}({},{})", v.name.display, i / cols + 1, i % cols + 1),
        };
        let variables = model.states.iter().map(|s| &s.variable);
        variables
            .flat_map(|v| (0..v.shape.len()).map(move |i| name(v, i)))
            .collect()
    };
    let all_names = names(&analysis.model);
    let position = |name: &String| all_names.iter().position(|n| n == name).expect(name);
    let own: Vec<usize> = names(&scene.model).iter().map(position).collect();
    tally.scenes += 1;
    tally.zeros += scene.receipt.zeros.len();
    tally.dropped += all_names.len() - own.len();
    let is_split = |s: &residua_codegen::model::State| s.variable.name.display.contains(['(', '.']);
    tally.split += usize::from(scene.model.states.iter().any(is_split));

    let mut expected = start(&everything);
    let mut found: Vec<f64> = own.iter().map(|&i| expected[i]).collect();
    assert_eq!(found, start(&scene), "{some}");
    let h = 0.001;
    for step in 0..steps {
        expected = full.step(h, step as f64 * h, &expected);
        found = special.step(h, step as f64 * h, &found);
        let scale = size(&expected);
        for (found, &i) in found.iter().zip(&own) {
            let off = (found - expected[i]).abs();
            assert!(
                off <= 1e-9 * scale,
                "{} of\n{some}is {found}, not {} after step {step}",
                all_names[i],
                expected[i]
            );
        }
    }
}

/// Whatever is fixed, zero or kept: the same motion. Ten thousand steps let rounding grow as in
/// [`scenes_take_the_steps_of_their_models`].
#[test]
fn random_scenes_take_the_steps_of_their_models() {
    let mut rng = StdRng::seed_from_u64(12_4910);
    let mut tally = Tally::default();
    for (i, model) in CATALOGUE.iter().enumerate() {
        let tokens = read_source(model.source.as_bytes()).expect("a model");
        let analysis = analyse(model.name(), tokens).expect("a sound model");
        let steps = if i % 5 == 0 { STEPS } else { 100 };
        compare(model, &analysis, &mut rng, steps, &mut tally);
        for _ in 0..5 {
            compare(model, &analysis, &mut rng, 100, &mut tally);
        }
    }
    let Tally {
        scenes,
        unfit,
        zeros,
        dropped,
        split,
    } = tally;
    eprintln!("{scenes} scenes, {unfit} unfit, {zeros} zeros, {dropped} dropped, {split} split");
    assert!(scenes > 80 && zeros > 10 && dropped > 80 && split > 5);
}

/// The paper's body keeps ω.z = 0 by its symmetry. A run that breaks it is refused, by name and with the reason.
#[test]
fn a_run_that_breaks_a_symmetry_is_refused() {
    let scene = find("paper_spatial").expect("the scene").catalogued;
    let zeros = scene.description.scene.expect("a scene").zeros;
    assert_eq!(zeros.iter().map(|z| z.component).collect::<Vec<_>>(), [2]);
    let mut case = Case::of_file(scene);
    case.start[2] = 1e-3;
    let run = case.run(0.01, 10);
    let outcome = scene.solvers[0].simulate(&run, &mut |_| ControlFlow::Continue(()));
    let error = outcome.expect_err("a refusal");
    assert!(matches!(
        error,
        RunError::Invalid(InvalidRun::NotZero { .. })
    ));
    let message = error.to_string();
    for part in ["ω.z is 0.001", "relies on 0", "row 3 of `T1*Δω"] {
        assert!(message.contains(part), "{message}");
    }
    let flow = scene.flow.expect("a flow");
    assert!(
        flow.simulate(residua::erased::Scheme::RungeKutta4, &run, &mut |_| {
            ControlFlow::Continue(())
        })
        .is_err()
    );
}
