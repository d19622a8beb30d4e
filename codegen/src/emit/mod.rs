//! From schedules to Rust.
//!
//! In come the checked model (names, units, texts), the schedules of its functions and what came of its
//! claims; out go the items of one module. One file per kind of item.

mod budget;
mod cache;
mod context;
mod description;
mod equations;
mod errors;
mod expression;
mod fillers;
mod flow;
mod model;
mod names;
mod number;
mod phrase;
mod record;
mod requirements;
mod scope;
mod series;
mod solver;
mod statements;
mod variables;

pub use budget::BUDGET;
pub use errors::errors;
pub use errors::stub;
pub use errors::vacant;

use crate::finding::Finding;
use crate::model::Model;
use crate::scene::Receipt;
use crate::schedule::Program;
use proc_macro2::TokenStream;
use quote::quote;
use record::Record;

/// The items of a model: records, traits, description; of a scene if it comes with its receipt.
pub fn emit(
    model: &Model,
    program: &Program,
    findings: &[Finding],
    receipt: Option<&Receipt>,
) -> TokenStream {
    let items = items(model, program, findings, receipt);
    let catalogued = description::catalogued(program);
    let warning = budget::warning(model, program.operations());
    quote!(#items #catalogued #warning)
}

/// All items but `MODEL`.
fn items(
    model: &Model,
    program: &Program,
    findings: &[Finding],
    receipt: Option<&Receipt>,
) -> TokenStream {
    let records = [
        Record::parameters(model),
        Record::state(model),
        Record::outputs(model),
    ];
    let records = records.iter().map(Record::declare);
    let implementation = model::emit(model, program);
    let flow = program
        .flow
        .as_ref()
        .map(|schedule| flow::emit(model, schedule));
    let series = match &program.series {
        Some(Ok(expansion)) => Some(series::emit(model, expansion)),
        Some(Err(_)) | None => None,
    };
    let solvers = program.solvers.iter().enumerate();
    let solvers = solvers.map(|(i, solver)| solver::emit(model, solver, i));
    let description = description::emit(model, program, findings, receipt);
    quote! {
        #(#records)*
        #implementation
        #flow
        #series
        #(#solvers)*
        #description
    }
}

/// What emitted implementations may do although a person would be told not to.
fn allow() -> TokenStream {
    quote! {
        #[allow(non_snake_case, reason = "names as in the model")]
        #[allow(clippy::approx_constant, reason = "numbers as in the model")]
        #[allow(clippy::possible_missing_comma, reason = "all tokens have one place, the invocation")]
        #[allow(clippy::many_single_char_names, clippy::suspicious_operation_groupings, reason = "formulas")]
    }
}
