//! `differential-equations`.

use super::Equations;
use super::MOST_STEPS;
use super::Rival;
use super::Solved;
use super::Task;
use crate::effort::Effort;
use crate::effort::Visit;
use ::differential_equations::interpolate::Interpolation;
use ::differential_equations::ivp::IVP;
use ::differential_equations::methods::ExplicitRungeKutta;
use ::differential_equations::methods::ImplicitRungeKutta;
use ::differential_equations::ode::ODE;
use ::differential_equations::ode::OrdinaryNumericalMethod;
use ::differential_equations::prelude::ControlFlag;
use ::differential_equations::prelude::Solout;
use ::differential_equations::prelude::Solution;
use ::num_dual::Dual64;
use ::residua::Flow;
use ::residua::Model;
use ::residua::Record;

impl<M, S, D, const N: usize> ODE<f64, [f64; N]> for Equations<M>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D>,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    #[inline]
    fn diff(&self, t: f64, x: &[f64; N], rates: &mut [f64; N]) {
        *rates = self.rates(t, x);
    }
}

/// Keeps the last state only.
struct Last<'l, 'v, const N: usize> {
    end: &'l mut (f64, [f64; N]),
    visit: Option<Visit<'v>>,
}

impl<const N: usize> Solout<f64, [f64; N]> for Last<'_, '_, N> {
    fn solout<I>(
        &mut self,
        t: f64,
        _before: f64,
        x: &[f64; N],
        _x_before: &[f64; N],
        _interpolator: &mut I,
        _solution: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        *self.end = (t, *x);
        if let Some(visit) = &mut self.visit {
            visit(x);
        }
        ControlFlag::Continue
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
    let (most, tolerance) = (MOST_STEPS as usize, task.tolerance);
    match rival {
        Rival::DormandPrince853 => {
            let method = ExplicitRungeKutta::dop853().max_steps(most);
            let method = method.rtol(tolerance).atol(tolerance);
            run(method, equations, start, task, visit)
        }
        Rival::Verner98 => {
            let method = ExplicitRungeKutta::rkv988e().max_steps(most);
            let method = method.rtol(tolerance).atol(tolerance);
            run(method, equations, start, task, visit)
        }
        _ => {
            let method = ImplicitRungeKutta::radau5().max_steps(most);
            let method = method.rtol(tolerance).atol(tolerance);
            run(method, equations, start, task, visit)
        }
    }
}

fn run<E, Scheme, const N: usize>(
    method: Scheme,
    equations: &E,
    start: [f64; N],
    task: &Task<'_>,
    visit: Option<Visit<'_>>,
) -> Solved<N>
where
    E: ODE<f64, [f64; N]>,
    Scheme: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    let mut end = (0.0, start);
    let last = Last {
        end: &mut end,
        visit,
    };
    let problem = IVP::ode(equations, 0.0, task.until, start);
    let solved = problem.method(method).solout(last).solve();
    let solution = solved.map_err(|error| format!("{error:?}"))?;
    let effort = Effort {
        steps: solution.steps.accepted as u64,
        evaluations: solution.evals.function as u64,
    };
    Ok((end.0, end.1, effort))
}
