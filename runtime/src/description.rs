//! What a model says about itself.

use core::ops::Range;

/// Everything about a model but its arithmetic.
#[derive(Debug)]
pub struct Description {
    /// The stem of its file.
    pub name: &'static str,
    /// Its doc lines.
    pub doc: &'static str,
    /// In file order.
    pub parameters: &'static [Variable],
    /// In file order.
    pub states: &'static [Variable],
    /// Invariants and observables in file order.
    pub outputs: &'static [Output],
    /// One per form.
    pub solvers: &'static [Solver],
    /// What papers print, compared with the derivative at build time.
    pub claims: &'static [Claim],
    /// What the data of a run must be like, see [`Model::meets`](crate::Model::meets).
    pub requirements: &'static [Requirement],
    /// It has continuous equations.
    pub has_flow: bool,
    /// Why they have no Taylor series, if they have none.
    pub no_series: Option<&'static str>,
    /// Operation counts of what belongs to no solver: outputs, flow.
    pub counts: &'static [(&'static str, Count)],
    /// Operations of all functions, each counted where it stands: what compiling takes its time for.
    pub operations: usize,
    /// The scene that it was made for, if it was made for one.
    pub scene: Option<&'static Scene>,
}

/// A model made for one run.
#[derive(Debug)]
pub struct Scene {
    /// The model that it is a scene of.
    pub model: &'static str,
    /// The time step.
    pub step: f64,
    /// The end time.
    pub until: f64,
    /// Names of the states and outputs that were asked for; the other states are there because these need them.
    pub keep: &'static [&'static str],
    /// Parameters that are folded in.
    pub fixed: &'static [Fixed],
    /// Components of the state that are taken for 0 throughout.
    pub zeros: &'static [Zero],
    /// What of the model is not computed.
    pub skipped: &'static [Skipped],
}

/// A parameter of the model with the value that a scene gives it for good.
#[derive(Debug)]
pub struct Fixed {
    /// As in the model file.
    pub name: &'static str,
    /// Components row by row.
    pub values: &'static [f64],
}

/// A component of the state that starts at 0 and stays there.
#[derive(Debug)]
pub struct Zero {
    /// Its position in the flat state.
    pub component: usize,
    /// Why it stays there.
    pub reason: &'static str,
}

/// Something in a model that a scene does without.
#[derive(Debug)]
pub struct Skipped {
    /// `parameter`, `state`, `component`, `unknown`, `equation`, `output` or `flow`.
    pub kind: &'static str,
    /// Its name or text.
    pub what: &'static str,
    /// Why it can be left out.
    pub reason: &'static str,
    /// Its line in the model file.
    pub line: usize,
}

/// A named quantity.
#[derive(Debug)]
pub struct Variable {
    /// As in the file: `ω`.
    pub name: &'static str,
    /// As in Rust: `omega`.
    pub ascii: &'static str,
    /// Rows.
    pub rows: usize,
    /// Columns; 1 for scalars and vectors.
    pub cols: usize,
    /// Unit as in the file, in ASCII: `rad/s`, `J`; in base SI symbols where the file leaves it open,
    /// `1` without one.
    pub unit: &'static str,
    /// The unit is a number, such as `1` or `rad`.
    pub dimensionless: bool,
    /// Its doc lines.
    pub doc: &'static str,
}

/// An invariant or an observable.
#[derive(Debug)]
pub struct Output {
    /// Name, shape, unit.
    pub variable: Variable,
    /// Constant along solutions of the continuous equations.
    pub invariant: bool,
}

/// What the data of a run must be like.
#[derive(Debug)]
pub struct Requirement {
    /// Its text: `m > 0`.
    pub text: &'static str,
    /// What it means if that does not hold.
    pub otherwise: &'static str,
    /// Its line in the file.
    pub line: usize,
}

/// One solver.
#[derive(Debug)]
pub struct Solver {
    /// `next` or `increment`.
    pub form: &'static str,
    /// The blocks of the unknown vector.
    pub unknowns: &'static [Unknown],
    /// The equations as in the file.
    pub equations: &'static [Equation],
    /// Structural non-zeros of the Jacobian as (row, column), row by row.
    pub pattern: &'static [(usize, usize)],
    /// Operation counts: scene, step, residual, residual and Jacobian, next.
    pub counts: &'static [(&'static str, Count)],
    /// What is iterated on, where that is less.
    pub core: Option<&'static Core>,
}

impl Solver {
    /// The unknowns are what is added to the state.
    pub fn is_increment(&self) -> bool {
        self.form == "increment"
    }

    /// Whether component `i` of the state is among the unknowns, and no `update` gives it another value.
    pub fn solves_for(&self, i: usize) -> bool {
        let mut told = self.unknowns.iter().filter(|block| block.told);
        told.any(|block| block.measure.as_ref().is_some_and(|own| own.contains(&i)))
    }

    /// The components of the state that the unknowns are, in their order; none if the state does not tell all of them.
    pub fn own_states(&self) -> Option<impl Iterator<Item = usize>> {
        let measures = self
            .unknowns
            .iter()
            .filter_map(|block| block.measure.clone());
        let all_told = self.unknowns.iter().all(|block| block.told);
        all_told.then(|| measures.flatten())
    }
}

/// A solver after unknowns that enter linearly are eliminated.
#[derive(Debug)]
pub struct Core {
    /// The unknowns that are left.
    pub unknowns: &'static [Unknown],
    /// The unknowns that are eliminated.
    pub eliminated: &'static [Unknown],
    /// The lines of the equations that are solved for them, each once.
    pub lines: &'static [usize],
    /// Structural non-zeros of the Jacobian as (row, column), row by row.
    pub pattern: &'static [(usize, usize)],
    /// Operation counts, as those of the solver.
    pub counts: &'static [(&'static str, Count)],
}

/// Operations of one function.
#[derive(Debug, Clone, Copy)]
pub struct Count {
    /// `+` and `-`
    pub additions: usize,
    /// `*`
    pub multiplications: usize,
    /// `/`
    pub divisions: usize,
    /// Elementary functions.
    pub calls: usize,
}

/// A block of unknowns.
#[derive(Debug)]
pub struct Unknown {
    /// As in the file: `Δω`, `ω[k+1]`, `F`.
    pub name: &'static str,
    /// Components.
    pub len: usize,
    /// The state that it advances, in the flat state, if it does: what its size is measured by. For some components
    /// of a vector that is all of it.
    pub measure: Option<Range<usize>>,
    /// The state after the step tells it: it is all of that state, and no `update` gives that another value.
    pub told: bool,
}

/// An equation.
#[derive(Debug)]
pub struct Equation {
    /// Its text.
    pub text: &'static str,
    /// Its line in the file.
    pub line: usize,
    /// Components.
    pub len: usize,
}

/// A printed statement and what the generator found.
#[derive(Debug)]
pub struct Claim {
    /// What it is about: `jacobian`, `residual`, `flow`, `equation` or `differential`.
    pub kind: &'static str,
    /// What the author calls it.
    pub label: &'static str,
    /// The label of the claimed residual that a Jacobian belongs to.
    pub of: Option<&'static str>,
    /// Its line in the file.
    pub line: usize,
    /// What differs; empty if the claim is right.
    pub differences: &'static [Difference],
}

/// An entry of a Jacobian, a component of an equation, or a block of the wrong shape, in which a claim is
/// wrong.
#[derive(Debug)]
pub struct Difference {
    /// Row, counted from 0.
    pub row: usize,
    /// Column, counted from 0.
    pub col: usize,
    /// ∂(equation)/∂(unknown), or the component of an equation, in words.
    pub entry: &'static str,
    /// What is printed; the right side of an identity.
    pub printed: &'static str,
    /// What it should be; the left side of an identity.
    pub derived: &'static str,
    /// Values of both at one generic point.
    pub values: (f64, f64),
}
