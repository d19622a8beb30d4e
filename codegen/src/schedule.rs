//! What is computed where: the output of `stage`, the input of `emit`.

use crate::ast::Form;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::Rate;
use crate::dag::low_digits;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use std::hash::Hash;
use std::hash::Hasher;
use std::mem::discriminant;
use std::ops::AddAssign;

/// Index of a value in its [`Schedule`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ValueId(pub u32);

impl ValueId {
    /// The position in the list.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// How a value comes about. Unlike a node of the graph, a sum or product here is split so that each
/// part is computed at its own rate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Op {
    /// An exact number.
    Constant(BigRational),
    /// π
    Pi,
    /// An input.
    Leaf(Leaf),
    /// Σ cᵢ vᵢ, left to right.
    Sum(Vec<(BigRational, ValueId)>),
    /// c · Π vᵢ / Π wᵢ, left to right; powers are repeated factors or values of their own.
    Product {
        /// Factor in front, 1 if none.
        coefficient: BigRational,
        /// Factors.
        numerator: Vec<ValueId>,
        /// Divisors.
        denominator: Vec<ValueId>,
    },
    /// f(v, …)
    Call(Elementary, Vec<ValueId>),
}

/// A value and when it is computed.
#[derive(Clone, Debug)]
pub struct Value {
    /// How.
    pub op: Op,
    /// When.
    pub rate: Rate,
}

/// A function to emit.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// `residual`, `jacobian`, `flow`, …
    pub name: &'static str,
    /// When it is called.
    pub rate: Rate,
    /// Its results.
    pub roots: Vec<ValueId>,
    /// The values that it computes, operands first, in the order in which the roots need them: those
    /// of its own rate apart from numbers and inputs, and negations of any rate.
    pub body: Vec<ValueId>,
}

/// Additions, multiplications, divisions and calls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

/// Values at their rates.
#[derive(Clone, Debug, Default)]
pub struct Schedule {
    /// All values, operands first.
    pub values: Vec<Value>,
    /// Values of rate Scene that faster code needs: the fields of the scene cache.
    pub scene: Vec<ValueId>,
    /// Values of rate Step that faster code needs: the fields of the step cache.
    pub step: Vec<ValueId>,
    /// The functions to emit; `scene` and `step`, which fill the caches, come first.
    pub kernels: Vec<Kernel>,
}

/// A solver at its rates.
#[derive(Clone, Debug)]
pub struct Solver {
    /// Which unknowns.
    pub form: Form,
    /// Structural non-zeros of the Jacobian as (row, column), row by row.
    pub pattern: Vec<(usize, usize)>,
    /// Kernels `guess`, `residual`, `residual_and_jacobian` and `next`. The roots of
    /// `residual_and_jacobian` are row by row rᵢ and the entries of its row in the pattern. What is iterated on may have a
    /// kernel `correction`, with the growth of rounding as its last root.
    pub schedule: Schedule,
    /// The unknowns, by their positions in the unknown vector of the form: all, or those of a core.
    pub unknowns: Vec<usize>,
    /// The equations that are solved for the other unknowns of the form: none, or those of a core.
    pub solved: Vec<usize>,
    /// What is left after elimination, with a kernel `growth` besides.
    pub core: Option<Box<Solver>>,
}

impl Schedule {
    /// Whether what a kernel computes has kinks or jumps.
    pub fn has_kinks(&self, kernel: &str) -> bool {
        let kernels = self.kernels.iter().filter(|k| k.name == kernel);
        let mut computed = kernels.flat_map(|kernel| &kernel.body);
        computed.any(|value| {
            let op = &self.values[value.index()].op;
            matches!(
                op,
                Op::Call(Elementary::Abs | Elementary::Sign | Elementary::Positive, _)
            )
        })
    }
}

/// Everything that is emitted for one model.
#[derive(Clone, Debug)]
pub struct Program {
    /// Kernel `defaults`.
    pub defaults: Schedule,
    /// Kernel `start`.
    pub start: Schedule,
    /// Kernel `outputs`.
    pub outputs: Schedule,
    /// Kernel `requirement` of each: its left and then its right side.
    pub requirements: Vec<Schedule>,
    /// Kernel `flow`, if the model has one.
    pub flow: Option<Schedule>,
    /// Its Taylor series, or why it has none.
    pub series: Option<Result<Expansion, String>>,
    /// One per form.
    pub solvers: Vec<Solver>,
}

/// Recurrences for Taylor coefficients at their rates: what is of order 0 is of rate Step.
#[derive(Clone, Debug)]
pub struct Expansion {
    /// Kernels `rates` and `starts`, of order 0, `factors` and `next`, of order n: the rates, and aₙ and then bₙ of each
    /// product, and of each inner sum, in full rows.
    pub schedule: Schedule,
    /// Inner sums.
    pub n_sums: usize,
    /// Products.
    pub n_products: usize,
}

impl Expansion {
    /// Lanes that stand in one row.
    pub const ROW: usize = 4;

    /// Rows that so many lanes fill, with zeros at the end.
    pub fn rows(n_lanes: usize) -> usize {
        n_lanes.div_ceil(Self::ROW)
    }
}

/// As derived, but for numbers, of which the hash of a [`BigRational`] takes a continued fraction: they are in lowest
/// terms, and few expressions differ in nothing but large numbers.
impl Hash for Op {
    fn hash<H: Hasher>(&self, state: &mut H) {
        discriminant(self).hash(state);
        match self {
            Op::Constant(value) => low_digits(value).hash(state),
            Op::Pi => {}
            Op::Leaf(leaf) => leaf.hash(state),
            Op::Sum(terms) => {
                for (coefficient, id) in terms {
                    (low_digits(coefficient), id).hash(state);
                }
            }
            Op::Product {
                coefficient,
                numerator,
                denominator,
            } => (
                coefficient.numer(),
                coefficient.denom(),
                numerator,
                denominator,
            )
                .hash(state),
            Op::Call(function, arguments) => (function, arguments).hash(state),
        }
    }
}

impl Op {
    /// The values it needs, first to last.
    pub fn operands(&self) -> Vec<ValueId> {
        match self {
            Op::Constant(_) | Op::Pi | Op::Leaf(_) => Vec::new(),
            Op::Sum(terms) => terms.iter().map(|t| t.1).collect(),
            Op::Product {
                numerator,
                denominator,
                ..
            } => numerator.iter().chain(denominator).copied().collect(),
            Op::Call(_, arguments) => arguments.clone(),
        }
    }

    /// A number or an input: there is nothing to compute.
    pub fn is_given(&self) -> bool {
        matches!(self, Op::Constant(_) | Op::Pi | Op::Leaf(_))
    }

    /// A number that is written where it is used.
    pub fn is_number(&self) -> bool {
        matches!(self, Op::Constant(_) | Op::Pi)
    }

    /// −v: costs nothing, so that it is not cached but written where it is used.
    pub fn is_negation(&self) -> bool {
        matches!(self, Op::Sum(terms) if matches!(terms.as_slice(), [(c, _)] if (-c).is_one()))
    }

    /// What it costs. A sign costs nothing.
    pub fn count(&self) -> Count {
        let mut count = Count::default();
        match self {
            Op::Constant(_) | Op::Pi | Op::Leaf(_) => {}
            Op::Sum(terms) => {
                count.additions = terms.len() - 1;
                count.multiplications = terms.iter().filter(|t| !t.0.abs().is_one()).count();
            }
            Op::Product {
                coefficient,
                numerator,
                denominator,
            } => {
                let factors = numerator.len() + usize::from(!coefficient.abs().is_one());
                count.multiplications =
                    factors.saturating_sub(1) + denominator.len().saturating_sub(1);
                count.divisions = usize::from(!denominator.is_empty());
            }
            Op::Call(..) => count.calls = 1,
        }
        count
    }
}

impl Program {
    /// Operations of all functions, each counted where it stands: what `rustc` takes its time for.
    pub fn operations(&self) -> usize {
        let solvers = self.solvers.iter();
        let solvers = solvers.flat_map(|solver| [Some(solver), solver.core.as_deref()]);
        let series = self.series.iter().flatten();
        let schedules = [&self.defaults, &self.start, &self.outputs].into_iter();
        let schedules = schedules.chain(&self.requirements).chain(&self.flow);
        let schedules = schedules.chain(series.map(|expansion| &expansion.schedule));
        let schedules = schedules.chain(solvers.flatten().map(|solver| &solver.schedule));
        let mut count = Count::default();
        for schedule in schedules {
            for kernel in &schedule.kernels {
                count += schedule.count(kernel);
            }
        }
        count.total()
    }
}

impl Schedule {
    /// The value behind an id.
    pub fn value(&self, id: ValueId) -> &Value {
        &self.values[id.index()]
    }

    /// The kernel called `name`.
    pub fn kernel(&self, name: &str) -> Option<&Kernel> {
        self.kernels.iter().find(|k| k.name == name)
    }

    /// The operations of one call of `kernel`.
    pub fn count(&self, kernel: &Kernel) -> Count {
        let mut count = Count::default();
        for &id in &kernel.body {
            count += self.value(id).op.count();
        }
        count
    }
}

impl Schedule {
    /// Checks what `emit` relies on: operands stand before users, and a kernel uses only what it has
    /// computed before, inputs of its own rate, numbers and cached values of slower rates.
    ///
    /// # Errors
    /// Says which value breaks which rule.
    pub fn verify(&self) -> Result<(), String> {
        for (i, value) in self.values.iter().enumerate() {
            if value.op.operands().iter().any(|o| o.index() >= i) {
                return Err(format!(
                    "value {i} uses a value that does not stand before it"
                ));
            }
        }
        for kernel in &self.kernels {
            let mut known = vec![false; self.values.len()];
            for (i, value) in self.values.iter().enumerate() {
                known[i] = value.op.is_number() || value.op.is_given() && value.rate == kernel.rate;
            }
            let caches = [(Rate::Scene, &self.scene), (Rate::Step, &self.step)];
            for (rate, cache) in caches.into_iter().filter(|c| c.0 < kernel.rate) {
                for id in cache {
                    known[id.index()] = self.value(*id).rate == rate;
                }
            }
            for id in &kernel.body {
                let operands = self.value(*id).op.operands();
                if let Some(missing) = operands.iter().find(|o| !known[o.index()]) {
                    return Err(format!("{}: {id:?} needs {missing:?}", kernel.name));
                }
                let value = self.value(*id);
                known[id.index()] = value.rate == kernel.rate || value.op.is_negation();
            }
            if let Some(missing) = kernel.roots.iter().find(|r| !known[r.index()]) {
                return Err(format!(
                    "{}: the result {missing:?} is unknown",
                    kernel.name
                ));
            }
        }
        Ok(())
    }
}

impl Count {
    /// Operations of all kinds.
    pub fn total(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.calls
    }
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Count) {
        self.additions += other.additions;
        self.multiplications += other.multiplications;
        self.divisions += other.divisions;
        self.calls += other.calls;
    }
}
