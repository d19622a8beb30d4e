//! What is wrong with a model file, and where.
//!
//! User mistakes are values: every stage collects them in [`Errors`], the driver stops between stages.
//! A message says what was found and what was expected, in lower case and without a full stop.

use proc_macro2::Span;
use std::fmt;

/// A stretch of the model file, from its first token to its last.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// The first token.
    pub start: Span,
    /// The last token; equal to `start` for a single token.
    pub end: Span,
}

impl Range {
    /// The range of one token.
    pub fn of(span: Span) -> Self {
        Self {
            start: span,
            end: span,
        }
    }

    /// From the start of `self` to the end of `other`.
    pub fn to(self, other: Range) -> Self {
        Self {
            start: self.start,
            end: other.end,
        }
    }

    /// Line of the first token, counted from 1.
    pub fn line(self) -> usize {
        self.start.start().line
    }
}

/// One mistake.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Where the caret goes.
    pub range: Range,
    /// What was found and what was expected.
    pub message: String,
    /// What to do about it.
    pub help: Option<String>,
}

impl Diagnostic {
    /// Line and column of its first character, for sorting.
    pub fn place(&self) -> (usize, usize) {
        let start = self.range.start.start();
        (start.line, start.column)
    }
}

/// The mistakes of one model, in the order they were found.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    list: Vec<Diagnostic>,
}

impl Errors {
    /// Adds a mistake.
    pub fn push(&mut self, range: Range, message: impl Into<String>) {
        self.list.push(Diagnostic {
            range,
            message: message.into(),
            help: None,
        });
    }

    /// Adds a mistake and what to do about it.
    pub fn push_with_help(
        &mut self,
        range: Range,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.list.push(Diagnostic {
            range,
            message: message.into(),
            help: Some(help.into()),
        });
    }

    /// Adds a mistake that is already written down.
    pub fn add(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// The same mistakes, all of them at `range`: for a text that is not the one to point into.
    pub fn at(mut self, range: Range) -> Self {
        self.list.iter_mut().for_each(|d| d.range = range);
        self
    }

    /// The same mistakes with `old` called `new`.
    pub fn reworded(mut self, old: &str, new: &str) -> Self {
        for diagnostic in &mut self.list {
            diagnostic.message = diagnostic.message.replace(old, new);
        }
        self
    }

    /// Nothing found so far.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The mistakes, in file order.
    pub fn into_sorted(mut self) -> Vec<Diagnostic> {
        self.list.sort_by_key(Diagnostic::place);
        self.list
    }

    /// `value` if nothing was found, the mistakes otherwise.
    pub fn or<T>(self, value: T) -> Result<T, Errors> {
        if self.is_empty() {
            Ok(value)
        } else {
            Err(self)
        }
    }
}

/// `LINE:COLUMN: message` and `  help: …` of each mistake, in file order. Both count from 1.
impl fmt::Display for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for diagnostic in self.clone().into_sorted() {
            let start = diagnostic.range.start.start();
            let (line, column) = (start.line, start.column + 1);
            writeln!(f, "{line}:{column}: {}", diagnostic.message)?;
            if let Some(help) = diagnostic.help {
                writeln!(f, "  help: {help}")?;
            }
        }
        Ok(())
    }
}

impl From<Diagnostic> for Errors {
    fn from(diagnostic: Diagnostic) -> Self {
        Self {
            list: vec![diagnostic],
        }
    }
}
