//! Why a command ends early, and its exit code.

use crate::notation::excerpt;
use residua_models::UnknownModel;
use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Why a command ends early.
#[derive(Debug)]
pub enum Failure {
    /// The user asked for something that cannot be: exit code 2.
    Input {
        /// What was found and what was expected.
        message: String,
        /// What to do about it.
        help: Option<String>,
    },
    /// A run or a check failed, or a file could not be written: exit code 1.
    Run(String),
    /// What is wrong has been printed; only the exit code is left.
    Reported(u8),
    /// Nobody reads the output any more, as in `residua list | head`: exit code 0.
    Closed,
}

impl Failure {
    /// Bad usage or input.
    pub fn input(message: impl Into<String>) -> Self {
        Self::Input {
            message: message.into(),
            help: None,
        }
    }

    /// Bad usage or input, and what to do about it.
    pub fn input_with_help(message: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Input {
            message: message.into(),
            help: Some(help.into()),
        }
    }

    /// A name that is none of `known`, with the nearest of them as help.
    pub fn unknown<'n>(message: String, name: &str, known: impl Iterator<Item = &'n str>) -> Self {
        Self::Input {
            message,
            help: residua_models::nearest(name, known).map(did_you_mean),
        }
    }

    /// A file that could not be read or written.
    pub fn file(verb: &str, path: &Path, error: &io::Error) -> Self {
        Self::Run(format!("cannot {verb} {}: {error}", path.display()))
    }

    /// Prints the message and returns the exit code.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Input { message, help } => {
                tell!("error: {message}");
                if let Some(help) = help {
                    tell!("help: {help}");
                }
                ExitCode::from(2)
            }
            Self::Run(message) => {
                tell!("error: {message}");
                ExitCode::from(1)
            }
            Self::Reported(code) => ExitCode::from(code),
            Self::Closed => ExitCode::SUCCESS,
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Closed,
            _ => Self::Run(format!("cannot write the output: {error}")),
        }
    }
}

impl From<UnknownModel> for Failure {
    fn from(unknown: UnknownModel) -> Self {
        let is_path = unknown.name.contains(['/', '\\']) || unknown.name.ends_with(".model");
        let help = match &unknown.nearest {
            Some(name) => did_you_mean(name.clone()),
            None if is_path => "models are compiled in: put the file into models/dsl/, build, and give its name alone".to_owned(),
            None => "`residua list` names all models".to_owned(),
        };
        Self::Input {
            message: format!("there is no model `{}`", excerpt(&unknown.name)),
            help: Some(help),
        }
    }
}

fn did_you_mean(name: String) -> String {
    format!("did you mean `{name}`?")
}
