//! Whether the numbers that a step is solved in resolve its equations.

mod equations;
mod unknowns;

use crate::error::Failure;
use crate::error::Fault;
use crate::error::Place;
use crate::linear::Correctable;
use crate::linear::SquareMatrix;
use crate::model::Model;
use crate::model::Record;
use crate::model::StateArray;
use crate::model::System;
use crate::scalar::Real;
use crate::scalar::Rounded;
use crate::scalar::all_finite;

/// A step with its solution.
pub(crate) struct Solved<S: System<T>, T: Real> {
    pub(crate) parameters: <S::Model as Model<T>>::Parameters,
    pub(crate) h: T,
    pub(crate) t: T,
    pub(crate) scene: S::Scene,
    pub(crate) step: S::Step,
    /// The state before it.
    pub(crate) state: StateArray<S, T>,
    pub(crate) x: S::Unknowns,
}

impl<S: Correctable<T>, T: Real> Solved<S, T> {
    /// Why the solution is none that can be told from others: an equation is infinitely steep there, rounding of the unknowns makes it
    /// another one, or rounding of the equations the state.
    #[cold]
    pub(crate) fn doubt(&self) -> Option<Fault> {
        let unresolved = || self.unresolved();
        self.steep().or_else(unresolved).or_else(|| self.drowned())
    }

    /// r(x) and J(x).
    fn jacobian(&self) -> (S::Unknowns, S::Jacobian) {
        let (mut r, mut j) = S::zeros();
        S::residual_and_jacobian(&self.scene, &self.step, &self.x, &mut r, &mut j);
        (r, j)
    }

    /// The first equation with a derivative that is no number: any residual is nothing beside it.
    fn steep(&self) -> Option<Fault> {
        let (r, j) = self.jacobian();
        let mut rows = 0..r.as_ref().len();
        let row = rows.find(|row| !all_finite(j.row(*row)))?;
        Some(Fault {
            failure: Failure::Singular,
            place: Place::Equation(row),
            value: r.as_ref().get(row).map_or(0.0, |r| r.to_f64()),
        })
    }
}

/// How far rounding may have taken r(x) of `S`, and from `x` the state after the step, in numbers that know:
/// [`System::rounding`] as the generator implements it.
#[cold]
pub fn rounding<S, T>(
    parameters: &<<S as System<T>>::Model as Model<T>>::Parameters,
    h: T,
    t: T,
    state: &StateArray<S, T>,
    x: &<S as System<T>>::Unknowns,
) -> (<S as System<T>>::Unknowns, StateArray<S, T>)
where
    T: Real,
    S: System<T> + System<Rounded<T>>,
{
    type Wide<S, T> = <S as System<Rounded<T>>>::Model;
    let mut given = <Wide<S, T> as Model<Rounded<T>>>::Parameters::default();
    let mut known = <Wide<S, T> as Model<Rounded<T>>>::start(&given).to_array();
    let mut array = given.to_array();
    copy(parameters.to_array().as_ref(), array.as_mut());
    given = Record::from_array(array);
    copy(state.as_ref(), known.as_mut());
    let (mut r, _) = <S as System<Rounded<T>>>::zeros();
    let mut unknowns = r;
    copy(x.as_ref(), unknowns.as_mut());

    let scene = <S as System<Rounded<T>>>::scene(&given, Rounded::exact(h));
    let step = <S as System<Rounded<T>>>::step(&scene, Rounded::exact(t), &known);
    <S as System<Rounded<T>>>::residual(&scene, &step, &unknowns, &mut r);
    let next = <S as System<Rounded<T>>>::next(&scene, &step, &unknowns);
    let (mut errors, mut errors_after) = (*x, *state);
    errors_of(r.as_ref(), errors.as_mut());
    errors_of(next.as_ref(), errors_after.as_mut());
    (errors, errors_after)
}

/// What is given is meant as it is.
fn copy<T: Real>(from: &[T], to: &mut [Rounded<T>]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = Rounded::exact(*from);
    }
}

fn errors_of<T: Real>(from: &[Rounded<T>], to: &mut [T]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = from.error;
    }
}

/// Σ |aⱼ| |xⱼ|
fn weighted<T: Real>(row: impl Iterator<Item = T>, scales: &[T]) -> T {
    row.zip(scales)
        .fold(T::constant(0.0), |sum, (a, scale)| sum + a.abs() * *scale)
}

#[cfg(test)]
mod tests {
    use super::Solved;
    use crate::specimens::root::Flat;
    use crate::specimens::root::Problem;
    use crate::specimens::root::Root;

    impl<P: Problem<N>, const N: usize> Solved<Root<P, N>, f64> {
        /// The solution `x` of the problem from `state`.
        pub(super) fn of_root(state: [f64; N], x: [f64; N]) -> Self {
            Self {
                parameters: Flat([]),
                h: 1.0,
                t: 0.0,
                scene: (),
                step: state,
                state,
                x,
            }
        }
    }
}
