//! Integrators of other crates on the generated `flow`, compiled for each model: nothing between them and it.
//!
//! Tolerances are relative and absolute alike, dense output is off, and no states are kept but the last where the crate
//! allows that.

mod differential_equations;
mod diffsol;
mod ode_solvers;

use crate::effort::Effort;
use crate::effort::Visit;
use ::num_dual::Dual64;
use ::residua::Flow;
use ::residua::Model;
use ::residua::Record;
use std::marker::PhantomData;

/// Steps after which a run is given up: at 100 ns a step they last a second.
pub const MOST_STEPS: u32 = 10_000_000;

/// A scheme of another crate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rival {
    /// `ode_solvers`: Dormand and Prince, order 5(4).
    Dopri5,
    /// `ode_solvers`: Dormand and Prince, order 8(5, 3).
    Dop853,
    /// `differential-equations`: the same of order 8(5, 3).
    DormandPrince853,
    /// `differential-equations`: Verner's most efficient pair of order 9(8).
    Verner98,
    /// `differential-equations`: Radau IIA of order 5, with Jacobians by differences.
    Radau5,
    /// `diffsol`: Tsitouras, order 5(4).
    Tsit45,
    /// `diffsol`: backward differences of variable order, with exact Jacobians.
    Bdf,
}

impl Rival {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Dopri5,
        Self::Dop853,
        Self::DormandPrince853,
        Self::Verner98,
        Self::Radau5,
        Self::Tsit45,
        Self::Bdf,
    ];

    /// Its name.
    pub fn scheme(self) -> &'static str {
        match self {
            Self::Dopri5 => "dopri5",
            Self::Dop853 | Self::DormandPrince853 => "dop853",
            Self::Verner98 => "rkv988e",
            Self::Radau5 => "radau5",
            Self::Tsit45 => "tsit45",
            Self::Bdf => "bdf",
        }
    }

    /// The crate that it is from.
    pub fn package(self) -> &'static str {
        match self {
            Self::Dopri5 | Self::Dop853 => "ode_solvers",
            Self::DormandPrince853 | Self::Verner98 | Self::Radau5 => "differential-equations",
            Self::Tsit45 | Self::Bdf => "diffsol",
        }
    }
}

/// What is to be integrated.
#[derive(Clone, Copy, Debug)]
pub struct Task<'t> {
    /// In file order.
    pub parameters: &'t [f64],
    /// The flat state at t = 0.
    pub start: &'t [f64],
    /// The end, s.
    pub until: f64,
    /// Relative and absolute.
    pub tolerance: f64,
}

/// The continuous equations of a model, integrated by others.
pub trait Rivals: Sync {
    /// The state at the end, and what it took. The states after all steps are shown to a visitor, if there is one.
    ///
    /// # Errors
    /// Where the integrator fails, in its words.
    fn solve(
        &self,
        rival: Rival,
        task: &Task<'_>,
        visit: Option<Visit<'_>>,
    ) -> Result<(Vec<f64>, Effort), String>;
}

/// Finds out whether `M` has continuous equations.
pub struct Probe<M>(PhantomData<fn() -> M>);

impl<M, S, D, const N: usize> Probe<M>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D> + 'static,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    /// They are there.
    pub const RIVALS: Option<&'static dyn Rivals> = Some(&Flowing::<M, N>(PhantomData));
}

/// What is there where a model has none: constants of a type come before those of its traits.
pub trait WithoutFlow {
    /// They are not there.
    const RIVALS: Option<&'static dyn Rivals> = None;
}

impl<M> WithoutFlow for Probe<M> {}

struct Flowing<M, const N: usize>(PhantomData<fn() -> M>);

/// The right-hand side with what depends on the parameters only.
struct Equations<M: Flow<f64> + Flow<Dual64>> {
    scene: <M as Flow<f64>>::FlowScene,
    dual: <M as Flow<Dual64>>::FlowScene,
}

impl<M: Flow<f64> + Flow<Dual64>> Equations<M> {
    fn new(parameters: &[f64]) -> Self {
        Self {
            scene: <M as Flow<f64>>::flow_scene(&record::<M, f64>(parameters)),
            dual: <M as Flow<Dual64>>::flow_scene(&record::<M, Dual64>(parameters)),
        }
    }
}

fn record<M: Model<T>, T: ::residua::Scalar>(parameters: &[f64]) -> M::Parameters {
    let mut array = M::Parameters::default().to_array();
    for (to, from) in array.as_mut().iter_mut().zip(parameters) {
        *to = T::constant(*from);
    }
    M::Parameters::from_array(array)
}

impl<M, S, D, const N: usize> Equations<M>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D>,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    /// dx/dt
    #[inline(always)]
    fn rates(&self, t: f64, x: &[f64; N]) -> [f64; N] {
        <M as Flow<f64>>::flow(&self.scene, t, x)
    }

    /// ∂(dx/dt)/∂x v
    #[inline]
    fn product(&self, t: f64, x: &[f64; N], v: &[f64]) -> [f64; N] {
        let x: [Dual64; N] = std::array::from_fn(|i| Dual64::new(x[i], v[i]));
        let rates = <M as Flow<Dual64>>::flow(&self.dual, Dual64::from(t), &x);
        rates.map(|rate| rate.eps)
    }
}

impl<M, S, D, const N: usize> Rivals for Flowing<M, N>
where
    M: Flow<f64> + Model<f64, State = S> + Flow<Dual64> + Model<Dual64, State = D>,
    S: Record<f64, Array = [f64; N]>,
    D: Record<Dual64, Array = [Dual64; N]>,
{
    fn solve(
        &self,
        rival: Rival,
        task: &Task<'_>,
        visit: Option<Visit<'_>>,
    ) -> Result<(Vec<f64>, Effort), String> {
        let equations = Equations::<M>::new(task.parameters);
        let start: [f64; N] = std::array::from_fn(|i| task.start[i]);
        let solved = match rival {
            Rival::Dopri5 | Rival::Dop853 => {
                ode_solvers::solve(rival, &equations, start, task, visit)
            }
            Rival::DormandPrince853 | Rival::Verner98 | Rival::Radau5 => {
                differential_equations::solve(rival, &equations, start, task, visit)
            }
            Rival::Tsit45 | Rival::Bdf => diffsol::solve(rival, &equations, start, task, visit),
        };
        let (t, end, effort) = solved?;
        // Nobody wins by doing less.
        match (t - task.until).abs() <= 1e-12 * task.until {
            true => Ok((end.to_vec(), effort)),
            false => Err(format!("it ends at {t} s")),
        }
    }
}

/// The state of a run at its end, the time of that, and what it took.
type Solved<const N: usize> = Result<(f64, [f64; N], Effort), String>;
