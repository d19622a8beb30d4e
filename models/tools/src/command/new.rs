//! `residua new`: a commented model file to start from.

use crate::failure::Failure;
use crate::name;
use clap::Args;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Write a commented model file to start from
#[derive(Args)]
pub struct New {
    /// Name of the model: lower-case letters, digits and `_`
    name: String,
    /// Folder to write to
    #[arg(long, value_name = "FOLDER", default_value = "models/dsl")]
    dir: PathBuf,
}

impl New {
    /// Writes the file, unless there is one.
    pub fn run(self) -> Result<(), Failure> {
        name::check(&self.name).map_err(Failure::input)?;
        if !self.dir.is_dir() {
            return Err(Failure::input_with_help(
                format!("there is no folder {}", self.dir.display()),
                "run this in the root of the workspace, or name another folder with --dir",
            ));
        }
        let path = self.dir.join(format!("{}.model", self.name));
        let mut file = OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&path)
            .map_err(|error| match error.kind() {
                ErrorKind::AlreadyExists => {
                    Failure::input(format!("{} exists already", path.display()))
                }
                _ => Failure::file("write", &path, &error),
            })?;
        file.write_all(include_bytes!("template.model"))
            .map_err(|error| Failure::file("write", &path, &error))?;
        tell!("{} written; next:", path.display());
        tell!("  cargo run --release -- check {}", self.name);
        tell!(
            "  cargo run --release -- simulate {} --plot {}.svg",
            self.name,
            self.name
        );
        Ok(())
    }
}
