//! Errors of a run.

use super::problem::Formulation;
use super::problem::Problem;
use crate::study::Signals;
use crate::study::largest_difference;
use crate::study::term_size;
use residua::description::Output;
use residua_models::values::size;
use std::ops::Range;

/// How wrong a run is, each kind by itself. NaN for what there is none of, and for runs that fail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Largest difference of a signal from the exact one at the end, relative to its size in the motion.
    pub trajectory: f64,
    /// How far in time the motion is from the exact one at the end, s. None beyond ±0.25 s.
    pub phase: f64,
    /// Largest drift of the energy on the way, relative to the size of its terms.
    pub energy: f64,
    /// Largest drift of an invariant without unit, such as RᵀR, likewise.
    pub constraint: f64,
    /// Largest drift of any other invariant, likewise.
    pub momentum: f64,
}

impl Errors {
    /// Of a run that failed.
    pub const NONE: Self = Self {
        trajectory: f64::NAN,
        phase: f64::NAN,
        energy: f64::NAN,
        constraint: f64::NAN,
        momentum: f64::NAN,
    };
}

/// An invariant of a formulation.
struct Invariant {
    place: Range<usize>,
    size: f64,
    class: usize,
    drift: f64,
}

/// Watches a run.
pub struct Meter<'a> {
    problem: &'a Problem,
    formulation: &'a Formulation,
    first: Vec<f64>,
    invariants: Vec<Invariant>,
}

impl<'a> Meter<'a> {
    pub fn new(problem: &'a Problem, formulation: &'a Formulation) -> Self {
        let case = &formulation.case;
        let outputs = |state: &[f64]| case.outputs(0.0, 0.0, state);
        let mut offset = 0;
        let mut invariants = Vec::new();
        for output in case.model.description.outputs {
            let place = offset..offset + size(&output.variable);
            offset = place.end;
            if output.invariant {
                let terms = |state: &[f64]| outputs(state)[place.clone()].to_vec();
                let size = term_size(&case.start, terms);
                invariants.push(Invariant {
                    size: if size > 0.0 { size } else { 1.0 },
                    class: class(output),
                    drift: 0.0,
                    place,
                });
            }
        }
        Self {
            problem,
            formulation,
            first: outputs(&case.start),
            invariants,
        }
    }

    /// Looks at a state.
    pub fn visit(&mut self, state: &[f64]) {
        let values = self.formulation.case.outputs(0.0, 0.0, state);
        for invariant in &mut self.invariants {
            let place = invariant.place.clone();
            let drift = largest_difference(&values[place.clone()], &self.first[place]);
            // Infinite where it is NaN.
            invariant.drift = invariant.drift.max(drift / invariant.size);
        }
    }

    /// What is wrong in the end.
    pub fn judge(&self, end: &[f64]) -> Errors {
        let Formulation { case, alike, .. } = self.formulation;
        let signals = Signals::read(case, 0.0, self.problem.until, end).values;
        let piece = &self.problem.piece;
        let phase = piece.nearest(&signals, alike).0;
        let [energy, constraint, momentum] = [0, 1, 2].map(|class| {
            let own = self.invariants.iter().filter(|of| of.class == class);
            own.map(|of| of.drift)
                .reduce(f64::max)
                .map_or(f64::NAN, finite)
        });
        Errors {
            trajectory: finite(piece.difference(&signals, alike)),
            phase: phase.map_or(f64::NAN, |phase| finite(phase.abs())),
            energy,
            constraint,
            momentum,
        }
    }
}

/// What is not finite has failed.
fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { f64::NAN }
}

/// Energy, constraint or another.
fn class(output: &Output) -> usize {
    let variable = &output.variable;
    match variable.unit {
        _ if variable.name == "energy" => 0,
        "J" | "kg*m^2/s^2" => 0,
        _ if variable.dimensionless => 1,
        _ => 2,
    }
}
