//! The traits that generated code implements.

use crate::convolution::Rows;
use crate::description::Description;
use crate::description::Unknown;
use crate::scalar::Real;
use crate::scalar::Scalar;

/// A fixed number of scalars under names: parameters, states or outputs of a model.
pub trait Record<T>: Copy {
    /// `[T; n]`
    type Array: AsRef<[T]> + AsMut<[T]> + Copy;
    /// Components in declaration order, matrices row by row.
    fn from_array(array: Self::Array) -> Self;
    /// The inverse of [`Record::from_array`].
    fn to_array(&self) -> Self::Array;
}

/// A fixed number of scalars that nobody else knows the names of.
pub trait Cache<T>: Copy {
    /// How many.
    const LEN: usize;
    /// Made of component 0, 1, ….
    fn gather(from: impl Fn(usize) -> T) -> Self;
    /// Hands out its components.
    fn spread(&self, to: impl FnMut(usize, T));
}

/// Nothing.
impl<T> Cache<T> for () {
    const LEN: usize = 0;
    fn gather(_from: impl Fn(usize) -> T) -> Self {}
    fn spread(&self, _to: impl FnMut(usize, T)) {}
}

/// A model apart from its solvers. Implemented by the generated unit struct `Model`.
pub trait Model<T: Scalar> {
    /// The generated struct `Parameters<T>`; its `Default` holds the values of the file.
    type Parameters: Record<T> + Default;
    /// The generated struct `State<T>`.
    type State: Record<T>;
    /// The generated struct `Outputs<T>`: invariants and observables.
    type Outputs: Record<T>;
    /// Names, shapes, units, texts.
    const DESCRIPTION: &'static Description;
    /// The start values of the file for these parameters.
    fn start(parameters: &Self::Parameters) -> Self::State;
    /// Invariants and observables at time `t` and `state` of a run with step `h`.
    fn outputs(parameters: &Self::Parameters, h: T, t: T, state: &Self::State) -> Self::Outputs;
    /// Whether the data of a run meet a requirement of the file, by its position in [`Description::requirements`].
    ///
    /// Nothing is refused for not meeting one: equations can be solved for bodies that cannot exist.
    /// [`unmet`](crate::unmet) lists those that are not met.
    fn meets(
        _requirement: usize,
        _parameters: &Self::Parameters,
        _h: T,
        _state: &Self::State,
    ) -> bool
    where
        T: Real,
    {
        true
    }
}

/// A model with continuous equations. Implemented by the generated `Model` where the file has a `flow`.
pub trait Flow<T: Scalar>: Model<T> {
    /// What depends on the parameters only, computed once per run.
    type FlowScene: Copy;
    /// It has kinks or jumps: `abs`, `sign` or `positive` of something that depends on x or t.
    const FLOW_HAS_KINKS: bool = false;
    /// Computes the scene cache.
    fn flow_scene(parameters: &Self::Parameters) -> Self::FlowScene;
    /// dx/dt at time `t` and state `x`.
    fn flow(
        scene: &Self::FlowScene,
        t: T,
        x: &<Self::State as Record<T>>::Array,
    ) -> <Self::State as Record<T>>::Array;
}

/// A flow with recurrences for the Taylor coefficients of its motions. Implemented by the generated `Model` where every
/// function in its flow has one.
///
/// Along a motion, every quantity is a series a = Σ aₙ sⁿ in the time s since the start of a step, in units that the run
/// chooses. All that recurrences sum over are products Σ aⱼ bₙ₋ⱼ, either whole, 0 ≤ j ≤ n, or inner sums, 0 < j < n, which
/// hold no coefficient of order n. They need nothing from one another, so that they can be made as lanes.
pub trait Series<T: Scalar>: Flow<T> {
    /// What depends on the parameters only, computed once per run.
    type Scene: Copy;
    /// What depends on the start of a step only: order 0.
    type Base: Copy;
    /// One for each inner sum, and zeros to fill the last row.
    type Sums: Rows<T>;
    /// One for each product, and zeros to fill the last row.
    type Products: Rows<T>;
    /// Zero for each.
    fn zeros() -> (Self::Sums, Self::Products);
    /// Computes the scene cache.
    fn scene(parameters: &Self::Parameters) -> Self::Scene;
    /// Order 0 at time `t` and state `x`.
    fn base(
        scene: &Self::Scene,
        t: T,
        x: &<Self::State as Record<T>>::Array,
    ) -> <Self as Series<T>>::Base;
    /// dx/dt of order 0.
    fn rates(scene: &Self::Scene, base: &Self::Base) -> <Self::State as Record<T>>::Array;
    /// a₀ and b₀ of each product.
    fn starts(scene: &Self::Scene, base: &Self::Base) -> [Self::Products; 2];
    /// aₙ and bₙ of each product, from the state of order n and \[tₙ, n, 1/n\].
    fn factors(
        scene: &Self::Scene,
        base: &Self::Base,
        newest: &<Self::State as Record<T>>::Array,
        order: &[T; 3],
    ) -> [Self::Products; 2];
    /// dx/dt of order n, and aₙ and bₙ of each inner sum, from the same, the products and the inner sums of order n.
    fn next(
        scene: &Self::Scene,
        base: &Self::Base,
        newest: &<Self::State as Record<T>>::Array,
        order: &[T; 3],
        products: &Self::Products,
        sums: &Self::Sums,
    ) -> (<Self::State as Record<T>>::Array, [Self::Sums; 2]);
}

/// Shorthand for the flat array behind the state of `S`.
pub type StateArray<S, T> = <<<S as System<T>>::Model as Model<T>>::State as Record<T>>::Array;

/// One solver: r(x) = 0 for the unknowns x of one step. Implemented by the generated unit structs
/// `Next` and `Increment`.
pub trait System<T: Scalar> {
    /// The model it belongs to.
    type Model: Model<T>;
    /// `[T; n]`
    type Unknowns: AsRef<[T]> + AsMut<[T]> + Copy;
    /// `[[T; n]; n]`, rows first.
    type Jacobian: Copy;
    /// What depends on the parameters and h only, computed once per run.
    type Scene: Cache<T>;
    /// What depends on the known state and t besides, computed once per step.
    type Step: Copy;
    /// The same equations after unknowns that enter linearly are eliminated; `Self` where all are needed.
    type Core: System<T, Model = Self::Model>;
    /// The core is smaller.
    const HAS_CORE: bool = false;
    /// Index in [`Description::solvers`].
    const SOLVER: usize;
    /// r has kinks or jumps, `abs`, `sign` or `positive` of something that depends on x.
    const HAS_KINKS: bool = false;
    /// The blocks of x.
    const UNKNOWNS: &'static [Unknown] =
        <Self::Model as Model<T>>::DESCRIPTION.solvers[Self::SOLVER].unknowns;
    /// Zero unknowns and a zero Jacobian, to be overwritten.
    fn zeros() -> (Self::Unknowns, Self::Jacobian);
    /// Computes the scene cache.
    fn scene(parameters: &<Self::Model as Model<T>>::Parameters, h: T) -> Self::Scene;
    /// Computes the step cache.
    fn step(scene: &Self::Scene, t: T, state: &StateArray<Self, T>) -> Self::Step;
    /// The first guess of the unknowns: the known state, a zero increment, or what the file says.
    fn guess(scene: &Self::Scene, step: &Self::Step) -> Self::Unknowns;
    /// r(x)
    fn residual(scene: &Self::Scene, step: &Self::Step, x: &Self::Unknowns, r: &mut Self::Unknowns);
    /// r(x) and its Jacobian. Structural zeros of `j` are left as they are.
    fn residual_and_jacobian(
        scene: &Self::Scene,
        step: &Self::Step,
        x: &Self::Unknowns,
        r: &mut Self::Unknowns,
        j: &mut Self::Jacobian,
    );
    /// [`System::correction`] is there.
    const HAS_CORRECTION: bool = false;
    /// Newton's correction J(x)⁻¹ r(x) in closed form, the pivots chosen at build time, and how many times larger than
    /// rounding its error may be for that: Σ |terms| / |Σ terms| over the pivots. Without one, the growth is infinite.
    fn correction(
        _scene: &Self::Scene,
        _step: &Self::Step,
        x: &Self::Unknowns,
    ) -> (Self::Unknowns, T) {
        (*x, T::constant(f64::INFINITY))
    }
    /// The state after the step.
    fn next(scene: &Self::Scene, step: &Self::Step, x: &Self::Unknowns) -> StateArray<Self, T>;
    /// [`System::change`] is there.
    const HAS_CHANGE: bool = false;
    /// The state after the step less that before, computed without the state that it is added to. Only asked for where it
    /// is there.
    fn change(scene: &Self::Scene, step: &Self::Step, x: &Self::Unknowns) -> StateArray<Self, T> {
        Self::next(scene, step, x)
    }
    /// How far rounding may have taken r(x) from what it is for just these numbers, and from `x` the state after the step: bounds
    /// to first order. Without, none is known of, and zeros are returned.
    fn rounding(
        _parameters: &<Self::Model as Model<T>>::Parameters,
        _h: T,
        _t: T,
        state: &StateArray<Self, T>,
        _x: &Self::Unknowns,
    ) -> (Self::Unknowns, StateArray<Self, T>)
    where
        T: Real,
    {
        let mut none = *state;
        none.as_mut().fill(T::constant(0.0));
        (Self::zeros().0, none)
    }
    /// How many times larger than rounding the error of eliminated unknowns may be: Σ |terms| / |Σ terms| over
    /// what was divided by. 0 where nothing can cancel.
    fn growth(_scene: &Self::Scene, _step: &Self::Step, _x: &Self::Unknowns) -> T {
        T::constant(0.0)
    }
}
