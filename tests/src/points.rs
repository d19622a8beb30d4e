//! Random points at which to compare functions.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

/// What a discrete equation depends on, all drawn at random.
pub struct RandomPoint {
    /// In the order of the model file.
    pub parameters: Vec<f64>,
    /// The time step, s.
    pub h: f64,
    /// In the order of the model file.
    pub state: Vec<f64>,
    /// The unknowns.
    pub x: Vec<f64>,
}

/// A source of random points, the same in every run.
pub struct Points(StdRng);

impl Points {
    /// Starts from `seed`.
    pub fn new(seed: u64) -> Self {
        Points(StdRng::seed_from_u64(seed))
    }

    /// A point for the planar pendulum: m, J, l, g positive, everything else of order one and of any sign.
    pub fn planar(&mut self, states: usize, unknowns: usize) -> RandomPoint {
        let parameters = (0..4).map(|_| self.0.random_range(0.1..10.0)).collect();
        self.with(parameters, states, unknowns)
    }

    /// A point for the 3D pendulum: J any symmetric matrix, ρ any vector.
    pub fn spatial(&mut self, states: usize, unknowns: usize) -> RandomPoint {
        let mut parameters = vec![self.0.random_range(0.1..10.0)];
        let [a, b, c, d, e, f] = [0; 6].map(|_| self.0.random_range(-2.0..2.0));
        parameters.extend([a, d, e, d, b, f, e, f, c]);
        parameters.extend(self.numbers(3));
        parameters.push(self.0.random_range(0.1..10.0));
        self.with(parameters, states, unknowns)
    }

    /// `count` numbers of order one and of any sign.
    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.0.random_range(-2.0..2.0)).collect()
    }

    fn with(&mut self, parameters: Vec<f64>, states: usize, unknowns: usize) -> RandomPoint {
        RandomPoint {
            parameters,
            h: self.0.random_range(0.001..0.5),
            state: self.numbers(states),
            x: self.numbers(unknowns),
        }
    }
}
