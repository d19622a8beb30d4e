/// The parameters.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<T = f64> {
    /// `m` in `kg`: mass
    pub m: T,
    /// `J` in `kg*m^2`: moment of inertia about the pivot
    pub J: T,
    /// `l` in `m`: distance from the pivot to the centre of mass
    pub l: T,
    /// `g` in `m/s^2`: gravity
    pub g: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Parameters<T> {
    type Array = [T; 4];
    fn from_array([m, J, l, g]: [T; 4]) -> Self {
        Self { m, J, l, g }
    }
    fn to_array(&self) -> [T; 4] {
        let Self { m, J, l, g } = *self;
        [m, J, l, g]
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
    /// `energy` in `J`
    pub energy: T,
    /// `θ` in `rad`
    pub theta: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Outputs<T> {
    type Array = [T; 2];
    fn from_array([energy, theta]: [T; 2]) -> Self {
        Self { energy, theta }
    }
    fn to_array(&self) -> [T; 2] {
        let Self { energy, theta } = *self;
        [energy, theta]
    }
}
/// Planar pendulum, reduced attitude Γ = Rᵀe₂.
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
            let [c0_48, c0_6, two, c9_81] = [0.48, 0.6, 2.0, 9.81].map(T::constant);
            Self {
                m: two,
                J: c0_48,
                l: c0_6,
                g: c9_81,
            }
        }
    }
    impl<T: ::residua::Scalar> ::residua::Model<T> for super::Model {
        type Parameters = super::Parameters<T>;
        type State = super::State<T>;
        type Outputs = super::Outputs<T>;
        const DESCRIPTION: &'static ::residua::Description = super::DESCRIPTION;
        fn start(_parameters: &super::Parameters<T>) -> super::State<T> {
            let [zero, one] = [0.0, 1.0].map(T::constant);
            super::State {
                omega: one,
                Gamma: [zero, one],
            }
        }
        fn outputs(
            parameters: &super::Parameters<T>,
            _h: T,
            _t: T,
            state: &super::State<T>,
        ) -> super::Outputs<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            let super::State { omega, Gamma: [Gamma_x, Gamma_y] } = *state;
            let [half, two] = [0.5, 2.0].map(T::constant);
            super::Outputs {
                energy: half * (J * (omega * omega) - two * m * g * l * Gamma_y),
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
        m_g_l_over_J: T,
    }
    impl<T: ::residua::Scalar> ::residua::Flow<T> for super::Model {
        type FlowScene = Scene<T>;
        fn flow_scene(parameters: &super::Parameters<T>) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            Scene {
                m_g_l_over_J: m * g * l / J,
            }
        }
        /// dx/dt, 3 components, lines 21 to 22: 3 multiplications.
        #[inline(always)]
        fn flow(scene: &Scene<T>, _t: T, state: &[T; 3]) -> [T; 3] {
            let Scene { m_g_l_over_J } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            [-m_g_l_over_J * Gamma_x, omega * Gamma_y, -omega * Gamma_x]
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
        m_g_l_over_J: T,
    }
    /// What depends on the start of the step only.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        Gamma_x: T,
        m_g_l_over_J_Gamma_x: T,
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
        /// Once per run: 2 multiplications, 1 division.
        fn scene(parameters: &super::Parameters<T>) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            Scene {
                m_g_l_over_J: m * g * l / J,
            }
        }
        /// Once per step: 3 multiplications.
        #[inline(always)]
        fn base(scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let Scene { m_g_l_over_J } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            Step {
                Gamma_x,
                m_g_l_over_J_Gamma_x: m_g_l_over_J * Gamma_x,
                omega,
                Gamma_y,
                omega_Gamma_y: omega * Gamma_y,
                omega_Gamma_x: omega * Gamma_x,
            }
        }
        #[inline(always)]
        fn rates(_scene: &Scene<T>, step: &Step<T>) -> [T; 3] {
            let Step { m_g_l_over_J_Gamma_x, omega_Gamma_y, omega_Gamma_x, .. } = *step;
            [-m_g_l_over_J_Gamma_x, omega_Gamma_y, -omega_Gamma_x]
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
            let Scene { m_g_l_over_J } = *scene;
            let [_, Gamma_x_n, _] = *newest;
            let [[product_1, product_2, _, _]] = *products;
            ([-m_g_l_over_J * Gamma_x_n, product_1, -product_2], [[], []])
        }
    }
}
/// The solver whose unknowns are the next states, and those the model declares.
#[derive(Clone, Copy, Debug)]
pub struct Next;
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
mod next {
    /// What a run needs of the parameters and h.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        two_J: T,
        h: T,
        h_m_g_l: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        omega: T,
        Gamma_x: T,
        Gamma_y: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 3;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                two_J: from(0),
                h: from(1),
                h_m_g_l: from(2),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.two_J);
            to(1, self.h);
            to(2, self.h_m_g_l);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::Next {
        type Model = super::Model;
        type Unknowns = [T; 3];
        type Jacobian = [[T; 3]; 3];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = super::NextCore;
        const HAS_CORE: bool = true;
        const SOLVER: usize = 0;
        fn zeros() -> ([T; 3], [[T; 3]; 3]) {
            let zero = T::constant(0.0);
            ([zero; 3], [[zero; 3]; 3])
        }
        /// Once per run: 4 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            let two = T::constant(2.0);
            Scene {
                two_J: two * J,
                h,
                h_m_g_l: h * m * g * l,
            }
        }
        /// Once per step: no operations.
        #[inline(always)]
        fn step(_scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let [omega, Gamma_x, Gamma_y] = *state;
            Step { omega, Gamma_x, Gamma_y }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, step: &Step<T>) -> [T; 3] {
            let Step { omega, Gamma_x, Gamma_y } = *step;
            [omega, Gamma_x, Gamma_y]
        }
        /// r(x), 3 equations, lines 26 to 27: 9 additions, 7 multiplications.
        ///
        /// - row 0: `2*J*Δω + h*m*g*l*e1.T*(Γ[k+1] + Γ) = 0`
        /// - rows 1 to 2: `4*ΔΓ + h*S(ω[k+1] + ω)*(Γ[k+1] + Γ) = 0`
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 3],
            residual: &mut [T; 3],
        ) {
            let Scene { two_J, h, h_m_g_l } = *scene;
            let Step { omega, Gamma_x, Gamma_y } = *step;
            let [omega_next, Gamma_x_next, Gamma_y_next] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Gamma_x_next + Gamma_x;
            residual[0] = two_J * (omega_next - omega) + h_m_g_l * Gamma_x_sum;
            let h_omega_sum = h * (omega_next + omega);
            residual[1] = four * (Gamma_x_next - Gamma_x)
                - h_omega_sum * (Gamma_y_next + Gamma_y);
            residual[2] = h_omega_sum * Gamma_x_sum + four * (Gamma_y_next - Gamma_y);
        }
        /// r(x) and the 8 structural non-zeros of its Jacobian, lines 26 to 27: 9 additions, 9 multiplications.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 3],
            residual: &mut [T; 3],
            jacobian: &mut [[T; 3]; 3],
        ) {
            let Scene { two_J, h, h_m_g_l } = *scene;
            let Step { omega, Gamma_x, Gamma_y } = *step;
            let [omega_next, Gamma_x_next, Gamma_y_next] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Gamma_x_next + Gamma_x;
            residual[0] = two_J * (omega_next - omega) + h_m_g_l * Gamma_x_sum;
            jacobian[0][0] = two_J;
            jacobian[0][1] = h_m_g_l;
            let h_omega_sum = h * (omega_next + omega);
            let Gamma_y_sum = Gamma_y_next + Gamma_y;
            residual[1] = four * (Gamma_x_next - Gamma_x) - h_omega_sum * Gamma_y_sum;
            jacobian[1][0] = -h * Gamma_y_sum;
            jacobian[1][1] = four;
            jacobian[1][2] = -h_omega_sum;
            residual[2] = h_omega_sum * Gamma_x_sum + four * (Gamma_y_next - Gamma_y);
            jacobian[2][0] = h * Gamma_x_sum;
            jacobian[2][1] = h_omega_sum;
            jacobian[2][2] = four;
        }
        /// The state after the step: no operations.
        #[inline(always)]
        fn next(_scene: &Scene<T>, _step: &Step<T>, unknowns: &[T; 3]) -> [T; 3] {
            let [omega_next, Gamma_x_next, Gamma_y_next] = *unknowns;
            [omega_next, Gamma_x_next, Gamma_y_next]
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
/// What [`Next`] iterates on: 1 of its 3 unknowns. The others enter linearly and are eliminated.
#[derive(Clone, Copy, Debug)]
pub struct NextCore;
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
mod next_core {
    /// What a run needs of the parameters and h.
    #[derive(Clone, Copy)]
    pub struct Scene<T> {
        h: T,
        h_m_g_l: T,
        four_h: T,
        two_J: T,
        h_squared: T,
        two_h_squared: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        omega: T,
        four_h_Gamma_y: T,
        sixteen_Gamma_x: T,
        h_Gamma_x: T,
        four_Gamma_y: T,
        h_m_g_l_Gamma_x: T,
        h_squared_Gamma_x: T,
        four_h_Gamma_x: T,
        h_Gamma_y: T,
        four_Gamma_x: T,
        sixteen_Gamma_y: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 6;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                h: from(0),
                h_m_g_l: from(1),
                four_h: from(2),
                two_J: from(3),
                h_squared: from(4),
                two_h_squared: from(5),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.h);
            to(1, self.h_m_g_l);
            to(2, self.four_h);
            to(3, self.two_J);
            to(4, self.h_squared);
            to(5, self.two_h_squared);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::NextCore {
        type Model = super::Model;
        type Unknowns = [T; 1];
        type Jacobian = [[T; 1]; 1];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = Self;
        const UNKNOWNS: &'static [::residua::description::Unknown] = &[
            ::residua::description::Unknown {
                name: "ω[k+1]",
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
        /// Once per run: 7 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            let [two, four] = [2.0, 4.0].map(T::constant);
            let h_squared = h * h;
            Scene {
                h,
                h_m_g_l: h * m * g * l,
                four_h: four * h,
                two_J: two * J,
                h_squared,
                two_h_squared: two * h_squared,
            }
        }
        /// Once per step: 10 multiplications.
        #[inline(always)]
        fn step(scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let Scene { h, h_m_g_l, four_h, h_squared, .. } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            let [four, sixteen] = [4.0, 16.0].map(T::constant);
            Step {
                omega,
                four_h_Gamma_y: four_h * Gamma_y,
                sixteen_Gamma_x: sixteen * Gamma_x,
                h_Gamma_x: h * Gamma_x,
                four_Gamma_y: four * Gamma_y,
                h_m_g_l_Gamma_x: h_m_g_l * Gamma_x,
                h_squared_Gamma_x: h_squared * Gamma_x,
                four_h_Gamma_x: four_h * Gamma_x,
                h_Gamma_y: h * Gamma_y,
                four_Gamma_x: four * Gamma_x,
                sixteen_Gamma_y: sixteen * Gamma_y,
            }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, step: &Step<T>) -> [T; 1] {
            let Step { omega, .. } = *step;
            [omega]
        }
        /// r(x), 1 equations after elimination: 8 additions, 8 multiplications.
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
        ) {
            let Scene { h, h_m_g_l, two_J, .. } = *scene;
            let Step {
                omega,
                four_h_Gamma_y,
                sixteen_Gamma_x,
                h_Gamma_x,
                four_Gamma_y,
                h_m_g_l_Gamma_x,
                ..
            } = *step;
            let [omega_next] = *unknowns;
            let sixteen = T::constant(16.0);
            let omega_sum = omega_next + omega;
            let h_omega_sum = h * omega_sum;
            let v1 = four_h_Gamma_y * omega_sum + sixteen_Gamma_x
                - h_omega_sum * (h_Gamma_x * omega_sum - four_Gamma_y);
            let v2 = (h_omega_sum * h_omega_sum + sixteen)
                * (two_J * (omega_next - omega) + h_m_g_l_Gamma_x);
            residual[0] = h_m_g_l * v1 + v2;
        }
        /// r(x) and the 1 structural non-zeros of its Jacobian after elimination: 12 additions, 14 multiplications.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
            jacobian: &mut [[T; 1]; 1],
        ) {
            let Scene { h, h_m_g_l, two_J, two_h_squared, .. } = *scene;
            let Step {
                omega,
                four_h_Gamma_y,
                sixteen_Gamma_x,
                h_Gamma_x,
                four_Gamma_y,
                h_m_g_l_Gamma_x,
                h_squared_Gamma_x,
                ..
            } = *step;
            let [omega_next] = *unknowns;
            let sixteen = T::constant(16.0);
            let omega_sum = omega_next + omega;
            let h_omega_sum = h * omega_sum;
            let v3 = h_Gamma_x * omega_sum - four_Gamma_y;
            let v4 = h_m_g_l
                * (four_h_Gamma_y * omega_sum + sixteen_Gamma_x - h_omega_sum * v3);
            let v5 = h_omega_sum * h_omega_sum + sixteen;
            let v6 = two_J * (omega_next - omega) + h_m_g_l_Gamma_x;
            residual[0] = v4 + v5 * v6;
            let v7 = h_m_g_l * (h * v3 + h_squared_Gamma_x * omega_sum - four_h_Gamma_y);
            jacobian[0][0] = two_h_squared * omega_sum * v6 + two_J * v5 - v7;
        }
        const HAS_CORRECTION: bool = true;
        /// J(x)⁻¹ r(x) in closed form, and the growth of rounding in it: 12 additions, 14 multiplications, 1 division.
        #[inline(always)]
        fn correction(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
        ) -> ([T; 1], T) {
            let Scene { h, h_m_g_l, two_J, two_h_squared, .. } = *scene;
            let Step {
                omega,
                four_h_Gamma_y,
                sixteen_Gamma_x,
                h_Gamma_x,
                four_Gamma_y,
                h_m_g_l_Gamma_x,
                h_squared_Gamma_x,
                ..
            } = *step;
            let [omega_next] = *unknowns;
            let [zero, sixteen] = [0.0, 16.0].map(T::constant);
            let omega_sum = omega_next + omega;
            let h_omega_sum = h * omega_sum;
            let v3 = h_Gamma_x * omega_sum - four_Gamma_y;
            let v4 = h_m_g_l
                * (four_h_Gamma_y * omega_sum + sixteen_Gamma_x - h_omega_sum * v3);
            let v5 = h_omega_sum * h_omega_sum + sixteen;
            let v6 = two_J * (omega_next - omega) + h_m_g_l_Gamma_x;
            let v7 = h_m_g_l * (h * v3 + h_squared_Gamma_x * omega_sum - four_h_Gamma_y);
            ([(v4 + v5 * v6) / (two_h_squared * omega_sum * v6 + two_J * v5 - v7)], zero)
        }
        /// The state after the step: 8 additions, 10 multiplications, 1 division.
        #[inline(always)]
        fn next(scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 1]) -> [T; 3] {
            let Scene { h, .. } = *scene;
            let Step {
                omega,
                four_h_Gamma_y,
                sixteen_Gamma_x,
                h_Gamma_x,
                four_Gamma_y,
                four_h_Gamma_x,
                h_Gamma_y,
                four_Gamma_x,
                sixteen_Gamma_y,
                ..
            } = *step;
            let [omega_next] = *unknowns;
            let [one, sixteen] = [1.0, 16.0].map(T::constant);
            let omega_sum = omega_next + omega;
            let h_omega_sum = h * omega_sum;
            let v1 = four_h_Gamma_y * omega_sum + sixteen_Gamma_x
                - h_omega_sum * (h_Gamma_x * omega_sum - four_Gamma_y);
            let v8 = one / (h_omega_sum * h_omega_sum + sixteen);
            let v9 = four_h_Gamma_x * omega_sum
                + h_omega_sum * (h_Gamma_y * omega_sum + four_Gamma_x) - sixteen_Gamma_y;
            [omega_next, v1 * v8, -v9 * v8]
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
        h_m_g_l: T,
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
                h_m_g_l: from(2),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.two_J);
            to(1, self.h);
            to(2, self.h_m_g_l);
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
        const SOLVER: usize = 1;
        fn zeros() -> ([T; 3], [[T; 3]; 3]) {
            let zero = T::constant(0.0);
            ([zero; 3], [[zero; 3]; 3])
        }
        /// Once per run: 4 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            let two = T::constant(2.0);
            Scene {
                two_J: two * J,
                h,
                h_m_g_l: h * m * g * l,
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
            let Scene { two_J, h, h_m_g_l } = *scene;
            let Step { two_Gamma_x, two_omega, two_Gamma_y, .. } = *step;
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Delta_Gamma_x + two_Gamma_x;
            residual[0] = two_J * Delta_omega + h_m_g_l * Gamma_x_sum;
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
            let Scene { two_J, h, h_m_g_l } = *scene;
            let Step { two_Gamma_x, two_omega, two_Gamma_y, .. } = *step;
            let [Delta_omega, Delta_Gamma_x, Delta_Gamma_y] = *unknowns;
            let four = T::constant(4.0);
            let Gamma_x_sum = Delta_Gamma_x + two_Gamma_x;
            residual[0] = two_J * Delta_omega + h_m_g_l * Gamma_x_sum;
            jacobian[0][0] = two_J;
            jacobian[0][1] = h_m_g_l;
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
        h_m_g_l: T,
        four_h: T,
        J: T,
        h_squared: T,
        two_h_squared: T,
        two_h_m_g_l: T,
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
        h_m_g_l_Gamma_x: T,
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
                h_m_g_l: from(1),
                four_h: from(2),
                J: from(3),
                h_squared: from(4),
                two_h_squared: from(5),
                two_h_m_g_l: from(6),
                two_h: from(7),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.h);
            to(1, self.h_m_g_l);
            to(2, self.four_h);
            to(3, self.J);
            to(4, self.h_squared);
            to(5, self.two_h_squared);
            to(6, self.two_h_m_g_l);
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
        const SOLVER: usize = 1;
        fn zeros() -> ([T; 1], [[T; 1]; 1]) {
            let zero = T::constant(0.0);
            ([zero; 1], [[zero; 1]; 1])
        }
        /// Once per run: 11 multiplications.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters { m, J, l, g } = *parameters;
            let [two, four] = [2.0, 4.0].map(T::constant);
            let h_squared = h * h;
            Scene {
                h,
                h_m_g_l: h * m * g * l,
                four_h: four * h,
                J,
                h_squared,
                two_h_squared: two * h_squared,
                two_h_m_g_l: two * h * m * g * l,
                two_h: two * h,
            }
        }
        /// Once per step: 6 multiplications.
        #[inline(always)]
        fn step(scene: &Scene<T>, _t: T, state: &[T; 3]) -> Step<T> {
            let Scene { h_m_g_l, four_h, h_squared, two_h, .. } = *scene;
            let [omega, Gamma_x, Gamma_y] = *state;
            let two = T::constant(2.0);
            Step {
                Gamma_y,
                four_h_Gamma_y: four_h * Gamma_y,
                omega,
                two_omega: two * omega,
                Gamma_x,
                h_m_g_l_Gamma_x: h_m_g_l * Gamma_x,
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
        /// r(x), 1 equations after elimination: 5 additions, 8 multiplications.
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
        ) {
            let Scene { h, h_m_g_l, J, .. } = *scene;
            let Step { four_h_Gamma_y, two_omega, Gamma_x, h_m_g_l_Gamma_x, .. } = *step;
            let [Delta_omega] = *unknowns;
            let [two, sixteen] = [2.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = h_m_g_l
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v2 = (h_omega_sum_squared + sixteen)
                * (J * Delta_omega + h_m_g_l_Gamma_x);
            residual[0] = two * (v1 + v2);
        }
        /// r(x) and the 1 structural non-zeros of its Jacobian after elimination: 8 additions, 14 multiplications.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
            residual: &mut [T; 1],
            jacobian: &mut [[T; 1]; 1],
        ) {
            let Scene { h, h_m_g_l, J, two_h_squared, two_h_m_g_l, .. } = *scene;
            let Step {
                four_h_Gamma_y,
                two_omega,
                Gamma_x,
                h_m_g_l_Gamma_x,
                h_squared_Gamma_x,
                two_h_Gamma_y,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let [two, sixteen] = [2.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = h_m_g_l
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v3 = h_omega_sum_squared + sixteen;
            let v4 = J * Delta_omega + h_m_g_l_Gamma_x;
            residual[0] = two * (v1 + v3 * v4);
            let v5 = two_h_squared * omega_sum * v4 + J * v3
                - two_h_m_g_l * (h_squared_Gamma_x * omega_sum - two_h_Gamma_y);
            jacobian[0][0] = two * v5;
        }
        const HAS_CORRECTION: bool = true;
        /// J(x)⁻¹ r(x) in closed form, and the growth of rounding in it: 8 additions, 12 multiplications, 1 division.
        #[inline(always)]
        fn correction(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 1],
        ) -> ([T; 1], T) {
            let Scene { h, h_m_g_l, J, two_h_squared, two_h_m_g_l, .. } = *scene;
            let Step {
                four_h_Gamma_y,
                two_omega,
                Gamma_x,
                h_m_g_l_Gamma_x,
                h_squared_Gamma_x,
                two_h_Gamma_y,
                ..
            } = *step;
            let [Delta_omega] = *unknowns;
            let [zero, sixteen] = [0.0, 16.0].map(T::constant);
            let omega_sum = Delta_omega + two_omega;
            let h_omega_sum = h * omega_sum;
            let h_omega_sum_squared = h_omega_sum * h_omega_sum;
            let v1 = h_m_g_l
                * (four_h_Gamma_y * omega_sum - Gamma_x * h_omega_sum_squared);
            let v3 = h_omega_sum_squared + sixteen;
            let v4 = J * Delta_omega + h_m_g_l_Gamma_x;
            let v5 = two_h_squared * omega_sum * v4 + J * v3
                - two_h_m_g_l * (h_squared_Gamma_x * omega_sum - two_h_Gamma_y);
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
    name: "planar",
    doc: "Planar pendulum, reduced attitude Γ = Rᵀe₂.",
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
        ::residua::description::Variable {
            name: "l",
            ascii: "l",
            rows: 1,
            cols: 1,
            unit: "m",
            dimensionless: false,
            doc: "distance from the pivot to the centre of mass",
        },
        ::residua::description::Variable {
            name: "g",
            ascii: "g",
            rows: 1,
            cols: 1,
            unit: "m/s^2",
            dimensionless: false,
            doc: "gravity",
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
                name: "energy",
                ascii: "energy",
                rows: 1,
                cols: 1,
                unit: "J",
                dimensionless: false,
                doc: "",
            },
            invariant: true,
        },
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
            form: "next",
            unknowns: &[
                ::residua::description::Unknown {
                    name: "ω[k+1]",
                    len: 1,
                    measure: ::core::option::Option::Some(0..1),
                    told: true,
                },
                ::residua::description::Unknown {
                    name: "Γ[k+1]",
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
                        multiplications: 4,
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
                        additions: 9,
                        multiplications: 7,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "residual_and_jacobian",
                    ::residua::description::Count {
                        additions: 9,
                        multiplications: 9,
                        divisions: 0,
                        calls: 0,
                    },
                ),
                (
                    "next",
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
                            name: "ω[k+1]",
                            len: 1,
                            measure: ::core::option::Option::Some(0..1),
                            told: true,
                        },
                    ],
                    eliminated: &[
                        ::residua::description::Unknown {
                            name: "Γ[k+1]",
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
                                multiplications: 7,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "step",
                            ::residua::description::Count {
                                additions: 0,
                                multiplications: 10,
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
                                additions: 8,
                                multiplications: 8,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "residual_and_jacobian",
                            ::residua::description::Count {
                                additions: 12,
                                multiplications: 14,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "next",
                            ::residua::description::Count {
                                additions: 8,
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
                            "correction",
                            ::residua::description::Count {
                                additions: 12,
                                multiplications: 14,
                                divisions: 1,
                                calls: 0,
                            },
                        ),
                    ],
                },
            ),
        },
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
                        multiplications: 4,
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
                                multiplications: 11,
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
                                multiplications: 8,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "residual_and_jacobian",
                            ::residua::description::Count {
                                additions: 8,
                                multiplications: 14,
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
    claims: &[
        ::residua::description::Claim {
            kind: "jacobian",
            label: "misprinted",
            of: ::core::option::Option::None,
            line: 36,
            differences: &[
                ::residua::description::Difference {
                    row: 1,
                    col: 1,
                    entry: "∂(equation 2.1)/∂(Γ[k+1].x)",
                    printed: "2",
                    derived: "4",
                    values: (2.0, 4.0),
                },
                ::residua::description::Difference {
                    row: 2,
                    col: 2,
                    entry: "∂(equation 2.2)/∂(Γ[k+1].y)",
                    printed: "2",
                    derived: "4",
                    values: (2.0, 4.0),
                },
            ],
        },
    ],
    requirements: &[],
    has_flow: true,
    no_series: ::core::option::Option::None,
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
                multiplications: 0,
                divisions: 0,
                calls: 0,
            },
        ),
        (
            "outputs",
            ::residua::description::Count {
                additions: 1,
                multiplications: 4,
                divisions: 0,
                calls: 1,
            },
        ),
        (
            "scene",
            ::residua::description::Count {
                additions: 0,
                multiplications: 2,
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
    operations: 309,
    scene: ::core::option::Option::None,
};
/// The model behind one face, for programs that pick models at run time.
pub static MODEL: ::residua::Catalogued = ::residua::Catalogued {
    description: DESCRIPTION,
    model: &::residua::erased::ErasedModel::<Model>::NEW,
    solvers: &[
        &::residua::erased::ErasedSolver::<Next>::NEW,
        &::residua::erased::ErasedSolver::<Increment>::NEW,
    ],
    flow: ::core::option::Option::Some(&::residua::erased::ErasedFlow::<Model>::NEW),
    series: ::core::option::Option::Some(&::residua::erased::ErasedSeries::<Model>::NEW),
};
