//! What rounding of the equations does to the state.

use super::Solved;
use super::weighted;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::model::Model;
use crate::newton::scales;
use crate::newton::subtract;
use crate::scalar::Real;
use crate::sensitivity::Amplification;
use crate::sensitivity::change;
use crate::settings::ROUNDING;
use crate::settings::most_growth;

impl<S: Correctable<T>, T: Real> Solved<S, T> {
    /// The first equation that loses its digits before they get to the Jacobian, and with them those of the state: it has many
    /// roots in these numbers, and Newton's method stops at any of them.
    ///
    /// With a bound eᵢ of rounding in equation i, J⁻¹ e moves the state after the step by more than the tenth digit, in `f32` the
    /// fifth, and eᵢ is more than rounding of Σ |Jᵢⱼ| |xⱼ|: otherwise the unknowns, moved by a few ε, make up for it.
    ///
    /// (c + x)² − c² of x = 1 and c = 10¹² are 0 or 3 times what they should be, and the slope 2 (c + x) is right to all digits.
    pub(super) fn drowned(&self) -> Option<Fault> {
        let Self {
            scene,
            step,
            state,
            x,
            ..
        } = self;
        let (errors, errors_after) = S::rounding(&self.parameters, self.h, self.t, state, x);
        let next = S::next(scene, step, x);
        let states = S::Model::DESCRIPTION.states;
        let change_to = |there: &[T]| change::<T>(states, state.as_ref(), next.as_ref(), there);
        let digits = most_growth::<T>() * T::EPSILON;

        let (mut r, mut j) = S::zeros();
        S::residual_and_jacobian(scene, step, x, &mut r, &mut j);
        let scales = scales::<S, T>(state.as_ref(), x);
        for (i, error) in errors.as_ref().iter().enumerate() {
            let terms = weighted(j.row(i).iter().copied(), scales.as_ref());
            if *error <= T::constant(ROUNDING) * T::EPSILON * terms {
                continue;
            }
            r.as_mut().fill(T::constant(0.0));
            r.as_mut()
                .iter_mut()
                .skip(i)
                .take(1)
                .for_each(|r| *r = *error);
            let Some(correction) = j.solve(&r) else {
                continue;
            };
            let mut moved = *x;
            subtract(&mut moved, &correction);
            let times = change_to(S::next(scene, step, &moved).as_ref()).times;
            if times > digits {
                return Some(drowned(Place::Equation(i), times));
            }
        }
        // What follows from the unknowns. Where an `update` gives 0 as before, it has no size that digits could be counted of.
        let solver = S::Model::DESCRIPTION.solvers.get(S::SOLVER);
        let mut moved = next;
        let pairs = moved.as_mut().iter_mut().zip(errors_after.as_ref());
        for ((i, (moved, error)), before) in pairs.enumerate().zip(state.as_ref()) {
            let is_nothing = *moved == T::constant(0.0) && *before == T::constant(0.0);
            if !is_nothing || solver.is_some_and(|solver| solver.solves_for(i)) {
                *moved = *moved - *error;
            }
        }
        let Amplification { times, state } = change_to(moved.as_ref());
        (times > digits).then(|| drowned(Place::State(state), times))
    }
}

fn drowned<T: Real>(place: Place, part: T) -> Fault {
    Fault {
        failure: Failure::Drowned,
        place,
        value: part.to_f64(),
    }
}

#[cfg(test)]
mod tests {
    use super::Solved;
    use crate::description::Unknown;
    use crate::error::Place;
    use crate::specimens::root::Evaluated;
    use crate::specimens::root::Flat;
    use crate::specimens::root::Problem;
    use crate::specimens::root::Root;

    /// x = 2 y and y = 1, with `E`/10¹⁵ lost in the first.
    struct Lossy<const E: u32>;
    impl<const E: u32> Problem<2> for Lossy<E> {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            ([x - 2.0 * y, y - 1.0], [[1.0, -2.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[f64::from(E) * 1e-15, 0.0], [0.0; 2]]
        }
    }

    /// The same, where y is 10⁷ times as large: as much is rounding of the unknowns.
    struct Large;
    impl Problem<2> for Large {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            ([x - 2.0 * y + 2e7, y - 1e7], [[1.0, -2.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[4e-8, 0.0], [0.0; 2]]
        }
        const UNKNOWNS: &'static [Unknown] = &[SOLVED, ANOTHER];
        fn next(_known: [f64; 2], [x, _]: [f64; 2]) -> [f64; 2] {
            [x, 1e-7]
        }
    }

    const SOLVED: Unknown = Unknown {
        name: "x[k+1]",
        len: 1,
        measure: Some(0..1),
        told: true,
    };
    const ANOTHER: Unknown = Unknown {
        name: "y",
        len: 1,
        measure: None,
        told: false,
    };

    /// x = 1 and an update of the other component, which gives `N` with an error of 10⁻⁹.
    struct Updated<const N: u32>;
    impl<const N: u32> Problem<2> for Updated<N> {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            ([x - 1.0, y - 1.0], [[1.0, 0.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[0.0; 2], [0.0, 1e-9]]
        }
        const UNKNOWNS: &'static [Unknown] = &[SOLVED, ANOTHER];
        fn next(_known: [f64; 2], [x, _]: [f64; 2]) -> [f64; 2] {
            [x, f64::from(N)]
        }
    }

    /// What is blamed, and the part by which the state moves.
    fn loss<P: Problem<2>>(x: [f64; 2]) -> Option<(Place, f64)> {
        let state = [0.0; 2];
        let solved = Solved::<Root<P, 2>, f64> {
            parameters: Flat([]),
            h: 1.0,
            t: 0.0,
            scene: (),
            step: state,
            state,
            x,
        };
        let fault = solved.drowned()?;
        Some((fault.place, fault.value))
    }

    #[test]
    fn an_equation_that_loses_digits_is_blamed() {
        assert_eq!(loss::<Lossy<0>>([2.0, 1.0]), None);
        assert_eq!(loss::<Lossy<400_000>>([2.0, 1.0]), None);
        let (place, part) = loss::<Lossy<600_000>>([2.0, 1.0]).unwrap();
        assert_eq!(place, Place::Equation(0));
        assert!((part - 3e-10).abs() < 1e-15, "{part:e}");
    }

    #[test]
    fn rounding_that_unknowns_make_up_for_is_none() {
        assert_eq!(loss::<Large>([1.0, 1e7]), None);
    }

    #[test]
    fn an_update_that_loses_digits_is_blamed_unless_it_gives_nothing() {
        assert_eq!(loss::<Updated<0>>([1.0, 1.0]), None);
        let (place, part) = loss::<Updated<1>>([1.0, 1.0]).unwrap();
        assert_eq!(place, Place::State(0));
        assert!((part - 1e-9).abs() < 1e-15, "{part:e}");
    }
}
