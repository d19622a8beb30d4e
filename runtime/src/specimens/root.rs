//! Root-finding problems as systems without time: one block of N unknowns that starts at the known
//! state.

use core::marker::PhantomData;

use crate::description::Description;
use crate::description::Equation;
use crate::description::Solver;
use crate::description::Unknown;
use crate::description::Variable;
use crate::model::Model;
use crate::model::Record;
use crate::model::System;

/// r(x) and ∂r/∂x.
pub(crate) type Evaluated<const N: usize> = ([f64; N], [[f64; N]; N]);

/// A problem r(x) = 0.
pub(crate) trait Problem<const N: usize> {
    /// The blocks of x: one, measured by itself and by where it starts.
    const UNKNOWNS: &'static [Unknown] = &[Unknown {
        name: "x[k+1]",
        len: N,
        measure: Some(0..N),
        told: true,
    }];
    /// Some unknowns were eliminated.
    const HAS_CORE: bool = false;
    /// The state after the step is that before it and x.
    const IS_INCREMENT: bool = false;
    /// r and J at x.
    fn evaluate(x: [f64; N]) -> Evaluated<N>;
    /// The state after the step.
    fn next(known: [f64; N], x: [f64; N]) -> [f64; N] {
        match Self::IS_INCREMENT {
            true => core::array::from_fn(|i| known[i] + x[i]),
            false => x,
        }
    }
    /// Bounds of rounding in r(x), and in the state after the step.
    fn rounding() -> [[f64; N]; 2] {
        [[0.0; N]; 2]
    }
    /// How much rounding of eliminated unknowns has grown.
    fn growth() -> f64 {
        0.0
    }
}

/// The system of the problem `P`.
pub(crate) struct Root<P, const N: usize>(PhantomData<P>);

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Flat<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Default for Flat<N> {
    fn default() -> Self {
        Self([0.0; N])
    }
}

impl<const N: usize> Record<f64> for Flat<N> {
    type Array = [f64; N];
    fn from_array(array: [f64; N]) -> Self {
        Self(array)
    }
    fn to_array(&self) -> [f64; N] {
        self.0
    }
}

impl<P: Problem<N>, const N: usize> Model<f64> for Root<P, N> {
    type Parameters = Flat<0>;
    type State = Flat<N>;
    type Outputs = Flat<0>;
    const DESCRIPTION: &'static Description = &Description {
        name: "root",
        doc: "",
        parameters: &[],
        states: &[Variable {
            name: "x",
            ascii: "x",
            rows: N,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        }],
        outputs: &[],
        solvers: &[Solver {
            form: "next",
            unknowns: P::UNKNOWNS,
            equations: &[Equation {
                text: "r(x) = 0",
                line: 3,
                len: N,
            }],
            pattern: &[],
            counts: &[],
            core: None,
        }],
        claims: &[],
        requirements: &[],
        has_flow: false,
        no_series: None,
        counts: &[],
        operations: 0,
        scene: None,
    };
    fn start(_parameters: &Flat<0>) -> Flat<N> {
        Flat::default()
    }
    fn outputs(_parameters: &Flat<0>, _h: f64, _t: f64, _state: &Flat<N>) -> Flat<0> {
        Flat([])
    }
}

impl<P: Problem<N>, const N: usize> System<f64> for Root<P, N> {
    type Model = Self;
    type Unknowns = [f64; N];
    type Jacobian = [[f64; N]; N];
    type Scene = ();
    type Step = [f64; N];
    type Core = Self;
    const SOLVER: usize = 0;
    const HAS_CORE: bool = P::HAS_CORE;
    const HAS_CHANGE: bool = P::IS_INCREMENT;
    fn zeros() -> ([f64; N], [[f64; N]; N]) {
        ([0.0; N], [[0.0; N]; N])
    }
    fn scene(_parameters: &Flat<0>, _h: f64) {}
    fn step(_scene: &(), _t: f64, state: &[f64; N]) -> [f64; N] {
        *state
    }
    fn guess(_scene: &(), step: &[f64; N]) -> [f64; N] {
        *step
    }
    fn residual(_scene: &(), _step: &[f64; N], x: &[f64; N], r: &mut [f64; N]) {
        *r = P::evaluate(*x).0;
    }
    fn residual_and_jacobian(
        _scene: &(),
        _step: &[f64; N],
        x: &[f64; N],
        r: &mut [f64; N],
        j: &mut [[f64; N]; N],
    ) {
        (*r, *j) = P::evaluate(*x);
    }
    fn next(_scene: &(), step: &[f64; N], x: &[f64; N]) -> [f64; N] {
        P::next(*step, *x)
    }
    fn change(_scene: &(), _step: &[f64; N], x: &[f64; N]) -> [f64; N] {
        *x
    }
    fn rounding(
        _parameters: &Flat<0>,
        _h: f64,
        _t: f64,
        _state: &[f64; N],
        _x: &[f64; N],
    ) -> ([f64; N], [f64; N]) {
        P::rounding().into()
    }
    fn growth(_scene: &(), _step: &[f64; N], _x: &[f64; N]) -> f64 {
        P::growth()
    }
}
