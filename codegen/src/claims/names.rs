//! Leaves, nodes and equations as the model calls them.

use crate::ast::Form;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::model::Equation;
use crate::model::Model;
use crate::model::Solved;
use crate::model::Variable;

/// What it takes to write out an expression.
pub(super) struct Names<'a> {
    pub(super) model: &'a Model,
    /// Which unknowns; none among continuous equations, where they are the rates.
    pub(super) form: Option<Form>,
    pub(super) dag: &'a Dag,
}

impl Names<'_> {
    /// A node in the notation of the language.
    pub(super) fn text(&self, node: NodeId) -> String {
        self.dag.text(node, |leaf| self.leaf(leaf))
    }

    /// `Γ.x`, `Δω`, `h`
    pub(super) fn leaf(&self, leaf: Leaf) -> String {
        let parameters = self.model.parameters.iter().map(|p| &p.variable);
        let states = self.model.states.iter().map(|s| &s.variable);
        match leaf {
            Leaf::StepSize => "h".into(),
            Leaf::Time => "t".into(),
            Leaf::Parameter(i) => component(parameters, i, |name| name.to_owned()),
            Leaf::State(i) => component(states, i, |name| name.to_owned()),
            Leaf::Unknown(i) => match self.form {
                Some(form) => self.unknown(form, i),
                None => component(states, i, |name| format!("der({name})")),
            },
            Leaf::Variation(i) => match self.form {
                Some(form) => format!("δ({})", self.unknown(form, i)),
                None => "?".into(),
            },
        }
    }

    /// Component `row` of `equations`: `equation 2.1`.
    pub(super) fn row(&self, equations: &[Equation], row: usize) -> String {
        let mut offset = 0;
        for (i, equation) in equations.iter().enumerate() {
            let shape = equation.shape;
            if (offset..offset + shape.len()).contains(&row) {
                let within = row - offset;
                let part = match (shape.rows, shape.cols) {
                    (1, 1) => String::new(),
                    (_, 1) => format!(".{}", within + 1),
                    (_, cols) => format!(".{}{}", within / cols + 1, within % cols + 1),
                };
                return format!("equation {}{part}", i + 1);
            }
            offset += shape.len();
        }
        "equation ?".into()
    }

    fn unknown(&self, form: Form, i: usize) -> String {
        let mut offset = 0;
        for &solved in &self.model.solved {
            let variable = self.model.solved_variable(solved);
            if i < offset + variable.shape.len() {
                let suffix = variable.component_suffix(i - offset);
                let name = &variable.name.display;
                return match (solved, form) {
                    (Solved::Own(_), _) => format!("{name}{suffix}"),
                    (Solved::State(_), Form::Next) => format!("{name}[k+1]{suffix}"),
                    (Solved::State(_), Form::Increment) => format!("Δ{name}{suffix}"),
                };
            }
            offset += variable.shape.len();
        }
        "?".into()
    }
}

/// Component `i` of the variable that holds it.
fn component<'v>(
    mut variables: impl Iterator<Item = &'v Variable>,
    i: usize,
    write: impl Fn(&str) -> String,
) -> String {
    let holder = variables.find(|v| (v.offset..v.offset + v.shape.len()).contains(&i));
    holder.map_or("?".into(), |v| {
        write(&v.name.display) + &v.component_suffix(i - v.offset)
    })
}
