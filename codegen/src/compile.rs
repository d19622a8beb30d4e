//! The driver: the one module that names more than one stage.

mod scene;

use crate::ast::ClaimKind;
use crate::ast::Form;
use crate::ast::Name;
use crate::ast::TypeExpr;
use crate::change::change;
use crate::check::check;
use crate::check::check_value;
use crate::check::stand_in;
use crate::claims::continuous_claims;
use crate::claims::discrete_claims;
use crate::clear::clear;
use crate::correct::correct;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::differentiate::differentiate;
use crate::eliminate::Full;
use crate::eliminate::eliminate;
use crate::eliminate::pays;
use crate::emit::emit;
use crate::emit::errors;
use crate::emit::stub;
use crate::explicit::explicit;
use crate::finding::Finding;
use crate::finite::finite;
use crate::finite::representable;
use crate::lower::lower_continuous;
use crate::lower::lower_discrete;
use crate::model::Model;
use crate::model::Shape;
use crate::parse::ascii_spelling;
use crate::parse::parse;
use crate::parse::parse_expression;
use crate::parse::parse_leniently;
use crate::parse::parse_unit;
use crate::sample::Typical;
use crate::source::lex;
use crate::stage::program;
use crate::structure::structure;
use crate::system::Block;
use crate::system::Core;
use crate::system::Discrete;
use crate::system::Entry;
use crate::system::Equations;
use crate::system::Series;
use crate::system::System;
use crate::taylor::taylor;
use proc_macro2::Span;
use proc_macro2::TokenStream;

pub use scene::ReadModel;
pub use scene::Scene;
pub use scene::analyse_scene;
pub use scene::compile_scene;
pub use scene::expand_scene;
pub use scene::model_of_scene;

/// The Rust items of a model, from the tokens inside `model! { … }`; `name` is the stem of its file.
/// A model with mistakes becomes compiler errors and items that keep callers quiet.
pub fn expand(name: &str, tokens: TokenStream) -> TokenStream {
    compile(name, tokens.clone()).unwrap_or_else(|mistakes| {
        let mut items = errors(mistakes);
        items.extend(quiet(name, tokens));
        items
    })
}

/// The items of a model with mistakes, so that code that names them gives no errors of its own.
fn quiet(name: &str, tokens: TokenStream) -> TokenStream {
    let model = stand_in(&parse_leniently(name, tokens));
    let Ok((equations, _)) = continuous(&model) else {
        return TokenStream::new();
    };
    let typical = Typical::new(&equations.dag, &equations.defaults);
    let systems = model
        .forms
        .iter()
        .map(|&form| Ok(discrete(&model, form, &typical)?.0));
    match systems.collect::<Result<Vec<System>, Errors>>() {
        Ok(systems) => {
            let series = series(&model, &equations);
            stub(&model, &program(&equations, &systems, series))
        }
        Err(_) => TokenStream::new(),
    }
}

/// The Rust items of a model, from the tokens inside `model! { … }`.
///
/// # Errors
/// All mistakes of the first stage that finds any.
pub fn compile(name: &str, tokens: TokenStream) -> Result<TokenStream, Errors> {
    let analysis = analyse(name, tokens)?;
    let series = series(&analysis.model, &analysis.equations);
    let program = program(&analysis.equations, &analysis.systems, series);
    Ok(emit(&analysis.model, &program, &analysis.findings, None))
}

/// Everything the generator knows about a model before it emits code.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// Names, shapes, units, texts.
    pub model: Model,
    /// Defaults, start, outputs, flow.
    pub equations: Equations,
    /// One solver per form.
    pub systems: Vec<System>,
    /// What came of the claims.
    pub findings: Vec<Finding>,
}

/// Runs the stages up to [`System`].
///
/// # Errors
/// As [`compile`].
pub fn analyse(name: &str, tokens: TokenStream) -> Result<Analysis, Errors> {
    let model = check(&parse(name, tokens)?)?;
    let (equations, mut findings) = continuous(&model)?;
    finite(&model, &equations)?;
    let typical = Typical::new(&equations.dag, &equations.defaults);
    let mut systems = Vec::new();
    for &form in &model.forms {
        let (system, found) = discrete(&model, form, &typical)?;
        systems.push(system);
        // Every form gives the same verdicts; the first to speak names its unknowns.
        for (finding, found) in findings.iter_mut().zip(found) {
            *finding = finding.take().or(found);
        }
    }
    representable(&model, &equations, &systems)?;
    Ok(Analysis {
        model,
        equations,
        systems,
        findings: findings.into_iter().flatten().collect(),
    })
}

/// What can be given a value on the command line, or be named in one.
#[derive(Clone, Copy, Debug)]
pub struct Quantity<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its shape.
    pub shape: Shape,
    /// Its unit, as a model file writes it.
    pub unit: &'a str,
}

/// The components, row by row, of `text` as a value of `target`; it may use `symbols`, each with its
/// components. Units must fit as in a start value: bare numbers carry the unit of `target`.
///
/// # Errors
/// What is wrong with the text, in words.
pub fn evaluate(
    text: &str,
    target: Quantity,
    symbols: &[(Quantity, &[f64])],
) -> Result<Vec<f64>, String> {
    let tokens = lex(text).map_err(|error| error.message)?;
    let expression = parse_expression(tokens).map_err(in_words)?;
    let declared = |quantity: &Quantity| declared(quantity).map_err(in_words);
    let names: Result<Vec<_>, String> = symbols.iter().map(|(q, _)| declared(q)).collect();
    let model = check_value(&expression, &declared(&target)?, &names?).map_err(in_words)?;
    let lowered = lower_continuous(&model).map_err(in_words)?;
    let inputs: Vec<f64> = symbols
        .iter()
        .flat_map(|symbol| symbol.1)
        .copied()
        .collect();
    let values = lowered.dag.evaluate(|leaf| match leaf {
        Leaf::Parameter(i) => inputs[i],
        Leaf::StepSize | Leaf::Time | Leaf::State(_) | Leaf::Unknown(_) | Leaf::Variation(_) => {
            f64::NAN
        }
    });
    Ok(lowered
        .outputs
        .iter()
        .map(|node| values[node.index()])
        .collect())
}

fn declared(quantity: &Quantity) -> Result<(Name, TypeExpr), Errors> {
    let &Quantity { name, shape, unit } = quantity;
    let range = Range::of(Span::call_site());
    let unit = lex(unit).map_err(|error| {
        let mut errors = Errors::default();
        errors.push(range, error.message);
        errors
    })?;
    let name = Name {
        ascii: ascii_spelling(name).unwrap_or_else(|| name.to_owned()),
        display: name.to_owned(),
        range,
    };
    let ty = TypeExpr {
        shape: Some((vec![shape.rows, shape.cols], None)),
        unit: Some(parse_unit(unit)?),
    };
    Ok((name, ty))
}

/// Mistakes in a text of one line.
fn in_words(errors: Errors) -> String {
    let one = |d: Diagnostic| match d.help {
        Some(help) => format!("{} ({help})", d.message),
        None => d.message,
    };
    errors
        .into_sorted()
        .into_iter()
        .map(one)
        .collect::<Vec<_>>()
        .join("; ")
}

fn continuous(model: &Model) -> Result<(Equations, Vec<Option<Finding>>), Errors> {
    let mut lowered = lower_continuous(model)?;
    let typical = Typical::new(&lowered.dag, &lowered.defaults);
    let flow = if model.flow.is_empty() {
        None
    } else {
        let entries = differentiate(&mut lowered.dag, &lowered.flow, model.n_states());
        let rates = explicit(model, &mut lowered.dag, &lowered.flow, &entries, &typical);
        Some(rates?)
    };
    let crate::system::Continuous {
        mut dag,
        defaults,
        start,
        outputs,
        requirements,
        claims,
        ..
    } = lowered;
    let findings = continuous_claims(model, &mut dag, &claims, flow.as_deref(), &typical)?;
    debug_assert_eq!(dag.verify(), Ok(()));
    let equations = Equations {
        dag,
        defaults,
        start,
        outputs,
        requirements,
        flow,
    };
    Ok((equations, findings))
}

/// The Taylor series of the flow, if there is a flow, or why it has none.
fn series(model: &Model, equations: &Equations) -> Option<Result<Series, String>> {
    let rates = equations.flow.as_ref()?;
    Some(taylor(&equations.dag, rates, model.n_states()))
}

fn discrete(
    model: &Model,
    form: Form,
    typical: &Typical,
) -> Result<(System, Vec<Option<Finding>>), Errors> {
    let mut lowered = lower_discrete(model, form)?;
    let n = model.n_unknowns();
    let jacobian = differentiate(&mut lowered.dag, &lowered.residual, n);
    let blocks = structure(model, &lowered.dag, &lowered.residual, &jacobian)?;
    let mut derivatives = vec![Vec::new(); model.claims.len()];
    for (i, claim) in model.claims.iter().enumerate() {
        if claim.kind == ClaimKind::Residual {
            let claimed = &lowered.claims[i].differences;
            derivatives[i] = differentiate(&mut lowered.dag, claimed, n);
        }
    }
    let judged = discrete_claims(model, &mut lowered, &jacobian, &derivatives, typical)?;
    let system = System {
        printed: judged.printed,
        ..system(lowered, jacobian, blocks, typical)
    };
    Ok((system, judged.findings))
}

/// A solver with all that makes it short: what is left to iterate on, its correction, what it adds to the state.
fn system(
    discrete: Discrete,
    jacobian: Vec<Entry>,
    blocks: Vec<Block>,
    typical: &Typical,
) -> System {
    let Discrete {
        form,
        mut dag,
        residual,
        guess,
        next,
        ..
    } = discrete;
    let full = Full {
        residual: &residual,
        jacobian: &jacobian,
        guess: &guess,
        next: &next,
        blocks: &blocks,
        typical,
    };
    let core = core(&mut dag, &full, form);
    let change = added(&mut dag, &next, form);
    let correction = match &core {
        Some(core) => correct(&mut dag, &core.reduced.residual, &core.jacobian, typical),
        None => correct(&mut dag, &residual, &jacobian, typical),
    };
    debug_assert_eq!(dag.verify(), Ok(()));
    System {
        form,
        dag,
        residual,
        jacobian,
        guess,
        next,
        change,
        blocks,
        core,
        correction,
        printed: Vec::new(),
    }
}

/// What is left of a solver after elimination, and its Jacobian.
fn core(dag: &mut Dag, full: &Full, form: Form) -> Option<Core> {
    let mut reduced = eliminate(dag, full)?;
    // The product is less linear than the quotient: only of one equation is a division much of the work.
    if reduced.residual.len() == 1 {
        reduced.residual = clear(dag, &reduced.residual);
    }
    let entries = differentiate(dag, &reduced.residual, full.residual.len()).into_iter();
    let own = entries.filter_map(|entry| {
        let col = reduced.unknowns.iter().position(|&col| col == entry.col)?;
        Some(Entry { col, ..entry })
    });
    let jacobian = own.collect();
    let change = added(dag, &reduced.next, form);
    let core = Core {
        reduced,
        jacobian,
        change,
    };
    pays(dag, &core, full).then_some(core)
}

/// What a step adds to the state, where the unknowns are increments.
fn added(dag: &mut Dag, next: &[NodeId], form: Form) -> Option<Vec<NodeId>> {
    match form {
        Form::Increment => change(dag, next),
        Form::Next => None,
    }
}
