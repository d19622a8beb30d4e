// A pendulum by the implicit midpoint rule, written by hand as the generator writes its models:
// θ' = θ + h (ω + ω')/2, ω' = ω − h c sin((θ + θ')/2), with the next state as unknowns. To test for
// invariance, angle and rate are in units that the parameters choose: θ = u x₀ and ω = v x₁.
// Crate-level paths, so that integration tests and doc tests can include it.

use residua::Cache;
use residua::Catalogued;
use residua::Flow;
use residua::Record;
use residua::Scalar;
use residua::System;
use residua::description::Description;
use residua::description::Equation;
use residua::description::Output;
use residua::description::Solver;
use residua::description::Unknown;
use residua::description::Variable;
use residua::erased::ErasedFlow;
use residua::erased::ErasedModel;
use residua::erased::ErasedSolver;

/// [`Catalogued`] as generated code has it.
pub static MODEL: Catalogued = Catalogued {
    description: &DESCRIPTION,
    model: &ErasedModel::<Model>::NEW,
    solvers: &[&ErasedSolver::<Next>::NEW],
    flow: Some(&ErasedFlow::<Model>::NEW),
    series: None,
};

/// c = g/l, and the units u and v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<T = f64> {
    pub c: T,
    pub unit: [T; 2],
}

impl<T: Scalar> Default for Parameters<T> {
    fn default() -> Self {
        Self {
            c: T::constant(9.81),
            unit: [T::constant(1.0); 2],
        }
    }
}

impl<T: Scalar> Record<T> for Parameters<T> {
    type Array = [T; 3];
    fn from_array([c, u, v]: [T; 3]) -> Self {
        Self { c, unit: [u, v] }
    }
    fn to_array(&self) -> [T; 3] {
        [self.c, self.unit[0], self.unit[1]]
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State<T = f64> {
    pub theta: T,
    pub omega: T,
}

impl<T: Scalar> Record<T> for State<T> {
    type Array = [T; 2];
    fn from_array([theta, omega]: [T; 2]) -> Self {
        Self { theta, omega }
    }
    fn to_array(&self) -> [T; 2] {
        [self.theta, self.omega]
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<T = f64> {
    pub energy: T,
}

impl<T: Scalar> Record<T> for Outputs<T> {
    type Array = [T; 1];
    fn from_array([energy]: [T; 1]) -> Self {
        Self { energy }
    }
    fn to_array(&self) -> [T; 1] {
        [self.energy]
    }
}

pub struct Model;

impl<T: Scalar> residua::Model<T> for Model {
    type Parameters = Parameters<T>;
    type State = State<T>;
    type Outputs = Outputs<T>;
    const DESCRIPTION: &'static Description = &DESCRIPTION;

    fn start(parameters: &Parameters<T>) -> State<T> {
        let [u, v] = parameters.unit;
        State {
            theta: T::constant(1.0) / u,
            omega: T::constant(0.5) / v,
        }
    }

    fn outputs(parameters: &Parameters<T>, _h: T, _t: T, state: &State<T>) -> Outputs<T> {
        let [u, v] = parameters.unit;
        let omega = v * state.omega;
        Outputs {
            energy: omega * omega / T::constant(2.0) - parameters.c * (u * state.theta).cos(),
        }
    }
}

impl<T: Scalar> Flow<T> for Model {
    type FlowScene = Parameters<T>;

    fn flow_scene(parameters: &Parameters<T>) -> Parameters<T> {
        *parameters
    }

    fn flow(scene: &Parameters<T>, _t: T, &[theta, omega]: &[T; 2]) -> [T; 2] {
        let [u, v] = scene.unit;
        [v * omega / u, -(scene.c * (u * theta).sin()) / v]
    }
}

pub struct Next;

#[derive(Debug, Clone, Copy)]
pub struct Scene<T> {
    h: T,
    parameters: Parameters<T>,
}

impl<T: Scalar> Cache<T> for Scene<T> {
    const LEN: usize = 4;
    #[inline(always)]
    fn gather(from: impl Fn(usize) -> T) -> Self {
        let (c, unit) = (from(1), [from(2), from(3)]);
        let parameters = Parameters { c, unit };
        let h = from(0);
        Self { h, parameters }
    }
    fn spread(&self, mut to: impl FnMut(usize, T)) {
        let Parameters { c, unit: [u, v] } = self.parameters;
        for (i, value) in [self.h, c, u, v].into_iter().enumerate() {
            to(i, value);
        }
    }
}

impl<T: Scalar> System<T> for Next {
    type Model = Model;
    type Unknowns = [T; 2];
    type Jacobian = [[T; 2]; 2];
    type Scene = Scene<T>;
    type Step = [T; 2];
    type Core = Self;
    const SOLVER: usize = 0;

    fn zeros() -> ([T; 2], [[T; 2]; 2]) {
        ([T::constant(0.0); 2], [[T::constant(0.0); 2]; 2])
    }

    fn scene(parameters: &Parameters<T>, h: T) -> Scene<T> {
        let parameters = *parameters;
        Scene { h, parameters }
    }

    fn step(_scene: &Scene<T>, _t: T, state: &[T; 2]) -> [T; 2] {
        *state
    }

    fn guess(_scene: &Scene<T>, step: &[T; 2]) -> [T; 2] {
        *step
    }

    fn residual(scene: &Scene<T>, step: &[T; 2], x: &[T; 2], r: &mut [T; 2]) {
        let [u, v] = scene.parameters.unit;
        let half = scene.h / T::constant(2.0);
        let angle = u * (x[0] + step[0]) / T::constant(2.0);
        r[0] = u * (x[0] - step[0]) - half * v * (x[1] + step[1]);
        r[1] = v * (x[1] - step[1]) + scene.h * scene.parameters.c * angle.sin();
    }

    fn residual_and_jacobian(
        scene: &Scene<T>,
        step: &[T; 2],
        x: &[T; 2],
        r: &mut [T; 2],
        j: &mut [[T; 2]; 2],
    ) {
        Self::residual(scene, step, x, r);
        let [u, v] = scene.parameters.unit;
        let half = scene.h / T::constant(2.0);
        let angle = u * (x[0] + step[0]) / T::constant(2.0);
        *j = [
            [u, -(half * v)],
            [half * scene.parameters.c * angle.cos() * u, v],
        ];
    }

    const HAS_CORRECTION: bool = true;

    fn correction(scene: &Scene<T>, step: &[T; 2], x: &[T; 2]) -> ([T; 2], T) {
        let (mut r, mut j) = <Self as System<T>>::zeros();
        Self::residual_and_jacobian(scene, step, x, &mut r, &mut j);
        let [[a, b], [c, d]] = j;
        let (ad, bc) = (a * d, b * c);
        let determinant = ad - bc;
        let x = [
            (d * r[0] - b * r[1]) / determinant,
            (a * r[1] - c * r[0]) / determinant,
        ];
        (x, (ad.abs() + bc.abs()) / determinant.abs())
    }

    fn next(_scene: &Scene<T>, _step: &[T; 2], x: &[T; 2]) -> [T; 2] {
        *x
    }
}

static DESCRIPTION: Description = Description {
    name: "pendulum",
    doc: "",
    parameters: &[scalar("c", "1/s^2"), vector("unit", 2)],
    states: &[scalar("θ", "rad"), scalar("ω", "1/s")],
    outputs: &[Output {
        variable: scalar("energy", "1/s^2"),
        invariant: true,
    }],
    solvers: &[Solver {
        form: "next",
        unknowns: &[unknown("θ[k+1]", 0), unknown("ω[k+1]", 1)],
        equations: &[
            equation("der(θ) - ω[k+1/2] = 0", 7),
            equation("der(ω) + c*sin(θ[k+1/2]) = 0", 8),
        ],
        pattern: &[(0, 0), (0, 1), (1, 0), (1, 1)],
        counts: &[],
        core: None,
    }],
    claims: &[],
    requirements: &[],
    has_flow: true,
    no_series: Some("it is written by hand"),
    counts: &[],
    operations: 0,
    scene: None,
};

const fn scalar(name: &'static str, unit: &'static str) -> Variable {
    Variable {
        name,
        ascii: name,
        rows: 1,
        cols: 1,
        unit,
        dimensionless: matches!(unit.as_bytes(), b"1" | b"rad"),
        doc: "",
    }
}

const fn vector(name: &'static str, rows: usize) -> Variable {
    Variable {
        rows,
        ..scalar(name, "1")
    }
}

const fn unknown(name: &'static str, state: usize) -> Unknown {
    Unknown {
        name,
        len: 1,
        measure: Some(state..state + 1),
        told: true,
    }
}

const fn equation(text: &'static str, line: usize) -> Equation {
    Equation { text, line, len: 1 }
}
