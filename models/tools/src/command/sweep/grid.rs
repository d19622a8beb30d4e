//! All combinations of the swept values, by number: the last axis runs fastest.

use super::over::Axis;
use crate::assignment::{Assignment, Target, assign};
use crate::failure::Failure;
use crate::motion::symbols;
use residua::Catalogued;
use residua_models::values;

/// The trajectories of a sweep.
pub struct Grid<'a> {
    pub model: &'a Catalogued,
    pub axes: Vec<Axis>,
    /// What is not swept.
    pub parameters: Vec<f64>,
    /// Assignments to the start values of the file.
    pub start: &'a [Assignment],
    /// The start state, where no parameter is swept that it may depend on.
    fixed: Option<Vec<f64>>,
}

impl<'a> Grid<'a> {
    /// Checks that there is a start state with the parameters as they are.
    pub fn new(
        model: &'a Catalogued,
        axes: Vec<Axis>,
        parameters: Vec<f64>,
        start: &'a [Assignment],
    ) -> Result<Self, Failure> {
        let mut grid = Self {
            model,
            axes,
            parameters,
            start,
            fixed: None,
        };
        let state = grid.start_of(&grid.parameters)?;
        if grid.axes.iter().all(|axis| axis.is_start) {
            grid.fixed = Some(state);
        }
        Ok(grid)
    }

    /// Number of trajectories; `None` if it is beyond counting.
    pub fn len(&self) -> Option<usize> {
        let mut counts = self.axes.iter().map(|axis| axis.count);
        counts.try_fold(1_usize, |product, count| product.checked_mul(count))
    }

    /// The swept values of a trajectory.
    pub fn point(&self, trajectory: usize) -> Vec<f64> {
        let mut rest = trajectory;
        let mut point = vec![0.0; self.axes.len()];
        for (value, axis) in point.iter_mut().zip(&self.axes).rev() {
            *value = axis.value(rest % axis.count);
            rest /= axis.count;
        }
        point
    }

    /// Parameters and start state of a trajectory.
    pub fn data(&self, trajectory: usize) -> (Vec<f64>, Vec<f64>) {
        let (mut parameters, mut state) = (
            self.parameters.clone(),
            values::start(self.model, &self.parameters),
        );
        self.fill(trajectory, &mut parameters, &mut state);
        (parameters, state)
    }

    /// Overwrites parameters and start state with those of a trajectory.
    pub fn fill(&self, trajectory: usize, parameters: &mut [f64], state: &mut [f64]) {
        let point = self.point(trajectory);
        parameters.copy_from_slice(&self.parameters);
        let swept = || self.axes.iter().zip(&point);
        for (axis, value) in swept().filter(|(axis, _)| !axis.is_start) {
            parameters[axis.position] = *value;
        }
        match &self.fixed {
            Some(fixed) => state.copy_from_slice(fixed),
            // A start value without a number here ends this trajectory, and is reported with it.
            None => match self.start_of(parameters) {
                Ok(start) => state.copy_from_slice(&start),
                Err(_) => state.fill(f64::NAN),
            },
        }
        for (axis, value) in swept().filter(|(axis, _)| axis.is_start) {
            state[axis.position] = *value;
        }
    }

    /// The start state with these parameters, but for what is swept of it.
    fn start_of(&self, parameters: &[f64]) -> Result<Vec<f64>, Failure> {
        let description = self.model.description;
        let mut state = values::start(self.model, parameters);
        if !self.start.is_empty() {
            let symbols = symbols(description.parameters, parameters);
            let target = Target {
                kind: "state",
                variables: description.states,
                values: &mut state,
            };
            assign(self.start, target, &symbols)?;
        }
        Ok(state)
    }
}
