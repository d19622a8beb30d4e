//! The model file as written: the output of `parse`, the input of `check`.
//!
//! Names are not resolved and nothing has a shape yet. Expressions live in one flat list, operands
//! before users, so that later passes are loops.

use crate::diagnostic::Range;
use num_rational::BigRational;
use std::fmt;

/// Most rows or columns of a matrix, and most scalar unknowns of a solver: nalgebra has static sizes
/// up to 127, and a dense solve of that size takes a millisecond.
pub const LARGEST_DIMENSION: usize = 127;

/// The words that begin a statement.
pub const KEYWORDS: [&str; 13] = [
    "param",
    "state",
    "unknown",
    "let",
    "flow",
    "residual",
    "solve",
    "update",
    "start",
    "invariant",
    "observe",
    "require",
    "claim",
];

/// An identifier in its two spellings.
///
/// `ω` and `omega` are one name: [`Name::ascii`] decides equality and becomes the Rust identifier,
/// [`Name::display`] is what the author wrote and what users of the model see.
#[derive(Clone, Debug)]
pub struct Name {
    /// ASCII spelling: `omega`, `Gamma1`.
    pub ascii: String,
    /// Spelling in the file: `ω`, `Γ1`.
    pub display: String,
    /// Where it stands.
    pub range: Range,
}

/// Index of an expression in [`Ast::exprs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ExprId(pub u32);

impl ExprId {
    /// The position in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A time level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// `x[k-1]`, reserved for two-step schemes.
    Previous,
    /// `x` or `x[k]`, the known state.
    Now,
    /// `x[k+1/2]`, the mean of now and next.
    Half,
    /// `x[k+1]`, the next state.
    Next,
}

/// An operator between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binary {
    /// `a + b`
    Add,
    /// `a - b`
    Sub,
    /// `a * b`
    Mul,
    /// `a / b`
    Div,
    /// `a ^ b`
    Pow,
}

/// An expression and where it stands.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// From its first token to its last.
    pub range: Range,
}

/// The forms of an expression.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A literal, exact: `9.81` is 981/100.
    Number(BigRational),
    /// `x` (level absent) or `x[k+1]`.
    Name(Name, Option<Level>),
    /// `Δx` or `Delta(x)`.
    Increment(Name),
    /// `ẋ` or `der(x)`.
    Rate(Name),
    /// `-a`
    Neg(ExprId),
    /// `a + b` and its kin.
    Binary(Binary, ExprId, ExprId),
    /// `a.T`
    Transpose(ExprId),
    /// `a.x`, `a.y`, `a.z`: component 1, 2, 3.
    Field(ExprId, usize),
    /// `f(a, b)`; also `x(i)` and `A(i, j)`, which `check` tells from a call by the name.
    Call(Name, Vec<ExprId>),
    /// `a[k+1](i, j)`: components of something that is not a bare name, counted from 1.
    Component(ExprId, Vec<ExprId>),
    /// `[a, b, c]`: stacked below each other.
    Stack(Vec<ExprId>),
    /// `[[a, b], [c, d]]`: block rows.
    Blocks(Vec<Vec<ExprId>>),
}

impl ExprKind {
    /// The expressions it is made of, left to right.
    pub fn operands(&self) -> Vec<ExprId> {
        match self {
            ExprKind::Number(_)
            | ExprKind::Name(..)
            | ExprKind::Increment(_)
            | ExprKind::Rate(_) => Vec::new(),
            ExprKind::Neg(a) | ExprKind::Transpose(a) | ExprKind::Field(a, _) => vec![*a],
            ExprKind::Binary(_, a, b) => vec![*a, *b],
            ExprKind::Call(_, list) | ExprKind::Stack(list) => list.clone(),
            ExprKind::Component(a, indices) => [&[*a], indices.as_slice()].concat(),
            ExprKind::Blocks(rows) => rows.concat(),
        }
    }
}

/// `: [3, 3] kg*m^2` behind a name. Both halves are optional.
#[derive(Clone, Debug, Default)]
pub struct TypeExpr {
    /// `[n]` or `[n, m]`, each with its position.
    pub shape: Option<(Vec<usize>, Option<Range>)>,
    /// The unit, if one is written (`1` counts as written).
    pub unit: Option<UnitExpr>,
}

/// A unit as written: a product of powers.
#[derive(Clone, Debug)]
pub struct UnitExpr {
    /// `(symbol, exponent)`; `1` has none. `m/s^2` is `[(m, 1), (s, -2)]`.
    pub factors: Vec<(Name, (i32, i32))>,
    /// From its first token to its last.
    pub range: Range,
}

/// As written, in ASCII and without blanks: `rad/s`, `N*m`, `kg*m^2/s`, `m^(1/2)`; `1` if there is no
/// factor. Reads back as the same unit.
impl fmt::Display for UnitExpr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.factors.first().is_none_or(|(_, (p, _))| *p < 0) {
            f.write_str("1")?;
        }
        for (i, (symbol, (p, q))) in self.factors.iter().enumerate() {
            match (*p < 0, i) {
                (true, _) => f.write_str("/")?,
                (false, 0) => {}
                (false, _) => f.write_str("*")?,
            }
            // The letter of the ohm is also that of a name.
            let ascii = symbol.ascii.as_str();
            f.write_str(if ascii == "Omega" { "ohm" } else { ascii })?;
            match (p.abs(), *q) {
                (1, 1) => {}
                (p, 1) => write!(f, "^{p}")?,
                (p, q) => write!(f, "^({p}/{q})")?,
            }
        }
        Ok(())
    }
}

/// `lhs = rhs;`
#[derive(Clone, Debug)]
pub struct Equation {
    /// Left of `=`.
    pub lhs: ExprId,
    /// Right of `=`.
    pub rhs: ExprId,
    /// The source text, blanks normalised, for reports.
    pub text: String,
    /// From its first token to its last.
    pub range: Range,
}

/// How the two sides of a requirement compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// `a < b`
    Less,
    /// `a <= b`
    LessOrEqual,
    /// `a > b`
    Greater,
    /// `a >= b`
    GreaterOrEqual,
}

/// `require lhs < rhs else "…";`
#[derive(Clone, Debug)]
pub struct Requirement {
    /// Left of the relation.
    pub lhs: ExprId,
    /// The relation.
    pub relation: Relation,
    /// Right of it.
    pub rhs: ExprId,
    /// What it means if they do not compare so.
    pub otherwise: String,
    /// The source text of both sides, blanks normalised, for reports.
    pub text: String,
    /// Both sides, from the first token to the last.
    pub range: Range,
}

/// `name = value;` in `start` and `update`.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// Left of `=`.
    pub name: Name,
    /// Right of `=`.
    pub value: ExprId,
}

/// Whether an output should stay constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputKind {
    /// `invariant`: constant along solutions of the continuous equations.
    Invariant,
    /// `observe`: anything worth looking at.
    Observable,
}

/// What the unknowns of a solver are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Form {
    /// `solve for next`: `x[k+1]`.
    Next,
    /// `solve for increment`: `Δx`.
    Increment,
}

impl Form {
    /// The word of the language.
    pub fn keyword(self) -> &'static str {
        match self {
            Form::Next => "next",
            Form::Increment => "increment",
        }
    }
}

/// What a claim is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClaimKind {
    /// The derivative of the residual.
    Jacobian,
    /// The discrete equations.
    Residual,
    /// The continuous equations.
    Flow,
    /// An identity.
    Equation,
    /// The variation of the residual.
    Differential,
}

impl ClaimKind {
    /// Every kind.
    pub const ALL: [ClaimKind; 5] = [
        ClaimKind::Jacobian,
        ClaimKind::Residual,
        ClaimKind::Flow,
        ClaimKind::Equation,
        ClaimKind::Differential,
    ];

    /// The word of the language.
    pub fn keyword(self) -> &'static str {
        match self {
            ClaimKind::Jacobian => "jacobian",
            ClaimKind::Residual => "residual",
            ClaimKind::Flow => "flow",
            ClaimKind::Equation => "equation",
            ClaimKind::Differential => "differential",
        }
    }
}

/// `claim jacobian "Eq. 50" { ... }`: what a paper prints.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What it is about.
    pub kind: ClaimKind,
    /// The quoted label.
    pub label: String,
    /// `of "Eq. 86"`: the label of the claimed residual that a Jacobian belongs to.
    pub of: Option<(String, Range)>,
    /// `require` in front: a difference is an error, not a finding.
    pub required: bool,
    /// Block rows of a Jacobian as written, each block with its source text, blanks normalised.
    pub blocks: Vec<Vec<(ExprId, String)>>,
    /// What every other kind consists of.
    pub equations: Vec<Equation>,
    /// From `claim` to the closing brace.
    pub range: Range,
}

/// `param`, `state` and `unknown` share this.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Its name.
    pub name: Name,
    /// Shape and unit.
    pub ty: TypeExpr,
    /// `= value`: default of a parameter, first guess of an unknown; absent for a state.
    pub value: Option<ExprId>,
}

/// `invariant` and `observe`.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Which of the two.
    pub kind: OutputKind,
    /// Its name.
    pub name: Name,
    /// Shape and unit.
    pub ty: TypeExpr,
    /// Its value.
    pub value: ExprId,
}

/// One statement of the file.
#[derive(Clone, Debug)]
pub enum Item {
    /// `param m: kg = 2;`
    Parameter(Declaration),
    /// `state ω: 1/s;`
    State(Declaration),
    /// `unknown F: [2,2] = I;`
    Unknown(Declaration),
    /// `let e1 = [1, 0];`
    Let(Name, ExprId),
    /// `flow { ... }`
    Flow(Vec<Equation>, Range),
    /// `residual { ... }`
    Residual(Vec<Equation>, Range),
    /// `solve for next, increment;`
    SolveFor(Vec<(Form, Range)>, Range),
    /// `update { ... }`
    Update(Vec<Assignment>, Range),
    /// `start { ... }`
    Start(Vec<Assignment>, Range),
    /// `invariant` or `observe`.
    Output(Output),
    /// `claim jacobian "..." { ... }`
    Claim(Claim),
    /// `require m > 0 else "...";`
    Requirement(Requirement),
}

/// A lone expression, such as a value on the command line.
#[derive(Clone, Debug)]
pub struct Expression {
    /// Its parts, operands before users.
    pub exprs: Vec<Expr>,
    /// All of it.
    pub root: ExprId,
}

/// A parsed model file.
#[derive(Clone, Debug)]
pub struct Ast {
    /// The model's name: the stem of its file.
    pub name: String,
    /// The model's own doc: its `//!` lines, or without them the `///` lines at the very top.
    pub doc: Vec<String>,
    /// The statements in file order.
    pub items: Vec<Item>,
    /// All expressions, operands before users.
    pub exprs: Vec<Expr>,
    /// The whole invocation, for errors about something that is missing.
    pub range: Range,
}
