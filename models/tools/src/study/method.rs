//! A way to step a model.

use residua::Catalogued;
use residua::RunError;
use residua::Statistics;
use residua::erased::AnyFlow;
use residua::erased::AnySolver;
use residua::erased::Observer;
use residua::erased::Run;
use residua::erased::Scheme;

/// A generated solver or a baseline.
#[derive(Clone, Copy)]
pub enum Method {
    /// Newton's method on the discrete equations.
    Newton(&'static dyn AnySolver),
    /// The classical Runge–Kutta method on the continuous equations.
    RungeKutta4(&'static dyn AnyFlow),
}

impl Method {
    /// All methods of a model, the generated ones first.
    pub fn of(model: &Catalogued) -> Vec<Self> {
        let solvers = model.solvers.iter().map(|solver| Method::Newton(*solver));
        solvers.chain(model.flow.map(Method::RungeKutta4)).collect()
    }

    /// `next`, `increment` or `RK4`.
    pub fn name(self) -> &'static str {
        match self {
            Method::Newton(solver) => solver.solver().form,
            Method::RungeKutta4(_) => "RK4",
        }
    }

    /// The order of the method in theory: the paper's schemes are midpoint rules.
    pub fn order(self) -> i32 {
        match self {
            Method::Newton(_) => 2,
            Method::RungeKutta4(_) => 4,
        }
    }

    /// Runs it.
    ///
    /// # Errors
    /// As the solver's own `simulate`.
    pub fn simulate(self, run: &Run, observer: &mut Observer) -> Result<Statistics, RunError> {
        match self {
            Method::Newton(solver) => solver.simulate(run, observer),
            Method::RungeKutta4(flow) => flow.simulate(Scheme::RungeKutta4, run, observer),
        }
    }
}
