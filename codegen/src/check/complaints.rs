//! Mistakes found while expressions are typed, so that one gives one message.

use super::advance::counted;
use super::types::Type;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::Name;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::model::Op;
use num_rational::BigRational;
use num_traits::Zero;
use std::collections::btree_map::Entry;

/// A mistake that shows in several places.
pub(super) struct Repeated {
    /// In the first of them.
    first: Diagnostic,
    places: usize,
}

impl<'a> Typing<'a> {
    /// Adds an expression in doubt; the mistake is already reported.
    pub(super) fn poison(&mut self, range: Range) -> ExprId {
        self.push(Op::Number(BigRational::zero()), Type::Poison, range)
    }

    /// Reports a mistake and adds an expression in doubt.
    pub(super) fn fail(&mut self, range: Range, message: impl Into<String>) -> ExprId {
        self.errors.push(range, message);
        self.poison(range)
    }

    /// Reports a mistake with its cure and adds an expression in doubt.
    pub(super) fn fail_with_help(
        &mut self,
        range: Range,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> ExprId {
        self.errors.push_with_help(range, message, help);
        self.poison(range)
    }

    /// Reports a mistake that shows wherever a name is used, and adds an expression in doubt. All
    /// with the same `key` are one mistake.
    pub(super) fn fail_once(
        &mut self,
        key: String,
        range: Range,
        message: String,
        help: Option<String>,
    ) -> ExprId {
        let here = Diagnostic {
            range,
            message,
            help,
        };
        match self.repeated.entry(key) {
            Entry::Vacant(vacant) => {
                vacant.insert(Repeated {
                    first: here,
                    places: 1,
                });
            }
            Entry::Occupied(occupied) => {
                let repeated = occupied.into_mut();
                repeated.places += 1;
                if here.place() < repeated.first.place() {
                    repeated.first = here;
                }
            }
        }
        self.poison(range)
    }

    /// Reports a mistake with an operand. Where that is the value of a `let`, the caret goes `around`
    /// it, the `let` is named, and the same mistake in other places is no other.
    pub(super) fn fail_with(
        &mut self,
        operand: ExprId,
        around: Range,
        message: String,
        help: Option<&str>,
    ) -> ExprId {
        match (self.abbreviation(operand), help) {
            (Some(name), _) => {
                let (shown, line) = (&name.display, name.range.line());
                let advice = help.map_or(String::new(), |help| format!("{help}; "));
                let help = format!("{advice}`{shown}` is the `let` in line {line}");
                self.fail_once(
                    format!("{} {message}", name.ascii),
                    around,
                    message,
                    Some(help),
                )
            }
            (None, Some(help)) => self.fail_with_help(self.range(operand), message, help),
            (None, None) => self.fail(self.range(operand), message),
        }
    }

    /// The name of the `let` that has this value.
    fn abbreviation(&self, value: ExprId) -> Option<&'a Name> {
        let index = *self.lets.get(&value)?;
        Some(self.symbols.list[index].name)
    }

    /// True for the value of a `let`.
    pub(super) fn is_abbreviation(&self, value: ExprId) -> bool {
        self.abbreviation(value).is_some()
    }

    /// Where an operand stands; `around` it where that is the value of a `let`.
    pub(super) fn place(&self, operand: ExprId, around: Range) -> Range {
        match self.abbreviation(operand) {
            Some(_) => around,
            None => self.range(operand),
        }
    }

    /// All mistakes.
    pub(super) fn into_errors(self) -> Errors {
        let mut errors = self.errors;
        for Repeated { mut first, places } in self.repeated.into_values() {
            if places > 1 {
                let more = counted(places - 1, "more place");
                first.message = format!("{}, here and in {more}", first.message);
            }
            errors.add(first);
        }
        errors
    }

    /// Reports a mistake in units, unless they are not compared here.
    pub(super) fn unit_error(&mut self, range: Range, message: String) {
        if !self.lenient {
            self.errors.push(range, message);
        }
    }
}
