//! A step that failed, taken once more with everything in sight.
//!
//! Newton's method starts from the plain guess, on all unknowns, and every iterate is looked at: how large the correction is,
//! which equation is furthest from 0, how near the Jacobian is to being singular. Where something is not finite, the model
//! file is evaluated expression by expression and the first one to blame is found; where everything is, shorter steps
//! from the same state are tried.

use std::ops::ControlFlow;

use nalgebra::DMatrix;
use nalgebra::DVector;
use proc_macro2::TokenStream;
use residua::RunError;
use residua::Settings;
use residua::erased::AnySolver;
use residua::erased::Point;
use residua::erased::Run;
use residua_codegen::analyse;
use residua_codegen::source::read_source;
use residua_codegen::trace;
use residua_codegen::trace::Culprit;

use residua_models::Entry;

/// Corrections that are shown: a solution that is near takes fewer.
const CORRECTIONS: usize = 8;

/// Halvings of the step that are tried.
const HALVINGS: u32 = 12;

/// What the step did.
#[derive(Clone, Debug)]
pub struct Replay {
    /// The time at which it starts.
    pub t: f64,
    /// The flat state there.
    pub state: Vec<f64>,
    /// Corrections, first to last.
    pub corrections: Vec<Correction>,
    /// The first expression of the file that has no finite value.
    pub culprit: Option<Culprit>,
    /// The largest part h/2, h/4, … of the step that can be taken from the same state, and after how many halvings.
    pub possible: Option<(f64, u32)>,
}

/// One iterate and what corrects it.
#[derive(Clone, Debug)]
pub struct Correction {
    /// Largest component of the correction; NaN where there is none.
    pub size: f64,
    /// The row of the largest residual before it, each row relative to its terms Σ |Jᵢⱼ| |xⱼ| + |rᵢ|.
    pub row: usize,
    /// The residual there.
    pub residual: f64,
    /// Condition number of the Jacobian after its rows are scaled to length 1, σ₁/σₙ; infinite where it is singular.
    pub condition: f64,
}

/// Takes step number `step` of `run` once more; `None` where it cannot be reached.
pub fn replay(entry: &Entry, solver: &dyn AnySolver, run: &Run, step: u64) -> Option<Replay> {
    let state = state_at(solver, run, step)?;
    let t = run.t0 + step as f64 * run.h;
    let at = Point {
        parameters: run.parameters,
        h: run.h,
        t,
        state: &state,
    };
    let (corrections, x) = iterate(solver, &at);
    let culprit = culprit(entry, solver, &at, &x);
    let possible = shorter(solver, run, &at);
    Some(Replay {
        t,
        corrections,
        culprit,
        possible,
        state,
    })
}

/// The state before a step, by the same run.
fn state_at(solver: &dyn AnySolver, run: &Run, step: u64) -> Option<Vec<f64>> {
    let mut state = Vec::new();
    let upto = Run {
        steps: step,
        every: 0,
        ..*run
    };
    let outcome = solver.simulate(&upto, &mut |sample| {
        state = sample.state.to_vec();
        ControlFlow::Continue(())
    });
    outcome.is_ok().then_some(state)
}

/// Newton's method up to what is not finite, or for as many corrections as are shown; and the last iterate.
fn iterate(solver: &dyn AnySolver, at: &Point) -> (Vec<Correction>, Vec<f64>) {
    let n = solver.solver().unknowns.iter().map(|block| block.len).sum();
    let (mut x, mut r, mut j) = (vec![0.0; n], vec![0.0; n], vec![0.0; n * n]);
    let mut corrections = Vec::new();
    solver.guess(at, &mut x);
    while corrections.len() < CORRECTIONS {
        solver.residual(at, &x, &mut r);
        solver.jacobian(at, &x, &mut j);
        if !r.iter().chain(&j).all(|value| value.is_finite()) {
            break;
        }
        let jacobian = DMatrix::from_row_slice(n, n, &j);
        let step = jacobian.clone().lu().solve(&DVector::from_column_slice(&r));
        let (row, residual) = worst_row(&r, &jacobian, &x);
        corrections.push(Correction {
            size: step.as_ref().map_or(f64::NAN, DVector::amax),
            row,
            residual,
            condition: condition(jacobian),
        });
        let Some(step) = step.filter(|step| step.amax() > 0.0) else {
            break;
        };
        x.iter_mut()
            .zip(step.iter())
            .for_each(|(x, step)| *x -= step);
    }
    (corrections, x)
}

fn worst_row(r: &[f64], jacobian: &DMatrix<f64>, x: &[f64]) -> (usize, f64) {
    let relative = |row: usize| {
        let entries = jacobian.row(row);
        let terms: f64 = entries.iter().zip(x).map(|(j, x)| (j * x).abs()).sum();
        let size = r[row].abs();
        if size == 0.0 {
            0.0
        } else {
            size / (size + terms)
        }
    };
    let row = (0..r.len()).max_by(|a, b| relative(*a).total_cmp(&relative(*b)));
    row.map_or((0, 0.0), |row| (row, r[row]))
}

fn condition(mut jacobian: DMatrix<f64>) -> f64 {
    for mut row in jacobian.row_iter_mut() {
        let length = row.norm();
        if length > 0.0 {
            row /= length;
        }
    }
    let values = jacobian.singular_values();
    values.max() / values.min()
}

/// The expression to blame at the last iterate; for a scene, which has no file of equations, none.
fn culprit(entry: &Entry, solver: &dyn AnySolver, at: &Point, x: &[f64]) -> Option<Culprit> {
    if entry.catalogued.description.scene.is_some() {
        return None;
    }
    let tokens: TokenStream = read_source(entry.source.as_bytes()).ok()?;
    let model = analyse(entry.name(), tokens).ok()?.model;
    let named = |form: &&residua_codegen::ast::Form| form.keyword() == solver.solver().form;
    let form = *model.forms.iter().find(named)?;
    let point = trace::Point {
        parameters: at.parameters,
        h: at.h,
        t: at.t,
        state: at.state,
        unknowns: x,
    };
    trace::first_not_finite(&model, form, &point).ok()?
}

/// The largest part of the step that can be taken, and as many of them as make the step; and after how many halvings.
fn shorter(solver: &dyn AnySolver, run: &Run, at: &Point) -> Option<(f64, u32)> {
    (1..=HALVINGS).find_map(|halvings| {
        let parts = 2u64.pow(halvings);
        let h = run.h / parts as f64;
        let run = Run {
            start: at.state,
            t0: at.t,
            h,
            steps: parts,
            every: 0,
            settings: Settings {
                halvings: 0,
                ..run.settings
            },
            ..*run
        };
        let outcome: Result<_, RunError> =
            solver.simulate(&run, &mut |_| ControlFlow::Continue(()));
        outcome.is_ok().then_some((h, halvings))
    })
}
