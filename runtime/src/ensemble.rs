//! Ensembles: many independent trajectories of one solver, several at a time and on all cores.
//!
//! Trajectories are taken in groups, in step, by vector instructions, and groups by threads. A step begins with an
//! extrapolated start and mostly ends with one correction; where a trajectory needs more, the others of its group wait
//! and are left as they are; where that does not help, it goes on alone for a while, as a
//! [`Stepper`](crate::Stepper). So no trajectory depends on its neighbours: it has the same bits in any group and with any
//! number of threads.

mod group;
mod judge;
mod kernel;
mod rows;
mod shifts;

use core::marker::PhantomData;
use core::ops::Range;
use std::vec::Vec;

use rayon::iter::IntoParallelIterator;
use rayon::iter::ParallelIterator;

use crate::erased::Sample;
use crate::error::InvalidRun;
use crate::error::RunError;
use crate::integration::validate_time;
use crate::model::Model;
use crate::model::Record;
use crate::model::System;
use crate::report::Statistics;
use crate::settings::Settings;
use group::Group;
use kernel::Emitted;
use kernel::Kernel;

pub use kernel::Wide;
pub use rows::WIDTH;

/// Runs to be made, over flat values: so many steps h from t₀ for each of the trajectories.
pub struct Fleet<'a> {
    /// Which trajectories, by number.
    pub trajectories: Range<usize>,
    /// Overwrites the parameters and the start state of a trajectory, in file order; called once for each.
    pub fill: &'a Fill<'a>,
    /// The step, in s where the model has units; negative runs backwards in time.
    pub h: f64,
    /// The time of the start states.
    pub t0: f64,
    /// Steps to take.
    pub steps: u64,
    /// Shows the start, every so many steps and the end; 0 shows the end only. The last state before a step that
    /// failed is shown in any case.
    pub every: u64,
    /// Of Newton's method.
    pub settings: Settings<f64>,
    /// Takes states, those of one trajectory one after the other. Trajectories come in any order and at the same time.
    pub observer: &'a (dyn Fn(usize, Sample) + Sync),
}

/// Gives a trajectory its parameters and its start state.
pub type Fill<'a> = dyn Fn(usize, &mut [f64], &mut [f64]) + Sync + 'a;

/// How a trajectory ended.
#[derive(Debug, Clone, Copy, Default)]
pub struct Outcome {
    /// What it has cost.
    pub statistics: Statistics,
    /// Steps that it took alone.
    pub alone: u64,
    /// Why it ended early, or did not start.
    pub error: Option<RunError>,
}

/// The solver `S` for many trajectories.
pub struct Ensemble<S>(PhantomData<fn() -> S>);

impl<S: Wide + 'static> Ensemble<S> {
    /// The only value.
    pub const NEW: Self = Self(PhantomData);

    /// Runs trajectories that are given by parameters and start state, with defaults for what [`Fleet`] has besides,
    /// and shows their ends.
    ///
    /// Errors: see [`Ensemble::fly`].
    pub fn run(
        &self,
        runs: &[Given<S>],
        h: f64,
        steps: u64,
        observer: &(dyn Fn(usize, Sample) + Sync),
    ) -> Result<Vec<Outcome>, InvalidRun>
    where
        Given<S>: Sync,
    {
        let fill = |trajectory: usize, parameters: &mut [f64], state: &mut [f64]| {
            let (given, start) = &runs[trajectory];
            parameters.copy_from_slice(given.to_array().as_ref());
            state.copy_from_slice(start.to_array().as_ref());
        };
        self.fly(&Fleet {
            trajectories: 0..runs.len(),
            fill: &fill,
            h,
            t0: 0.0,
            steps,
            every: 0,
            settings: Settings::default(),
            observer,
        })
    }

    /// Runs a fleet on the threads of the current pool of `rayon`, and returns how each trajectory ended.
    ///
    /// Errors: the step is 0, or it or the start time is infinite or NaN.
    pub fn fly(&self, fleet: &Fleet) -> Result<Vec<Outcome>, InvalidRun> {
        fly(&Emitted::<S>::NEW, fleet)
    }
}

/// Parameters and start state of a trajectory.
pub type Given<S> = (
    <<S as System<f64>>::Model as Model<f64>>::Parameters,
    <<S as System<f64>>::Model as Model<f64>>::State,
);

fn fly(kernel: &dyn Kernel, fleet: &Fleet) -> Result<Vec<Outcome>, InvalidRun> {
    if !fleet.h.is_finite() || fleet.h == 0.0 {
        return Err(InvalidRun::StepSize(fleet.h));
    }
    validate_time(fleet.t0, fleet.h)?;
    let Range { start, end } = fleet.trajectories;
    let groups = end.saturating_sub(start).div_ceil(WIDTH);
    let outcomes: Vec<Vec<Outcome>> = (0..groups)
        .into_par_iter()
        .map(|group| {
            let first = start + group * WIDTH;
            Group::new(kernel, fleet, first, WIDTH.min(end - first)).run()
        })
        .collect();
    Ok(outcomes.concat())
}

#[cfg(test)]
mod tests;
