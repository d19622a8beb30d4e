//! Newton's method with the equations as somebody would code them from the page.

use nalgebra::DMatrix;
use nalgebra::DVector;
use residua_codegen::Analysis;
use residua_codegen::dag::Leaf;
use residua_codegen::dag::NodeId;
use residua_codegen::dag::Tape;
use residua_codegen::system::System;
use serde::Serialize;
use std::fmt;

/// Corrections after which a step counts as failed. A wrong Jacobian that still converges does so linearly;
/// at a rate of 0.75 that takes a hundred corrections to [`TOLERANCE`], beyond is no method.
const MOST_ITERATIONS: usize = 100;

/// Size of the last correction, relative to the largest of 1, the state and the unknowns. Rounding leaves
/// some 1e-15; a larger value would end slow convergence early and count too few corrections.
const TOLERANCE: f64 = 1e-12;

/// How far to run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Plan {
    /// h, s
    pub h: f64,
    /// Steps from the model's start.
    pub steps: usize,
}

impl Default for Plan {
    /// The larger step of the paper's planar runs, for five seconds.
    fn default() -> Self {
        Self {
            h: 0.05,
            steps: 100,
        }
    }
}

/// Newton's method as printed beside Newton's method as it should be.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// `next` or `increment`.
    pub form: &'static str,
    /// The run.
    pub plan: Plan,
    /// With what is printed.
    pub printed: Run,
    /// With the model's own residual and its derivative.
    pub right: Run,
    /// Largest difference of the states after as many steps as both have, if they have any.
    pub difference: Option<f64>,
}

/// A run.
#[derive(Clone, Debug, Serialize)]
pub struct Run {
    /// Steps that converged.
    pub steps: usize,
    /// Corrections per step, on average over these.
    pub mean_iterations: f64,
    /// Corrections of the worst of these.
    pub most_iterations: usize,
    /// Why it ended early, if it did.
    pub failure: Option<Failure>,
    /// The state after each step.
    #[serde(skip)]
    pub states: Vec<Vec<f64>>,
}

/// Why a step fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Failure {
    /// The Jacobian has no inverse.
    Singular,
    /// Infinity or NaN.
    NotFinite,
    /// Too many corrections.
    NoConvergence,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Singular => f.write_str("the Jacobian is singular"),
            Self::NotFinite => f.write_str("a value is not finite"),
            Self::NoConvergence => write!(f, "no convergence in {MOST_ITERATIONS} iterations"),
        }
    }
}

/// Runs the claim number `claim` of the model as printed, and the model itself; `None` if the claim gives no
/// equations that fit.
pub fn compare(analysis: &Analysis, claim: usize, plan: &Plan) -> Option<Comparison> {
    let system = analysis
        .systems
        .iter()
        .find(|system| system.printed[claim].is_some())?;
    let equations = system.printed[claim].as_ref()?;
    let printed = Newton::new(system, &equations.residual, &equations.jacobian);
    let n = system.residual.len();
    let mut entries = vec![None; n * n];
    for entry in &system.jacobian {
        entries[entry.row * n + entry.col] = Some(entry.node);
    }
    let right = Newton::sparse(system, &system.residual, &entries);
    let scene = Scene::of(analysis);
    let (printed, right) = (printed.run(&scene, plan), right.run(&scene, plan));
    let last = printed.states.len().min(right.states.len()) - 1;
    let pairs = printed.states[last].iter().zip(&right.states[last]);
    let largest = pairs.fold(0.0, |most, (a, b)| f64::max(most, (a - b).abs()));
    Some(Comparison {
        form: system.form.keyword(),
        plan: *plan,
        difference: (last > 0).then_some(largest),
        printed,
        right,
    })
}

/// Default parameters and the state at t = 0.
struct Scene {
    parameters: Vec<f64>,
    start: Vec<f64>,
}

impl Scene {
    fn of(analysis: &Analysis) -> Self {
        let equations = &analysis.equations;
        let defaults = equations.dag.tape(&equations.defaults);
        let parameters = defaults.evaluate(|_| f64::NAN);
        let start = equations
            .dag
            .tape(&equations.start)
            .evaluate(|leaf| match leaf {
                Leaf::Parameter(i) => parameters[i],
                _ => f64::NAN,
            });
        Self { parameters, start }
    }
}

/// A system that steps.
struct Newton {
    guess: Tape,
    /// The residual and then the Jacobian, row by row.
    equations: Tape,
    next: Tape,
    /// Where on the Jacobian's tape each entry is; absent ones are 0.
    entries: Vec<Option<usize>>,
    n: usize,
}

impl Newton {
    fn new(system: &System, residual: &[NodeId], jacobian: &[NodeId]) -> Self {
        let entries: Vec<_> = jacobian.iter().copied().map(Some).collect();
        Self::sparse(system, residual, &entries)
    }

    fn sparse(system: &System, residual: &[NodeId], jacobian: &[Option<NodeId>]) -> Self {
        let n = residual.len();
        let mut roots = residual.to_vec();
        let mut entries = Vec::new();
        for node in jacobian {
            entries.push(node.map(|_| roots.len()));
            roots.extend(*node);
        }
        Self {
            guess: system.dag.tape(&system.guess),
            equations: system.dag.tape(&roots),
            next: system.dag.tape(&system.next),
            entries,
            n,
        }
    }

    fn run(&self, scene: &Scene, plan: &Plan) -> Run {
        let mut run = Run {
            steps: 0,
            mean_iterations: f64::NAN,
            most_iterations: 0,
            failure: None,
            states: vec![scene.start.clone()],
        };
        let mut total = 0;
        for step in 0..plan.steps {
            let at = Point {
                parameters: &scene.parameters,
                h: plan.h,
                t: step as f64 * plan.h,
                state: &run.states[step],
            };
            match self.step(&at) {
                Ok((next, iterations)) => {
                    run.states.push(next);
                    run.steps += 1;
                    run.most_iterations = run.most_iterations.max(iterations);
                    total += iterations;
                }
                Err(failure) => {
                    run.failure = Some(failure);
                    break;
                }
            }
        }
        run.mean_iterations = total as f64 / run.steps.max(1) as f64;
        run
    }

    /// The next state and the number of corrections to it.
    fn step(&self, at: &Point) -> Result<(Vec<f64>, usize), Failure> {
        let mut x = DVector::from_vec(self.guess.evaluate(|leaf| at.value(leaf, &[])));
        for iteration in 1..=MOST_ITERATIONS {
            let values = self.equations.evaluate(|leaf| at.value(leaf, x.as_slice()));
            let r = DVector::from_column_slice(&values[..self.n]);
            let entry = |i: &Option<usize>| i.map_or(0.0, |i| values[i]);
            let j = DMatrix::from_row_iterator(self.n, self.n, self.entries.iter().map(entry));
            if values.iter().any(|v| !v.is_finite()) {
                return Err(Failure::NotFinite);
            }
            let correction = j.lu().solve(&r).ok_or(Failure::Singular)?;
            x -= &correction;
            if x.iter().any(|v| !v.is_finite()) {
                return Err(Failure::NotFinite);
            }
            let state = at.state.iter().fold(1.0, |most, v| f64::max(most, v.abs()));
            if correction.amax() <= TOLERANCE * state.max(x.amax()) {
                let next = self.next.evaluate(|leaf| at.value(leaf, x.as_slice()));
                return Ok((next, iteration));
            }
        }
        Err(Failure::NoConvergence)
    }
}

/// What a step starts from.
struct Point<'a> {
    parameters: &'a [f64],
    h: f64,
    t: f64,
    state: &'a [f64],
}

impl Point<'_> {
    fn value(&self, leaf: Leaf, x: &[f64]) -> f64 {
        match leaf {
            Leaf::Parameter(i) => self.parameters[i],
            Leaf::StepSize => self.h,
            Leaf::Time => self.t,
            Leaf::State(i) => self.state[i],
            Leaf::Unknown(i) => x.get(i).copied().unwrap_or(f64::NAN),
            Leaf::Variation(_) => f64::NAN,
        }
    }
}
