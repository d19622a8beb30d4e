//! Schemes for continuous equations, as values.

use super::simulate::Observer;
use super::simulate::Run;
use crate::error::InvalidRun;
use crate::error::RunError;
use crate::integration::Integration;
use crate::integration::Method;
use crate::model::Model;
use crate::report::Statistics;
use crate::scheme::Collocated;
use crate::scheme::Collocation;
use crate::scheme::Composed;
use crate::scheme::Controlled;
use crate::scheme::Ends;
use crate::scheme::Explicit;
use crate::scheme::Pair;
use crate::scheme::Tolerance;
use crate::scheme::VariableGauss;

/// What the continuous equations are integrated with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// The classical Runge–Kutta method, [`RungeKutta4`](crate::RungeKutta4).
    RungeKutta4,
    /// [`Gauss`](crate::Gauss); one stage is the implicit midpoint rule.
    Gauss {
        /// 1 to 8; fewer or more are taken for these.
        stages: usize,
    },
    /// The [`Trapezoidal`](crate::Trapezoidal) rule.
    Trapezoidal,
    /// The [`Composition`](crate::Composition) of implicit midpoint rules.
    Composition {
        /// 4, 6 or 8; what lies between is taken for the next.
        order: usize,
    },
    /// Steps as long as the tolerance allows, between outputs every h.
    Adaptive {
        /// Of the steps.
        pair: Embedded,
        /// Of their errors.
        tolerance: Tolerance,
    },
}

/// A scheme with an error estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Embedded {
    /// [`VariableGauss`](crate::VariableGauss).
    Gauss {
        /// 3 to 8; fewer or more are taken for these.
        stages: usize,
    },
    /// [`DormandPrince5`](crate::DormandPrince5).
    DormandPrince5,
}

/// Names, and what they mean.
const NAMES: [(&str, Scheme); 14] = [
    ("rk4", Scheme::RungeKutta4),
    ("midpoint", Scheme::Gauss { stages: 1 }),
    ("trapezoidal", Scheme::Trapezoidal),
    ("gauss2", Scheme::Gauss { stages: 2 }),
    ("gauss3", Scheme::Gauss { stages: 3 }),
    ("gauss4", Scheme::Gauss { stages: 4 }),
    ("gauss5", Scheme::Gauss { stages: 5 }),
    ("gauss6", Scheme::Gauss { stages: 6 }),
    ("gauss7", Scheme::Gauss { stages: 7 }),
    ("gauss8", Scheme::Gauss { stages: 8 }),
    ("composition4", Scheme::Composition { order: 4 }),
    ("composition6", Scheme::Composition { order: 6 }),
    ("composition8", Scheme::Composition { order: 8 }),
    (
        DORMAND_PRINCE,
        Scheme::Adaptive {
            pair: Embedded::DormandPrince5,
            tolerance: Tolerance {
                absolute: 1e-9,
                relative: 1e-9,
            },
        },
    ),
];

const DORMAND_PRINCE: &str = "dopri5";

impl Scheme {
    /// The scheme of that name, such as `gauss8`.
    pub fn named(name: &str) -> Option<Self> {
        let found = NAMES.iter().find(|(known, _)| *known == name);
        found.map(|(_, scheme)| *scheme)
    }

    /// All names.
    pub fn names() -> impl Iterator<Item = &'static str> + Clone {
        NAMES.iter().map(|(name, _)| *name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let plain = match self {
            Self::Gauss { stages } => Self::Gauss {
                stages: stages.clamp(1, 8),
            },
            Self::Adaptive {
                pair: Embedded::Gauss { stages },
                ..
            } => Self::Gauss {
                stages: stages.clamp(3, 8),
            },
            Self::Adaptive { .. } => return DORMAND_PRINCE,
            Self::Composition { order } => Self::Composition {
                order: order.next_multiple_of(2).clamp(4, 8),
            },
            other => other,
        };
        let found = NAMES.iter().find(|(_, scheme)| *scheme == plain);
        found.map_or("", |(name, _)| name)
    }

    /// The same with steps as long as the tolerance allows; `None` for schemes without an error estimate.
    pub fn within(self, tolerance: Tolerance) -> Option<Self> {
        let pair = match self {
            Self::Gauss { stages } if stages >= 3 => Embedded::Gauss { stages },
            Self::Adaptive { pair, .. } => pair,
            Self::Gauss { .. } | Self::RungeKutta4 | Self::Trapezoidal => return None,
            Self::Composition { .. } => return None,
        };
        Some(Self::Adaptive { pair, tolerance })
    }

    /// p of its error, which is proportional to hᵖ, or, where the step follows the error, of the estimate.
    pub fn order(self) -> usize {
        match self {
            Self::RungeKutta4 => 4,
            Self::Gauss { stages } => 2 * stages.clamp(1, 8),
            Self::Trapezoidal => 2,
            Self::Composition { order } => order.next_multiple_of(2).clamp(4, 8),
            Self::Adaptive {
                pair: Embedded::Gauss { stages },
                ..
            } => 2 * stages.clamp(3, 8) - 1,
            Self::Adaptive { .. } => 5,
        }
    }

    /// Runs `M` by it.
    pub(super) fn simulate<M: Collocated<f64>>(
        self,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        let records = run.records::<M, f64>()?;
        match self {
            Self::RungeKutta4 => {
                let integration = start::<Explicit<M, f64>>(records, run)?;
                run.through(integration, observer)
            }
            Self::Gauss { stages } => {
                let integration = start::<Collocation<M, 8, f64>>(records, run)?;
                run.through(integration.with_stages(stages), observer)
            }
            Self::Trapezoidal => {
                let integration = start::<Ends<M, f64>>(records, run)?;
                run.through(integration, observer)
            }
            Self::Composition { order } => {
                type Composed15<M> = Composed<Collocation<M, 1, f64>, 15, f64>;
                let integration = start::<Composed15<M>>(records, run)?;
                run.through(integration.with_order(order), observer)
            }
            Self::Adaptive {
                pair: Embedded::DormandPrince5,
                tolerance,
            } => {
                let integration = start::<Controlled<Pair<M, f64>, f64>>(records, run)?;
                run.through(integration.with_tolerance(tolerance), observer)
            }
            Self::Adaptive {
                pair: Embedded::Gauss { stages },
                tolerance,
            } => {
                type Method<M> = Controlled<VariableGauss<M, 8, f64>, f64>;
                let integration = start::<Method<M>>(records, run)?;
                let integration = integration.with_stages(stages);
                run.through(integration.with_tolerance(tolerance), observer)
            }
        }
    }
}

/// The run before its first step.
fn start<S: Method<f64>>(
    (parameters, start): (
        <S::Model as Model<f64>>::Parameters,
        <S::Model as Model<f64>>::State,
    ),
    run: &Run,
) -> Result<Integration<S, f64>, InvalidRun> {
    Integration::new(parameters, start, run.h)?.at(run.t0)
}
