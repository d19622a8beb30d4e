//! The proc-macro door to the generator.

use proc_macro::Span;
use proc_macro::TokenStream;
use std::path::Path;

/// Turns a model into its solver; see the language reference of `residua-codegen`.
///
/// The model takes its name from the file it stands in.
#[proc_macro]
pub fn model(tokens: TokenStream) -> TokenStream {
    let file = Span::call_site().file();
    let stem = Path::new(&file).file_stem().and_then(|stem| stem.to_str());
    residua_codegen::expand(stem.unwrap_or("model"), tokens.into()).into()
}
