/// The parameters.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<T = f64> {
    /// `m` in `kg`: mass
    pub m: T,
    /// `J` in `kg*m^2`: moment of inertia about the pivot
    pub J: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Parameters<T> {
    type Array = [T; 2];
    fn from_array([m, J]: [T; 2]) -> Self {
        Self { m, J }
    }
    fn to_array(&self) -> [T; 2] {
        let Self { m, J } = *self;
        [m, J]
    }
}
/// The state.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T = f64> {
    /// `ω` in `rad/s`: angular velocity
    pub omega: T,
    /// `Γ`: second row of the rotation matrix
    pub Gamma: [T; 2],
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for State<T> {
    type Array = [T; 3];
    fn from_array([omega, Gamma_x, Gamma_y]: [T; 3]) -> Self {
        Self {
            omega,
            Gamma: [Gamma_x, Gamma_y],
        }
    }
    fn to_array(&self) -> [T; 3] {
        let Self { omega, Gamma: [Gamma_x, Gamma_y] } = *self;
        [omega, Gamma_x, Gamma_y]
    }
}
/// The invariants and observables.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs<T = f64> {
    /// `θ` in `rad`
    pub theta: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Outputs<T> {
    type Array = [T; 1];
    fn from_array([theta]: [T; 1]) -> Self {
        Self { theta }
    }
    fn to_array(&self) -> [T; 1] {
        let Self { theta } = *self;
        [theta]
    }
}
/// A swing of the planar pendulum, without gravity being open to change.
#[derive(Clone, Copy, Debug)]
pub struct Model;
#[allow(non_snake_case, reason = "names as in the model")]
#[allow(clippy::approx_constant, reason = "numbers as in the model")]
#[allow(
    clippy::possible_missing_comma,
    reason = "all tokens have one place, the invocation"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::suspicious_operation_groupings,
    reason = "formulas"
)]
mod model {
    /// The values of the file.
    impl<T: ::residua::Scalar> ::core::default::Default for super::Parameters<T> {
        fn default() -> Self {
            let [c0_48, two] = [0.48, 2.0].map(T::constant);
            Self { m: two, J: c0_48 }
        }
    }
    impl<T: ::residua::Scalar> ::residua::Model<T> for super::Model {
        type Parameters = super::Parameters<T>;
        type State = super::State<T>;
        type Outputs = super::Outputs<T>;
        const DESCRIPTION: &'static ::residua::Description = super::DESCRIPTION;
        fn start(_parameters: &super::Parameters<T>) -> super::State<T> {
            let zero = T::constant(0.0);
            let third = T::constant(1.0) / T::constant(3.0);
            let pi = T::constant(::core::f64::consts::PI)
                + T::constant(1.2246467991473532e-16);
            let (sin_third_pi, cos_third_pi) = (third * pi).sin_cos();
            super::State {
                omega: zero,
                Gamma: [sin_third_pi, cos_third_pi],
            }
        }
        fn outputs(
            _parameters: &super::Parameters<T>,
            _h: T,
            _t: T,
            state: &super::State<T>,
        ) -> super::Outputs<T> {
            let super::State { Gamma: [Gamma_x, Gamma_y], .. } = *state;
            super::Outputs {
                theta: Gamma_x.atan2(Gamma_y),
            }
        }
    }
}
#[allow(non_snake_case, reason = "names as in the model")]
#[allow(clippy::approx_constant, reason = "numbers as in the model")]
#[allow(
    clippy::possible_missing_comma,
    reason = "all tokens have one place, the invocation"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::suspicious_operation_groupings,
    reason = "formulas"
)]
mod flow {
    /// What the flow needs of the parameters.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        c5_886_m_over_J: T,
    }
    impl<T: ::residua::Scalar> ::residua::Flow<T> for super::Model {
        type FlowScene = Scene<T>;
        fn flow_scene(parameters: &super::Parameters<T>) -> Scene<T> {
            let super::Parameters { m, J } = *parameters;
            let c5_886 = T::constant(2943.0) / T::constant(500.0);
            Scene {
                c5_886_m_over_J: c5_886 * m / J,
            }
        }
        /// dx/dt, 3 components, lines 21 to 22: 3 multiplications.
        #[inline(always)]
        fn flow(scene: &Scene<T>, _t: T, state: &[T; 3]) -> [T; 3] {
            let Scene { c5_886_m_over_J } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            [-c5_886_m_over_J * Gamma_x, omega * Gamma_y, -omega * Gamma_x]
        }
    }
}
#[allow(non_snake_case, reason = "names as in the model")]
#[allow(clippy::approx_constant, reason = "numbers as in the model")]
#[allow(
    clippy::possible_missing_comma,
    reason = "all tokens have one place, the invocation"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::suspicious_operation_groupings,
    reason = "formulas"
)]
mod series {
    /// What depends on parameters only.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        c5_886_m_over_J: T,
    }
    /// What depends on the start of the step only.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        Gamma_x: T,
        c5_886_m_over_J_Gamma_x: T,
        omega: T,
        Gamma_y: T,
        omega_Gamma_y: T,
        omega_Gamma_x: T,
    }
    impl<T: ::residua::Scalar> ::residua::Series<T> for super::Model {
        type Scene = Scene<T>;
        type Base = Step<T>;
        type Sums = [[T; 4]; 0];
        type Products = [[T; 4]; 1];
        fn zeros() -> (Self::Sums, Self::Products) {
            let row = [T::constant(0.0); 4];
            ([row; 0], [row; 1])
        }
        /// Once per run: 1 multiplication, 1 division.
        fn scene(parameters: &super::Parameters<T>) -> Scene<T> {
            let super::Parameters { m, J } = *parameters;
            let c5_886 = T::constant(2943.0) / T::constant(500.0);
            Scene {
                c5_886_m_over_J: c5_886 * m / J,
            }
        }
        /// Once per step: 3 multiplications.
        #[inline(always)]
        fn base(scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let Scene { c5_886_m_over_J } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            Step {
                Gamma_x,
                c5_886_m_over_J_Gamma_x: c5_886_m_over_J * Gamma_x,
                omega,
                Gamma_y,
                omega_Gamma_y: omega * Gamma_y,
                omega_Gamma_x: omega * Gamma_x,
            }
        }
        #[inline(always)]
        fn rates(_scene: &Scene<T>, step: &Step<T>) -> [T; 3] {
            let Step { c5_886_m_over_J_Gamma_x, omega_Gamma_y, omega_Gamma_x, .. } = *step;
            [-c5_886_m_over_J_Gamma_x, omega_Gamma_y, -omega_Gamma_x]
        }
        #[inline(always)]
        fn starts(_scene: &Scene<T>, step: &Step<T>) -> [Self::Products; 2] {
            let Step { Gamma_x, omega, Gamma_y, .. } = *step;
            let zero = T::constant(0.0);
            [[[omega, omega, zero, zero]], [[Gamma_y, Gamma_x, zero, zero]]]
        }
        /// Order n of what is multiplied: no operations.
        #[inline(always)]
        fn factors(
            _scene: &Scene<T>,
            _step: &Step<T>,
            newest: &[T; 3],
            _order: &[T; 3],
        ) -> [Self::Products; 2] {
            let [omega_n, Gamma_x_n, Gamma_y_n] = *newest;
            let zero = T::constant(0.0);
            [[[omega_n, omega_n, zero, zero]], [[Gamma_y_n, Gamma_x_n, zero, zero]]]
        }
        /// Order n, lines 21 to 22: 2 sums of n + 1 products, 0 sums of n − 1 products, and 1 multiplication.
        #[inline(always)]
        fn next(
            scene: &Scene<T>,
            _step: &Step<T>,
            newest: &[T; 3],
            _order: &[T; 3],
            products: &Self::Products,
            _sums: &Self::Sums,
        ) -> ([T; 3], [Self::Sums; 2]) {
            let Scene { c5_886_m_over_J } = *scene;
            let [_, Gamma_x_n, _] = *newest;
            let [[product_1, product_2, _, _]] = *products;
            ([-c5_886_m_over_J * Gamma_x_n, product_1, -product_2], [[], []])
        }
    }
}
/// The solver whose unknowns are the increments, and those the model declares.
#[derive(Clone, Copy, Debug)]
pub struct Increment;
#[allow(non_snake_case, reason = "names as in the model")]
#[allow(clippy::approx_constant, reason = "numbers as in the model")]
#[allow(
    clippy::possible_missing_comma,
    reason = "all tokens have one place, the invocation"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::suspicious_operation_groupings,
    reason = "formulas"
)]
mod increment {
    /// What a run needs of the parameters and h.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        two_J: T,
        h: T,
        c5_886_h_m: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        Gamma_x: T,
        two_Gamma_x: T,
        omega: T,
        two_omega: T,
        Gamma_y: T,
        two_Gamma_y: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 3;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                two_J: from(0),
                h: from(1),
                c5_886_h_m: from(2),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.two_J);
            to(1, self.h);
            to(2, self.c5_886_h_m);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::Increment {
        type Model = super::Model;
        type Unknowns = [T; 3];
        type Jacobian = [[T; 3]; 3];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = super::IncrementCore;
        const HAS_CORE: bool = true;
        const SOLVER: usize = 0;
        fn zeros() -> ([T; 3], [[T; 3]; 3]) {
            let zero = T::constant(0.0);
            ([zero; 3], [[zero; 3]; 3])
        }
        /// Once per run: 3 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J } = *parameters;
            let two = T::constant(2.0);
            let c5_886 = T::constant(2943.0) / T::constant(500.0);
            Scene {
                two_J: two * J,
                h,
                c5_886_h_m: c5_886 * h * m,
            }
        }
        /// Once per step: 3 multiplications.
        #[inline(always)]
        fn step(_scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let [omega, Gamma_x, Gamma_y] = *state;
            let two = T::constant(2.0);
            Step {
                Gamma_x,
                two_Gamma_x: two * Gamma_x,
                omega,
                two_omega: two * omega,
                Gamma_y,
                two_Gamma_y: two * Gamma_y,
            }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, _step: &Step<T>) -> [T; 3] {
            let zero = T::constant(0.0);
            [zero, zero, zero]
        }
        /// r(x), 3 equations, lines 26 to 27: 6 additions, 7 multiplications.
        ///
        /// - row 0: `2*J*Δω + h*m*g*l*e1.T*(Γ[k+1] + Γ) = 0`
        /// - rows 1 to 2: `4*ΔΓ + h*S(ω[k+1] + ω)*(Γ[k+1] + Γ) = 0`
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 3],
            residual: &mut [T; 3],
        ) {
            let Scene { two_J, h, c5_886_h_m } = *scene;
            let Step { two_Gamma_x, two_omega, two_Gamma_y, .. } = *step;
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Delta_Gamma_x + two_Gamma_x;
            residual[0] = two_J * Delta_omega + c5_886_h_m * Gamma_x_sum;
            let h_omega_sum = h * (Delta_omega + two_omega);
            residual[1] = four * Delta_Gamma_x
                - h_omega_sum * (Delta_Gamma_y + two_Gamma_y);
            residual[2] = four * Delta_Gamma_y + h_omega_sum * Gamma_x_sum;
        }
        /// r(x) and the 8 structural non-zeros of its Jacobian, lines 26 to 27: 6 additions, 9 multiplications.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 3],
            residual: &mut [T; 3],
            jacobian: &mut [[T; 3]; 3],
        ) {
            let Scene { two_J, h, c5_886_h_m } = *scene;
            let Step { two_Gamma_x, two_omega, two_Gamma_y, .. } = *step;
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Delta_Gamma_x + two_Gamma_x;
            residual[0] = two_J * Delta_omega + c5_886_h_m * Gamma_x_sum;
            jacobian[0][0] = two_J;
            jacobian[0][1] = c5_886_h_m;
            let h_omega_sum = h * (Delta_omega + two_omega);
            let Gamma_y_sum = Delta_Gamma_y + two_Gamma_y;
            residual[1] = four * Delta_Gamma_x - h_omega_sum * Gamma_y_sum;
            jacobian[1][0] = -h * Gamma_y_sum;
            jacobian[1][1] = four;
            jacobian[1][2] = -h_omega_sum;
            residual[2] = four * Delta_Gamma_y + h_omega_sum * Gamma_x_sum;
            jacobian[2][0] = h * Gamma_x_sum;
            jacobian[2][1] = h_omega_sum;
            jacobian[2][2] = four;
        }
        /// The state after the step: 3 additions.
        #[inline(always)]
        fn next(_scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 3]) -> [T; 3] {
            let Step { Gamma_x, omega, Gamma_y, .. } = *step;
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            [Delta_omega + omega, Delta_Gamma_x + Gamma_x, Delta_Gamma_y + Gamma_y]
        }
        const HAS_CHANGE: bool = true;
        /// What the step adds to the state: no operations.
        #[inline(always)]
        fn change(_scene: &Scene<T>, _step: &Step<T>, unknowns: &[T; 3]) -> [T; 3] {
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            [Delta_omega, Delta_Gamma_x, Delta_Gamma_y]
        }
        fn rounding(
            parameters: &super::Parameters<T>,
            h: T,
            t: T,
            state: &[T; 3],
            unknowns: &[T; 3],
        ) -> ([T; 3], [T; 3])
        where
            T: ::residua::Real,
        {
            ::residua::rounding::<Self, T>(parameters, h, t, state, unknowns)
        }
    }
}
/// What [`Increment`] iterates on: 1 of its 3 unknowns. The others enter linearly and are eliminated.
#[derive(Clone, Copy, Debug)]
pub struct IncrementCore;
#[allow(non_snake_case, reason = "names as in the model")]
#[allow(clippy::approx_constant, reason = "numbers as in the model")]
#[allow(
    clippy::possible_missing_comma,
    reason = "all tokens have one place, the invocation"
)]
#[allow(
    clippy::many_single_char_names,
    clippy::suspicious_operation_groupings,
    reason = "formulas"
)]
mod increment_core {
    /// What a run needs of the parameters and h.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        h: T,
        c11_772_h_m: T,
        four_h: T,
        two_J: T,
        h_squared: T,
        two_h_squared: T,
        c23_544_h_m: T,
        two_h: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        Gamma_y: T,
        four_h_Gamma_y: T,
        omega: T,
        two_omega: T,
        Gamma_x: T,
        c11_772_h_m_Gamma_x: T,
        h_squared_Gamma_x: T,
        two_h_Gamma_y: T,
        four_h_Gamma_x: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 8;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                h: from(0),
                c11_772_h_m: from(1),
                four_h: from(2),
                two_J: from(3),
                h_squared: from(4),
                two_h_squared: from(5),
                c23_544_h_m: from(6),
                two_h: from(7),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.h);
            to(1, self.c11_772_h_m);
            to(2, self.four_h);
            to(3, self.two_J);
            to(4, self.h_squared);
            to(5, self.two_h_squared);
            to(6, self.c23_544_h_m);
            to(7, self.two_h);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::IncrementCore {
        type Model = super::Model;
        type Unknowns = [T; 1];
        type Jacobian = [[T; 1]; 1];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = Self;
        const UNKNOWNS: &'static [::residua::description::Unknown] = &[
            ::residua::description::Unknown {
                name: "Δω",
                len: 1,
                measure: ::core::option::Option::Some(0..1),
                told: true,
            },
        ];
        const SOLVER: usize = 0;
        fn zeros() -> ([T; 1], [[T; 1]; 1]) {
            let zero = T::constant(0.0);
            ([zero; 1], [[zero; 1]; 1])
        }
        /// Once per run: 9 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J } = *parameters;
            let [two, four] = [2.0, 4.0].map(T::constant);
            let c11_772 = T::constant(2943.0) / T::constant(250.0);
            let c23_544 = T::constant(2943.0) / T::constant(125.0);
            let h_squared = h * h;
            Scene {
                h,
                c11_772_h_m: c11_772 * h * m,
                four_h: four * h,
                two_J: two * J,
                h_squared,
                two_h_squared: two * h_squared,
                c23_544_h_m: c23_544 * h * m,
                two_h: two * h,
            }
        }
        /// Once per step: 6 multiplications.
        #[inline(always)]
        fn step(scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let Scene { c11_772_h_m, four_h, h_squared, two_h, .. } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            let two = T::constant(2.0);
            Step {
                Gamma_y,
                four_h_Gamma_y: four_h * Gamma_y,
                omega,
                two_omega: two * omega,
                Gamma_x,
                c11_772_h_m_Gamma_x: c11_772_h_m * Gamma_x,
                h_squared_Gamma_x: h_squared * Gamma_x,
                two_h_Gamma_y: two_h * Gamma_y,
                four_h_Gamma_x: four_h * Gamma_x,
            }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, _step: &Step<T>) -> [T; 1] {
            let zero = T::constant(0.0);
            [zero]
        }
        /// r(x), 1 equations after elimination: 5 additions, 7 multiplications.
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
        ) {
            let Scene { h, c11_772_h_m, two_J, .. } = *scene;
            let Step { four_h_Gamma_y, two_omega, Gamma_x, c11_772_h_m_Gamma_x, .. } = *step;
            let [Delta_omega] = *unknowns;
            let sixteen = T::constant(16.0);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = c11_772_h_m
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v2 = (h_omega_sum_squared + sixteen)
                * (two_J * Delta_omega + c11_772_h_m_Gamma_x);
            residual[0] = v1 + v2;
        }
        /// r(x) and the 1 structural non-zeros of its Jacobian after elimination: 8 additions, 12 multiplications.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
            jacobian: &mut [[T; 1]; 1],
        ) {
            let Scene { h, c11_772_h_m, two_J, two_h_squared, c23_544_h_m, .. } = *scene;
            let Step {
                four_h_Gamma_y,
                two_omega,
                Gamma_x,
                c11_772_h_m_Gamma_x,
                h_squared_Gamma_x,
                two_h_Gamma_y,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let sixteen = T::constant(16.0);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = c11_772_h_m
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v3 = h_omega_sum_squared + sixteen;
            let v4 = two_J * Delta_omega + c11_772_h_m_Gamma_x;
            residual[0] = v1 + v3 * v4;
            jacobian[0][0] = two_h_squared * omega_sum * v4 + two_J * v3
                - c23_544_h_m * (h_squared_Gamma_x * omega_sum - two_h_Gamma_y);
        }
        const HAS_CORRECTION: bool = true;
        /// J(x)⁻¹ r(x) in closed form, and the growth of rounding in it: 8 additions, 12 multiplications, 1 division.
        #[inline(always)]
        fn correction(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
        ) -> ([T; 1], T) {
            let Scene { h, c11_772_h_m, two_J, two_h_squared, c23_544_h_m, .. } = *scene;
            let Step {
                four_h_Gamma_y,
                two_omega,
                Gamma_x,
                c11_772_h_m_Gamma_x,
                h_squared_Gamma_x,
                two_h_Gamma_y,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let [zero, sixteen] = [0.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = c11_772_h_m
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v3 = h_omega_sum_squared + sixteen;
            let v4 = two_J * Delta_omega + c11_772_h_m_Gamma_x;
            let v5 = two_h_squared * omega_sum * v4 + two_J * v3
                - c23_544_h_m * (h_squared_Gamma_x * omega_sum - two_h_Gamma_y);
            ([(v1 + v3 * v4) / v5], zero)
        }
        /// The state after the step: 7 additions, 10 multiplications, 1 division.
        #[inline(always)]
        fn next(scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 1]) -> [T; 3] {
            let Scene { h, .. } = *scene;
            let Step {
                Gamma_y,
                four_h_Gamma_y,
                omega,
                two_omega,
                Gamma_x,
                four_h_Gamma_x,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let [one, two, sixteen] = [1.0, 2.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v6 = one / (h_omega_sum_squared + sixteen);
            let v7 = (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared) * v6;
            let v8 = (four_h_Gamma_x * omega_sum + Gamma_y * h_omega_sum_squared) * v6;
            [Delta_omega + omega, two * v7 + Gamma_x, Gamma_y - two * v8]
        }
        const HAS_CHANGE: bool = true;
        /// What the step adds to the state: 4 additions, 10 multiplications, 1 division.
        #[inline(always)]
        fn change(scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 1]) -> [T; 3] {
            let Scene { h, .. } = *scene;
            let Step {
                Gamma_y,
                four_h_Gamma_y,
                two_omega,
                Gamma_x,
                four_h_Gamma_x,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let [one, two, sixteen] = [1.0, 2.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v6 = one / (h_omega_sum_squared + sixteen);
            let v7 = (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared) * v6;
            let v8 = (four_h_Gamma_x * omega_sum + Gamma_y * h_omega_sum_squared) * v6;
            [Delta_omega, two * v7, -two * v8]
        }
        fn rounding(
            parameters: &super::Parameters<T>,
            h: T,
            t: T,
            state: &[T; 3],
            unknowns: &[T; 1],
        ) -> ([T; 1], [T; 3])
        where
            T: ::residua::Real,
        {
            ::residua::rounding::<Self, T>(parameters, h, t, state, unknowns)
        }
        /// Σ|terms|/|Σ terms| over the divisors: no operations.
        #[inline(always)]
        fn growth(_scene: &Scene<T>, _step: &Step<T>, _unknowns: &[T; 1]) -> T {
            let zero = T::constant(0.0);
            zero
        }
    }
}
/// Names, shapes, units and texts.
pub const DESCRIPTION: &::residua::Description = &::residua::Description {
    name: "swing",
    doc: "A swing of the planar pendulum, without gravity being open to change.",
    parameters: &[
        ::residua::description::Variable {
            name: "m",
            ascii: "m",
            rows: 1,
            cols: 1,
            unit: "kg",
            dimensionless: false,
            doc: "mass",
        },
        ::residua::description::Variable {
            name: "J",
            ascii: "J",
            rows: 1,
            cols: 1,
            unit: "kg*m^2",
            dimensionless: false,
            doc: "moment of inertia about the pivot",
        },
    ],
    states: &[
        ::residua::description::Variable {
            name: "ω",
            ascii: "omega",
            rows: 1,
            cols: 1,
            unit: "rad/s",
            dimensionless: false,
            doc: "angular velocity",
        },
        ::residua::description::Variable {
            name: "Γ",
            ascii: "Gamma",
            rows: 2,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "second row of the rotation matrix",
        },
    ],
    outputs: &[
        ::residua::description::Output {
            variable: ::residua::description::Variable {
                name: "θ",
                ascii: "theta",
                rows: 1,
                cols: 1,
                unit: "rad",
                dimensionless: true,
                doc: "",
            },
            invariant: false,
        },
    ],
    solvers: &[
        ::residua::description::Solver {
            form: "increment",
            unknowns: &[
                ::residua::description::Unknown {
                    name: "Δω",
                    len: 1,
                    measure: ::core::option::Option::Some(0..1),
                    told: true,
                },
                ::residua::description::Unknown {
                    name: "ΔΓ",
                    len: 2,
                    measure: ::core::option::Option::Some(1..3),
                    told: true,
                },
            ],
            equations: &[
                ::residua::description::Equation {
                    text: "2*J*Δω + h*m*g*l*e1.T*(Γ[k+1] + Γ) = 0",
                    line: 26,
                    len: 1,
                },
                ::residua::description::Equation {
                    text: "4*ΔΓ + h*S(ω[k+1] + ω)*(Γ[k+1] + Γ) = 0",
                    line: 27,
                    len: 2,
                },
            ],
            pattern: &[(0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)],
            counts: &[
                (
                    "scene",
                    ::residua::description::Count {
                        additions: 0,
                        multiplications: 3,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "step",
                    ::residua::description::Count {
                        additions: 0,
                        multiplications: 3,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "guess",
                    ::residua::description::Count {
                        additions: 0,
                        multiplications: 0,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "residual",
                    ::residua::description::Count {
                        additions: 6,
                        multiplications: 7,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "residual_and_jacobian",
                    ::residua::description::Count {
                        additions: 6,
                        multiplications: 9,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "next",
                    ::residua::description::Count {
                        additions: 3,
                        multiplications: 0,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "change",
                    ::residua::description::Count {
                        additions: 0,
                        multiplications: 0,
                        divisions: 0,
                        calls: 0,
                    },
                ),
            ],
            core: ::core::option::Option::Some(
                &::residua::description::Core {
                    unknowns: &[
                        ::residua::description::Unknown {
                            name: "Δω",
                            len: 1,
                            measure: ::core::option::Option::Some(0..1),
                            told: true,
                        },
                    ],
                    eliminated: &[
                        ::residua::description::Unknown {
                            name: "ΔΓ",
                            len: 2,
                            measure: ::core::option::Option::Some(1..3),
                            told: true,
                        },
                    ],
                    lines: &[27],
                    pattern: &[(0, 0)],
                    counts: &[
                        (
                            "scene",
                            ::residua::description::Count {
                                additions: 0,
                                multiplications: 9,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "step",
                            ::residua::description::Count {
                                additions: 0,
                                multiplications: 6,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "guess",
                            ::residua::description::Count {
                                additions: 0,
                                multiplications: 0,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "residual",
                            ::residua::description::Count {
                                additions: 5,
                                multiplications: 7,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "residual_and_jacobian",
                            ::residua::description::Count {
                                additions: 8,
                                multiplications: 12,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "next",
                            ::residua::description::Count {
                                additions: 7,
                                multiplications: 10,
                                divisions: 1,
                                calls: 0,
                            },
                        ),
                        (
                            "growth",
                            ::residua::description::Count {
                                additions: 0,
                                multiplications: 0,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "change",
                            ::residua::description::Count {
                                additions: 4,
                                multiplications: 10,
                                divisions: 1,
                                calls: 0,
                            },
                        ),
                        (
                            "correction",
                            ::residua::description::Count {
                                additions: 8,
                                multiplications: 12,
                                divisions: 1,
                                calls: 0,
                            },
                        ),
                    ],
                },
            ),
        },
    ],
    claims: &[],
    requirements: &[],
    has_flow: true,
    no_series: ::core::option::Option::None,
    counts: &[
        (
            "scene",
            ::residua::description::Count {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                calls: 0,
            },
        ),
        (
            "step",
            ::residua::description::Count {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                calls: 0,
            },
        ),
        (
            "outputs",
            ::residua::description::Count {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                calls: 1,
            },
        ),
        (
            "scene",
            ::residua::description::Count {
                additions: 0,
                multiplications: 1,
                divisions: 1,
                calls: 0,
            },
        ),
        (
            "step",
            ::residua::description::Count {
                additions: 0,
                multiplications: 0,
                divisions: 0,
                calls: 0,
            },
        ),
        (
            "flow",
            ::residua::description::Count {
                additions: 0,
                multiplications: 3,
                divisions: 0,
                calls: 0,
            },
        ),
    ],
    operations: 153,
    scene: ::core::option::Option::Some(
        &::residua::description::Scene {
            model: "planar",
            step: 0.01,
            until: 10.0,
            keep: &["ω", "θ"],
            fixed: &[
                ::residua::description::Fixed {
                    name: "l",
                    values: &[0.6],
                },
                ::residua::description::Fixed {
                    name: "g",
                    values: &[9.81],
                },
            ],
            zeros: &[],
            skipped: &[
                ::residua::description::Skipped {
                    kind: "parameter",
                    what: "l",
                    reason: "fixed as `0.6` in line 4 of the scene and folded in",
                    line: 9,
                },
                ::residua::description::Skipped {
                    kind: "parameter",
                    what: "g",
                    reason: "fixed as `9.81` in line 5 of the scene and folded in",
                    line: 11,
                },
                ::residua::description::Skipped {
                    kind: "output",
                    what: "energy",
                    reason: "not kept",
                    line: 33,
                },
            ],
        },
    ),
};
/// The model behind one face, for programs that pick models at run time.
pub static MODEL: ::residua::Catalogued = ::residua::Catalogued {
    description: DESCRIPTION,
    model: &::residua::erased::ErasedModel::<Model>::NEW,
    solvers: &[&::residua::erased::ErasedSolver::<Increment>::NEW],
    flow: ::core::option::Option::Some(&::residua::erased::ErasedFlow::<Model>::NEW),
    series: ::core::option::Option::Some(&::residua::erased::ErasedSeries::<Model>::NEW),
};
