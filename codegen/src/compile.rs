//! The driver: the one file that names more than one stage.

use crate::ast::Form;
use crate::check::check;
use crate::claims::claims;
use crate::diagnostic::Errors;
use crate::differentiate::differentiate;
use crate::emit::emit;
use crate::emit::errors;
use crate::emit::stub;
use crate::explicit::explicit;
use crate::finding::Finding;
use crate::lower::lower_continuous;
use crate::lower::lower_discrete;
use crate::model::Model;
use crate::parse::parse;
use crate::stage::program;
use crate::structure::structure;
use crate::system::Equations;
use crate::system::System;
use proc_macro2::TokenStream;

/// The Rust items of a model, from the tokens inside `model! { … }`; `name` is the stem of its file.
/// A model with mistakes becomes compiler errors and items that keep callers quiet.
pub fn expand(name: &str, tokens: TokenStream) -> TokenStream {
    match compile(name, tokens) {
        Ok(compiled) => {
            let program = program(&compiled.equations, &compiled.systems);
            emit(&compiled.model, &program, &compiled.findings)
        }
        Err(mistakes) => {
            let mut tokens = errors(mistakes);
            tokens.extend(stub(name));
            tokens
        }
    }
}

/// Everything the generator knows about a model before it emits code.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Names, shapes, units, texts.
    pub model: Model,
    /// Defaults, start, outputs, flow.
    pub equations: Equations,
    /// One solver per form.
    pub systems: Vec<System>,
    /// What came of the claims.
    pub findings: Vec<Finding>,
}

/// Runs the stages up to [`System`] on the tokens inside `model! { … }`.
///
/// # Errors
/// All mistakes of the first stage that finds any.
pub fn compile(name: &str, tokens: TokenStream) -> Result<Compiled, Errors> {
    let model = check(&parse(name, tokens)?)?;
    let equations = continuous(&model)?;
    let mut systems = Vec::new();
    let mut findings = Vec::new();
    for &form in &model.forms {
        let (system, found) = discrete(&model, form)?;
        systems.push(system);
        if findings.is_empty() {
            findings = found;
        }
    }
    Ok(Compiled {
        model,
        equations,
        systems,
        findings,
    })
}

fn continuous(model: &Model) -> Result<Equations, Errors> {
    let mut lowered = lower_continuous(model)?;
    let flow = if model.flow.is_empty() {
        None
    } else {
        let entries = differentiate(&mut lowered.dag, &lowered.flow, model.n_states());
        Some(explicit(model, &mut lowered.dag, &lowered.flow, &entries)?)
    };
    let crate::system::Continuous {
        dag,
        defaults,
        start,
        outputs,
        ..
    } = lowered;
    debug_assert_eq!(dag.verify(), Ok(()));
    Ok(Equations {
        dag,
        defaults,
        start,
        outputs,
        flow,
    })
}

fn discrete(model: &Model, form: Form) -> Result<(System, Vec<Finding>), Errors> {
    let mut lowered = lower_discrete(model, form)?;
    let jacobian = differentiate(&mut lowered.dag, &lowered.residual, model.n_unknowns());
    let blocks = structure(model, &lowered.dag, &jacobian)?;
    let findings = claims(model, &mut lowered, &jacobian)?;
    let crate::system::Discrete {
        dag,
        residual,
        guess,
        next,
        ..
    } = lowered;
    debug_assert_eq!(dag.verify(), Ok(()));
    Ok((
        System {
            form,
            dag,
            residual,
            jacobian,
            guess,
            next,
            blocks,
        },
        findings,
    ))
}
