//! Which names may stand in which statement.

use super::symbols::Builtin;
use super::symbols::Kind;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::Level;
use crate::diagnostic::Range;
use crate::model::Op;
use std::collections::BTreeSet;

/// A statement with an expression in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Context {
    Default,
    Guess,
    Start,
    Flow,
    Residual,
    Update,
    Output,
    Claim,
    Value,
}

impl Context {
    /// The statement in words.
    fn noun(self) -> &'static str {
        match self {
            Context::Default => "the default of a parameter",
            Context::Guess => "a first guess",
            Context::Start => "a start value",
            Context::Flow => "the flow",
            Context::Residual => "the residual",
            Context::Update => "an update",
            Context::Output => "an invariant or observable",
            Context::Claim => "a claim",
            Context::Value => "a value",
        }
    }

    /// What its expressions may contain, in words.
    fn contents(self) -> &'static str {
        match self {
            Context::Default => "numbers only; what depends on other parameters can be a `let`",
            Context::Guess => "parameters, h, t and the known states",
            Context::Start | Context::Value => "parameters only",
            Context::Flow => "parameters, t, states without a time level and their rates der(x)",
            Context::Residual | Context::Update | Context::Claim => "any name",
            Context::Output => "parameters, h, t and states without a time level",
        }
    }

    fn admits(self, op: &Op) -> bool {
        let discrete = matches!(self, Context::Residual | Context::Update | Context::Claim);
        match op {
            Op::Parameter(_) => self != Context::Default,
            Op::StepSize => discrete || matches!(self, Context::Guess | Context::Output),
            Op::State(_, Level::Now) | Op::Time(Level::Now) => {
                discrete || matches!(self, Context::Guess | Context::Output | Context::Flow)
            }
            Op::State(..) | Op::Time(_) | Op::Increment(_) | Op::Unknown(_) => discrete,
            Op::Rate(_) => discrete || self == Context::Flow,
            Op::Number(_)
            | Op::Pi
            | Op::Identity
            | Op::Neg(_)
            | Op::Add(..)
            | Op::Sub(..)
            | Op::Mul(..)
            | Op::Div(..)
            | Op::Pow(..)
            | Op::Transpose(_)
            | Op::Component(..)
            | Op::Blocks { .. }
            | Op::Call(..) => true,
        }
    }
}

impl Typing<'_> {
    /// Types `root` and checks that `context` admits all that is in it, through `let`s too.
    pub(super) fn expression_in(&mut self, root: ExprId, context: Context) -> ExprId {
        let typed = self.expression(root);
        for id in self.reachable(typed) {
            let expr = &self.exprs[id.index()];
            if context.admits(&expr.op) {
                continue;
            }
            let (range, what) = (expr.range, self.what(&expr.op));
            let through = self.through(root, range);
            let message = format!("{} cannot contain {what}{through}", context.noun());
            let help = format!("it may contain {}", context.contents());
            self.errors.push_with_help(range, message, help);
        }
        typed
    }

    /// `id` and all it is made of, in file order.
    pub(super) fn reachable(&self, id: ExprId) -> BTreeSet<ExprId> {
        let mut seen = BTreeSet::new();
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            if seen.insert(id) {
                open.extend(self.exprs[id.index()].op.operands());
            }
        }
        seen
    }

    /// The operation in words.
    fn what(&self, op: &Op) -> String {
        let name = |kind, index: usize| {
            let found = self.symbols.of_kind(kind).find(|(_, s)| s.index == index);
            found.map_or(String::new(), |(_, s)| s.name.display.clone())
        };
        let state = |index: usize| name(Kind::State, index);
        match op {
            Op::Parameter(i) => format!("the parameter `{}`", name(Kind::Parameter, *i)),
            Op::Unknown(i) => format!("the unknown `{}`", name(Kind::Unknown, *i)),
            Op::State(i, Level::Next) => format!("`{}[k+1]`", state(*i)),
            Op::State(i, Level::Half) => format!("`{}[k+1/2]`", state(*i)),
            Op::State(i, _) => format!("the state `{}`", state(*i)),
            Op::Increment(i) => format!("`Δ{}`", state(*i)),
            Op::Rate(i) => format!("`der({})`", state(*i)),
            Op::Time(Level::Now) => format!("{} `t`", Builtin::Time.noun()),
            Op::Time(_) => "another time than `t`".to_owned(),
            _ => format!("{} `h`", Builtin::StepSize.noun()),
        }
    }

    /// Where the expression at `range` is not written in `root` itself: the `let` it stands in.
    fn through(&self, root: ExprId, range: Range) -> String {
        let written = |id: ExprId| self.source[id.index()].range;
        let position = |at: proc_macro2::LineColumn| (at.line, at.column);
        let start = position(range.start.start());
        let inside = |outer: Range| {
            position(outer.start.start()) <= start && start <= position(outer.end.end())
        };
        if inside(written(root)) {
            return String::new();
        }
        let holder = self
            .symbols
            .list
            .iter()
            .find(|s| s.value.is_some_and(|v| inside(written(v))));
        holder.map_or(String::new(), |s| {
            format!(", here through `{}`", s.name.display)
        })
    }
}
