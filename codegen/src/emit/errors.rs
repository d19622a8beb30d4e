//! What a model with mistakes becomes: one compiler error each, and items that keep callers quiet.

use crate::diagnostic::Diagnostic;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::schedule::Program;
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

/// The one item of which the catalogue knows the name.
pub fn vacant(name: &str) -> TokenStream {
    quote! {
        /// Nothing could be read.
        pub static MODEL: ::residua::Catalogued = ::residua::Catalogued::stub(#name);
    }
}

/// The items of the stand-in for a model with mistakes. The catalogue gets nothing to run.
pub fn stub(model: &Model, program: &Program) -> TokenStream {
    let items = super::items(model, program, &[], None);
    let vacant = vacant(&model.name);
    quote!(#items #vacant)
}
