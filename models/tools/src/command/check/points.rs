//! Random parameters, states, unknowns and steps, the same in every run.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use residua::Catalogued;
use residua::description::Variable;
use residua::erased::{AnySolver, Point};
use residua_models::values;

/// Points per solver: enough that no entry stays small by chance at all of them.
const N_POINTS: usize = 64;
/// Any number would do; this one is fixed so that reports repeat.
const SEED: u64 = 20220412;
/// Largest relative change of a parameter.
const PARAMETER_CHANGE: f64 = 0.4;
/// Largest change of a state or unknown, relative to its size or 1.
const STATE_CHANGE: f64 = 0.5;

/// Where a residual can be evaluated.
pub struct Sampled {
    /// Flat.
    pub parameters: Vec<f64>,
    /// Step.
    pub h: f64,
    /// Time.
    pub t: f64,
    /// Known state, flat.
    pub state: Vec<f64>,
    /// Unknowns.
    pub x: Vec<f64>,
}

impl Sampled {
    /// All but the unknowns.
    pub fn point(&self) -> Point<'_> {
        Point {
            parameters: &self.parameters,
            h: self.h,
            t: self.t,
            state: &self.state,
        }
    }
}

/// Points around the defaults of the model and the guess of the solver.
pub fn random_points(model: &Catalogued, solver: &dyn AnySolver) -> Vec<Sampled> {
    let mut rng = StdRng::seed_from_u64(SEED);
    (0..N_POINTS)
        .map(|_| random_point(model, solver, &mut rng))
        .collect()
}

fn random_point(model: &Catalogued, solver: &dyn AnySolver, rng: &mut StdRng) -> Sampled {
    let mut parameters = values::defaults(model);
    change_parameters(model.description.parameters, &mut parameters, rng);
    let mut state = values::start(model, &parameters);
    change(&mut state, rng);
    let mut sampled = Sampled {
        parameters,
        h: 10f64.powf(rng.random_range(-3.0..-0.5)),
        t: rng.random_range(0.0..10.0),
        state,
        x: vec![0.0; n_unknowns(solver)],
    };
    let mut x = sampled.x.clone();
    solver.guess(&sampled.point(), &mut x);
    change(&mut x, rng);
    sampled.x = x;
    sampled
}

/// Number of scalar unknowns.
pub fn n_unknowns(solver: &dyn AnySolver) -> usize {
    solver.solver().unknowns.iter().map(|block| block.len).sum()
}

/// Zeros move too, by the size of their variable: a diagonal default must not hide a wrong entry.
fn change_parameters(variables: &[Variable], values: &mut [f64], rng: &mut StdRng) {
    let mut rest = values;
    for variable in variables {
        let (own, after) = rest.split_at_mut(variable.rows * variable.cols);
        let largest = own
            .iter()
            .fold(0.0, |size: f64, value| size.max(value.abs()));
        let size = if largest == 0.0 { 1.0 } else { largest };
        for value in own {
            let scale = if *value == 0.0 { 0.25 * size } else { *value };
            *value += scale * rng.random_range(-PARAMETER_CHANGE..PARAMETER_CHANGE);
        }
        rest = after;
    }
}

fn change(values: &mut [f64], rng: &mut StdRng) {
    for value in values {
        *value += value.abs().max(1.0) * rng.random_range(-STATE_CHANGE..STATE_CHANGE);
    }
}
