//! Which names may stand where.
//!
//! A `let` is text: what it may contain depends on where it is used. So the names are followed from
//! each statement through the `let`s.

use super::statements::Statements;
use super::symbols::Builtin;
use super::symbols::Kind;
use super::symbols::Symbols;
use super::typing::Typing;
use crate::ast::ClaimKind;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::Level;
use crate::ast::Name;
use crate::ast::OutputKind;

/// Complains about names that may not stand where they do.
pub(super) fn check_all<'a>(typing: &mut Typing<'a>, statements: &Statements<'a>) {
    check_values(typing, Kind::Parameter, Context::Default);
    check_values(typing, Kind::Unknown, Context::Guess);
    check_values(
        typing,
        Kind::Output(OutputKind::Observable),
        Context::Output,
    );
    if let Some((list, _)) = statements.start {
        let roots = list.iter().map(|a| (Some(&a.name), a.value));
        check(typing, Context::Start, roots.collect());
    }
    if let Some((list, _)) = statements.flow {
        let roots = list.iter().flat_map(|e| [(None, e.lhs), (None, e.rhs)]);
        check(typing, Context::Flow, roots.collect());
    }
    let claims = statements
        .claims
        .iter()
        .filter(|c| c.kind == ClaimKind::Flow);
    let roots = claims
        .flat_map(|claim| &claim.equations)
        .flat_map(|e| [(None, e.lhs), (None, e.rhs)]);
    check(typing, Context::ClaimedFlow, roots.collect());
    let requirements = statements.requirements.iter();
    let roots = requirements.flat_map(|r| [(None, r.lhs), (None, r.rhs)]);
    check(typing, Context::Requirement, roots.collect());
}

/// The same for the values of all declarations of one kind, which stand in `context`.
pub(super) fn check_values(typing: &mut Typing, kind: Kind, context: Context) {
    let values = typing.symbols.of_kind(kind);
    let roots = values.filter_map(|(_, s)| Some((Some(s.name), s.value?)));
    check(typing, context, roots.collect());
}

/// An expression and the name that it gives a value to, if there is one.
type Root<'a> = (Option<&'a Name>, ExprId);

/// A statement that may not contain all names. The residual, the update and claims about them may.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Context {
    Default,
    Guess,
    Start,
    Flow,
    ClaimedFlow,
    Output,
    Requirement,
    /// On the command line.
    Value,
}

impl Context {
    /// The statement in words, `name` being what it gives a value to.
    fn noun(self, name: Option<&Name>) -> String {
        let noun = match self {
            Context::Default => "the default",
            Context::Guess => "the first guess",
            Context::Start => "the start value",
            Context::Flow => "the flow",
            Context::ClaimedFlow => "a claimed flow",
            Context::Output => "the output",
            Context::Requirement => "a requirement",
            Context::Value => return "the value".to_owned(),
        };
        match name {
            Some(name) if self == Context::Output => format!("{noun} `{}`", name.display),
            Some(name) => format!("{noun} of `{}`", name.display),
            None => noun.to_owned(),
        }
    }

    /// What it may contain, in words.
    fn allowed(self) -> &'static str {
        match self {
            Context::Default => {
                "it may contain numbers only; what depends on parameters can be a `let`"
            }
            Context::Guess => "it may contain parameters, h, t and states at step k",
            Context::Start | Context::Value => "it may contain parameters only",
            Context::Flow | Context::ClaimedFlow => {
                "it may contain parameters, t, states and rates, without time levels"
            }
            Context::Output => "it may contain parameters, h, t and states, without time levels",
            Context::Requirement => {
                "it is about the start of a run: it may contain parameters, h and states, without time levels"
            }
        }
    }

    fn allows(self, mention: Mention) -> bool {
        use Mention::*;
        match self {
            Context::Default => false,
            Context::Guess => matches!(
                mention,
                Parameter
                    | StepSize
                    | Time(None | Some(Level::Now))
                    | State(None | Some(Level::Now))
            ),
            Context::Start | Context::Value => mention == Parameter,
            Context::Flow | Context::ClaimedFlow => {
                matches!(mention, Parameter | Rate | Time(None) | State(None))
            }
            Context::Output => matches!(mention, Parameter | StepSize | Time(None) | State(None)),
            Context::Requirement => matches!(mention, Parameter | StepSize | State(None)),
        }
    }
}

/// A name in an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mention {
    Parameter,
    State(Option<Level>),
    Increment,
    Rate,
    Unknown,
    Time(Option<Level>),
    StepSize,
}

/// Looks for names that may not stand in `context`. What is wrong with one that stands there itself,
/// not in a `let`, is told by that, so it gets no type.
fn check<'a>(typing: &mut Typing<'a>, context: Context, roots: Vec<Root<'a>>) {
    let (source, symbols) = (typing.source, typing.symbols);
    // What has been looked at is fine or complained about already.
    let mut seen = vec![false; source.len()];
    for (owner, root) in roots {
        let mut pending: Vec<(ExprId, Option<&Name>)> = vec![(root, None)];
        while let Some((id, through)) = pending.pop() {
            if std::mem::replace(&mut seen[id.index()], true) {
                continue;
            }
            let expr = &source[id.index()];
            pending.extend(expr.kind.operands().into_iter().map(|id| (id, through)));
            if let Some((name, value)) = abbreviation(&expr.kind, symbols) {
                pending.push((value, Some(name)));
            }
            let Some(mention) = mention(&expr.kind, symbols) else {
                continue;
            };
            if context.allows(mention) {
                continue;
            }
            let (noun, shown) = (context.noun(owner), shown(&expr.kind));
            let through = match through {
                Some(name) => format!(", as it does through `let {}`", name.display),
                None => {
                    typing.doubt(id);
                    String::new()
                }
            };
            let message = format!("{noun} cannot contain `{shown}`{through}");
            let help = context.allowed();
            typing.errors.push_with_help(expr.range, message, help);
        }
    }
}

/// The `let` that an expression names, and its value.
fn abbreviation<'a>(kind: &ExprKind, symbols: &Symbols<'a>) -> Option<(&'a Name, ExprId)> {
    let (ExprKind::Name(name, _) | ExprKind::Call(name, _)) = kind else {
        return None;
    };
    let symbol = &symbols.list[symbols.find(name)?];
    let is_let = symbol.kind == Kind::Let && !symbol.contested;
    let value = symbol.value.filter(|_| is_let)?;
    Some((symbol.name, value))
}

/// What an expression names, `let`s and constants aside.
fn mention(kind: &ExprKind, symbols: &Symbols) -> Option<Mention> {
    let (name, level) = match kind {
        ExprKind::Name(name, level) => (name, *level),
        ExprKind::Call(name, _) => (name, None),
        ExprKind::Increment(_) => return Some(Mention::Increment),
        ExprKind::Rate(_) => return Some(Mention::Rate),
        ExprKind::Number(_)
        | ExprKind::Neg(_)
        | ExprKind::Binary(..)
        | ExprKind::Transpose(_)
        | ExprKind::Field(..)
        | ExprKind::Component(..)
        | ExprKind::Stack(_)
        | ExprKind::Blocks(_) => return None,
    };
    if symbols.is_contested(name) {
        return None;
    }
    match Builtin::named(&name.ascii) {
        Some(Builtin::StepSize) => return Some(Mention::StepSize),
        Some(Builtin::Time) => return Some(Mention::Time(level)),
        Some(_) => return None,
        None => {}
    }
    match symbols.list[symbols.find(name)?].kind {
        Kind::Parameter => Some(Mention::Parameter),
        Kind::State => Some(Mention::State(level)),
        Kind::Unknown => Some(Mention::Unknown),
        Kind::Let | Kind::Output(_) => None,
    }
}

/// The name as written.
fn shown(kind: &ExprKind) -> String {
    match kind {
        ExprKind::Name(name, level) => {
            let level = match level {
                None => "",
                Some(Level::Previous) => "[k-1]",
                Some(Level::Now) => "[k]",
                Some(Level::Half) => "[k+1/2]",
                Some(Level::Next) => "[k+1]",
            };
            format!("{}{level}", name.display)
        }
        ExprKind::Call(name, _) => name.display.clone(),
        ExprKind::Increment(name) => format!("Δ{}", name.display),
        ExprKind::Rate(name) => format!("der({})", name.display),
        ExprKind::Number(_)
        | ExprKind::Neg(_)
        | ExprKind::Binary(..)
        | ExprKind::Transpose(_)
        | ExprKind::Field(..)
        | ExprKind::Component(..)
        | ExprKind::Stack(_)
        | ExprKind::Blocks(_) => String::new(),
    }
}
