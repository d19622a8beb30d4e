//! Does the residual vanish at the step that is taken?
//!
//! A plain Newton iteration, written here and not the runtime's, solves for the unknowns; its step must be
//! the runtime's step.

use super::order::{Moment, Range};
use super::points::n_unknowns;
use super::report::ResidualReport;
use residua::Catalogued;
use residua::erased::{AnySolver, Point};
use residua_tools::study::{Case, largest_difference};

/// Largest residual taken for rounding, in units of ε times the size of its terms: room for
/// sums of some hundred terms.
pub const RESIDUAL_BOUND: f64 = 1000.0;
/// Largest difference between the two steps, relative to the state: rounding, and what Newton's
/// tolerance leaves.
pub const STEP_BOUND: f64 = 1e-10;
/// Iterations; a good guess takes 2 to 5.
const MAX_ITERATIONS: usize = 30;

/// The solution of one step.
pub struct Solution {
    /// State after the step.
    pub next: Vec<f64>,
    /// Largest residual in units of ε times the size of its terms.
    pub residual: f64,
}

/// Solves every step of a run with the defaults anew.
pub fn at_accepted_steps(
    model: &'static Catalogued,
    solver: &dyn AnySolver,
    range: &Range,
    run: &[Moment],
) -> Result<ResidualReport, String> {
    let mut report = ResidualReport::default();
    let case = Case::of_file(model);
    for (taken, pair) in run.windows(2).enumerate() {
        let [before, after] = pair else { continue };
        let at = Point {
            parameters: &case.parameters,
            h: range.h,
            t: before.t,
            state: &before.state,
        };
        let solution = solve(solver, &at)
            .filter(|solution| solution.residual <= RESIDUAL_BOUND)
            .or_else(|| solve_from(solver, &at, accepted(solver, &before.state, &after.state)?))
            .ok_or_else(|| format!("step {taken} from t = {} has no solution", before.t))?;
        report.steps += 1;
        report.residual = report.residual.max(solution.residual);
        let size = after
            .state
            .iter()
            .fold(0.0, |size: f64, value| size.max(value.abs()));
        let off = largest_difference(&solution.next, &after.state);
        report.step_difference = report
            .step_difference
            .max(off / size.max(f64::MIN_POSITIVE));
    }
    Ok(report)
}

/// Newton from the guess of the file until the residual no longer shrinks.
pub fn solve(solver: &dyn AnySolver, at: &Point<'_>) -> Option<Solution> {
    let mut guess = vec![0.0; n_unknowns(solver)];
    solver.guess(at, &mut guess);
    solve_from(solver, at, guess)
}

/// The unknowns of the step that was taken, if the states tell them: where a step is so long that the plain guess leads nowhere.
fn accepted(solver: &dyn AnySolver, before: &[f64], after: &[f64]) -> Option<Vec<f64>> {
    let solver = solver.solver();
    let moved = |i: usize| match solver.is_increment() {
        true => after[i] - before[i],
        false => after[i],
    };
    Some(solver.own_states()?.map(moved).collect())
}

fn solve_from(solver: &dyn AnySolver, at: &Point<'_>, guess: Vec<f64>) -> Option<Solution> {
    let n = guess.len();
    let (mut r, mut j) = (vec![0.0; n], vec![0.0; n * n]);
    let mut x = guess.clone();
    let mut forcing = vec![0.0; n];
    solver.residual(at, &x, &mut forcing);
    let mut best: Option<(f64, Vec<f64>)> = None;
    for _ in 0..MAX_ITERATIONS {
        solver.residual(at, &x, &mut r);
        solver.jacobian(at, &x, &mut j);
        let rows = term_sizes(&j, &x, &guess, &forcing);
        let size = in_rounding(&r, &by_equation(solver, &rows));
        match &best {
            Some((smallest, _)) if size >= *smallest && *smallest < RESIDUAL_BOUND => break,
            Some((smallest, _)) if size >= *smallest => {}
            _ => best = Some((size, x.clone())),
        }
        let correction = linear_solution(&j, &r)?;
        x.iter_mut().zip(&correction).for_each(|(x, dx)| *x -= dx);
    }
    let (residual, x) = best?;
    let mut next = vec![0.0; at.state.len()];
    solver.next(at, &x, &mut next);
    Some(Solution { next, residual })
}

/// Per row: Σⱼ |Jᵢⱼ| (|xⱼ| + |guessⱼ|) + |rᵢ(guess)|, the size of the terms that cancel at the solution.
fn term_sizes(j: &[f64], x: &[f64], guess: &[f64], forcing: &[f64]) -> Vec<f64> {
    let sizes: Vec<f64> = x
        .iter()
        .zip(guess)
        .map(|(x, g)| x.abs() + g.abs())
        .collect();
    let weigh = |row: &[f64]| {
        row.iter()
            .zip(&sizes)
            .map(|(j, x)| j.abs() * x)
            .sum::<f64>()
    };
    j.chunks(x.len())
        .zip(forcing)
        .map(|(row, f)| weigh(row) + f.abs())
        .collect()
}

/// For each row the largest size in its equation: in a component of a vector equation terms may cancel
/// exactly, as in ω × Jω of an isotropic body, and leave the rounding of the whole.
fn by_equation(solver: &dyn AnySolver, rows: &[f64]) -> Vec<f64> {
    let mut sizes = Vec::with_capacity(rows.len());
    for equation in solver.solver().equations {
        let components = &rows[sizes.len()..sizes.len() + equation.len];
        let largest = components.iter().copied().fold(0.0, f64::max);
        sizes.extend(std::iter::repeat_n(largest, equation.len));
    }
    sizes
}

/// Largest |rᵢ| / (ε sizeᵢ), infinite if one is not finite.
fn in_rounding(r: &[f64], sizes: &[f64]) -> f64 {
    let ratios = r.iter().zip(sizes).map(|(r, size)| match r.abs() {
        0.0 => 0.0,
        r if r.is_finite() => r / (f64::EPSILON * size),
        _ => f64::INFINITY,
    });
    ratios.fold(0.0, f64::max)
}

/// x with A x = b, by elimination with row pivoting; `None` if A is singular or not finite.
fn linear_solution(a: &[f64], b: &[f64]) -> Option<Vec<f64>> {
    let n = b.len();
    let mut rows: Vec<Vec<f64>> = a
        .chunks(n)
        .zip(b)
        .map(|(row, &b)| [row, &[b]].concat())
        .collect();
    for col in 0..n {
        let pivot = (col..n).max_by(|&p, &q| rows[p][col].abs().total_cmp(&rows[q][col].abs()))?;
        rows.swap(col, pivot);
        let (done, below) = rows.split_at_mut(col + 1);
        let pivot_row = &done[col];
        if pivot_row[col] == 0.0 || !pivot_row[col].is_finite() {
            return None;
        }
        for row in below {
            let factor = row[col] / pivot_row[col];
            for (entry, above) in row.iter_mut().zip(pivot_row).skip(col) {
                *entry -= factor * above;
            }
        }
    }
    let mut x = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| rows[i][k] * x[k]).sum();
        x[i] = (rows[i][n] - known) / rows[i][i];
    }
    Some(x)
}
