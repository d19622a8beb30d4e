//! One Newton correction of all trajectories of a group, as a loop over them.
//!
//! The body of the loop is the code that the generator has emitted, without a branch, on [`Lanes`]: the compiler
//! makes vector instructions of it, once for each instruction set, and the machine is asked which to run.

use core::marker::PhantomData;

use pulp::NullaryFnOnce;

use super::Landing;
use super::Start;
use crate::compensated::compensated_sum;
use crate::ensemble::rows::Row;
use crate::ensemble::rows::WIDTH;
use crate::ensemble::rows::lanes;
use crate::ensemble::rows::set_lanes;
use crate::lanes::Lanes;
use crate::model::Cache;
use crate::model::Model;
use crate::model::Record;
use crate::model::System;
use crate::scalar::Scalar;
use crate::settings::MOST_GROWTH;
use crate::settings::USUAL;

/// [`correct`] with its arguments, for [`Arch::dispatch`](pulp::Arch::dispatch).
pub(super) struct Correct<'a, C, const N: usize> {
    pub(super) start: Start<'a>,
    pub(super) landing: Landing<'a>,
    pub(super) system: PhantomData<C>,
}

impl<C: System<Lanes<N>>, const N: usize> NullaryFnOnce for Correct<'_, C, N> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let (from, to) = (self.start, self.landing);
        correct::<C, N>(
            from.t,
            from.scene,
            from.state,
            from.lost,
            from.shift,
            from.enough,
            from.harmless,
            from.reach,
            to.shift,
            to.x,
            to.correction,
            to.next,
            to.lost,
            to.sound,
            to.within,
        );
    }
}

/// x = guess + shift, c = J(x)⁻¹ r(x), x ← x − c, and the state after that.
///
/// All is passed one by one: only references that are arguments are known not to overlap, and only with that known is
/// the loop taken several lanes at a time.
#[inline(always)]
#[expect(clippy::too_many_arguments, reason = "see above")]
fn correct<C: System<Lanes<N>>, const N: usize>(
    t: f64,
    scene: &[Row],
    state: &[Row],
    losses: &[Row],
    shifts: &[Row],
    enough: &[Row],
    harmless: &[Row],
    reach: &[Row],
    shift: &mut [Row],
    x: &mut [Row],
    correction: &mut [Row],
    next: &mut [Row],
    lost: &mut [Row],
    sound: &mut Row,
    within: &mut Row,
) {
    // Only to say how many components there are.
    let parameters = <C::Model as Model<Lanes<N>>>::Parameters::default();
    let states = C::Model::start(&parameters).to_array();
    let (unknowns, _) = C::zeros();

    let n = unknowns.as_ref().len();
    let (shifts, enough, harmless) = (&shifts[..n], &enough[..n], &harmless[..n]);
    let (shift, x, correction) = (&mut shift[..n], &mut x[..n], &mut correction[..n]);
    let n = states.as_ref().len();
    let (state, losses, reach) = (&state[..n], &losses[..n], &reach[..n]);
    let (next, lost) = (&mut next[..n], &mut lost[..n]);
    let scene = &scene[..C::Scene::LEN];
    for i in 0..WIDTH / N {
        let scene = C::Scene::gather(|j| lanes(&scene[j], i));
        let known = columns(states, state, i);
        let step = C::step(&scene, Lanes::constant(t), &known);
        let guess = C::guess(&scene, &step);
        let mut at = guess;
        for (at, shift) in at.as_mut().iter_mut().zip(shifts) {
            *at = *at + lanes(shift, i);
        }

        let (c, growth) = C::correction(&scene, &step, &at);
        let mut is_within = [true; N];
        for j in 0..shifts.len() {
            let (c, enough) = (c.as_ref()[j], lanes::<N>(&enough[j], i));
            let (harmless, before) = (lanes::<N>(&harmless[j], i), lanes::<N>(&correction[j], i));
            let corrected = at.as_ref()[j] - c;
            at.as_mut()[j] = corrected;
            set_lanes(&mut correction[j], i, c);
            set_lanes(&mut x[j], i, corrected);
            set_lanes(&mut shift[j], i, corrected - guess.as_ref()[j]);
            for (k, is_within) in is_within.iter_mut().enumerate() {
                let size = c.0[k].abs();
                let is_usual = (size <= USUAL * before.0[k].abs()) | (size <= harmless.0[k]);
                *is_within &= (size <= enough.0[k]) & is_usual;
            }
        }

        let eliminated = C::growth(&scene, &step, &at);
        let mut after = known;
        if C::HAS_CHANGE {
            let change = C::change(&scene, &step, &at);
            for j in 0..losses.len() {
                let loss = lanes(&losses[j], i);
                let (sum, loss) = compensated_sum(known.as_ref()[j], change.as_ref()[j] + loss);
                after.as_mut()[j] = sum;
                set_lanes(&mut lost[j], i, loss);
            }
        } else {
            after = C::next(&scene, &step, &at);
        }
        let mut is_known = [true; N];
        for (j, next) in next.iter_mut().enumerate() {
            let (after, reach) = (after.as_ref()[j], lanes::<N>(&reach[j], i));
            set_lanes(next, i, after);
            for (k, is_known) in is_known.iter_mut().enumerate() {
                // False for NaN and infinity.
                *is_known &= after.0[k].abs() < reach.0[k];
            }
        }
        for (k, is_within) in is_within.into_iter().enumerate() {
            let at = i + k * (WIDTH / N);
            let is_sound =
                (growth.0[k] <= MOST_GROWTH) & (eliminated.0[k] <= MOST_GROWTH) & is_known[k];
            let is_enough = is_sound & is_within;
            sound[at] = if is_sound { 1.0 } else { 0.0 };
            within[at] = if is_enough { 1.0 } else { 0.0 };
        }
    }
}

/// Column `i` of `rows`, in an array like `shape`.
#[inline(always)]
fn columns<A: AsMut<[Lanes<N>]>, const N: usize>(mut shape: A, rows: &[Row], i: usize) -> A {
    for (component, row) in shape.as_mut().iter_mut().zip(rows) {
        *component = lanes(row, i);
    }
    shape
}
