//! Evaluates expressions of the model to matrices of nodes.

use crate::ast::ExprId;
use crate::ast::Form;
use crate::ast::Level;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::matrix::Matrix;
use crate::model::Model;
use crate::model::Op;
use crate::model::Shape;
use crate::model::Solved;
use crate::normal::rational;
use crate::system::ClaimedBlock;
use num_rational::BigRational;

/// What time levels and rates stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// In a residual and what goes with it.
    Discrete(Form),
    /// In flow, start, defaults and outputs: rates are the unknowns.
    Continuous,
}

/// A value, or a multiple of an `I` whose size its surroundings decide.
#[derive(Clone, Debug)]
pub(super) enum Value {
    Matrix(Matrix),
    Identity(NodeId),
}

/// The graph under construction and what is already in it.
pub struct Context<'m> {
    pub(super) model: &'m Model,
    meaning: Meaning,
    /// Position of each state's unknown, for states that are solved for.
    unknown_of_state: Vec<usize>,
    /// Position of each own unknown.
    unknown_of_own: Vec<usize>,
    values: Vec<Option<Value>>,
    pub dag: Dag,
    pub errors: Errors,
}

impl<'m> Context<'m> {
    pub fn new(model: &'m Model, meaning: Meaning) -> Self {
        let mut unknown_of_state = vec![0; model.states.len()];
        let mut unknown_of_own = vec![0; model.unknowns.len()];
        let mut offset = 0;
        for &solved in &model.solved {
            match solved {
                Solved::State(i) => unknown_of_state[i] = offset,
                Solved::Own(i) => unknown_of_own[i] = offset,
            }
            offset += model.solved_variable(solved).shape.len();
        }
        Self {
            model,
            meaning,
            unknown_of_state,
            unknown_of_own,
            values: vec![None; model.exprs.len()],
            dag: Dag::new(),
            errors: Errors::default(),
        }
    }

    /// The components of `id`, as many as `shape` says.
    pub fn components(&mut self, id: ExprId, shape: Shape) -> Vec<NodeId> {
        let value = self.value(id);
        match fit(&mut self.dag, &value, shape) {
            Some(matrix) => matrix.entries,
            None => {
                let range = self.model.expr(id).range;
                let (rows, cols) = (shape.rows, shape.cols);
                self.errors
                    .push(range, format!("expected a value of shape [{rows}, {cols}]"));
                vec![self.dag.integer(0); shape.len()]
            }
        }
    }

    /// A block of a claim as written, whatever its shape.
    pub fn claimed(&mut self, id: ExprId) -> ClaimedBlock {
        match self.value(id) {
            Value::Matrix(m) => ClaimedBlock {
                shape: Some(m.shape),
                entries: m.entries,
            },
            Value::Identity(factor) => ClaimedBlock {
                shape: None,
                entries: vec![factor],
            },
        }
    }

    /// The first guess of every unknown: the known state, no increment, or what the file says.
    pub fn guesses(&mut self) -> Vec<NodeId> {
        let model = self.model;
        let mut guesses = Vec::new();
        for &solved in &model.solved {
            let shape = model.solved_variable(solved).shape;
            match solved {
                Solved::Own(i) => guesses.extend(self.components(model.unknowns[i].guess, shape)),
                Solved::State(i) if self.meaning == Meaning::Discrete(Form::Next) => {
                    guesses.extend(self.known(i).entries);
                }
                Solved::State(_) => guesses.extend(vec![self.dag.integer(0); shape.len()]),
            }
        }
        guesses
    }

    /// The state after the step.
    pub fn next_states(&mut self) -> Vec<NodeId> {
        let model = self.model;
        let mut next = Vec::new();
        for (i, state) in model.states.iter().enumerate() {
            match state.update {
                Some(update) => next.extend(self.components(update, state.variable.shape)),
                None => next.extend(self.at_level(i, Level::Next).entries),
            }
        }
        next
    }

    /// The value of `id` and of everything it needs, without recursion.
    fn value(&mut self, id: ExprId) -> Value {
        let mut open = vec![id];
        while let Some(&top) = open.last() {
            let missing: Vec<ExprId> = self
                .dependencies(top)
                .into_iter()
                .filter(|d| self.values[d.index()].is_none())
                .collect();
            if missing.is_empty() {
                open.pop();
                if self.values[top.index()].is_none() {
                    let value = self.evaluate(top);
                    self.values[top.index()] = Some(value);
                }
            } else {
                open.extend(missing.into_iter().rev());
            }
        }
        self.computed(id)
    }

    pub(super) fn computed(&self, id: ExprId) -> Value {
        self.values[id.index()]
            .clone()
            .expect("operands are computed before users")
    }

    /// The expressions whose values `id` is computed from.
    fn dependencies(&self, id: ExprId) -> Vec<ExprId> {
        match &self.model.expr(id).op {
            Op::Number(_) | Op::Pi | Op::Identity | Op::Parameter(_) | Op::Unknown(_) => Vec::new(),
            Op::Variation(_) => Vec::new(),
            Op::Time(_) | Op::StepSize | Op::State(_, Level::Now | Level::Previous) => Vec::new(),
            Op::State(i, Level::Half | Level::Next) | Op::Increment(i) | Op::Rate(i) => {
                let state = &self.model.states[*i];
                let discrete = self.meaning != Meaning::Continuous;
                state
                    .update
                    .filter(|_| discrete && !state.solved)
                    .into_iter()
                    .collect()
            }
            Op::Neg(a) | Op::Transpose(a) | Op::Component(a, _, _) => vec![*a],
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Pow(a, b) => {
                vec![*a, *b]
            }
            Op::Blocks { rows, .. } => rows.concat(),
            Op::Call(_, arguments) => arguments.clone(),
        }
    }

    fn evaluate(&mut self, id: ExprId) -> Value {
        match self.model.expr(id).op.clone() {
            Op::Number(value) => scalar(self.dag.constant(value)),
            Op::Pi => scalar(self.dag.pi()),
            Op::Identity => Value::Identity(self.dag.integer(1)),
            Op::Parameter(i) => {
                let variable = &self.model.parameters[i].variable;
                let leaf = |c| Leaf::Parameter(variable.offset + c);
                Value::Matrix(self.leaves(variable.shape, leaf))
            }
            Op::State(i, level) => Value::Matrix(self.at_level(i, level)),
            Op::Increment(i) => Value::Matrix(self.increment(i)),
            Op::Rate(i) => Value::Matrix(self.rate(i)),
            Op::Unknown(i) => {
                let (shape, offset) = (
                    self.model.unknowns[i].variable.shape,
                    self.unknown_of_own[i],
                );
                Value::Matrix(self.leaves(shape, |c| Leaf::Unknown(offset + c)))
            }
            Op::Variation(solved) => self.variation(id, solved),
            Op::Time(level) => scalar(self.time(level)),
            Op::StepSize => scalar(self.dag.leaf(Leaf::StepSize)),
            Op::Neg(a) => {
                let value = self.computed(a);
                self.map(value, |dag, e| dag.neg(e))
            }
            Op::Add(a, b) => self.combine(id, a, b, |dag, x, y| dag.add(x, y)),
            Op::Sub(a, b) => self.combine(id, a, b, |dag, x, y| dag.sub(x, y)),
            Op::Mul(a, b) => self.multiply(a, b),
            Op::Div(a, b) => self.divide(id, a, b),
            Op::Pow(a, b) => self.raise(id, a, b),
            Op::Transpose(a) => match self.computed(a) {
                Value::Matrix(matrix) => Value::Matrix(matrix.transpose()),
                identity => identity,
            },
            Op::Component(a, row, col) => match self.computed(a) {
                Value::Matrix(matrix) => scalar(matrix.at(row, col)),
                Value::Identity(_) => self.misfit(id),
            },
            Op::Blocks {
                rows,
                heights,
                widths,
            } => self.blocks(id, &rows, &heights, &widths),
            Op::Call(function, arguments) => self.call(id, function, &arguments),
        }
    }

    fn leaves(&mut self, shape: Shape, leaf: impl Fn(usize) -> Leaf) -> Matrix {
        let entries = (0..shape.len()).map(|c| self.dag.leaf(leaf(c))).collect();
        Matrix { shape, entries }
    }

    /// x\[k\]
    fn known(&mut self, i: usize) -> Matrix {
        let variable = &self.model.states[i].variable;
        self.leaves(variable.shape, |c| Leaf::State(variable.offset + c))
    }

    /// The unknown of a solved state: x\[k+1\] or Δx.
    fn unknown(&mut self, i: usize) -> Matrix {
        let (shape, offset) = (
            self.model.states[i].variable.shape,
            self.unknown_of_state[i],
        );
        self.leaves(shape, |c| Leaf::Unknown(offset + c))
    }

    fn at_level(&mut self, i: usize, level: Level) -> Matrix {
        let known = self.known(i);
        match level {
            Level::Now | Level::Previous => known,
            Level::Half => {
                let half = BigRational::new(1.into(), 2.into());
                let next = self.at_level(i, Level::Next);
                known.zip(&next, |x, y| {
                    self.dag.sum([(half.clone(), x), (half.clone(), y)])
                })
            }
            Level::Next => match (self.meaning, self.model.states[i].update) {
                (_, Some(update)) if !self.model.states[i].solved => {
                    let shape = self.model.states[i].variable.shape;
                    Matrix {
                        shape,
                        entries: self.components(update, shape),
                    }
                }
                (Meaning::Discrete(Form::Increment), _) => {
                    let increment = self.unknown(i);
                    known.zip(&increment, |x, dx| self.dag.add(x, dx))
                }
                (Meaning::Discrete(Form::Next) | Meaning::Continuous, _) => self.unknown(i),
            },
        }
    }

    /// δ of the unknown that `solved` brings into the system.
    fn variation(&mut self, id: ExprId, solved: Solved) -> Value {
        let model = self.model;
        if !model.solved.contains(&solved) {
            let name = &model.solved_variable(solved).name.display;
            let message =
                format!("`{name}` is advanced by `update`, so it has no variation of its own");
            self.errors.push(model.expr(id).range, message);
        }
        let offset = match solved {
            Solved::State(i) => self.unknown_of_state[i],
            Solved::Own(i) => self.unknown_of_own[i],
        };
        let shape = model.solved_variable(solved).shape;
        Value::Matrix(self.leaves(shape, |c| Leaf::Variation(offset + c)))
    }

    fn increment(&mut self, i: usize) -> Matrix {
        let known = self.known(i);
        let next = self.at_level(i, Level::Next);
        next.zip(&known, |x, y| self.dag.sub(x, y))
    }

    fn rate(&mut self, i: usize) -> Matrix {
        if self.meaning == Meaning::Continuous {
            let variable = &self.model.states[i].variable;
            return self.leaves(variable.shape, |c| Leaf::Unknown(variable.offset + c));
        }
        let h = self.dag.leaf(Leaf::StepSize);
        self.increment(i).map(|e| self.dag.div(e, h))
    }

    fn time(&mut self, level: Level) -> NodeId {
        let t = self.dag.leaf(Leaf::Time);
        let h = self.dag.leaf(Leaf::StepSize);
        match level {
            Level::Now | Level::Previous => t,
            Level::Half => self
                .dag
                .sum([(rational(1), t), (BigRational::new(1.into(), 2.into()), h)]),
            Level::Next => self.dag.add(t, h),
        }
    }
}

pub(super) fn scalar(node: NodeId) -> Value {
    Value::Matrix(Matrix::scalar(node))
}

/// `value` in `shape`: itself, a multiple of I, or a literal zero spread out.
pub(super) fn fit(dag: &mut Dag, value: &Value, shape: Shape) -> Option<Matrix> {
    match value {
        Value::Matrix(matrix) if matrix.shape == shape => Some(matrix.clone()),
        Value::Matrix(matrix) if matrix.entries.iter().all(|&e| dag.is_zero(e)) => {
            let zero = dag.integer(0);
            Some(Matrix {
                shape,
                entries: vec![zero; shape.len()],
            })
        }
        Value::Matrix(_) => None,
        Value::Identity(factor) => Some(Matrix::diagonal(dag, shape, *factor)),
    }
}
