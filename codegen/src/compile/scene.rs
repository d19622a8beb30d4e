//! The driver for scenes.

use super::Quantity;
use super::continuous;
use super::declared;
use super::quiet;
use super::series;
use super::system;
use crate::ast::Ast;
use crate::ast::Expression;
use crate::ast::Name;
use crate::check::check;
use crate::check::check_value;
use crate::check::set;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::differentiate::differentiate;
use crate::emit::emit;
use crate::emit::errors;
use crate::emit::vacant;
use crate::finite::finite;
use crate::finite::representable;
use crate::lower::lower_continuous;
use crate::lower::lower_discrete;
use crate::model::Model;
use crate::model::Shape;
use crate::parse::parse;
use crate::parse::parse_at;
use crate::parse::parse_scene;
use crate::parse::parse_scene_leniently;
use crate::sample::Typical;
use crate::scene::Receipt;
use crate::scene::Wishes;
use crate::source::read_source;
use crate::specialise::specialise;
use crate::stage::program;
use crate::structure::structure;
use crate::system::Equations;
use crate::system::System;
use proc_macro2::TokenStream;
use proc_macro2::fallback;

/// Gives the text of the model file of a name, or says why there is none.
pub type ReadModel<'a> = &'a dyn Fn(&str) -> Result<String, String>;

/// The model that a scene names, from the tokens inside `scene! { … }`.
pub fn model_of_scene(tokens: TokenStream) -> Option<String> {
    let scene = parse_scene_leniently("", tokens);
    scene.model().map(|name| name.display.clone())
}

/// The Rust items of a scene, from the tokens inside `scene! { … }`; `name` is the stem of its file. A scene with
/// mistakes becomes compiler errors and items that keep callers quiet.
pub fn expand_scene(name: &str, tokens: TokenStream, read: ReadModel) -> TokenStream {
    compile_scene(name, tokens.clone(), read).unwrap_or_else(|mistakes| {
        let mut items = errors(mistakes);
        let text = model_of_scene(tokens).and_then(|model| read(&model).ok());
        let model = text.and_then(|text| read_source(text.as_bytes()).ok());
        items.extend(model.map_or_else(|| vacant(name), |tokens| quiet(name, tokens)));
        items
    })
}

/// The Rust items of a scene.
///
/// # Errors
/// All mistakes of the first stage that finds any.
pub fn compile_scene(
    name: &str,
    tokens: TokenStream,
    read: ReadModel,
) -> Result<TokenStream, Errors> {
    let scene = analyse_scene(name, tokens, read)?;
    let series = series(&scene.model, &scene.equations);
    let program = program(&scene.equations, &[scene.system], series);
    Ok(emit(&scene.model, &program, &[], Some(&scene.receipt)))
}

/// Everything the generator knows about a scene before it emits code.
#[derive(Clone, Debug)]
pub struct Scene {
    /// What of the model is left.
    pub model: Model,
    /// Defaults, start, outputs, flow.
    pub equations: Equations,
    /// The solver.
    pub system: System,
    /// What is not left, and why.
    pub receipt: Receipt,
}

/// Runs the stages up to [`System`].
///
/// # Errors
/// As [`compile_scene`]; all of them point into the scene.
pub fn analyse_scene(name: &str, tokens: TokenStream, read: ReadModel) -> Result<Scene, Errors> {
    let scene = parse_scene(name, tokens)?;
    let Some(named) = scene.model() else {
        let mut errors = Errors::default();
        let help = "write `model NAME;` for the model file NAME.model beside this one";
        errors.push_with_help(scene.range, "the scene names no model", help);
        return Err(errors);
    };
    let place = named.range;
    let (file, placed) = model_file(named, read)?;
    let setting = set(&scene, &placed, &file)?;
    let in_words = |errors: Errors| errors.reworded("the default of", "the value of");
    let mut model = check(&setting.ast).map_err(in_words)?;
    let (equations, _) = continuous(&model)?;
    finite(&model, &equations).map_err(in_words)?;
    let (step, until) = times(&setting.step, &setting.until)?;
    point_into(&file, &mut model);

    let wishes = setting.wishes;
    let mut lowered = lower_discrete(&model, wishes.form).map_err(|errors| errors.at(place))?;
    let n = model.n_unknowns();
    let jacobian = differentiate(&mut lowered.dag, &lowered.residual, n);
    let special = specialise(&model, &equations, &lowered, &jacobian, &wishes);
    let special = special.map_err(|unfit| mistake(place, unfit.to_string()))?;
    let receipt = Receipt {
        model: file.name.clone(),
        step,
        until,
        keep: keep(&file, &wishes),
        fixed: fixed(&model, &equations, &wishes),
        zeros: special.zeros,
        skipped: special.skipped,
    };
    let model = Model {
        name: name.to_owned(),
        doc: scene.doc.clone(),
        ..special.model
    };
    let mut discrete = special.discrete;
    let jacobian = differentiate(&mut discrete.dag, &discrete.residual, model.n_unknowns());
    let blocks = structure(&model, &discrete.dag, &discrete.residual, &jacobian)
        .map_err(|errors| errors.at(place))?;
    let equations = special.equations;
    let typical = Typical::new(&equations.dag, &equations.defaults);
    let system = system(discrete, jacobian, blocks, &typical);
    let systems = std::slice::from_ref(&system);
    representable(&model, &equations, systems).map_err(|errors| errors.at(place))?;
    Ok(Scene {
        model,
        equations,
        system,
        receipt,
    })
}

/// The model that a scene names, and its text as if all of it stood where the scene names it.
fn model_file(named: &Name, read: ReadModel) -> Result<(Model, Ast), Errors> {
    let (name, place) = (&named.display, named.range);
    let missing = |reason| mistake(place, format!("there is no model `{name}`: {reason}"));
    let text = read(name).map_err(missing)?;
    let flawed = |first: &str| mistake(place, format!("the model `{name}` has mistakes: {first}"));
    let first = |errors: Errors| flawed(errors.to_string().lines().next().unwrap_or_default());
    // Inside rustc a text other than the source has no lines; outside it has. Nothing but positions leaves this
    // detour, so nothing is mixed up.
    fallback::force();
    let parsed = read_source(text.as_bytes()).map(|tokens| {
        let file = parse(name, tokens.clone());
        let placed = parse_at(name, tokens, place.start);
        (file, placed)
    });
    fallback::unforce();
    let (file, placed) = parsed.map_err(|error| flawed(&error.to_string()))?;
    let file = check(&file.map_err(first)?).map_err(first)?;
    Ok((file, placed.map_err(first)?))
}

fn mistake(place: Range, message: String) -> Errors {
    let mut errors = Errors::default();
    errors.push(place, message);
    errors
}

/// The step and the end.
fn times(step: &Expression, until: &Expression) -> Result<(f64, f64), Errors> {
    let mut errors = Errors::default();
    let mut positive = |expression: &Expression, what: &str| {
        let place = expression.exprs[expression.root.index()].range;
        let value = seconds(expression)?;
        if !(value > 0.0 && value.is_finite()) {
            let message = format!("the {what} is {value}, expected a number above 0");
            errors.push(place, message);
        }
        Ok::<f64, Errors>(value)
    };
    let (h, end) = (positive(step, "step")?, positive(until, "end time")?);
    if errors.is_empty() && end < h {
        let place = until.exprs[until.root.index()].range;
        let message = format!("the run ends at {end}, before its first step of {h}");
        errors.push(place, message);
    }
    errors.or((h, end))
}

fn seconds(expression: &Expression) -> Result<f64, Errors> {
    let target = declared(&Quantity {
        name: "time",
        shape: Shape::SCALAR,
        unit: "s",
    })?;
    let model = check_value(expression, &target, &[])?;
    let lowered = lower_continuous(&model)?;
    let values = lowered.dag.evaluate(|_| f64::NAN);
    Ok(values[lowered.outputs[0].index()])
}

/// Positions and texts of the file for those of its copy.
fn point_into(file: &Model, model: &mut Model) {
    let parameters = model.parameters.iter_mut().zip(&file.parameters);
    parameters.for_each(|(to, from)| to.variable.name = from.variable.name.clone());
    let states = model.states.iter_mut().zip(&file.states);
    states.for_each(|(to, from)| to.variable.name = from.variable.name.clone());
    let unknowns = model.unknowns.iter_mut().zip(&file.unknowns);
    unknowns.for_each(|(to, from)| to.variable.name = from.variable.name.clone());
    let outputs = model.outputs.iter_mut().zip(&file.outputs);
    outputs.for_each(|(to, from)| to.variable.name = from.variable.name.clone());
    let flow = model.flow.iter_mut().zip(&file.flow);
    let residual = model.residual.iter_mut().zip(&file.residual);
    flow.chain(residual).for_each(|(to, from)| {
        to.range = from.range;
        to.text.clone_from(&from.text);
    });
    let requirements = model.requirements.iter_mut().zip(&file.requirements);
    requirements.for_each(|(to, from)| {
        to.range = from.range;
        to.text.clone_from(&from.text);
    });
}

/// The parameters that are folded in, as numbers.
fn fixed(model: &Model, equations: &Equations, wishes: &Wishes) -> Vec<(String, Vec<f64>)> {
    let values = equations.dag.evaluate(|_| f64::NAN);
    let parameters = model.parameters.iter().zip(&wishes.fixed);
    let fixed = parameters.filter(|(_, fixed)| fixed.is_some());
    fixed
        .map(|(parameter, _)| {
            let variable = &parameter.variable;
            let own = variable.offset..variable.offset + variable.shape.len();
            let values = equations.defaults[own].iter().map(|n| values[n.index()]);
            (variable.name.display.clone(), values.collect())
        })
        .collect()
}

/// The names of what is wanted.
fn keep(model: &Model, wishes: &Wishes) -> Vec<String> {
    let states = model.states.iter().map(|s| &s.variable);
    let outputs = model.outputs.iter().map(|o| &o.variable);
    let wanted = wishes.states.iter().chain(&wishes.outputs);
    let kept = states.chain(outputs).zip(wanted).filter(|v| *v.1);
    kept.map(|(variable, _)| variable.name.display.clone())
        .collect()
}
