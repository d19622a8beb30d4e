//! A group of trajectories that take their steps together.

mod rare;
mod seats;

use std::boxed::Box;
use std::mem;
use std::vec;
use std::vec::Vec;

use pulp::Arch;

use super::Fleet;
use super::Outcome;
use super::judge;
use super::kernel::Alone;
use super::kernel::Kernel;
use super::kernel::Landing;
use super::kernel::Start;
use super::rows::Row;
use super::rows::WIDTH;
use super::rows::all;
use super::rows::get;
use super::rows::put;
use super::rows::zeros;
use super::shifts::Shifts;
use crate::erased::Sample;
use crate::error::RunError;
use crate::report::Statistics;

/// Steps that a trajectory takes alone after one that it could not take with its group. Each time twice as many as
/// before: more keeps it from disturbing the group, fewer gets it back to its speed.
const FIRST_ABSENCE: u64 = 32;

/// Steps after which convergence is measured again. All of a group wait for that, so more of them than of one trajectory: with
/// 63, groups would be a sixth slower.
const QUIET_STEPS: u64 = 255;

/// The limit of a trajectory that is to be corrected more than once.
const NEVER: f64 = -1.0;

/// Where a trajectory is.
enum Seat {
    /// In step with the others.
    Together,
    /// On its own until it has taken so many steps.
    Alone { run: Box<dyn Alone>, until: u64 },
    /// It has failed, or there is none.
    Out,
}

/// Trajectories `first`, `first + 1`, … of a fleet, at most [`WIDTH`].
pub(super) struct Group<'a> {
    kernel: &'a dyn Kernel,
    fleet: &'a Fleet<'a>,
    arch: Arch,
    first: usize,
    step: u64,
    parameters: Vec<Row>,
    scene: Vec<Row>,
    state: Vec<Row>,
    next: Vec<Row>,
    /// What the sums of increments have lost to rounding, before and after the step.
    lost: [Vec<Row>; 2],
    shifts: Shifts,
    /// First corrections up to here leave less than rounding, as second ones told,
    enough: Vec<Row>,
    /// if they are also no more than that part of their scales.
    part: Vec<Row>,
    /// Those up to here leave little, whatever the equations have become.
    harmless: Vec<Row>,
    /// Some of the state follows from unknowns that are not its own.
    follows: bool,
    /// States below that are resolved, and known from the unknowns, as they were where that was looked at.
    reach: Vec<Row>,
    /// The step at which convergence is measured anew.
    due: [u64; WIDTH],
    /// The first step at which it is for any trajectory.
    quiet_until: u64,
    start: Vec<Row>,
    x: Vec<Row>,
    correction: Vec<Row>,
    sound: Row,
    within: Row,
    /// 1 for those that are not in step, else 0.
    idle: Row,
    seats: Vec<Seat>,
    together: usize,
    alone: usize,
    absences: [u32; WIDTH],
    /// First corrections of all, and what each trajectory had more or less.
    rounds: u64,
    iterations: [i64; WIDTH],
    /// What earlier steps alone have cost.
    apart: [Statistics; WIDTH],
    outcomes: Vec<Outcome>,
    /// A state, for the observer.
    column: Vec<f64>,
}

impl<'a> Group<'a> {
    /// `count` trajectories at their starts.
    pub(super) fn new(
        kernel: &'a dyn Kernel,
        fleet: &'a Fleet<'a>,
        first: usize,
        count: usize,
    ) -> Self {
        let sizes = kernel.sizes();
        let rows = |n| zeros(n);
        let mut group = Self {
            kernel,
            fleet,
            arch: Arch::new(),
            first,
            step: 0,
            parameters: rows(sizes.parameters),
            scene: rows(sizes.scene),
            state: rows(sizes.state),
            next: rows(sizes.state),
            lost: [rows(sizes.state), rows(sizes.state)],
            shifts: Shifts::new(sizes.unknowns),
            enough: vec![all(NEVER); sizes.unknowns],
            part: rows(sizes.unknowns),
            harmless: rows(sizes.unknowns),
            follows: kernel.follows(),
            reach: rows(sizes.state),
            due: [0; WIDTH],
            quiet_until: 0,
            start: rows(sizes.unknowns),
            x: rows(sizes.unknowns),
            correction: rows(sizes.unknowns),
            sound: all(0.0),
            within: all(0.0),
            idle: all(1.0),
            seats: (0..WIDTH).map(|_| Seat::Out).collect(),
            together: 0,
            alone: 0,
            absences: [0; WIDTH],
            rounds: 0,
            iterations: [0; WIDTH],
            apart: [Statistics::default(); WIDTH],
            outcomes: vec![Outcome::default(); count],
            column: vec![0.0; sizes.state],
        };
        let mut parameters = vec![0.0; sizes.parameters];
        let mut scene = vec![0.0; sizes.scene];
        for lane in 0..WIDTH {
            // Empty seats compute what the last one does, and nobody looks.
            if lane < count {
                (fleet.fill)(first + lane, &mut parameters, &mut group.column);
                kernel.scene(&parameters, fleet.h, &mut scene);
            }
            put(&mut group.parameters, lane, &parameters);
            put(&mut group.scene, lane, &scene);
            put(&mut group.state, lane, &group.column);
            if lane < count {
                group.seat(lane);
            }
        }
        group
    }

    /// Takes all steps.
    pub(super) fn run(mut self) -> Vec<Outcome> {
        let Fleet { steps, every, .. } = *self.fleet;
        if every > 0 {
            self.show();
        }
        while self.step < steps && self.together + self.alone > 0 {
            self.advance();
            if self.step == steps || (every > 0 && self.step.is_multiple_of(every)) {
                self.show();
            }
        }
        for lane in 0..self.outcomes.len() {
            self.leave(lane);
        }
        self.outcomes
    }

    /// Nothing is iterated on, and no correction shows what goes wrong: now and then, each trajectory takes a step alone.
    fn is_explicit(&self) -> bool {
        self.start.is_empty()
    }

    fn advance(&mut self) {
        if self.together > 0 {
            self.advance_together();
        }
        if self.alone > 0 {
            self.advance_alone();
        }
        mem::swap(&mut self.state, &mut self.next);
        self.step += 1;
        if self.alone > 0 {
            self.rejoin();
        }
    }

    #[inline]
    fn advance_together(&mut self) {
        let t = self.t();
        let is_quiet = self.step < self.quiet_until;
        if !is_quiet {
            self.set_out();
        }
        self.shifts.ahead(self.arch, &mut self.start);
        let [lost, lost_next] = &mut self.lost;
        let start = Start {
            t,
            scene: &self.scene,
            state: &self.state,
            lost,
            shift: &self.start,
            enough: &self.enough,
            harmless: &self.harmless,
            reach: &self.reach,
        };
        let landing = Landing {
            shift: self.shifts.next(),
            x: &mut self.x,
            correction: &mut self.correction,
            next: &mut self.next,
            lost: lost_next,
            sound: &mut self.sound,
            within: &mut self.within,
        };
        self.kernel.correct(self.arch, start, landing);
        self.rounds += 1;
        if !self.are_all_within() {
            self.correct_again();
        }
        if !is_quiet {
            self.settle();
        }
        if self.fleet.settings.compensated {
            self.lost.swap(0, 1);
        }
        self.shifts.push();
    }

    /// Whether the correction was enough for all; not for those that it was a larger part of `x` than was ever enough.
    #[inline]
    fn are_all_within(&mut self) -> bool {
        self.arch.dispatch(judge::Parts {
            blocks: self.kernel.blocks(),
            state: &self.state,
            x: &self.x,
            correction: &self.correction,
            part: &self.part,
            idle: &self.idle,
            within: &mut self.within,
        })
    }

    /// The steps of those that are alone. Who fails is shown where it was, and out.
    fn advance_alone(&mut self) {
        for lane in 0..self.outcomes.len() {
            let Seat::Alone { run, .. } = &mut self.seats[lane] else {
                continue;
            };
            match run.step() {
                Ok(()) => {
                    self.outcomes[lane].alone += 1;
                    put(&mut self.next, lane, run.state());
                }
                Err(error) => {
                    self.show_one(lane);
                    self.outcomes[lane].error = Some(RunError::Step(error));
                    self.leave(lane);
                }
            }
        }
    }

    fn t(&self) -> f64 {
        self.fleet.t0 + self.step as f64 * self.fleet.h
    }

    fn show(&mut self) {
        for lane in 0..self.outcomes.len() {
            if !matches!(self.seats[lane], Seat::Out) {
                self.show_one(lane);
            }
        }
    }

    fn show_one(&mut self, lane: usize) {
        get(&self.state, lane, &mut self.column);
        let sample = Sample {
            step: self.step,
            t: self.t(),
            state: &self.column,
            statistics: self.statistics(lane),
        };
        (self.fleet.observer)(self.first + lane, sample);
    }
}
