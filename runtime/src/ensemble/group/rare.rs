//! What a group does now and then: measuring convergence anew, and correcting again where one correction was not enough.

use super::FIRST_ABSENCE;
use super::Group;
use super::NEVER;
use super::QUIET_STEPS;
use crate::ensemble::judge;
use crate::ensemble::kernel::At;
use crate::ensemble::kernel::Landing;
use crate::ensemble::kernel::Start;
use crate::ensemble::rows::Mask;
use crate::ensemble::rows::Row;
use crate::ensemble::rows::WIDTH;
use crate::ensemble::rows::merge;
use crate::ensemble::rows::zeros;
use crate::newton::rate::is_last;
use crate::newton::rate::is_settled;
use crate::newton::rate::is_telling;
use crate::newton::rate::most_enough;
use crate::newton::rate::most_harmless;
use crate::settings::MOST_GROWTH;
use crate::settings::MOST_QUICK;

impl Group<'_> {
    /// Who is to find out now what is enough.
    fn is_due(&self, lane: usize) -> bool {
        self.due[lane] <= self.step && self.idle[lane] == 0.0
    }

    /// Those who are due set out from further away, and with no limit to the first correction but the second.
    #[cold]
    pub(super) fn set_out(&mut self) {
        let due: Mask = core::array::from_fn(|lane| self.is_due(lane));
        let scales = judge::scales(self.kernel.blocks(), &self.state, &self.x);
        self.shifts.set_out(self.arch, &due, &scales);
        if self.is_explicit() {
            let due = (0..WIDTH).filter(|lane| due[*lane]);
            due.for_each(|lane| self.depart(lane, self.step + 1));
        }
        for enough in &mut self.enough {
            for lane in 0..WIDTH {
                enough[lane] = if due[lane] { NEVER } else { enough[lane] };
            }
        }
    }

    /// After a step that was not quiet: who is due next?
    #[cold]
    pub(super) fn settle(&mut self) {
        self.shifts.weigh(&[false; WIDTH]);
        let together = (0..WIDTH).filter(|lane| self.idle[*lane] == 0.0);
        let next = together.map(|lane| self.due[lane]).min();
        // Those who still are due are so in the next step.
        self.quiet_until = next.unwrap_or(u64::MAX);
    }

    /// Goes on with those that one correction was not enough for, and leaves the others as they are.
    #[cold]
    pub(super) fn correct_again(&mut self) {
        let blocks = self.kernel.blocks();
        let (tolerance, has_kinks) = (self.fleet.settings.tolerance, self.kernel.has_kinks());
        let n = self.start.len();
        let mut open: Mask = core::array::from_fn(|i| self.idle[i] == 0.0 && self.within[i] == 0.0);
        self.look_at_grown(&open);
        (0..WIDTH).for_each(|i| open[i] &= self.idle[i] == 0.0);
        let mut before = judge::progress(blocks, &self.state, &self.x, &self.correction, tolerance);
        let first = self.correction.clone();
        let (mut shift, mut next, mut lost) = (zeros(n), self.next.clone(), self.lost[1].clone());
        self.start.copy_from_slice(self.shifts.next());
        let mut last_x = self.x.clone();
        for round in 2..=MOST_QUICK {
            let start = Start {
                t: self.t(),
                scene: &self.scene,
                state: &self.state,
                lost: &self.lost[0],
                shift: &self.start,
                enough: &self.enough,
                harmless: &self.harmless,
                reach: &self.reach,
            };
            let landing = Landing {
                shift: &mut shift,
                x: &mut last_x,
                correction: &mut self.correction,
                next: &mut next,
                lost: &mut lost,
                sound: &mut self.sound,
                within: &mut self.within,
            };
            self.kernel.correct(self.arch, start, landing);
            self.arch.dispatch(judge::Parts {
                blocks,
                state: &self.state,
                x: &last_x,
                correction: &self.correction,
                part: &self.part,
                idle: &self.idle,
                within: &mut self.within,
            });
            let now = judge::progress(blocks, &self.state, &last_x, &self.correction, tolerance);
            if round == 2 {
                let scales = judge::scales(blocks, &self.state, &last_x);
                let most = most_enough(tolerance, has_kinks);
                let limits = judge::limits(blocks, &scales, &first, &self.correction, most);
                let telling = core::array::from_fn(|i| open[i] && is_telling(before.size[i]));
                self.learn(&telling, &limits, &scales);
            }
            let mut accepted = [false; WIDTH];
            for i in 0..WIDTH {
                let is_last = !has_kinks && is_last(now.size[i], before.size[i], tolerance);
                let is_small = now.converged[i] && now.size[i] <= before.size[i];
                let is_settled = is_settled(now.size[i], before.size[i], tolerance);
                let is_within = self.within[i] != 0.0 && is_settled;
                let is_enough = is_within || is_last || is_small;
                accepted[i] = open[i]
                    && self.sound[i] != 0.0
                    && is_enough
                    && (!self.is_due(i) || self.is_known(i, &last_x));
                self.iterations[i] += i64::from(open[i]);
                open[i] &= !accepted[i];
            }
            merge(self.shifts.next(), &shift, &accepted);
            merge(&mut self.next, &next, &accepted);
            merge(&mut self.lost[1], &lost, &accepted);
            merge(&mut self.x, &last_x, &accepted);
            if open == [false; WIDTH] {
                break;
            }
            self.start.copy_from_slice(&shift);
            before = now;
        }
        // What the next step's are compared with.
        self.correction = first;
        for lane in (0..WIDTH).filter(|lane| open[*lane]) {
            self.give_up(lane);
        }
    }

    /// Lets a trajectory go that cannot take this step with its group.
    fn give_up(&mut self, lane: usize) {
        let absence = FIRST_ABSENCE << self.absences[lane].min(32);
        self.absences[lane] += 1;
        self.depart(lane, self.step.saturating_add(absence));
    }

    /// Looks again at those whose states have grown beyond where they were looked at, and lets go whose rounding of the unknowns does not
    /// leave what it should.
    fn look_at_grown(&mut self, open: &Mask) {
        for lane in (0..WIDTH).filter(|lane| open[*lane]) {
            let mut pairs = self.next.iter().zip(&self.reach);
            if !pairs.any(|(next, reach)| next[lane].abs() >= reach[lane]) {
                continue;
            }
            if self.is_explicit() {
                self.depart(lane, self.step + 1);
            } else if self.is_known(lane, &self.x)
                && self.kernel.is_resolved(self.at(lane, &self.x))
            {
                judge::widen(self.kernel.states(), &self.next, lane, &mut self.reach);
            } else {
                self.give_up(lane);
            }
        }
    }

    /// Whether the state after the step follows from the unknowns to more than rounding, which is looked at together with
    /// convergence.
    fn is_known(&self, lane: usize, x: &[Row]) -> bool {
        if !self.follows {
            return true;
        }
        self.kernel.amplification(self.at(lane, x)) <= MOST_GROWTH
    }

    fn at<'b>(&'b self, lane: usize, x: &'b [Row]) -> At<'b> {
        At {
            lane,
            t: self.t(),
            h: self.fleet.h,
            parameters: &self.parameters,
            scene: &self.scene,
            state: &self.state,
            x,
        }
    }

    /// Takes in the limits of those who are due, and the larger ones of others.
    fn learn(&mut self, open: &Mask, limits: &[Row], scales: &[Row]) {
        for lane in (0..WIDTH).filter(|lane| open[*lane]) {
            let is_due = self.is_due(lane);
            if is_due && self.shifts.are_many(lane) {
                self.due[lane] = self.step + 1 + QUIET_STEPS;
            }
            for (harmless, scale) in self.harmless.iter_mut().zip(scales) {
                harmless[lane] = most_harmless::<f64>() * scale[lane];
            }
            let rows = self.enough.iter_mut().zip(&mut self.part);
            for ((enough, part), (limit, scale)) in rows.zip(limits.iter().zip(scales)) {
                let (limit, scale) = (limit[lane], scale[lane]);
                if is_due || limit > enough[lane] {
                    enough[lane] = limit;
                    // What is nothing, and stays so, needs no correction.
                    part[lane] = if limit <= 0.0 { limit } else { limit / scale };
                }
            }
        }
    }
}
