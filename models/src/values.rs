//! Flat values of a model, as its file gives them.

use residua::Catalogued;
use residua::description::Variable;

/// The parameters.
pub fn defaults(model: &Catalogued) -> Vec<f64> {
    let mut parameters = vec![0.0; total(model.description.parameters)];
    model.model.defaults(&mut parameters);
    parameters
}

/// The start state for these parameters.
pub fn start(model: &Catalogued, parameters: &[f64]) -> Vec<f64> {
    let mut state = vec![0.0; total(model.description.states)];
    model.model.start(parameters, &mut state);
    state
}

/// Number of components.
pub fn size(variable: &Variable) -> usize {
    variable.rows * variable.cols
}

/// Number of components of several variables.
pub fn total<'v>(variables: impl IntoIterator<Item = &'v Variable>) -> usize {
    variables.into_iter().map(size).sum()
}
