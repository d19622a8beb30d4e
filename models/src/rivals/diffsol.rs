//! `diffsol`, on its vectors of nalgebra.

use super::Equations;
use super::MOST_STEPS;
use super::Rival;
use super::Solved;
use super::Task;
use crate::effort::Effort;
use crate::effort::Visit;
use ::diffsol::DiffsolError;
use ::diffsol::NalgebraLU;
use ::diffsol::NalgebraMat;
use ::diffsol::OdeBuilder;
use ::diffsol::OdeEquations;
use ::diffsol::OdeSolverMethod;
use ::diffsol::OdeSolverStopReason;
use ::num_dual::Dual64;
use ::residua::Flow;
use ::residua::Model;
use ::residua::Record;
use std::cell::Cell;

pub fn solve<M, S, D, const N: usize>(
    rival: Rival,
    equations: &Equations<M>,
    start: [f64; N],
    task: &Task<'_>,
    visit: Option<Visit<'_>>,
) -> Solved<N>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D>,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    let calls = Cell::new(0);
    let whole = |x: &[f64]| -> [f64; N] { std::array::from_fn(|i| x[i]) };
    let rates = |x: &[f64], _: &[f64], t: f64, out: &mut [f64]| {
        calls.set(calls.get() + 1);
        out.copy_from_slice(&equations.rates(t, &whole(x)));
    };
    let product = |x: &[f64], _: &[f64], t: f64, v: &[f64], out: &mut [f64]| {
        out.copy_from_slice(&equations.product(t, &whole(x), v));
    };
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(task.tolerance)
        .atol([task.tolerance])
        .rhs_implicit(rates, product)
        .init(|_: &[f64], _, x: &mut [f64]| x.copy_from_slice(&start), N)
        .build()
        .map_err(|error| error.to_string())?;
    let solved = match rival {
        Rival::Tsit45 => problem
            .tsit45()
            .and_then(|solver| run(solver, task.until, visit)),
        _ => problem
            .bdf::<NalgebraLU<f64>>()
            .and_then(|solver| run(solver, task.until, visit)),
    };
    let (t, end, steps) = solved.map_err(|error| error.to_string())?;
    let evaluations = calls.get();
    Ok((t, end, Effort { steps, evaluations }))
}

fn run<'a, E, Solver, const N: usize>(
    mut solver: Solver,
    until: f64,
    mut visit: Option<Visit<'_>>,
) -> Result<(f64, [f64; N], u64), DiffsolError>
where
    E: OdeEquations<T = f64> + 'a,
    Solver: OdeSolverMethod<'a, E>,
    E::V: std::ops::Index<usize, Output = f64>,
{
    solver.set_stop_time(until)?;
    let mut steps = 0;
    loop {
        let stop = solver.step()?;
        steps += 1;
        let state = solver.state();
        let is_last = !matches!(stop, OdeSolverStopReason::InternalTimestep);
        if is_last || visit.is_some() {
            let x: [f64; N] = std::array::from_fn(|i| state.y[i]);
            if let Some(visit) = &mut visit {
                visit(&x);
            }
            // One that has not arrived is found out by its time.
            if is_last || steps >= u64::from(MOST_STEPS) {
                return Ok((state.t, x, steps));
            }
        } else if steps >= u64::from(MOST_STEPS) {
            return Ok((state.t, [f64::NAN; N], steps));
        }
    }
}
