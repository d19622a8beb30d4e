//! `ode_solvers`.

use super::Equations;
use super::MOST_STEPS;
use super::Rival;
use super::Solved;
use super::Task;
use crate::effort::Effort;
use crate::effort::Visit;
use ::num_dual::Dual64;
use ::ode_solvers::Dop853;
use ::ode_solvers::Dopri5;
use ::ode_solvers::OutputType;
use ::ode_solvers::SVector;
use ::ode_solvers::System;
use ::residua::Flow;
use ::residua::Model;
use ::residua::Record;

struct Watched<'e, 'w, M: Flow<f64> + Flow<Dual64>> {
    equations: &'e Equations<M>,
    visit: Option<Visit<'w>>,
}

impl<M, S, D, const N: usize> System<f64, SVector<f64, N>> for Watched<'_, '_, M>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D>,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    #[inline]
    fn system(&self, t: f64, x: &SVector<f64, N>, rates: &mut SVector<f64, N>) {
        let [x] = &x.data.0;
        rates.data.0 = [self.equations.rates(t, x)];
    }

    fn solout(&mut self, _t: f64, x: &SVector<f64, N>, _rates: &SVector<f64, N>) -> bool {
        if let Some(visit) = &mut self.visit {
            visit(x.as_slice());
        }
        false
    }
}

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
    let system = Watched { equations, visit };
    let start = SVector::<f64, N>::from(start);
    let Task {
        until, tolerance, ..
    } = *task;
    // Safety, β, least and largest growth of a step as the crate has them.
    match rival {
        Rival::Dopri5 => {
            let mut solver = Dopri5::from_param(
                system,
                0.0,
                until,
                until,
                start,
                tolerance,
                tolerance,
                0.9,
                0.04,
                0.2,
                10.0,
                until,
                0.0,
                MOST_STEPS,
                1000,
                OutputType::Sparse,
            );
            let stats = solver.integrate().map_err(|error| error.to_string())?;
            end(solver.x_out(), solver.y_out(), &stats)
        }
        _ => {
            let mut solver = Dop853::from_param(
                system,
                0.0,
                until,
                until,
                start,
                tolerance,
                tolerance,
                0.9,
                0.0,
                0.333,
                6.0,
                until,
                0.0,
                MOST_STEPS,
                1000,
                OutputType::Sparse,
            );
            let stats = solver.integrate().map_err(|error| error.to_string())?;
            end(solver.x_out(), solver.y_out(), &stats)
        }
    }
}

fn end<const N: usize>(
    times: &[f64],
    states: &[SVector<f64, N>],
    stats: &::ode_solvers::dop_shared::Stats,
) -> Solved<N> {
    match (times.last(), states.last()) {
        (Some(t), Some(state)) => {
            let effort = Effort {
                steps: u64::from(stats.accepted_steps),
                evaluations: u64::from(stats.num_eval),
            };
            Ok((*t, std::array::from_fn(|i| state[i]), effort))
        }
        _ => Err("it gives no state".to_owned()),
    }
}
