//! The inputs of emitted functions: components of parameters, states and unknowns under names.

use super::scope::components;
use crate::ast::Form;
use crate::dag::Leaf;
use crate::model::Model;
use crate::model::Solved;
use crate::schedule::Expansion;

/// Names of all leaves of one model and form.
pub(super) struct Variables {
    parameters: Vec<String>,
    states: Vec<String>,
    unknowns: Vec<String>,
    /// For each unknown the state component it advances and whether it is an increment.
    pub(super) advanced: Vec<Option<(usize, bool)>>,
}

impl Variables {
    /// The inputs of `model`; without a form there are no unknowns.
    pub(super) fn new(model: &Model, form: Option<Form>) -> Self {
        let all = |variables: Vec<&crate::model::Variable>| {
            variables
                .into_iter()
                .flat_map(|v| components(&v.name.ascii, v.shape))
                .collect()
        };
        let mut variables = Self {
            parameters: all(model.parameters.iter().map(|p| &p.variable).collect()),
            states: all(model.states.iter().map(|s| &s.variable).collect()),
            unknowns: Vec::new(),
            advanced: Vec::new(),
        };
        let Some(form) = form else { return variables };
        for (solved, i) in model.unknown_components() {
            let variable = model.solved_variable(solved);
            let name = components(&variable.name.ascii, variable.shape).swap_remove(i);
            let (name, advanced) = match (solved, form) {
                (Solved::Own(_), _) => (name, None),
                (Solved::State(_), Form::Increment) => {
                    let advanced = (variable.offset + i, true);
                    (format!("Delta_{name}"), Some(advanced))
                }
                (Solved::State(_), Form::Next) => {
                    let advanced = (variable.offset + i, false);
                    (format!("{name}_next"), Some(advanced))
                }
            };
            variables.unknowns.push(name);
            variables.advanced.push(advanced);
        }
        variables
    }

    /// The inputs of recurrences.
    pub(super) fn of_series(model: &Model, expansion: &Expansion) -> Self {
        let mut variables = Self::new(model, None);
        let newest = variables.states.iter().map(|name| format!("{name}_n"));
        let given = ["t_n", "n", "inverse_n"].map(str::to_owned);
        let lanes = 1..=expansion.n_sums.max(expansion.n_products);
        let lanes = lanes.flat_map(|lane| [format!("sum_{lane}"), format!("product_{lane}")]);
        variables.unknowns = newest.chain(given).chain(lanes).collect();
        variables.advanced = vec![None; variables.unknowns.len()];
        variables
    }

    /// The name of an input.
    pub(super) fn name(&self, leaf: Leaf) -> &str {
        match leaf {
            Leaf::Parameter(i) => &self.parameters[i],
            Leaf::StepSize => "h",
            Leaf::Time => "t",
            Leaf::State(i) => &self.states[i],
            Leaf::Unknown(i) => &self.unknowns[i],
            Leaf::Variation(_) => "δ",
        }
    }

    /// All inputs, in the order in which they take their names.
    pub(super) fn leaves(&self) -> impl Iterator<Item = Leaf> {
        [Leaf::StepSize, Leaf::Time]
            .into_iter()
            .chain((0..self.parameters.len()).map(Leaf::Parameter))
            .chain((0..self.states.len()).map(Leaf::State))
            .chain((0..self.unknowns.len()).map(Leaf::Unknown))
    }
}
