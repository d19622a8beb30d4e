//! Names in expressions: what they stand for and where a time level may follow.

use super::symbols::Builtin;
use super::symbols::Kind;
use super::types::Type;
use super::typing::Meaning;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::Level;
use crate::ast::Name;
use crate::diagnostic::Range;
use crate::function::Function;
use crate::function::NO_CONDITIONALS;
use crate::function::TABLE;
use crate::model::Op;
use crate::similar::most_similar;
use crate::unit::Unit;

/// Functions by other names that they go by.
const ALIASES: &[(&str, &str)] = &[
    ("arctan", "atan(x)"),
    ("arctan2", "atan2(y, x)"),
    ("arcsin", "asin(x)"),
    ("arccos", "acos(x)"),
    ("ln", "log(x)"),
    ("sgn", "sign(x)"),
    ("skew", "S(v)"),
    ("hat", "S(v)"),
    ("tr", "trace(A)"),
    ("transpose", "A.T"),
    ("inverse", "inv(A)"),
    ("pow", "x^n"),
    ("maximum", "max(a, b)"),
    ("minimum", "min(a, b)"),
    ("fmax", "max(a, b)"),
    ("fmin", "min(a, b)"),
    ("expm", "exp(A)"),
];

/// Functions that decide between values, and what to write for those that can be had without.
const CONDITIONALS: &[(&str, &str)] = &[
    ("if", ""),
    ("ifelse", ""),
    ("where", ""),
    ("select", ""),
    ("piecewise", ""),
    ("heaviside", "; heaviside(x) is (1 + sign(x))/2"),
];

impl Typing<'_> {
    /// `x` or `x[k+1]`.
    pub(super) fn name(&mut self, name: &Name, level: Option<Level>, range: Range) -> ExprId {
        if level == Some(Level::Previous) {
            return self.fail(range, "two-step schemes are not supported yet");
        }
        if self.symbols.is_contested(name) {
            return self.poison(range);
        }
        if let Some(builtin) = Builtin::named(&name.ascii) {
            return self.builtin(builtin, name, level, range);
        }
        let Some(index) = self.symbols.find(name) else {
            return self.unknown_name(name, range);
        };
        let symbol = self.symbols.list[index];
        let op = match symbol.kind {
            Kind::State => Op::State(symbol.index, level.unwrap_or(Level::Now)),
            _ if level.is_some() => return self.no_level(name, symbol.kind, range),
            Kind::Parameter => Op::Parameter(symbol.index),
            Kind::Unknown => Op::Unknown(symbol.index),
            Kind::Output(_) => {
                let noun = symbol.kind.noun();
                let message = format!("`{}` is {noun}, which no expression can use", name.display);
                let help = "name its value with `let` and use that in both places";
                return self.fail_with_help(range, message, help);
            }
            Kind::Let => {
                return match self.meanings[index] {
                    Meaning::Value(value) => value,
                    Meaning::Unclear | Meaning::Variable(_) => self.poison(range),
                };
            }
        };
        match self.meanings[index].clone() {
            Meaning::Variable(ty) => self.push(op, ty, range),
            Meaning::Unclear | Meaning::Value(_) => self.poison(range),
        }
    }

    fn builtin(
        &mut self,
        builtin: Builtin,
        name: &Name,
        level: Option<Level>,
        range: Range,
    ) -> ExprId {
        let shown = &name.display;
        if level.is_some() && builtin != Builtin::Time {
            let message = format!("`{shown}` is {}, which has no time level", builtin.noun());
            return self.fail(range, message);
        }
        let second = self.second;
        match builtin {
            Builtin::Pi => self.push(Op::Pi, Type::scalar(Some(Unit::ONE)), range),
            Builtin::Identity => self.push(Op::Identity, Type::Multiple(Some(Unit::ONE)), range),
            Builtin::StepSize => self.push(Op::StepSize, Type::scalar(second), range),
            Builtin::Time => {
                let op = Op::Time(level.unwrap_or(Level::Now));
                self.push(op, Type::scalar(second), range)
            }
            Builtin::Counter => self.fail(
                range,
                "`k` counts the steps and stands only in a time level such as `x[k+1]`",
            ),
            Builtin::Rate | Builtin::Increment => {
                let message = format!("expected the name of one state behind `{shown}`");
                self.fail_with_help(range, message, "write der(x) or Delta(x)")
            }
        }
    }

    /// `Δx`
    pub(super) fn increment(&mut self, name: &Name, range: Range) -> ExprId {
        match self.state("Δ belongs to a state", name, range) {
            Ok((index, ty)) => self.push(Op::Increment(index), ty, range),
            Err(poison) => poison,
        }
    }

    /// `der(x)`, with the unit of `x/t`.
    pub(super) fn rate(&mut self, name: &Name, range: Range) -> ExprId {
        match self.state("der belongs to a state", name, range) {
            Ok((index, ty)) => {
                let second = self.second;
                let ty = ty.map(|unit| unit.and_then(|u| u.over(second?)));
                self.push(Op::Rate(index), ty, range)
            }
            Err(poison) => poison,
        }
    }

    /// The state called `name` and its type; `expected` is what to say if there is none.
    pub(super) fn state(
        &mut self,
        expected: &str,
        name: &Name,
        range: Range,
    ) -> Result<(usize, Type), ExprId> {
        if self.symbols.is_contested(name) {
            return Err(self.poison(range));
        }
        let shown = &name.display;
        let noun = match (Builtin::named(&name.ascii), self.symbols.find(name)) {
            (Some(builtin), _) => builtin.noun(),
            (None, Some(index)) => {
                let symbol = self.symbols.list[index];
                match (symbol.kind, &self.meanings[index]) {
                    (Kind::State, Meaning::Variable(ty)) => return Ok((symbol.index, ty.clone())),
                    (Kind::State, _) => return Err(self.poison(range)),
                    (kind, _) => kind.noun(),
                }
            }
            (None, None) => return Err(self.unknown_name(name, range)),
        };
        let message = format!("{expected}, and `{shown}` is {noun}");
        Err(self.fail(range, message))
    }

    fn no_level(&mut self, name: &Name, kind: Kind, range: Range) -> ExprId {
        let message = format!(
            "`{}` is {}, which has no time level; only states and `t` have one",
            name.display,
            kind.noun()
        );
        let help = match kind {
            Kind::Let => "write the levels inside the `let`, one `let` for each level",
            Kind::Unknown => "the name alone is its value in this step",
            Kind::Parameter => "write the name alone",
            Kind::State | Kind::Output(_) => return self.fail(range, message),
        };
        self.fail_with_help(range, message, help)
    }

    fn unknown_name(&mut self, name: &Name, range: Range) -> ExprId {
        let shown = &name.display;
        if let Some(function) = Function::named(&name.ascii) {
            let message = format!("`{shown}` is a function, expected its arguments in brackets");
            return self.fail_with_help(range, message, format!("write {}(…)", function.name()));
        }
        let message = format!("unknown name `{shown}`");
        let help = self.help_for(name);
        self.fail_once(name.ascii.clone(), range, message, help)
    }

    fn help_for(&self, name: &Name) -> Option<String> {
        match name.ascii.as_str() {
            "e1" => return Some("write `let e1 = [1, 0, 0];`, or [1, 0] in the plane".to_owned()),
            "e2" => return Some("write `let e2 = [0, 1, 0];`, or [0, 1] in the plane".to_owned()),
            "e3" => return Some("write `let e3 = [0, 0, 1];`".to_owned()),
            "e" => return Some("write exp(x) for e^x".to_owned()),
            "T" => return Some("write x.T for the transpose of x".to_owned()),
            _ => {}
        }
        if let Some(similar) = self.symbols.similar(name) {
            return Some(format!("did you mean `{similar}`?"));
        }
        let state = name.ascii.strip_suffix("dot");
        let state = state.map(|state| state.trim_end_matches('_'));
        if let Some(state) = state.filter(|state| !state.is_empty()) {
            return Some(format!("write der({state}) for a rate"));
        }
        let is_unit = name.ascii.len() > 1 && Unit::named(&name.ascii).is_some();
        is_unit.then(|| "a unit stands only behind the colon of a declaration".to_owned())
    }

    /// `f(a, b)` of a name that is neither declared nor a function.
    pub(super) fn unknown_function(&mut self, name: &Name, range: Range) -> ExprId {
        let message = format!("unknown function `{}`", name.display);
        let alias = ALIASES.iter().find(|row| row.0 == name.ascii);
        let key = format!("{}()", name.ascii);
        if let Some((_, usage)) = alias {
            return self.fail_once(key, range, message, Some(format!("write {usage}")));
        }
        let conditional = CONDITIONALS.iter().find(|row| row.0 == name.ascii);
        if let Some((_, instead)) = conditional {
            let help = format!("{NO_CONDITIONALS}{instead}");
            return self.fail_once(key, range, message, Some(help));
        }
        let close = |candidate: &str| strsim::damerau_levenshtein(candidate, &name.ascii) <= 1;
        let functions = TABLE
            .iter()
            .map(|row| row.0)
            .filter(|f| f.len() > 1 && close(f));
        let lower = name.ascii.to_lowercase();
        let similar = most_similar(&lower, functions.map(|f| (f, f)), 0.0);
        let similar = similar.or_else(|| self.symbols.similar(name));
        let help = similar.map(|similar| format!("did you mean `{similar}`?"));
        self.fail_once(key, range, message, help)
    }
}
