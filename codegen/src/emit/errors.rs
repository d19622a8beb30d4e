//! What a model with mistakes becomes: one compiler error each, and items that keep callers quiet.

use crate::ast::Form;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::schedule::Program;
use crate::schedule::Schedule;
use crate::schedule::Solver;
use proc_macro2::Delimiter;
use proc_macro2::Group;
use proc_macro2::Literal;
use proc_macro2::TokenStream;
use proc_macro2::TokenTree;
use quote::quote;
use quote::quote_spanned;

/// `compile_error!` for each mistake, in file order.
pub fn errors(errors: Errors) -> TokenStream {
    errors.into_sorted().iter().map(error).collect()
}

/// rustc underlines from the span of the path to that of the braces.
fn error(diagnostic: &Diagnostic) -> TokenStream {
    let (start, end) = (diagnostic.range.start, diagnostic.range.end);
    let text = match &diagnostic.help {
        Some(help) => format!("{}\nhelp: {help}", diagnostic.message),
        None => diagnostic.message.clone(),
    };
    let mut message = Literal::string(&text);
    message.set_span(end);
    let mut braces = Group::new(Delimiter::Brace, TokenTree::from(message).into());
    braces.set_span(end);
    quote_spanned!(start=> ::core::compile_error! #braces)
}

/// The items of a model without variables or equations: code that names them, and asks no more of
/// them than the traits, gives no errors of its own.
pub fn stub(name: &str) -> TokenStream {
    let forms = vec![Form::Next, Form::Increment];
    let program = Program {
        defaults: Schedule::default(),
        start: Schedule::default(),
        outputs: Schedule::default(),
        flow: Some(Schedule::default()),
        solvers: forms.iter().map(|form| solver(*form)).collect(),
    };
    let model = Model {
        name: name.to_owned(),
        doc: Vec::new(),
        parameters: Vec::new(),
        states: Vec::new(),
        unknowns: Vec::new(),
        solved: Vec::new(),
        exprs: Vec::new(),
        residual: Vec::new(),
        flow: Vec::new(),
        outputs: Vec::new(),
        forms,
        claims: Vec::new(),
    };
    let items = super::items(&model, &program, &[]);
    quote! {
        #items

        /// A model with mistakes.
        pub static MODEL: ::residua::Catalogued = ::residua::Catalogued::stub(#name);
    }
}

fn solver(form: Form) -> Solver {
    Solver {
        form,
        pattern: Vec::new(),
        schedule: Schedule::default(),
    }
}
