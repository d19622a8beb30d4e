//! The generated Jacobian against two derivatives that the generator has no part in.

use super::points::Sampled;
use super::report::{JacobianReport, Worst};
use residua::description::Solver;
use residua::erased::AnySolver;

/// Largest difference from dual numbers taken for rounding, in units of ε times the row's absolute sum.
///
/// Both sides are sums of products with other groupings, each within a few ε per operation of the
/// size of its terms; where terms cancel inside an entry, that is more than the size of the entry. Over
/// 64 points such cancellation costs up to about two digits. A wrong derivative is off by 1e12 and more.
pub const DUAL_BOUND: f64 = 1000.0;

/// Largest difference from central differences, relative to the row's absolute sum. The step δ = ∛ε
/// leaves an error of about δ² = 4e-11 times third derivatives.
pub const CENTRAL_BOUND: f64 = 1e-6;

/// Compares at every point where both sides are finite.
pub fn compare(solver: &dyn AnySolver, points: &[Sampled]) -> JacobianReport {
    let n = points.first().map_or(0, |sampled| sampled.x.len());
    let mut report = JacobianReport::default();
    let (mut exact, mut dual) = (vec![0.0; n * n], vec![0.0; n * n]);
    for sampled in points {
        solver.jacobian(&sampled.point(), &sampled.x, &mut exact);
        solver.dual_jacobian(&sampled.point(), &sampled.x, &mut dual);
        if !exact.iter().chain(&dual).all(|entry| entry.is_finite()) {
            report.skipped += 1;
            continue;
        }
        report.points += 1;
        let central = central_differences(solver, sampled);
        report
            .dual
            .take(difference(&exact, &dual, n, f64::EPSILON), solver.solver());
        report
            .central
            .take(difference(&exact, &central, n, 1.0), solver.solver());
    }
    report
}

/// The largest entry difference in units of `unit` times the absolute sum of its row, and where it is.
fn difference(a: &[f64], b: &[f64], n: usize, unit: f64) -> (f64, usize, usize) {
    let mut worst = (0.0, 0, 0);
    for (row, (a, b)) in a.chunks(n).zip(b.chunks(n)).enumerate() {
        let size: f64 = b.iter().map(|entry| entry.abs()).sum();
        for (col, (a, b)) in a.iter().zip(b).enumerate() {
            let off = (a - b).abs();
            // Not `off > bound * size` at size 0, which would let NaN and wrong zeros pass.
            let relative = if off == 0.0 { 0.0 } else { off / (unit * size) };
            if relative > worst.0 || relative.is_nan() {
                worst = (relative, row, col);
            }
        }
    }
    worst
}

fn central_differences(solver: &dyn AnySolver, sampled: &Sampled) -> Vec<f64> {
    let n = sampled.x.len();
    let mut jacobian = vec![0.0; n * n];
    let mut x = sampled.x.clone();
    let (mut above, mut below) = (vec![0.0; n], vec![0.0; n]);
    for col in 0..n {
        let delta = f64::EPSILON.cbrt() * x[col].abs().max(1.0);
        x[col] = sampled.x[col] + delta;
        let high = x[col];
        solver.residual(&sampled.point(), &x, &mut above);
        x[col] = sampled.x[col] - delta;
        // What was added after rounding, not what was asked for.
        let width = high - x[col];
        solver.residual(&sampled.point(), &x, &mut below);
        x[col] = sampled.x[col];
        for row in 0..n {
            jacobian[row * n + col] = (above[row] - below[row]) / width;
        }
    }
    jacobian
}

impl Worst {
    fn take(&mut self, (value, row, col): (f64, usize, usize), solver: &Solver) {
        // A NaN is never overwritten.
        if value > self.value || value.is_nan() {
            self.value = value;
            self.entry = Some(entry(solver, row, col));
        }
    }
}

/// `∂(row 2 of "4*ΔΓ + … = 0", line 31)/∂(Δω.x)`
fn entry(solver: &Solver, mut row: usize, mut col: usize) -> String {
    let mut above = String::new();
    for equation in solver.equations {
        if row < equation.len {
            let part = if equation.len == 1 {
                String::new()
            } else {
                format!("row {} of ", row + 1)
            };
            above = format!("{part}`{}`, line {}", equation.text, equation.line);
            break;
        }
        row -= equation.len;
    }
    let mut below = String::new();
    for unknown in solver.unknowns {
        if col < unknown.len {
            let part = if unknown.len == 1 {
                String::new()
            } else {
                format!("({})", col + 1)
            };
            below = format!("{}{part}", unknown.name);
            break;
        }
        col -= unknown.len;
    }
    format!("∂({above})/∂({below})")
}
