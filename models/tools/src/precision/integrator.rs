//! Our schemes.

use super::contest::Rung;
use crate::study::Case;
use residua::Catalogued;
use residua::Tolerance;
use residua::erased::AnyFlow;
use residua::erased::AnySeries;
use residua::erased::AnySolver;
use residua::erased::Sample;
use residua::erased::Scheme;
use residua_models::effort::Effort;
use residua_models::effort::Visit;
use std::ops::ControlFlow;

/// Steps after which the drift of invariants is looked for, at most.
const LOOKS: u64 = 4096;

/// Outputs between which a scheme that chooses its steps is looked at.
const OUTPUTS: u64 = 256;

/// Orders of Taylor series with a fixed step.
const ORDERS: [usize; 5] = [8, 12, 16, 20, 24];

/// A scheme on a model.
#[derive(Clone, Copy)]
pub enum Integrator {
    /// Newton's method on the discrete equations.
    Newton(&'static dyn AnySolver),
    /// A scheme on the continuous equations, with steps of one length.
    Fixed(&'static dyn AnyFlow, Scheme),
    /// The same with steps as long as a tolerance allows.
    Within(&'static dyn AnyFlow, Scheme),
    /// Taylor series of one order, with steps of one length.
    Series(&'static dyn AnySeries, usize),
    /// The same of an order and with steps that follow from a tolerance.
    SeriesWithin(&'static dyn AnySeries),
}

impl Integrator {
    /// All schemes of a model.
    pub fn of(model: &Catalogued) -> Vec<Self> {
        let mut list: Vec<Self> = model.solvers.iter().map(|s| Self::Newton(*s)).collect();
        if let Some(flow) = model.flow {
            let schemes = Scheme::names().filter_map(Scheme::named);
            let plain = schemes.clone();
            let plain = plain.filter(|scheme| !matches!(scheme, Scheme::Adaptive { .. }));
            list.extend(plain.map(|scheme| Self::Fixed(flow, scheme)));
            let can = schemes.filter(|scheme| scheme.within(Tolerance::default()).is_some());
            list.extend(can.map(|scheme| Self::Within(flow, scheme)));
        }
        if let Some(series) = model.series {
            list.extend(ORDERS.map(|order| Self::Series(series, order)));
            list.push(Self::SeriesWithin(series));
        }
        list
    }

    /// Its name: one with a fixed step as on the command line, others with `adaptive` before it where there are both.
    pub fn name(self) -> String {
        match self {
            Self::Newton(solver) => solver.solver().form.to_owned(),
            Self::Fixed(_, scheme) => scheme.name().to_owned(),
            Self::Within(_, scheme @ Scheme::Adaptive { .. }) => scheme.name().to_owned(),
            Self::Within(_, scheme) => format!("adaptive-{}", scheme.name()),
            Self::Series(_, order) => format!("taylor{order}"),
            Self::SeriesWithin(_) => "adaptive-taylor".to_owned(),
        }
    }

    /// Its order in theory, where the step is fixed.
    pub fn order(self) -> Option<usize> {
        match self {
            Self::Newton(_) => Some(2),
            Self::Fixed(_, scheme) => Some(scheme.order()),
            Self::Series(_, order) => Some(order),
            Self::Within(..) | Self::SeriesWithin(_) => None,
        }
    }

    /// Runs `case` to the time `until`.
    pub fn solve(
        self,
        case: &Case,
        until: f64,
        rung: Rung,
        mut visit: Option<Visit<'_>>,
    ) -> Result<(Vec<f64>, Effort), String> {
        let (h, steps, tolerance) = match rung {
            Rung::Step { h, steps } => (h, steps, 1.0),
            Rung::Tolerance(tolerance) => {
                let outputs = if visit.is_some() { OUTPUTS } else { 1 };
                (until / outputs as f64, outputs, tolerance)
            }
        };
        let tolerance = Tolerance {
            absolute: tolerance,
            relative: tolerance,
        };
        let mut run = case.run(h, steps);
        run.every = if visit.is_some() {
            steps.div_ceil(LOOKS)
        } else {
            0
        };
        let mut end = (0, Vec::new());
        let observer = &mut |sample: Sample<'_>| {
            if let Some(visit) = &mut visit {
                visit(sample.state);
            }
            if sample.step == steps {
                end = (sample.step, sample.state.to_vec());
            }
            ControlFlow::Continue(())
        };
        let outcome = match self {
            Self::Newton(solver) => solver.simulate(&run, observer),
            Self::Fixed(flow, scheme) => flow.simulate(scheme, &run, observer),
            Self::Within(flow, scheme) => {
                let scheme = scheme.within(tolerance).unwrap_or(scheme);
                flow.simulate(scheme, &run, observer)
            }
            Self::Series(series, order) => series.simulate(&run, order, observer),
            Self::SeriesWithin(series) => series.simulate_within(&run, tolerance, observer),
        };
        let statistics = outcome.map_err(|error| error.to_string())?;
        if end.0 != steps {
            return Err("it ends early".to_owned());
        }
        let effort = Effort {
            steps: statistics.steps.max(statistics.accepted),
            evaluations: statistics.flows.max(statistics.iterations),
        };
        Ok((end.1, effort))
    }
}
