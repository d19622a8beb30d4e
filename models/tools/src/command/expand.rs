//! `residua expand`: the generated Rust.

use crate::diagnose::{compile_entry, compile_file};
use crate::failure::Failure;
use clap::Args;
use residua_models::find;
use std::io::{self, Write};
use std::path::Path;

/// Print the Rust that is generated from a model or a scene
#[derive(Args)]
pub struct Expand {
    /// A model or scene from `residua list`, or the path of its file
    model: String,
}

impl Expand {
    /// Prints it formatted.
    pub fn run(self) -> Result<(), Failure> {
        let tokens = match as_path(&self.model) {
            Some(path) => compile_file(path)?,
            None => compile_entry(find(&self.model)?)?,
        };
        let file = syn::parse2(tokens)
            .map_err(|error| Failure::Run(format!("the generated code is no Rust: {error}")))?;
        Ok(write!(io::stdout(), "{}", prettyplease::unparse(&file))?)
    }
}

/// `argument` as a path, if it looks like one.
pub fn as_path(argument: &str) -> Option<&Path> {
    let path = Path::new(argument);
    (path.extension().is_some() || path.components().count() > 1).then_some(path)
}
