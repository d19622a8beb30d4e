//! The proc-macro door to the generator.

use proc_macro::Span;
use proc_macro::TokenStream;
use std::fs;
use std::path::Path;
use std::path::PathBuf;

/// Turns a model into its solver; see the language reference of `residua-codegen`.
///
/// The model takes its name from the file it stands in.
#[proc_macro]
pub fn model(tokens: TokenStream) -> TokenStream {
    residua_codegen::expand(&stem("model"), tokens.into()).into()
}

/// Turns a scene into the solver of its model for this one run; see the language reference of `residua-codegen`.
///
/// The scene takes its name from the file it stands in, and the model `NAME` is the file `NAME.model` beside it.
#[proc_macro]
pub fn scene(tokens: TokenStream) -> TokenStream {
    let tokens = proc_macro2::TokenStream::from(tokens);
    let model = residua_codegen::model_of_scene(tokens.clone());
    let is_there = model.as_ref().is_some_and(|model| beside(model).is_file());
    let read = |model: &str| {
        let path = beside(model);
        let missing = |error| format!("cannot read `{}`: {error}", path.display());
        fs::read_to_string(&path).map_err(missing)
    };
    let mut items = residua_codegen::expand_scene(&stem("scene"), tokens, &read);
    // Saving the model rebuilds the scene too: rustc keeps track of what is included.
    if let Some(model) = model.filter(|_| is_there) {
        let file = format!("{model}.model");
        items.extend(quote::quote!(
            const _: &str = ::core::include_str!(#file);
        ));
    }
    items.into()
}

/// The name of the file of the invocation, without its ending.
fn stem(otherwise: &str) -> String {
    let file = Span::call_site().file();
    let stem = Path::new(&file).file_stem().and_then(|stem| stem.to_str());
    stem.unwrap_or(otherwise).to_owned()
}

/// A model file in the folder of the invocation.
fn beside(model: &str) -> PathBuf {
    let here = Span::call_site();
    let file = here.local_file();
    let file = file.unwrap_or_else(|| PathBuf::from(here.file()));
    file.with_file_name(format!("{model}.model"))
}
