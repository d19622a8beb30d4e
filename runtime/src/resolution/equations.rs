//! What rounding of the equations does to the state.

use super::Solved;
use super::weighted;
use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::model::Model;
use crate::model::Record;
use crate::model::StateArray;
use crate::newton::scales;
use crate::newton::subtract;
use crate::scalar::Real;
use crate::sensitivity::change;
use crate::settings::ROUNDING;
use crate::settings::most_growth;

impl<S: Correctable<T>, T: Real> Solved<S, T> {
    /// The first equation that loses its digits before they get to the Jacobian, and with them those of the state: it has many
    /// roots in these numbers, and Newton's method stops at any of them.
    ///
    /// With a bound eᵢ of rounding in equation i, J⁻¹ e moves the state after the step by more than the tenth digit, in `f32` the
    /// fifth, and eᵢ is more than what a few ε of the unknowns or of the data make of the equation. Where they make up for it, the
    /// step is exact for data that nobody can tell from these: forces may well balance.
    ///
    /// (c + x)² − c² of x = 1 and c = 10¹² are 0 or 3 times what they should be, the slope 2 (c + x) is right to all digits, and so
    /// is −c² + (c + x)² by c.
    pub(super) fn drowned(&self) -> Option<Fault> {
        let (scene, step, known) = (&self.scene, &self.step, self.state.as_ref());
        let (errors, errors_after) = self.errors();
        let next = S::next(scene, step, &self.x);
        let states = S::Model::DESCRIPTION.states;
        let change_to = |there: &[T]| change::<T>(states, known, next.as_ref(), there);
        let digits = most_growth::<T>() * T::EPSILON;
        let few = T::constant(ROUNDING) * T::EPSILON;

        let (mut r, j) = self.jacobian();
        let scales = scales::<S, T>(known, &self.x);
        for (i, error) in errors.as_ref().iter().enumerate() {
            let terms = weighted(j.row(i).iter().copied(), scales.as_ref());
            if *error <= few * terms {
                continue;
            }
            r.as_mut().fill(T::constant(0.0));
            let mut row = r.as_mut().iter_mut().skip(i);
            if let Some(row) = row.next() {
                *row = *error;
            }
            let Some(correction) = j.solve(&r) else {
                continue;
            };
            let mut moved = self.x;
            subtract(&mut moved, &correction);
            let times = change_to(S::next(scene, step, &moved).as_ref()).times;
            if times > digits && !self.is_explained(&errors, |this| this.residual(), i) {
                return Some(drowned(Place::Equation(i), times));
            }
        }
        // What is eliminated. An `update` is computed as it stands there, like any formula.
        let solver = S::Model::DESCRIPTION.solvers.get(S::SOLVER)?;
        for i in (0..known.len()).filter(|i| solver.solves_for(*i)) {
            let mut moved = next;
            let pairs = moved.as_mut().iter_mut().zip(errors_after.as_ref());
            for (moved, error) in pairs.skip(i).take(1) {
                *moved = *moved - *error;
            }
            let times = change_to(moved.as_ref()).times;
            if times > digits && !self.is_explained(&errors_after, |this| this.next(), i) {
                return Some(drowned(Place::State(i), times));
            }
        }
        None
    }

    /// Whether the last iterate of an iteration that has found no end is as good as any: all equations hold within their rounding,
    /// the data make up for that, and what is solved for does not vanish among other unknowns.
    ///
    /// At rest, where forces balance but for rounding, no correction is small beside what it corrects.
    #[cold]
    pub(crate) fn is_rounding(&self) -> bool {
        let (errors, _) = self.errors();
        let (r, j) = self.jacobian();
        let few = T::constant(2.0);
        let pairs = r.as_ref().iter().zip(errors.as_ref());
        let mut holds = pairs.map(|(r, error)| r.abs() <= few * *error + T::LEAST);
        let n = r.as_ref().len();
        holds.all(|holds| holds)
            && (0..n).all(|i| self.is_explained(&errors, |this| this.residual(), i))
            && (0..n).all(|i| is_told(&j, r, i, n))
    }

    fn errors(&self) -> (S::Unknowns, StateArray<S, T>) {
        S::rounding(&self.parameters, self.h, self.t, &self.state, &self.x)
    }

    fn residual(&self) -> S::Unknowns {
        let (mut r, _) = S::zeros();
        S::residual(&self.scene, &self.step, &self.x, &mut r);
        r
    }

    fn next(&self) -> StateArray<S, T> {
        S::next(&self.scene, &self.step, &self.x)
    }

    /// Whether a few ε of the data, and of the unknowns, change number `i` of a result by its error: Σ |∂f/∂p| |p| over all p.
    fn is_explained<A: AsRef<[T]>>(
        &self,
        errors: &A,
        result: impl Fn(&Self) -> A,
        i: usize,
    ) -> bool {
        let at = |values: &A| values.as_ref().get(i).copied();
        let (Some(here), Some(error)) = (at(&result(self)), at(errors)) else {
            return false;
        };
        let part = T::EPSILON.powf(T::constant(1.0 / 3.0));
        let mut size = T::constant(0.0);
        for k in 0..self.count() {
            let change = at(&result(&self.moved(k, part))).map(|there| (there - here).abs());
            // What has no value there tells nothing.
            if let Some(change) = change.filter(|change| change.is_finite()) {
                size = size + change / part;
            }
        }
        error <= T::constant(ROUNDING) * T::EPSILON * size + T::LEAST
    }

    /// How many numbers a step follows from, the unknowns with them.
    fn count(&self) -> usize {
        let parameters = self.parameters.to_array();
        2 + parameters.as_ref().len() + self.state.as_ref().len() + self.x.as_ref().len()
    }

    /// The step where number `k` of them is larger by a part.
    fn moved(&self, k: usize, part: T) -> Self {
        let mut moved = Self { ..*self };
        let mut parameters = moved.parameters.to_array();
        let scalars = [&mut moved.h, &mut moved.t].into_iter();
        let given = scalars
            .chain(parameters.as_mut())
            .chain(moved.state.as_mut());
        for number in given.chain(moved.x.as_mut()).skip(k).take(1) {
            *number = *number + part * *number;
        }
        moved.parameters = Record::from_array(parameters);
        moved.scene = S::scene(&moved.parameters, moved.h);
        moved.step = S::step(&moved.scene, moved.t, &moved.state);
        moved
    }
}

/// Whether the equations tell unknown `i`: (|J⁻¹| |J|)ᵢᵢ is no more than what leaves it ten digits, in `f32` five (Bauer 1966; Skeel
/// 1979). Independent of all units.
fn is_told<T: Real, M: SquareMatrix<T, Vector: AsMut<[T]> + AsRef<[T]>>>(
    j: &M,
    mut one: M::Vector,
    i: usize,
    n: usize,
) -> bool {
    let mut sum = T::constant(0.0);
    for k in 0..n {
        one.as_mut().fill(T::constant(0.0));
        for one in one.as_mut().iter_mut().skip(k).take(1) {
            *one = T::constant(1.0);
        }
        // Column k of the inverse.
        let column = j.solve(&one);
        let inverse = column.as_ref().and_then(|column| column.as_ref().get(i));
        match (inverse, j.row(k).get(i)) {
            (Some(inverse), Some(entry)) => sum = sum + inverse.abs() * entry.abs(),
            _ => return false,
        }
    }
    sum <= most_growth::<T>()
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

    /// x = 1, and another component that is 1 with an error of 10⁻⁹: eliminated, or given by an update.
    struct Follows<const ELIMINATED: bool>;
    impl<const ELIMINATED: bool> Problem<2> for Follows<ELIMINATED> {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            ([x - 1.0, y - 1.0], [[1.0, 0.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[0.0; 2], [0.0, 1e-9]]
        }
        const UNKNOWNS: &'static [Unknown] = &[
            SOLVED,
            Unknown {
                measure: if ELIMINATED { Some(1..2) } else { None },
                told: ELIMINATED,
                ..ANOTHER
            },
        ];
        fn next(_known: [f64; 2], [x, _]: [f64; 2]) -> [f64; 2] {
            [x, 1.0]
        }
    }

    /// What is blamed, and the part by which the state moves.
    fn loss<P: Problem<2>>(x: [f64; 2]) -> Option<(Place, f64)> {
        let fault = solved::<P>(x).drowned()?;
        Some((fault.place, fault.value))
    }

    fn solved<P: Problem<2>>(x: [f64; 2]) -> Solved<Root<P, 2>, f64> {
        Solved::of_root([0.0; 2], x)
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
    fn what_is_eliminated_must_have_its_digits_and_an_update_need_not() {
        assert_eq!(loss::<Follows<false>>([1.0, 1.0]), None);
        let (place, part) = loss::<Follows<true>>([1.0, 1.0]).unwrap();
        assert_eq!(place, Place::State(1));
        assert!((part - 1e-9).abs() < 1e-15, "{part:e}");
    }

    /// Whether x = 2 y, y = 1 holds to rounding, `R`/10¹⁵ off in the first, where 10⁻¹⁵ is its rounding.
    struct Rest<const R: u32>;
    impl<const R: u32> Problem<2> for Rest<R> {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            let r = [x - 2.0 * y + f64::from(R) * 1e-15, y - 1.0];
            (r, [[1.0, -2.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[1e-15, 0.0], [0.0; 2]]
        }
    }

    /// The same twice, but for a trifle.
    struct Twice;
    impl Problem<2> for Twice {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            let r = [x - 2.0 * y, x - (2.0 + 1e-9) * y];
            (r, [[1.0, -2.0], [1.0, -2.0 - 1e-9]])
        }
    }

    /// Large numbers of no consequence.
    struct Idle;
    impl Problem<2> for Idle {
        fn evaluate([x, y]: [f64; 2]) -> Evaluated<2> {
            ([x - 2.0 * y, y - 1.0], [[1.0, -2.0], [0.0, 1.0]])
        }
        fn rounding() -> [[f64; 2]; 2] {
            [[1e-9, 0.0], [0.0; 2]]
        }
    }

    #[test]
    fn an_iterate_that_none_is_better_than_is_rounding() {
        assert!(solved::<Rest<1>>([2.0, 1.0]).is_rounding());
        assert!(!solved::<Rest<4>>([2.0, 1.0]).is_rounding());
        assert!(!solved::<Twice>([0.0, 0.0]).is_rounding());
        assert!(!solved::<Idle>([2.0, 1.0]).is_rounding());
        assert!(!solved::<Rest<0>>([f64::NAN, 1.0]).is_rounding());
    }
}
