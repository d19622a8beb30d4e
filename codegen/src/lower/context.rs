//! Evaluates expressions of the model to matrices of nodes.

use super::functions;
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
use num_traits::Signed;
use num_traits::ToPrimitive;

/// Largest exponent a model may write.
const LARGEST_EXPONENT: i64 = 64;

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
enum Value {
    Matrix(Matrix),
    Identity(NodeId),
}

/// The graph under construction and what is already in it.
pub struct Context<'m> {
    model: &'m Model,
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
                open.extend(missing);
            }
        }
        self.computed(id)
    }

    fn computed(&self, id: ExprId) -> Value {
        self.values[id.index()]
            .clone()
            .expect("operands are computed before users")
    }

    /// The expressions whose values `id` is computed from.
    fn dependencies(&self, id: ExprId) -> Vec<ExprId> {
        match &self.model.expr(id).op {
            Op::Number(_) | Op::Pi | Op::Identity | Op::Parameter(_) | Op::Unknown(_) => Vec::new(),
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

    fn map(&mut self, value: Value, mut f: impl FnMut(&mut Dag, NodeId) -> NodeId) -> Value {
        match value {
            Value::Matrix(matrix) => Value::Matrix(matrix.map(|e| f(&mut self.dag, e))),
            Value::Identity(factor) => Value::Identity(f(&mut self.dag, factor)),
        }
    }

    /// a ± b
    fn combine(
        &mut self,
        id: ExprId,
        a: ExprId,
        b: ExprId,
        f: impl Fn(&mut Dag, NodeId, NodeId) -> NodeId,
    ) -> Value {
        let (a, b) = (self.computed(a), self.computed(b));
        let shape = match (&a, &b) {
            (Value::Identity(x), Value::Identity(y)) => {
                return Value::Identity(f(&mut self.dag, *x, *y));
            }
            (Value::Identity(_), Value::Matrix(m)) | (Value::Matrix(m), Value::Identity(_)) => {
                m.shape
            }
            (Value::Matrix(m), Value::Matrix(n)) if m.shape.is_scalar() => n.shape,
            (Value::Matrix(m), Value::Matrix(_)) => m.shape,
        };
        let fitted = (fit(&mut self.dag, &a, shape), fit(&mut self.dag, &b, shape));
        match fitted {
            (Some(a), Some(b)) => Value::Matrix(a.zip(&b, |x, y| f(&mut self.dag, x, y))),
            _ => self.misfit(id),
        }
    }

    fn multiply(&mut self, a: ExprId, b: ExprId) -> Value {
        match (self.computed(a), self.computed(b)) {
            (Value::Matrix(m), other) | (other, Value::Matrix(m)) if m.shape.is_scalar() => {
                self.map(other, |dag, e| dag.mul(m.entries[0], e))
            }
            (Value::Matrix(m), Value::Matrix(n)) => Value::Matrix(m.product(&mut self.dag, &n)),
            (Value::Identity(factor), other) | (other, Value::Identity(factor)) => {
                self.map(other, |dag, e| dag.mul(factor, e))
            }
        }
    }

    fn divide(&mut self, id: ExprId, a: ExprId, b: ExprId) -> Value {
        let Value::Matrix(divisor) = self.computed(b) else {
            return self.misfit(id);
        };
        let divisor = divisor.entries[0];
        if self.dag.is_zero(divisor) {
            self.errors
                .push(self.model.expr(b).range, "division by zero");
            return self.computed(a);
        }
        let value = self.computed(a);
        self.map(value, |dag, e| dag.div(e, divisor))
    }

    fn raise(&mut self, id: ExprId, a: ExprId, b: ExprId) -> Value {
        let (Value::Matrix(base), Value::Matrix(exponent)) = (self.computed(a), self.computed(b))
        else {
            return self.misfit(id);
        };
        let (base, exponent) = (base.entries[0], exponent.entries[0]);
        let value = self.dag.as_constant(exponent).cloned();
        if value
            .as_ref()
            .is_some_and(|e| e.abs() > rational(LARGEST_EXPONENT))
        {
            let message =
                format!("the exponent must be between -{LARGEST_EXPONENT} and {LARGEST_EXPONENT}");
            self.errors.push(self.model.expr(b).range, message);
            return scalar(base);
        }
        if self.dag.is_zero(base) && value.is_some_and(|e| e.to_f64().is_none_or(|e| e <= 0.0)) {
            self.errors.push(
                self.model.expr(id).range,
                "zero to a power that is not positive",
            );
            return scalar(base);
        }
        scalar(self.dag.power(base, exponent))
    }

    fn blocks(
        &mut self,
        id: ExprId,
        rows: &[Vec<ExprId>],
        heights: &[usize],
        widths: &[usize],
    ) -> Value {
        let shape = Shape {
            rows: heights.iter().sum(),
            cols: widths.iter().sum(),
        };
        let mut entries = Vec::with_capacity(shape.len());
        for (row, &height) in rows.iter().zip(heights) {
            let mut fitted = Vec::new();
            for (&block, &width) in row.iter().zip(widths) {
                let value = self.computed(block);
                match fit(
                    &mut self.dag,
                    &value,
                    Shape {
                        rows: height,
                        cols: width,
                    },
                ) {
                    Some(matrix) => fitted.push(matrix),
                    None => return self.misfit(id),
                }
            }
            for i in 0..height {
                for block in &fitted {
                    entries.extend((0..block.shape.cols).map(|j| block.at(i, j)));
                }
            }
        }
        Value::Matrix(Matrix { shape, entries })
    }

    fn call(
        &mut self,
        id: ExprId,
        function: crate::function::Function,
        arguments: &[ExprId],
    ) -> Value {
        let mut matrices = Vec::with_capacity(arguments.len());
        for &argument in arguments {
            match self.computed(argument) {
                Value::Matrix(matrix) => matrices.push(matrix),
                Value::Identity(_) => return self.misfit(id),
            }
        }
        match functions::apply(&mut self.dag, function, &matrices) {
            Ok(matrix) => Value::Matrix(matrix),
            Err(message) => {
                self.errors.push(self.model.expr(id).range, message);
                let shape = self.model.expr(id).shape.unwrap_or(Shape::SCALAR);
                Value::Matrix(Matrix {
                    shape,
                    entries: vec![self.dag.integer(0); shape.len()],
                })
            }
        }
    }

    /// Where the size of an `I` cannot be told.
    fn misfit(&mut self, id: ExprId) -> Value {
        self.errors.push_with_help(
            self.model.expr(id).range,
            "the size of `I` cannot be told here",
            "write the matrix out, for example diag(1, 1, 1)",
        );
        scalar(self.dag.integer(0))
    }
}

fn scalar(node: NodeId) -> Value {
    Value::Matrix(Matrix::scalar(node))
}

/// `value` in `shape`: itself, a multiple of I, or a literal zero spread out.
fn fit(dag: &mut Dag, value: &Value, shape: Shape) -> Option<Matrix> {
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
