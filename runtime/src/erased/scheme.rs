//! Schemes for continuous equations, as values.

use super::simulate::Observer;
use super::simulate::Run;
use crate::error::RunError;
use crate::integration::Integration;
use crate::integration::Method;
use crate::report::Statistics;
use crate::scheme::Adaptive;
use crate::scheme::Collocated;
use crate::scheme::Collocation;
use crate::scheme::Composed;
use crate::scheme::DormandPrince5;
use crate::scheme::Ends;
use crate::scheme::Explicit;
use crate::scheme::Gauss;
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
        match self {
            Self::RungeKutta4 => by::<Explicit<M, f64>>(run, observer),
            Self::Gauss { stages } => {
                let (parameters, start) = run.records::<M>()?;
                let integration = Gauss::<M, 8>::new(parameters, start, run.h)?.at(run.t0)?;
                run.through(integration.with_stages(stages), observer)
            }
            Self::Trapezoidal => by::<Ends<M, f64>>(run, observer),
            Self::Composition { order: 0..=4 } => {
                by::<Composed<Collocation<M, 1, f64>, 5, f64>>(run, observer)
            }
            Self::Composition { order: 5 | 6 } => {
                by::<Composed<Collocation<M, 1, f64>, 9, f64>>(run, observer)
            }
            Self::Composition { .. } => {
                by::<Composed<Collocation<M, 1, f64>, 15, f64>>(run, observer)
            }
            Self::Adaptive { pair, tolerance } => pair.simulate::<M>(tolerance, run, observer),
        }
    }
}

impl Embedded {
    fn simulate<M: Collocated<f64>>(
        self,
        tolerance: Tolerance,
        run: &Run,
        observer: &mut Observer,
    ) -> Result<Statistics, RunError> {
        match self {
            Self::DormandPrince5 => {
                let (parameters, start) = run.records::<M>()?;
                let integration = DormandPrince5::<M>::new(parameters, start, run.h)?.at(run.t0)?;
                run.through(integration.with_tolerance(tolerance), observer)
            }
            Self::Gauss { stages } => {
                let (parameters, start) = run.records::<M>()?;
                let integration =
                    Adaptive::<VariableGauss<M, 8, f64>>::new(parameters, start, run.h)?
                        .at(run.t0)?;
                let integration = integration.with_stages(stages).with_tolerance(tolerance);
                run.through(integration, observer)
            }
        }
    }
}

fn by<S: Method<f64>>(run: &Run, observer: &mut Observer) -> Result<Statistics, RunError> {
    let (parameters, start) = run.records::<S::Model>()?;
    let integration = Integration::<S, f64>::new(parameters, start, run.h)?.at(run.t0)?;
    run.through(integration, observer)
}
