//! What rounding of the unknowns does to the equations.

use super::Solved;
use super::weighted;
use crate::description::Unknown;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::newton::scales;
use crate::scalar::Real;
use crate::scalar::larger;
use crate::settings::AT_ROUNDING;
use crate::settings::BLURRED;
use crate::settings::FAR;
use crate::settings::MOVES;

impl<S: Correctable<T>, T: Real> Solved<S, T> {
    /// The first equation that rounding of the unknowns makes another one: where each moves by a few ε, up or down, the row of
    /// the Jacobian changes by more than a share of itself, Σ |ΔJᵢⱼ| |xⱼ| > share Σ |Jᵢⱼ| |xⱼ|. Independent of units.
    ///
    /// Not so where a move many times larger changes it as many times more: there the row vanishes, as (x − L)³ and its slope do
    /// at L.
    ///
    /// In a sine of 10⁷ radians, of which `f32` holds only every one, a correction is small beside the angle wherever the iterate
    /// is, and leads to no solution.
    pub(super) fn unresolved(&self) -> Option<Fault> {
        let Self {
            scene,
            step,
            state,
            x,
            ..
        } = self;
        let rounding = rounding::<S, T>(state.as_ref(), x);
        let jacobian = |part: f64| {
            let mut moved = *x;
            for (x, rounding) in moved.as_mut().iter_mut().zip(rounding.as_ref()) {
                *x = *x + T::constant(part) * *rounding;
            }
            let (mut r, mut j) = S::zeros();
            S::residual_and_jacobian(scene, step, &moved, &mut r, &mut j);
            j
        };
        let scales = scales::<S, T>(state.as_ref(), x);
        let n = scales.as_ref().len();
        let here = jacobian(0.0);
        let [up, down, less] = MOVES.map(jacobian);
        let far = jacobian(FAR * MOVES[1]);
        let size = |i| weighted(here.row(i).iter().copied(), scales.as_ref());
        let change = |there: &S::Jacobian, i| {
            let pairs = there.row(i).iter().zip(here.row(i));
            weighted(pairs.map(|(there, here)| *there - *here), scales.as_ref())
        };
        // What has no value there tells nothing.
        let is_another = |there, i| change(there, i) > T::constant(BLURRED) * size(i);
        let is_saturated = |i| change(&far, i) <= T::constant(0.5 * FAR) * change(&down, i);
        // An edge is on one side.
        let row = (0..n).find(|&i| {
            is_another(&down, i) && (is_another(&up, i) || is_another(&less, i)) && is_saturated(i)
        })?;
        Some(Fault {
            failure: Failure::Unresolved,
            place: Place::Equation(row),
            value: 0.0,
        })
    }
}

/// A few ε of each unknown: of itself, or of the component that it advances.
fn rounding<S: Correctable<T>, T: Real>(known: &[T], x: &S::Unknowns) -> S::Unknowns {
    let mut rounding = *x;
    let mut own = rounding.as_mut().iter_mut();
    let blocks: &[Unknown] = S::UNKNOWNS;
    for block in blocks {
        let measure = block.measure.clone().unwrap_or(0..0);
        let mut advanced = known.iter().take(measure.end).skip(measure.start);
        for x in own.by_ref().take(block.len) {
            let known = advanced
                .next()
                .map_or(T::constant(0.0), |known| known.abs());
            *x = T::constant(AT_ROUNDING) * T::EPSILON * larger(x.abs(), known);
        }
    }
    rounding
}

#[cfg(test)]
mod tests {
    use super::Solved;
    use crate::description::Unknown;
    use crate::error::Place;
    use crate::specimens::root::Evaluated;
    use crate::specimens::root::Problem;
    use crate::specimens::root::Root;

    /// x − 2 sin x = 0, and nothing but itself for y.
    struct Wave;
    impl Problem<2> for Wave {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            let r = [y - 1.0, x - 2.0 * x.sin()];
            (r, [[0.0, 1.0], [1.0 - 2.0 * x.cos(), 0.0]])
        }
    }

    /// The equation that is blamed.
    fn row<P: Problem<2>>(state: [f64; 2], x: [f64; 2]) -> Option<Place> {
        let solved = Solved::<Root<P, 2>, f64>::of_root(state, x);
        solved.unresolved().map(|fault| fault.place)
    }

    #[test]
    fn a_sine_of_more_than_the_format_resolves_is_found() {
        let row = |x: f64| row::<Wave>([0.0; 2], [x, 1.0]);
        for x in [0.0, 1.0, 1e6, 1e13] {
            assert_eq!(row(x), None, "{x:e}");
        }
        for x in [1e15, 1e16, 1e200] {
            assert_eq!(row(x), Some(Place::Equation(1)), "{x:e}");
        }
    }

    /// √x and a stiff floor at 1, with an edge there.
    struct Edge;
    impl Problem<2> for Edge {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            let (force, stiffness) = if y < 1.0 {
                (1e6 * (1.0 - y), 1e6)
            } else {
                (0.0, 0.0)
            };
            let r = [x.sqrt(), y - 1.0 - force];
            (r, [[0.5 / x.sqrt(), 0.0], [0.0, 1.0 + stiffness]])
        }
    }

    /// Nothing moves, and nothing holds x.
    struct Cubic;
    impl Problem<2> for Cubic {
        fn evaluate([x, v]: [f64; 2]) -> Evaluated<2> {
            let r = [v + (x - 1.0).powi(3), x - 1.0 - v];
            (r, [[3.0 * (x - 1.0).powi(2), 1.0], [1.0, -1.0]])
        }
        const UNKNOWNS: &'static [Unknown] = &[
            Unknown {
                name: "x",
                len: 1,
                measure: Some(0..1),
                told: true,
            },
            Unknown {
                name: "v",
                len: 1,
                measure: Some(1..2),
                told: true,
            },
        ];
    }

    #[test]
    fn a_stiffness_that_vanishes_is_no_lack_of_digits() {
        for x in [1.0, 1.0 + f64::EPSILON, 1.0 - 1e-15] {
            assert_eq!(row::<Cubic>([x, 0.0], [x, 0.0]), None, "{x:?}");
        }
    }

    #[test]
    fn edges_are_not_blamed() {
        for x in [[1.0, 1.0], [1e-20, 1.0], [0.0, 1.0_f64.next_down()]] {
            assert_eq!(row::<Edge>([0.0; 2], x), None, "{x:?}");
        }
    }
}
