//! A scene: one run of a model, and what its own solver does without.

use crate::ast::Assignment;
use crate::ast::Expr;
use crate::ast::ExprId;
use crate::ast::Form;
use crate::ast::Name;
use crate::diagnostic::Range;

/// A scene file as written: the output of `parse`, the input of `check`.
#[derive(Clone, Debug)]
pub struct SceneAst {
    /// The stem of its file.
    pub name: String,
    /// Its own doc: its `//!` lines, or without them the `///` lines at the very top.
    pub doc: Vec<String>,
    /// The statements in file order.
    pub items: Vec<SceneItem>,
    /// All expressions, operands before users.
    pub exprs: Vec<Expr>,
    /// The whole invocation, for errors about something that is missing.
    pub range: Range,
}

/// One statement of a scene file.
#[derive(Clone, Debug)]
pub enum SceneItem {
    /// `model NAME;`
    Model(Name),
    /// `fix m = 10;` with the text of the value.
    Fix(Assignment, String),
    /// `let R0 = …;`
    Let(Name, ExprId),
    /// `start { … }`
    Start(Vec<Assignment>, Range),
    /// `step 0.1;`
    Step(ExprId, Range),
    /// `until 100;`
    Until(ExprId, Range),
    /// `keep ω, energy;`
    Keep(Vec<Name>, Range),
    /// `form increment;`
    Form(Form, Range),
}

impl SceneAst {
    /// The name behind the first `model`.
    pub fn model(&self) -> Option<&Name> {
        self.items.iter().find_map(|item| match item {
            SceneItem::Model(name) => Some(name),
            _ => None,
        })
    }
}

/// What a scene wants of its model: the output of `check`, the input of `specialise`.
#[derive(Clone, Debug)]
pub struct Wishes {
    /// For each parameter the text of the value that is folded in, and its line in the scene file.
    pub fixed: Vec<Option<(String, usize)>>,
    /// For each state whether it is wanted.
    pub states: Vec<bool>,
    /// For each output whether it is wanted.
    pub outputs: Vec<bool>,
    /// The solver.
    pub form: Form,
}

/// What became of it, for people.
#[derive(Clone, Debug)]
pub struct Receipt {
    /// The model.
    pub model: String,
    /// The time step.
    pub step: f64,
    /// The end time.
    pub until: f64,
    /// Names of wanted states and outputs.
    pub keep: Vec<String>,
    /// Names of the parameters that are folded in, each with its components row by row.
    pub fixed: Vec<(String, Vec<f64>)>,
    /// Positions in the flat state that stay 0, each with the reason.
    pub zeros: Vec<(usize, String)>,
    /// What of the model is left out.
    pub skipped: Vec<Skipped>,
}

/// Something in a model that a scene does without.
#[derive(Clone, Debug)]
pub struct Skipped {
    /// What it is.
    pub kind: SkippedKind,
    /// Its name or text.
    pub what: String,
    /// Why it can be left out.
    pub reason: String,
    /// Its line in the model file.
    pub line: usize,
}

/// What can be left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkippedKind {
    /// A parameter with a fixed value.
    Parameter,
    /// A state, or components of one.
    State,
    /// A component that stays 0.
    Component,
    /// An unknown of the model's own.
    Unknown,
    /// Rows of an equation.
    Equation,
    /// An output.
    Output,
    /// A requirement.
    Requirement,
    /// The continuous equations.
    Flow,
}

impl SkippedKind {
    /// The word for it.
    pub fn keyword(self) -> &'static str {
        match self {
            SkippedKind::Parameter => "parameter",
            SkippedKind::State => "state",
            SkippedKind::Component => "component",
            SkippedKind::Unknown => "unknown",
            SkippedKind::Equation => "equation",
            SkippedKind::Output => "output",
            SkippedKind::Requirement => "requirement",
            SkippedKind::Flow => "flow",
        }
    }
}
