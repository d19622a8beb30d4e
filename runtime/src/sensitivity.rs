//! How what follows from the unknowns of a core magnifies their rounding.

use crate::description::Variable;
use crate::model::Model;
use crate::model::StateArray;
use crate::model::System;
use crate::scalar::Real;
use crate::scalar::Scalar;
use crate::scalar::larger;
use crate::scalar::largest_of;
use crate::settings::MOVES;
use crate::settings::NOTHING;
use crate::settings::REACH;

/// Relative size of the moves that sensitivity is measured by: half of the digits.
#[inline]
fn relative_move<T: Real>() -> T {
    T::EPSILON.sqrt()
}

/// Whether some of the state follows from unknowns that are not its own.
pub(crate) fn follows<S: System<T>, T: Scalar>() -> bool {
    let told = S::UNKNOWNS.iter().filter(|block| block.told);
    let told: usize = told.map(|block| block.len).sum();
    let states = S::Model::DESCRIPTION.states.iter();
    let all: usize = states.map(|state| state.rows * state.cols).sum();
    told < all
}

/// How much larger rounding may be in a state than in the unknowns.
pub(crate) struct Amplification<T> {
    /// Times.
    pub(crate) times: T,
    /// The first component of the variable that it is largest in.
    pub(crate) state: usize,
}

/// The largest change of a state in units of its scale when an unknown moves by a part of its own: how many times rounding
/// of the unknowns grows on its way to the state. Scales are the largest |x| in a block of unknowns and in the state that it advances,
/// and in a state before and after the step.
///
/// Pivots do not tell this: for h ω ≫ 1 the rotation of a step is not known from angular velocities, however well
/// these are.
#[cold]
pub(crate) fn amplification<S: System<T>, T: Real>(
    scene: &S::Scene,
    step: &S::Step,
    x: &S::Unknowns,
    state: &StateArray<S, T>,
) -> Amplification<T> {
    let next = S::next(scene, step, x);
    let (known, next) = (state.as_ref(), next.as_ref());
    let mut most = Amplification {
        times: T::constant(0.0),
        state: 0,
    };
    let mut offset = 0;
    for block in S::UNKNOWNS {
        let own = offset..offset + block.len;
        offset = own.end;
        let known_of = block.measure.clone().unwrap_or(0..0);
        let scale = larger(largest_of(x.as_ref(), &own), largest_of(known, &known_of));
        for (j, part) in own.flat_map(|j| MOVES.map(|part| (j, T::constant(part)))) {
            let mut moved = *x;
            if let Some(moved) = moved.as_mut().get_mut(j) {
                *moved = *moved + part * relative_move::<T>() * scale;
            }
            let moved = S::next(scene, step, &moved);
            let mut change = change(S::Model::DESCRIPTION.states, known, next, moved.as_ref());
            change.times = change.times / part.abs();
            if change.times > most.times {
                most = change;
            }
        }
    }
    most.times = most.times / relative_move::<T>();
    most
}

/// How large a state may become before it is looked at again what rounding of the unknowns does: [`REACH`] times what each
/// variable is, or was before. What follows from the unknowns usually grows with them.
pub(crate) fn reach<S: System<T>, T: Real>(
    before: &StateArray<S, T>,
    state: &StateArray<S, T>,
) -> StateArray<S, T> {
    let mut reach = *before;
    let mut offset = 0;
    for variable in S::Model::DESCRIPTION.states {
        let own = offset..offset + variable.rows * variable.cols;
        offset = own.end;
        // What is 0 throughout is within it.
        let most = T::constant(REACH) * largest_of(state.as_ref(), &own) + T::constant(NOTHING);
        let own = reach.as_mut().iter_mut().take(own.end).skip(own.start);
        own.for_each(|reach| *reach = larger(*reach, most));
    }
    reach
}

/// The largest change of a variable relative to its scale, the largest |x| in it before and after the step.
pub(crate) fn change<T: Real>(
    variables: &[Variable],
    known: &[T],
    next: &[T],
    moved: &[T],
) -> Amplification<T> {
    let mut most = Amplification {
        times: T::constant(0.0),
        state: 0,
    };
    let mut offset = 0;
    for variable in variables {
        let own = offset..offset + variable.rows * variable.cols;
        offset = own.end;
        let scale = larger(largest_of(known, &own), largest_of(next, &own));
        let pairs = next.iter().zip(moved).take(own.end).skip(own.start);
        let change = pairs.fold(T::constant(0.0), |most, (next, moved)| {
            larger(most, (*moved - *next).abs())
        });
        // Not where both are 0; NaN is no larger than anything, and found elsewhere.
        if change > most.times * scale {
            most = Amplification {
                times: change / scale,
                state: own.start,
            };
        }
    }
    most
}
