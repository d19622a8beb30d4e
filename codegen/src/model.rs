//! A checked model: every name resolved, every shape and unit known, `let`s gone.
//!
//! The output of `check`, the input of `lower` and, for names and texts, of `emit`.

use crate::ast::ClaimKind;
use crate::ast::ExprId;
use crate::ast::Form;
use crate::ast::Level;
use crate::ast::Name;
use crate::ast::OutputKind;
use crate::ast::Relation;
use crate::diagnostic::Range;
use crate::function::Function;
use crate::unit::Unit;
use num_rational::BigRational;
use std::fmt;

/// Rows and columns. A scalar is 1×1, a vector n×1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub cols: usize,
}

impl Shape {
    /// 1×1.
    pub const SCALAR: Shape = Shape { rows: 1, cols: 1 };

    /// A column of `n`.
    pub fn vector(n: usize) -> Self {
        Self { rows: n, cols: 1 }
    }

    /// Number of components, never 0; they are numbered row by row.
    #[expect(clippy::len_without_is_empty, reason = "no shape is empty")]
    pub fn len(self) -> usize {
        self.rows * self.cols
    }

    /// True for 1×1.
    pub fn is_scalar(self) -> bool {
        self == Self::SCALAR
    }
}

/// `scalar`, `3-vector` or `2×3 matrix`.
impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.rows, self.cols) {
            (1, 1) => f.write_str("scalar"),
            (n, 1) => write!(f, "{n}-vector"),
            (n, m) => write!(f, "{n}×{m} matrix"),
        }
    }
}

/// What `param`, `state`, `unknown` and outputs have in common.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: Name,
    /// Its shape.
    pub shape: Shape,
    /// Its unit, the same for every component.
    pub unit: Unit,
    /// Its unit as its declaration writes it, or in base units: `J`, `kg*m^2`; `1` without one.
    pub symbols: String,
    /// Its `///` lines.
    pub doc: Vec<String>,
    /// Position of its first component in the flat list of its kind.
    pub offset: usize,
}

impl Variable {
    /// What is appended to the name for a component: nothing for a scalar, `.x` `.y` `.z` for short
    /// vectors, `.4` for long ones, `.12` for the entry in row 1, column 2 of a matrix.
    pub fn component_suffix(&self, component: usize) -> String {
        let Shape { rows, cols } = self.shape;
        let (row, col) = (component / cols, component % cols);
        match (rows, cols) {
            (1, 1) => String::new(),
            (2..=3, 1) => format!(".{}", ["x", "y", "z"][row]),
            (_, 1) => format!(".{}", row + 1),
            _ if rows < 10 && cols < 10 => format!(".{}{}", row + 1, col + 1),
            _ => format!(".{}_{}", row + 1, col + 1),
        }
    }
}

/// A parameter and its default.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name, shape, unit.
    pub variable: Variable,
    /// Default; depends on nothing.
    pub default: ExprId,
}

/// A state, where it starts and how it moves on.
#[derive(Clone, Debug)]
pub struct State {
    /// Name, shape, unit.
    pub variable: Variable,
    /// Start value; depends on parameters only.
    pub start: ExprId,
    /// Whether `x[k+1]` (or `Δx`) is an unknown of the Newton solve.
    pub solved: bool,
    /// Its value after the step, from `update`. Without one it is `x[k+1]`.
    /// Where `solved` is false this is present, and `x[k+1]` anywhere stands for it.
    pub update: Option<ExprId>,
}

/// An unknown that is not a state.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Name, shape, unit.
    pub variable: Variable,
    /// First guess; depends on parameters, h, t and the known state.
    pub guess: ExprId,
}

/// What one block of unknowns belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solved {
    /// The next value or increment of [`Model::states`]`[i]`.
    State(usize),
    /// [`Model::unknowns`]`[i]`.
    Own(usize),
}

/// `lhs = rhs`, both of `shape` (a literal zero or a multiple of `I` takes the other's shape).
#[derive(Clone, Debug)]
pub struct Equation {
    /// Left of `=`.
    pub lhs: ExprId,
    /// Right of `=`.
    pub rhs: ExprId,
    /// Shape of the difference.
    pub shape: Shape,
    /// Source text for reports.
    pub text: String,
    /// Where it stands.
    pub range: Range,
}

/// An invariant or an observable.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name, shape, unit.
    pub variable: Variable,
    /// Which of the two.
    pub kind: OutputKind,
    /// Its value; depends on parameters, h, t and the known state.
    pub value: ExprId,
}

/// What the data of a run must be like.
///
/// Vectors compare component by component. Square matrices compare as quadratic forms (Loewner's order): `A > B` where
/// A − B is symmetric and positive definite, `A >= B` where it may be singular.
#[derive(Clone, Debug)]
pub struct Requirement {
    /// Left of the relation; depends on parameters, h and the state.
    pub lhs: ExprId,
    /// The relation.
    pub relation: Relation,
    /// Right of it, as the left.
    pub rhs: ExprId,
    /// Shape of both.
    pub shape: Shape,
    /// What it means if they do not compare so.
    pub otherwise: String,
    /// Source text of both sides for reports.
    pub text: String,
    /// Where they stand.
    pub range: Range,
}

/// What a paper prints. Whether it has the shape of what it is compared with is not checked: a misfit is a
/// finding.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What it is about.
    pub kind: ClaimKind,
    /// What the author calls it.
    pub label: String,
    /// A difference is an error.
    pub required: bool,
    /// Position in [`Model::claims`] of the claimed residual that a Jacobian belongs to; without it the
    /// Jacobian belongs to the model's own.
    pub of: Option<usize>,
    /// Block rows of a Jacobian as written, with the source text of each block.
    pub blocks: Vec<Vec<(ExprId, String)>>,
    /// What every other kind consists of.
    pub equations: Vec<Equation>,
    /// Where it stands.
    pub range: Range,
}

/// A typed expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// The operation.
    pub op: Op,
    /// Its shape; `None` for a multiple of an `I` whose size its surroundings decide.
    pub shape: Option<Shape>,
    /// Where it stands.
    pub range: Range,
}

/// Vector-level operations.
///
/// Where operands must agree in shape, a literal zero and a multiple of `I` without a size take the
/// other operand's shape.
#[derive(Clone, Debug)]
pub enum Op {
    /// Exact literal, scalar.
    Number(BigRational),
    /// π
    Pi,
    /// `I`
    Identity,
    /// All of a parameter.
    Parameter(usize),
    /// All of a state at a level other than [`Level::Previous`].
    State(usize, Level),
    /// `Δx` of a state.
    Increment(usize),
    /// `der(x)` of a state: `Δx/h` in a residual, the rate itself in a flow.
    Rate(usize),
    /// All of an own unknown.
    Unknown(usize),
    /// `δ(…)` of an unknown.
    Variation(Solved),
    /// `t`
    Time(Level),
    /// `h`
    StepSize,
    /// `-a`
    Neg(ExprId),
    /// `a + b`
    Add(ExprId, ExprId),
    /// `a - b`
    Sub(ExprId, ExprId),
    /// `a * b`: scalar × anything or matrix product.
    Mul(ExprId, ExprId),
    /// `a / b`, b scalar.
    Div(ExprId, ExprId),
    /// `a ^ b`, both scalar.
    Pow(ExprId, ExprId),
    /// `a.T`
    Transpose(ExprId),
    /// One component, row and column counted from 0.
    Component(ExprId, usize, usize),
    /// Blocks with the height of each row and the width of each column.
    Blocks {
        /// Row by row.
        rows: Vec<Vec<ExprId>>,
        /// Height of each block row.
        heights: Vec<usize>,
        /// Width of each block column.
        widths: Vec<usize>,
    },
    /// A function of the language.
    Call(Function, Vec<ExprId>),
}

impl Op {
    /// The expressions it is made of, left to right.
    pub fn operands(&self) -> Vec<ExprId> {
        match self {
            Op::Number(_)
            | Op::Pi
            | Op::Identity
            | Op::Parameter(_)
            | Op::State(..)
            | Op::Increment(_)
            | Op::Rate(_)
            | Op::Unknown(_)
            | Op::Variation(_)
            | Op::Time(_)
            | Op::StepSize => Vec::new(),
            Op::Neg(a) | Op::Transpose(a) | Op::Component(a, ..) => vec![*a],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Pow(a, b) => {
                vec![*a, *b]
            }
            Op::Blocks { rows, .. } => rows.concat(),
            Op::Call(_, arguments) => arguments.clone(),
        }
    }
}

/// A checked model.
#[derive(Clone, Debug)]
pub struct Model {
    /// The stem of its file.
    pub name: String,
    /// Its own doc lines.
    pub doc: Vec<String>,
    /// In file order.
    pub parameters: Vec<Parameter>,
    /// In file order.
    pub states: Vec<State>,
    /// In file order.
    pub unknowns: Vec<Unknown>,
    /// The blocks of the unknown vector, in file order of their declarations.
    pub solved: Vec<Solved>,
    /// Components of these that are no unknowns after all: a scene has found them to be 0, or does without.
    pub absent: Vec<(Solved, usize)>,
    /// Typed expressions, operands before users.
    pub exprs: Vec<Expr>,
    /// The discrete equations, as many components as unknowns.
    pub residual: Vec<Equation>,
    /// The continuous equations, as many components as states; empty if the file gives none.
    pub flow: Vec<Equation>,
    /// Invariants and observables in file order.
    pub outputs: Vec<Output>,
    /// The solvers to emit.
    pub forms: Vec<Form>,
    /// What papers print.
    pub claims: Vec<Claim>,
    /// What the data of a run must be like.
    pub requirements: Vec<Requirement>,
}

impl Model {
    /// The expression behind an id.
    pub fn expr(&self, id: ExprId) -> &Expr {
        &self.exprs[id.index()]
    }

    /// Number of scalar states.
    pub fn n_states(&self) -> usize {
        self.states.iter().map(|s| s.variable.shape.len()).sum()
    }

    /// Number of scalar unknowns.
    pub fn n_unknowns(&self) -> usize {
        self.unknown_components().count()
    }

    /// The scalar unknowns in their order: components of the blocks.
    pub fn unknown_components(&self) -> impl Iterator<Item = (Solved, usize)> + '_ {
        let all = self.solved.iter().flat_map(|&solved| {
            let len = self.solved_variable(solved).shape.len();
            (0..len).map(move |component| (solved, component))
        });
        all.filter(|component| !self.absent.contains(component))
    }

    /// The variable a block of unknowns belongs to.
    pub fn solved_variable(&self, solved: Solved) -> &Variable {
        match solved {
            Solved::State(i) => &self.states[i].variable,
            Solved::Own(i) => &self.unknowns[i].variable,
        }
    }
}
