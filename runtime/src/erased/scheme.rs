//! Schemes for continuous equations, as values.

use super::simulate::Observer;
use super::simulate::Run;
use crate::error::RunError;
use crate::integration::Integration;
use crate::integration::Method;
use crate::report::Statistics;
use crate::scheme::Collocated;
use crate::scheme::Collocation;
use crate::scheme::Explicit;

/// What the continuous equations are integrated with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// The classical Runge–Kutta method, [`RungeKutta4`](crate::RungeKutta4).
    RungeKutta4,
    /// [`Gauss`](crate::Gauss) with so many stages; one is the implicit midpoint rule.
    Gauss {
        /// 1 to 8; fewer or more are taken for these.
        stages: usize,
    },
}

/// Names, and what they mean.
const NAMES: [(&str, Scheme); 10] = [
    ("rk4", Scheme::RungeKutta4),
    ("midpoint", Scheme::Gauss { stages: 1 }),
    ("gauss1", Scheme::Gauss { stages: 1 }),
    ("gauss2", Scheme::Gauss { stages: 2 }),
    ("gauss3", Scheme::Gauss { stages: 3 }),
    ("gauss4", Scheme::Gauss { stages: 4 }),
    ("gauss5", Scheme::Gauss { stages: 5 }),
    ("gauss6", Scheme::Gauss { stages: 6 }),
    ("gauss7", Scheme::Gauss { stages: 7 }),
    ("gauss8", Scheme::Gauss { stages: 8 }),
];

impl Scheme {
    /// The scheme of that name, such as `gauss8`.
    pub fn named(name: &str) -> Option<Self> {
        let found = NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, scheme)| *scheme)
    }

    /// All names.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().map(|(name, _)| *name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let found = NAMES.iter().find(|(_, scheme)| *scheme == self);
        found.map_or("", |(name, _)| name)
    }

    /// Runs `M` by it.
    pub(super) fn simulate<M: Collocated<f64>>(
        self,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        match self {
            Self::RungeKutta4 => by::<Explicit<M, f64>>(run, observer),
            Self::Gauss { stages: 0 | 1 } => by::<Collocation<M, 1, f64>>(run, observer),
            Self::Gauss { stages: 2 } => by::<Collocation<M, 2, f64>>(run, observer),
            Self::Gauss { stages: 3 } => by::<Collocation<M, 3, f64>>(run, observer),
            Self::Gauss { stages: 4 } => by::<Collocation<M, 4, f64>>(run, observer),
            Self::Gauss { stages: 5 } => by::<Collocation<M, 5, f64>>(run, observer),
            Self::Gauss { stages: 6 } => by::<Collocation<M, 6, f64>>(run, observer),
            Self::Gauss { stages: 7 } => by::<Collocation<M, 7, f64>>(run, observer),
            Self::Gauss { .. } => by::<Collocation<M, 8, f64>>(run, observer),
        }
    }
}

fn by<S: Method<f64>>(run: &Run, observer: &mut Observer) -> Result<Statistics, RunError> {
    let (parameters, start) = run.records::<S::Model>()?;
    let integration = Integration::<S, f64>::new(parameters, start, run.h)?.at(run.t0)?;
    run.through(integration, observer)
}
