//! The twin of a solver in double-double numbers: what a step should have been.
//!
//! It is evaluated from the generator's graph, not by the emitted code, with all unknowns, and knows nothing of elimination,
//! of closed forms of a correction or of extrapolation.

use nalgebra::DMatrix;
use nalgebra::DVector;
use nalgebra::Dyn;
use nalgebra::LU;
use proc_macro2::TokenStream;
use rand::RngExt;
use rand::SeedableRng;
use rand::rngs::StdRng;
use residua::description::Solver;
use residua::description::Variable;
use residua::erased::AnySolver;
use residua::erased::Point;
use residua_codegen::dag::Leaf;
use residua_codegen::dag::Tape;
use residua_codegen::source::read_scene;
use residua_codegen::source::read_source;
use residua_codegen::system::System;
use residua_codegen::{analyse, analyse_scene};

use super::format::Format;
use super::running::Running;
use residua_models::Entry;
use residua_models::exact::Double;
use residua_models::find;
use residua_models::values::size;

/// Corrections with the Jacobian of `f64`, each of which gains some digits: more than for 31 of them.
const REFINEMENTS: usize = 60;

/// A correction of this size relative to what it corrects is rounding of double-double numbers.
const NOTHING: f64 = 1e-29;

/// Corrections in `f64` that a start may take.
const ITERATIONS: usize = 50;

/// Starts from which a solution that fits is looked for.
const STARTS: usize = 12;

/// A start this close, relative, is refined; half of the digits of `f64`, also for difference quotients.
const NEAR: f64 = 1.5e-8;

/// A solver as graphs.
pub struct Twin {
    states: &'static [Variable],
    /// How many unknowns are.
    eliminated: usize,
    solver: &'static Solver,
    residual: Tape<Double>,
    running: Tape<Running<f64>>,
    running_in_single: Tape<Running<f32>>,
    next: Tape<Double>,
}

/// What a step should have been.
pub struct Exact {
    /// The state after it.
    pub next: Vec<Double>,
    /// How far the format may be from that, by component.
    pub bound: Vec<f64>,
}

impl Twin {
    /// The twin of a solver of `entry`; `None` for a file that does not compile, which the catalogue has not.
    pub fn new(entry: &Entry, solver: &dyn AnySolver) -> Option<Self> {
        let form = solver.solver().form;
        let system = systems(entry)?
            .into_iter()
            .find(|system| system.form.keyword() == form)?;
        Some(Self {
            states: entry.catalogued.description.states,
            eliminated: solver.solver().core.map_or(0, |core| {
                core.eliminated.iter().map(|block| block.len).sum()
            }),
            solver: solver.solver(),
            residual: system.dag.tape_of(&system.residual),
            running: system.dag.tape_of(&system.residual),
            running_in_single: system.dag.tape_of(&system.residual),
            next: system.dag.tape_of(&system.next),
        })
    }

    /// The step that ends near `ended`; `None` where the equations have no solution there that 31 digits can tell.
    ///
    /// Equations may have several. That of unknowns of the model's own is looked for from their guess first, and
    /// where that one ends elsewhere, from where they fit `ended` best. If there are several and none ends there, there
    /// is no telling.
    pub fn step(
        &self,
        solver: &dyn AnySolver,
        format: Format,
        at: &Point,
        ended: &[f64],
    ) -> Option<Exact> {
        if let Some(x) = self.told(at, ended) {
            let exact = self.refined(solver, format, at, x.clone())?;
            let is_in_doubt = !exact.is_met_by(ended) && self.is_rounding(solver, format, at, &x);
            return (!is_in_doubt).then_some(exact);
        }
        let guess = self.guessed(solver, at);
        let found = guess.and_then(|x| self.refined(solver, format, at, x))?;
        if found.is_met_by(ended) {
            return Some(found);
        }
        let starts = self.around(self.guess(solver, at));
        let fitted = starts.into_iter().filter_map(|start| {
            let x = self.fitted(solver, at, ended, start)?;
            self.refined(solver, format, at, x)
        });
        let (mut same, mut others) = (0, 0);
        for other in fitted {
            if other.is_met_by(ended) {
                return Some(other);
            }
            match other.is_met_by(&nearest(&found.next)) {
                true => same += 1,
                false => others += 1,
            }
        }
        (others == 0 && same > 0).then_some(found)
    }

    /// The guess and points around it, the same every time.
    fn around(&self, guess: Vec<f64>) -> Vec<Vec<f64>> {
        let mut rng = StdRng::seed_from_u64(STARTS as u64);
        let mut starts = vec![guess];
        while starts.len() < STARTS {
            let moved = |x: &f64| x + x.abs().max(1.0) * rng.random_range(-2.0..2.0);
            let start = starts[0].iter().map(moved).collect();
            starts.push(start);
        }
        starts
    }

    /// The solution near `x` in 31 digits.
    fn refined(
        &self,
        solver: &dyn AnySolver,
        format: Format,
        at: &Point,
        mut x: Vec<Double>,
    ) -> Option<Exact> {
        let mut before = f64::INFINITY;
        for _ in 0..REFINEMENTS {
            let factors = jacobian(solver, at, &nearest(&x))?.lu();
            let residual = nearest(&self.residual.evaluate(leaf(at, &x)));
            let correction = factors.solve(&DVector::from_vec(residual))?;
            for (x, correction) in x.iter_mut().zip(correction.iter()) {
                *x = *x - Double::from(*correction);
            }
            let size = part(&correction, &self.scales(at, &x));
            if !size.is_finite() {
                return None;
            }
            if size <= NOTHING || (size <= 1e3 * NOTHING && size >= before) {
                return self.exact(solver, format, at, &x);
            }
            before = size;
        }
        None
    }

    /// Whether `x` solves equations that differ from these by no more than rounding: then so many solutions do that none of
    /// them is the one.
    fn is_rounding(
        &self,
        solver: &dyn AnySolver,
        format: Format,
        at: &Point,
        x: &[Double],
    ) -> bool {
        let Some(jacobian) = jacobian(solver, at, &nearest(x)) else {
            return false;
        };
        let scales = DVector::from_vec(self.scales(at, x));
        let most = jacobian.abs() * scales * format.rounding() + self.rounding(format, at, x);
        let residual = self.residual.evaluate(leaf(at, x));
        let mut pairs = residual.iter().zip(&most);
        pairs.all(|(r, most)| r.to_f64().abs() <= *most)
    }

    /// The unknowns of a step that ended there, if the states tell them.
    fn told(&self, at: &Point, ended: &[f64]) -> Option<Vec<Double>> {
        let solver = self.solver;
        let moved = |i: usize| match solver.is_increment() {
            true => Double::from(ended[i]) - Double::from(at.state[i]),
            false => Double::from(ended[i]),
        };
        Some(solver.own_states()?.map(moved).collect())
    }

    /// By Newton's method from the guess.
    fn guessed(&self, solver: &dyn AnySolver, at: &Point) -> Option<Vec<Double>> {
        let mut x = self.guess(solver, at);
        let mut r = x.clone();
        for _ in 0..ITERATIONS {
            solver.residual(at, &x, &mut r);
            let factors = jacobian(solver, at, &x)?.lu();
            let correction = factors.solve(&DVector::from_column_slice(&r))?;
            x.iter_mut().zip(&correction).for_each(|(x, c)| *x -= c);
            if correction.amax() <= NEAR * DVector::from_column_slice(&x).amax() {
                break;
            }
        }
        Some(x.into_iter().map(Double::from).collect())
    }

    /// By the Gauss–Newton method for next(x) = `ended`.
    fn fitted(
        &self,
        solver: &dyn AnySolver,
        at: &Point,
        ended: &[f64],
        mut x: Vec<f64>,
    ) -> Option<Vec<Double>> {
        let next = |x: &[f64]| {
            let mut next = vec![0.0; ended.len()];
            solver.next(at, x, &mut next);
            next
        };
        for _ in 0..ITERATIONS {
            let here = next(&x);
            let missed = here.iter().zip(ended).map(|(here, ended)| here - ended);
            let missed = DVector::from_iterator(ended.len(), missed);
            let mut slope = DMatrix::zeros(ended.len(), x.len());
            for j in 0..x.len() {
                let moved = NEAR * x[j].abs().max(NEAR);
                let mut there = x.clone();
                there[j] += moved;
                for (i, (there, here)) in next(&there).iter().zip(&here).enumerate() {
                    slope[(i, j)] = (there - here) / moved;
                }
            }
            if !slope.iter().chain(&missed).all(|value| value.is_finite()) {
                return None;
            }
            let correction = slope.svd(true, true).solve(&missed, f64::EPSILON).ok()?;
            x.iter_mut().zip(&correction).for_each(|(x, c)| *x -= c);
            if correction.amax() <= NEAR * DVector::from_column_slice(&x).amax() {
                break;
            }
        }
        Some(x.into_iter().map(Double::from).collect())
    }

    fn guess(&self, solver: &dyn AnySolver, at: &Point) -> Vec<f64> {
        let mut guess = vec![0.0; self.solver.unknowns.iter().map(|block| block.len).sum()];
        solver.guess(at, &mut guess);
        guess
    }

    fn exact(
        &self,
        solver: &dyn AnySolver,
        format: Format,
        at: &Point,
        x: &[Double],
    ) -> Option<Exact> {
        let next = self.next.evaluate(leaf(at, x));
        let jacobian = jacobian(solver, at, &nearest(x))?;
        let scales = self.scales(at, x);
        let inverse = inverse(jacobian.clone().lu(), x.len())?;
        let rounding = jacobian.abs() * DVector::from_column_slice(&scales) * format.rounding()
            + self.rounding(format, at, x);
        let errors = inverse.abs() * rounding;
        let share = format
            .tolerance()
            .max(self.eliminated as f64 * format.eliminated());
        let mut bound = Vec::with_capacity(next.len());
        for variable in self.states {
            let own = bound.len()..bound.len() + size(variable);
            let after = next[own.clone()].iter().map(|x| x.to_f64().abs());
            let scale = at.state[own.clone()].iter().map(|x| x.abs()).chain(after);
            bound.resize(own.end, share * scale.fold(format.least(), f64::max));
        }
        for (i, scale) in scales.iter().enumerate() {
            let mut moved = x.to_vec();
            moved[i] = moved[i] + Double::from(errors[i] + format.tolerance() * scale);
            let moved = self.next.evaluate(leaf(at, &moved));
            for ((bound, moved), next) in bound.iter_mut().zip(moved).zip(&next) {
                *bound += (moved - *next).to_f64().abs();
            }
        }
        let is_finite = next.iter().all(|next| next.is_finite());
        (is_finite && bound.iter().all(|bound| bound.is_finite())).then_some(Exact { next, bound })
    }

    /// What rounding may do to the residual, in whatever order it is computed.
    fn rounding(&self, format: Format, at: &Point, x: &[Double]) -> DVector<f64> {
        let leaf = |l| leaf(at, x)(l).to_f64();
        let bounds: Vec<f64> = match format {
            Format::Double => {
                let residual = self.running.evaluate(|l| Running::exact(leaf(l)));
                residual.iter().map(|r| r.error).collect()
            }
            Format::Single => {
                let residual = self.running_in_single.evaluate(|l| Running::exact(leaf(l)));
                residual.iter().map(|r| r.error.into()).collect()
            }
        };
        DVector::from_vec(bounds)
    }

    /// The size of each unknown: the largest of its block and of the state that the block advances.
    fn scales(&self, at: &Point, x: &[Double]) -> Vec<f64> {
        let mut scales = Vec::with_capacity(x.len());
        for block in self.solver.unknowns {
            let own = &x[scales.len()..scales.len() + block.len];
            let known = block.measure.clone().unwrap_or(0..0);
            let sizes = own.iter().map(|x| x.to_f64().abs());
            let scale = sizes
                .chain(at.state[known].iter().map(|x| x.abs()))
                .fold(0.0, f64::max);
            scales.resize(scales.len() + block.len, scale);
        }
        scales
    }
}

impl Exact {
    /// No component is further off than it may be. False for NaN.
    pub fn is_met_by(&self, ended: &[f64]) -> bool {
        let pairs = ended.iter().zip(&self.next).zip(&self.bound);
        let mut within = pairs.map(|((ended, next), bound)| off(*ended, *next) <= *bound);
        within.all(|within| within)
    }
}

/// |found − exact|
pub fn off(found: f64, exact: Double) -> f64 {
    (Double::from(found) - exact).to_f64().abs()
}

fn nearest(values: &[Double]) -> Vec<f64> {
    values.iter().map(|value| value.to_f64()).collect()
}

/// The largest correction in units of its scale; a NaN stays one.
fn part(correction: &DVector<f64>, scales: &[f64]) -> f64 {
    let pairs = correction.iter().zip(scales);
    let relative = pairs.map(|(c, scale)| if *c == 0.0 { 0.0 } else { c.abs() / scale });
    relative.fold(
        0.0,
        |most: f64, size| if size <= most { most } else { size },
    )
}

fn leaf<'a>(at: &'a Point, x: &'a [Double]) -> impl Fn(Leaf) -> Double + 'a {
    move |leaf| match leaf {
        Leaf::Parameter(i) => at.parameters[i].into(),
        Leaf::StepSize => at.h.into(),
        Leaf::Time => at.t.into(),
        Leaf::State(i) => at.state[i].into(),
        Leaf::Unknown(i) => x[i],
        Leaf::Variation(_) => f64::NAN.into(),
    }
}

fn jacobian(solver: &dyn AnySolver, at: &Point, x: &[f64]) -> Option<DMatrix<f64>> {
    let n = x.len();
    let mut entries = vec![0.0; n * n];
    solver.jacobian(at, x, &mut entries);
    let is_finite = entries.iter().all(|entry| entry.is_finite());
    is_finite.then(|| DMatrix::from_row_slice(n, n, &entries))
}

fn inverse(factors: LU<f64, Dyn, Dyn>, n: usize) -> Option<DMatrix<f64>> {
    if n == 0 {
        return Some(DMatrix::zeros(0, 0));
    }
    factors.try_inverse()
}

fn systems(entry: &Entry) -> Option<Vec<System>> {
    let text = entry.source.as_bytes();
    if entry.catalogued.description.scene.is_none() {
        let tokens: TokenStream = read_source(text).ok()?;
        return Some(analyse(entry.name(), tokens).ok()?.systems);
    }
    let read = |model: &str| match find(model) {
        Ok(model) => Ok(model.source.to_owned()),
        Err(unknown) => Err(unknown.to_string()),
    };
    let scene = analyse_scene(entry.name(), read_scene(text).ok()?, &read).ok()?;
    Some(vec![scene.system])
}
