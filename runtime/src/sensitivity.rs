//! How what follows from the unknowns of a core magnifies their rounding.

use crate::description::Variable;
use crate::model::Model;
use crate::model::StateArray;
use crate::model::System;
use crate::scalar::Real;

/// Relative size of the moves that sensitivity is measured by, 2⁻²⁶: half of the digits of `f64`.
const MOVE: f64 = 1.490_116_119_384_765_6e-8;

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
) -> T {
    let zero = T::constant(0.0);
    let next = S::next(scene, step, x);
    let (known, next) = (state.as_ref(), next.as_ref());
    let mut most = zero;
    let mut offset = 0;
    for block in S::UNKNOWNS {
        let own = offset..offset + block.len;
        offset = own.end;
        let known_of = block.measure.clone().unwrap_or(0..0);
        let scale = larger(largest(&x.as_ref()[own.clone()]), largest(&known[known_of]));
        for j in own {
            let mut moved = *x;
            moved.as_mut()[j] = moved.as_ref()[j] + T::constant(MOVE) * scale;
            let moved = S::next(scene, step, &moved);
            most = larger(
                most,
                change(S::Model::DESCRIPTION.states, known, next, moved.as_ref()),
            );
        }
    }
    most / T::constant(MOVE)
}

/// The largest change of a variable relative to its scale.
fn change<T: Real>(variables: &[Variable], known: &[T], next: &[T], moved: &[T]) -> T {
    let mut most = T::constant(0.0);
    let mut offset = 0;
    for variable in variables {
        let own = offset..offset + variable.rows * variable.cols;
        offset = own.end;
        let scale = larger(largest(&known[own.clone()]), largest(&next[own.clone()]));
        let pairs = next[own.clone()].iter().zip(&moved[own]);
        let change = pairs.fold(T::constant(0.0), |most, (next, moved)| {
            larger(most, (*moved - *next).abs())
        });
        // Not where both are 0; NaN is no larger than anything, and found elsewhere.
        if change > most * scale {
            most = change / scale;
        }
    }
    most
}

fn largest<T: Real>(values: &[T]) -> T {
    values
        .iter()
        .fold(T::constant(0.0), |most, value| larger(most, value.abs()))
}

fn larger<T: Real>(a: T, b: T) -> T {
    if b > a { b } else { a }
}
