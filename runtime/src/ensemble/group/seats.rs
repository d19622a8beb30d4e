//! Who of a group is in step, who takes steps alone, and what each has cost.

use std::mem;
use std::vec;

use super::Group;
use super::QUIET_STEPS;
use super::Seat;
use crate::ensemble::judge;
use crate::ensemble::kernel::Departure;
use crate::ensemble::rows::get;
use crate::report::Statistics;
use crate::settings::Strategy;

impl Group<'_> {
    /// Starts a trajectory: in step, where the model and the settings allow it.
    pub(super) fn seat(&mut self, lane: usize) {
        let settings = self.fleet.settings;
        let can_join = self.kernel.has_correction()
            && settings.strategy == Strategy::Core
            && settings.is_above_rounding();
        // Whoever can start at all can start alone.
        let is_first_alone = can_join && self.is_explicit();
        self.depart(lane, if is_first_alone { 1 } else { u64::MAX });
        let is_alone = matches!(self.seats[lane], Seat::Alone { .. });
        if can_join && is_alone && !is_first_alone {
            self.stand_up(lane);
            self.join(lane);
        }
    }

    fn join(&mut self, lane: usize) {
        self.seats[lane] = Seat::Together;
        self.idle[lane] = 0.0;
        self.together += 1;
        self.iterations[lane] -= self.rounds as i64;
        let quiet = if self.is_explicit() { QUIET_STEPS } else { 0 };
        (self.due[lane], self.quiet_until) = (self.step + quiet, self.step);
        for row in &mut self.lost[0] {
            row[lane] = 0.0;
        }
        self.shifts.forget(lane);
        self.reach.iter_mut().for_each(|row| row[lane] = 0.0);
    }

    /// Lets a trajectory go on alone from the state before the step.
    pub(super) fn depart(&mut self, lane: usize, until: u64) {
        self.stand_up(lane);
        let mut parameters = vec![0.0; self.parameters.len()];
        get(&self.parameters, lane, &mut parameters);
        get(&self.state, lane, &mut self.column);
        let departure = Departure {
            parameters: &parameters,
            state: &self.column,
            h: self.fleet.h,
            t0: self.fleet.t0,
            steps: self.step,
            settings: self.fleet.settings,
        };
        self.seats[lane] = match self.kernel.alone(&departure) {
            Ok(run) => {
                self.alone += 1;
                Seat::Alone { run, until }
            }
            Err(error) => {
                self.outcomes[lane].error = Some(error.into());
                Seat::Out
            }
        };
    }

    /// Takes those back who have been alone long enough.
    pub(super) fn rejoin(&mut self) {
        for lane in 0..self.outcomes.len() {
            match &self.seats[lane] {
                Seat::Alone { until, .. } if *until <= self.step => {}
                _ => continue,
            }
            self.stand_up(lane);
            self.join(lane);
            // Its steps alone were looked at.
            judge::widen(self.kernel.states(), &self.state, lane, &mut self.reach);
        }
    }

    /// Ends a trajectory.
    pub(super) fn leave(&mut self, lane: usize) {
        if !matches!(self.seats[lane], Seat::Out) {
            self.outcomes[lane].statistics = self.statistics(lane);
            self.stand_up(lane);
        }
    }

    /// Leaves a seat, and adds up what it has cost to sit there.
    fn stand_up(&mut self, lane: usize) {
        match mem::replace(&mut self.seats[lane], Seat::Out) {
            Seat::Together => {
                self.together -= 1;
                self.iterations[lane] += self.rounds as i64;
            }
            Seat::Alone { run, .. } => {
                self.alone -= 1;
                add(&mut self.apart[lane], run.statistics());
            }
            Seat::Out => {}
        }
        self.idle[lane] = 1.0;
    }

    /// What a trajectory has cost up to here.
    pub(super) fn statistics(&self, lane: usize) -> Statistics {
        let mut sum = self.apart[lane];
        let mut iterations = self.iterations[lane];
        match &self.seats[lane] {
            Seat::Together => iterations += self.rounds as i64,
            Seat::Alone { run, .. } => add(&mut sum, run.statistics()),
            Seat::Out => {}
        }
        let iterations = iterations as u64;
        let together = Statistics {
            iterations,
            ..Statistics::default()
        };
        add(&mut sum, together);
        sum.steps = self.step;
        sum
    }
}

fn add(sum: &mut Statistics, more: Statistics) {
    sum.iterations += more.iterations;
    sum.residuals += more.residuals;
    sum.fallbacks += more.fallbacks;
    sum.halved += more.halved;
    sum.at_floor += more.at_floor;
}
