//! A scene put into its model.
//!
//! Values of the scene take the place of the model's own, and then the model is checked like any other: what is
//! wrong with its names, shapes and units from then on is wrong in the scene.

use super::symbols::Kind;
use super::symbols::complain_if_reserved;
use crate::ast::Assignment;
use crate::ast::Ast;
use crate::ast::Expr;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::Expression;
use crate::ast::Form;
use crate::ast::Item;
use crate::ast::Name;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::model::Model;
use crate::model::Variable;
use crate::scene::SceneAst;
use crate::scene::SceneItem;
use crate::scene::Wishes;
use crate::similar::most_similar;

/// Least Jaro-Winkler similarity of a name to the one that was probably meant.
const SIMILAR: f64 = 0.75;

/// A model with the values of a scene.
#[derive(Clone, Debug)]
pub struct Setting {
    /// What is to be checked, without the claims.
    pub ast: Ast,
    /// What is wanted of it.
    pub wishes: Wishes,
    /// The time step.
    pub step: Expression,
    /// The end time.
    pub until: Expression,
}

/// What a scene says, each at most once.
#[derive(Default)]
struct Said<'a> {
    fixed: Vec<(&'a Assignment, &'a str)>,
    lets: Vec<(&'a Name, ExprId)>,
    start: Option<(&'a [Assignment], Range)>,
    step: Option<(ExprId, Range)>,
    until: Option<(ExprId, Range)>,
    keep: Option<(&'a [Name], Range)>,
    form: Option<(Form, Range)>,
}

/// Puts `scene` into `file`, which is the text of `model` and has no mistakes.
///
/// # Errors
/// Names that the model does not have, statements that are missing or stand twice.
pub fn set(scene: &SceneAst, file: &Ast, model: &Model) -> Result<Setting, Errors> {
    let mut errors = Errors::default();
    let said = collect(scene, &mut errors);
    let fixed = fixed(&said, model, &mut errors);
    let (states, outputs) = kept(&said, model, &mut errors);
    complain_about_lets(&said, model, &mut errors);
    let form = form(&said, model, &mut errors);
    let (Some((step, _)), Some((until, _))) = (said.step, said.until) else {
        complain_if_missing(scene, &said, &mut errors);
        return Err(errors);
    };
    let expression = |root| Expression {
        exprs: scene.exprs.clone(),
        root,
    };
    let wishes = Wishes {
        fixed: fixed
            .iter()
            .map(|f| f.map(|(a, text)| (text.to_owned(), a.name.range.line())))
            .collect(),
        states,
        outputs,
        form,
    };
    errors.or(Setting {
        ast: merged(scene, file, model, &said, &fixed, form),
        wishes,
        step: expression(step),
        until: expression(until),
    })
}

fn collect<'a>(scene: &'a SceneAst, errors: &mut Errors) -> Said<'a> {
    let mut said = Said::default();
    let mut model = None;
    for item in &scene.items {
        match item {
            SceneItem::Model(name) => once(&mut model, (), name.range, "model", errors),
            SceneItem::Fix(assignment, text) => said.fixed.push((assignment, text)),
            SceneItem::Let(name, value) => said.lets.push((name, *value)),
            SceneItem::Start(list, at) => once(&mut said.start, list, *at, "start", errors),
            SceneItem::Step(value, at) => once(&mut said.step, *value, *at, "step", errors),
            SceneItem::Until(value, at) => once(&mut said.until, *value, *at, "until", errors),
            SceneItem::Keep(names, at) => once(&mut said.keep, names, *at, "keep", errors),
            SceneItem::Form(form, at) => once(&mut said.form, *form, *at, "form", errors),
        }
    }
    said
}

fn once<T>(slot: &mut Option<(T, Range)>, value: T, at: Range, word: &str, errors: &mut Errors) {
    match slot {
        None => *slot = Some((value, at)),
        Some((_, first)) => {
            let message = format!("a second `{word}`, the first is in line {}", first.line());
            errors.push(at, message);
        }
    }
}

fn complain_if_missing(scene: &SceneAst, said: &Said, errors: &mut Errors) {
    let place = scene.model().map_or(scene.range, |name| name.range);
    if said.step.is_none() {
        errors.push_with_help(place, "the scene has no `step`", "write `step 0.01;`");
    }
    if said.until.is_none() {
        errors.push_with_help(place, "the scene has no `until`", "write `until 100;`");
    }
}

/// For each parameter what fixes it.
fn fixed<'a>(
    said: &Said<'a>,
    model: &Model,
    errors: &mut Errors,
) -> Vec<Option<(&'a Assignment, &'a str)>> {
    let mut fixed: Vec<Option<(&Assignment, &str)>> = vec![None; model.parameters.len()];
    for &(assignment, text) in &said.fixed {
        let name = &assignment.name;
        let is_meant = |v: &Variable| v.name.ascii == name.ascii;
        let found = model.parameters.iter().position(|p| is_meant(&p.variable));
        let Some(i) = found else {
            let shown = &name.display;
            let message = match named(model, name) {
                Some(noun) => format!("`{shown}` is {noun}, and `fix` takes a parameter"),
                None => format!("the model `{}` has no parameter `{shown}`", model.name),
            };
            let known = model.parameters.iter().map(|p| &p.variable);
            complain(name, message, known, errors);
            continue;
        };
        match fixed[i] {
            None => fixed[i] = Some((assignment, text)),
            Some((first, _)) => {
                let line = first.name.range.line();
                let message = format!("`{}` is fixed twice, first in line {line}", name.display);
                errors.push(name.range, message);
            }
        }
    }
    fixed
}

/// For each state and each output whether it is wanted: without `keep` all are.
fn kept(said: &Said, model: &Model, errors: &mut Errors) -> (Vec<bool>, Vec<bool>) {
    let (n_states, n_outputs) = (model.states.len(), model.outputs.len());
    let Some((names, _)) = said.keep else {
        return (vec![true; n_states], vec![true; n_outputs]);
    };
    let mut states = vec![false; n_states];
    let mut outputs = vec![false; n_outputs];
    for name in names {
        let is_meant = |v: &Variable| v.name.ascii == name.ascii;
        let state = model.states.iter().position(|s| is_meant(&s.variable));
        let output = model.outputs.iter().position(|o| is_meant(&o.variable));
        let slot = match (state, output) {
            (Some(i), _) => &mut states[i],
            (None, Some(i)) => &mut outputs[i],
            (None, None) => {
                let shown = &name.display;
                let message = match named(model, name) {
                    Some(noun) => {
                        format!("`{shown}` is {noun}, and `keep` takes states and outputs")
                    }
                    None => format!(
                        "the model `{}` has no state or output `{shown}`",
                        model.name
                    ),
                };
                let states = model.states.iter().map(|s| &s.variable);
                let known = states.chain(model.outputs.iter().map(|o| &o.variable));
                complain(name, message, known, errors);
                continue;
            }
        };
        if std::mem::replace(slot, true) {
            errors.push(name.range, format!("`{}` is kept twice", name.display));
        }
    }
    (states, outputs)
}

/// A `let` of the scene may have the name of a `let` of the model, which it hides in the scene only.
fn complain_about_lets(said: &Said, model: &Model, errors: &mut Errors) {
    for (name, _) in &said.lets {
        complain_if_reserved(Kind::Let, name, errors);
        if let Some(noun) = named(model, name) {
            let message = format!(
                "`{}` is {noun} of the model, expected another name",
                name.display
            );
            errors.push(name.range, message);
        }
    }
}

fn form(said: &Said, model: &Model, errors: &mut Errors) -> Form {
    let first = model.forms.first().copied().unwrap_or(Form::Increment);
    let Some((form, range)) = said.form else {
        return first;
    };
    if !model.forms.contains(&form) {
        let (name, form, first) = (&model.name, form.keyword(), first.keyword());
        let message = format!("the model `{name}` has no form `{form}`, only `{first}`");
        errors.push(range, message);
    }
    form
}

/// What the model calls by this name, `let`s aside.
fn named(model: &Model, name: &Name) -> Option<&'static str> {
    let is_meant = |v: &Variable| v.name.ascii == name.ascii;
    if model.parameters.iter().any(|p| is_meant(&p.variable)) {
        Some("a parameter")
    } else if model.states.iter().any(|s| is_meant(&s.variable)) {
        Some("a state")
    } else if model.unknowns.iter().any(|u| is_meant(&u.variable)) {
        Some("an unknown")
    } else if model.outputs.iter().any(|o| is_meant(&o.variable)) {
        Some("an output")
    } else {
        None
    }
}

fn complain<'a>(
    name: &Name,
    message: String,
    known: impl Iterator<Item = &'a Variable>,
    errors: &mut Errors,
) {
    let names: Vec<&Name> = known.map(|variable| &variable.name).collect();
    let candidates = names.iter().map(|n| (n.ascii.as_str(), n));
    let best = most_similar(&name.ascii, candidates, SIMILAR);
    let help = match (best, names.as_slice()) {
        (Some(candidate), _) => format!("did you mean `{}`?", candidate.display),
        (None, []) => return errors.push(name.range, message),
        (None, names) => {
            let names: Vec<&str> = names.iter().map(|n| n.display.as_str()).collect();
            format!("there are {}", names.join(", "))
        }
    };
    errors.push_with_help(name.range, message, help);
}

/// The file with the values of the scene, and without claims.
fn merged(
    scene: &SceneAst,
    file: &Ast,
    model: &Model,
    said: &Said,
    fixed: &[Option<(&Assignment, &str)>],
    form: Form,
) -> Ast {
    let by = file.exprs.len();
    let is_let = |name: &Name| said.lets.iter().any(|(n, _)| n.ascii == name.ascii);
    let mut exprs = file.exprs.clone();
    exprs.extend(scene.exprs.iter().map(|expr| Expr {
        kind: moved(&expr.kind, by, &is_let),
        range: expr.range,
    }));
    let mut items = Vec::new();
    let mut parameters = fixed.iter().zip(&model.parameters);
    let start = said.start.map_or(&[][..], |(list, _)| list);
    for item in &file.items {
        match item {
            Item::Parameter(declaration) => {
                let mut declaration = declaration.clone();
                if let Some((Some((assignment, _)), parameter)) = parameters.next() {
                    let shape = parameter.variable.shape;
                    declaration.value = Some(after(assignment.value, by));
                    declaration.name.range = assignment.name.range;
                    declaration.ty.shape = Some((vec![shape.rows, shape.cols], None));
                }
                items.push(Item::Parameter(declaration));
            }
            Item::Start(list, keyword) => {
                let is_replaced =
                    |a: &Assignment| start.iter().any(|s| s.name.ascii == a.name.ascii);
                let own = list.iter().filter(|a| !is_replaced(a)).cloned();
                let new = start.iter().map(|a| Assignment {
                    name: a.name.clone(),
                    value: after(a.value, by),
                });
                let keyword = said.start.map_or(*keyword, |(_, keyword)| keyword);
                items.push(Item::Start(own.chain(new).collect(), keyword));
            }
            Item::SolveFor(_, keyword) => {
                items.push(Item::SolveFor(vec![(form, *keyword)], *keyword));
            }
            Item::Claim(_) => {}
            _ => items.push(item.clone()),
        }
    }
    let lets = said.lets.iter();
    items.extend(lets.map(|(name, value)| Item::Let(of_the_scene(name), after(*value, by))));
    Ast {
        items,
        exprs,
        ..file.clone()
    }
}

/// An expression of the scene behind those of the file.
fn after(id: ExprId, by: usize) -> ExprId {
    ExprId(id.0 + by as u32)
}

/// A `let` of the scene by a name that the model cannot have.
fn of_the_scene(name: &Name) -> Name {
    Name {
        ascii: format!("{} of the scene", name.ascii),
        ..name.clone()
    }
}

/// The same with its operands `by` further on and the `let`s of the scene by their names.
fn moved(kind: &ExprKind, by: usize, is_let: &dyn Fn(&Name) -> bool) -> ExprKind {
    let id = |id: &ExprId| after(*id, by);
    let list = |list: &[ExprId]| list.iter().map(id).collect::<Vec<_>>();
    let named = |name: &Name| {
        if is_let(name) {
            of_the_scene(name)
        } else {
            name.clone()
        }
    };
    match kind {
        ExprKind::Number(_) | ExprKind::Increment(_) | ExprKind::Rate(_) => kind.clone(),
        ExprKind::Name(name, level) => ExprKind::Name(named(name), *level),
        ExprKind::Neg(a) => ExprKind::Neg(id(a)),
        ExprKind::Binary(op, a, b) => ExprKind::Binary(*op, id(a), id(b)),
        ExprKind::Transpose(a) => ExprKind::Transpose(id(a)),
        ExprKind::Field(a, field) => ExprKind::Field(id(a), *field),
        ExprKind::Call(name, arguments) => ExprKind::Call(named(name), list(arguments)),
        ExprKind::Component(a, indices) => ExprKind::Component(id(a), list(indices)),
        ExprKind::Stack(parts) => ExprKind::Stack(list(parts)),
        ExprKind::Blocks(rows) => ExprKind::Blocks(rows.iter().map(|row| list(row)).collect()),
    }
}
