/// The parameters.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<T = f64> {
    /// `type`
    pub r#type: T,
    /// `T`
    pub T: T,
    /// `two`
    pub two: T,
    /// `scene`
    pub scene: T,
    /// `Model`
    pub Model: T,
    /// `None`
    pub None: T,
    /// `v1`
    pub v1: T,
    /// `a_x`
    pub a_x: T,
    /// `a`
    pub a: [T; 3],
    /// `M`
    pub M: [[T; 2]; 2],
    /// `unused`
    pub unused: [T; 4],
    /// `almost_pi`
    pub almost_pi: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Parameters<T> {
    type Array = [T; 20];
    fn from_array(
        [r#type,
        T,
        two,
        scene,
        Model_,
        None_,
        v1,
        a_x,
        a_x_,
        a_y,
        a_z,
        M_11,
        M_12,
        M_21,
        M_22,
        unused_1,
        unused_2,
        unused_3,
        unused_4,
        almost_pi,
        ]: [T; 20],
    ) -> Self {
        Self {
            r#type,
            T,
            two,
            scene,
            Model: Model_,
            None: None_,
            v1,
            a_x,
            a: [a_x_, a_y, a_z],
            M: [[M_11, M_12], [M_21, M_22]],
            unused: [unused_1, unused_2, unused_3, unused_4],
            almost_pi,
        }
    }
    fn to_array(&self) -> [T; 20] {
        let Self {
            r#type,
            T,
            two,
            scene,
            Model: Model_,
            None: None_,
            v1,
            a_x,
            a: [a_x_,
            a_y,
            a_z,
            ],
            M: [[M_11,
            M_12,
            ],
            [M_21,
            M_22,
            ],
            ],
            unused: [unused_1,
            unused_2,
            unused_3,
            unused_4,
            ],
            almost_pi,
        } = *self;
        [
            r#type,
            T,
            two,
            scene,
            Model_,
            None_,
            v1,
            a_x,
            a_x_,
            a_y,
            a_z,
            M_11,
            M_12,
            M_21,
            M_22,
            unused_1,
            unused_2,
            unused_3,
            unused_4,
            almost_pi,
        ]
    }
}
/// The state.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T = f64> {
    /// `x`
    pub x: [T; 2],
    /// `r`
    pub r: T,
    /// `Next`
    pub Next: T,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for State<T> {
    type Array = [T; 4];
    fn from_array([x_x, x_y, r, Next_]: [T; 4]) -> Self {
        Self {
            x: [x_x, x_y],
            r,
            Next: Next_,
        }
    }
    fn to_array(&self) -> [T; 4] {
        let Self { x: [x_x, x_y], r, Next: Next_ } = *self;
        [x_x, x_y, r, Next_]
    }
}
/// The invariants and observables.
#[allow(non_snake_case, reason = "names as in the model")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs<T = f64> {
    scalar: ::core::marker::PhantomData<T>,
}
#[allow(non_snake_case, reason = "names as in the model")]
impl<T: ::core::marker::Copy> ::residua::Record<T> for Outputs<T> {
    type Array = [T; 0];
    fn from_array([]: [T; 0]) -> Self {
        Self {
            scalar: ::core::marker::PhantomData,
        }
    }
    fn to_array(&self) -> [T; 0] {
        []
    }
}
/// Names that Rust or the emitted code has other plans for.
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
            let [zero, third, one, two_, three, c3_14, four, five, six, seven, eight] = [
                0.0,
                0.3333333333333333,
                1.0,
                2.0,
                3.0,
                3.14,
                4.0,
                5.0,
                6.0,
                7.0,
                8.0,
            ]
                .map(T::constant);
            Self {
                r#type: one,
                T: two_,
                two: three,
                scene: four,
                Model: five,
                None: six,
                v1: seven,
                a_x: eight,
                a: [one, two_, three],
                M: [[four, one], [one, four]],
                unused: [zero, zero, zero, third],
                almost_pi: c3_14,
            }
        }
    }
    impl<T: ::residua::Scalar> ::residua::Model<T> for super::Model {
        type Parameters = super::Parameters<T>;
        type State = super::State<T>;
        type Outputs = super::Outputs<T>;
        const DESCRIPTION: &'static ::residua::Description = super::DESCRIPTION;
        fn start(_parameters: &super::Parameters<T>) -> super::State<T> {
            let [zero, one, two_] = [0.0, 1.0, 2.0].map(T::constant);
            let c1_over_7 = T::constant(1.0) / T::constant(7.0);
            super::State {
                x: [one, two_],
                r: zero,
                Next: c1_over_7,
            }
        }
        fn outputs(
            _parameters: &super::Parameters<T>,
            _h: T,
            _t: T,
            _state: &super::State<T>,
        ) -> super::Outputs<T> {
            super::Outputs {
                scalar: ::core::marker::PhantomData,
            }
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
        two_M_11: T,
        M_12: T,
        two_M_12: T,
        h: T,
        h_a_x_type: T,
        c1: T,
        M_21: T,
        two_M_21: T,
        two_M_22: T,
        two: T,
        scene_over_None: T,
        two_v1: T,
        Model_: T,
        c2: T,
        c3: T,
        two_h: T,
        four_h: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        x_x: T,
        two_x_x: T,
        s1: T,
        x_y: T,
        two_x_y: T,
        s2: T,
        r: T,
        two_r: T,
        Next_: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 17;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                two_M_11: from(0),
                M_12: from(1),
                two_M_12: from(2),
                h: from(3),
                h_a_x_type: from(4),
                c1: from(5),
                M_21: from(6),
                two_M_21: from(7),
                two_M_22: from(8),
                two: from(9),
                scene_over_None: from(10),
                two_v1: from(11),
                Model_: from(12),
                c2: from(13),
                c3: from(14),
                two_h: from(15),
                four_h: from(16),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.two_M_11);
            to(1, self.M_12);
            to(2, self.two_M_12);
            to(3, self.h);
            to(4, self.h_a_x_type);
            to(5, self.c1);
            to(6, self.M_21);
            to(7, self.two_M_21);
            to(8, self.two_M_22);
            to(9, self.two);
            to(10, self.scene_over_None);
            to(11, self.two_v1);
            to(12, self.Model_);
            to(13, self.c2);
            to(14, self.c3);
            to(15, self.two_h);
            to(16, self.four_h);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::Increment {
        type Model = super::Model;
        type Unknowns = [T; 4];
        type Jacobian = [[T; 4]; 4];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = super::IncrementCore;
        const HAS_CORE: bool = true;
        const SOLVER: usize = 0;
        fn zeros() -> ([T; 4], [[T; 4]; 4]) {
            let zero = T::constant(0.0);
            ([zero; 4], [[zero; 4]; 4])
        }
        /// Once per run: 4 additions, 21 multiplications, 1 division.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters {
                r#type,
                T,
                two,
                scene: scene_,
                Model: Model_,
                None: None_,
                v1,
                a_x,
                a: [a_x_,
                a_y,
                a_z,
                ],
                M: [[M_11,
                M_12,
                ],
                [M_21,
                M_22,
                ],
                ],
                ..
            } = *parameters;
            let [half, two_, four] = [0.5, 2.0, 4.0].map(T::constant);
            let h_a_x_type = h * a_x * r#type;
            let c4 = h * (a_x_ * a_x_) + h * (a_y * a_y) + h * (a_z * a_z);
            Scene {
                two_M_11: two_ * M_11,
                M_12,
                two_M_12: two_ * M_12,
                h,
                h_a_x_type,
                c1: two_ * c4 * T,
                M_21,
                two_M_21: two_ * M_21,
                two_M_22: two_ * M_22,
                two,
                scene_over_None: scene_ / None_,
                two_v1: two_ * v1,
                Model_,
                c2: half * (two_ * M_11 + h_a_x_type),
                c3: half * (two_ * M_22 + h_a_x_type),
                two_h: two_ * h,
                four_h: four * h,
            }
        }
        /// Once per step: 5 multiplications.
        #[inline(always)]
        fn step(scene: &Scene<T>, _t: T, state: &[T; 4]) -> Step<T> {
            let Scene { c1, .. } = *scene;
            let [x_x, x_y, r, Next_] = *state;
            let two_ = T::constant(2.0);
            Step {
                x_x,
                two_x_x: two_ * x_x,
                s1: c1 * x_x,
                x_y,
                two_x_y: two_ * x_y,
                s2: c1 * x_y,
                r,
                two_r: two_ * r,
                Next_,
            }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, _step: &Step<T>) -> [T; 4] {
            let zero = T::constant(0.0);
            [zero, zero, zero, zero]
        }
        /// r(x), 4 equations, lines 22 to 24: 15 additions, 17 multiplications, 1 division, 2 calls.
        ///
        /// - rows 0 to 1: `M*Δx + h*a_x*type*x[k+1/2] + h*a.T*a*T*x = 0`
        /// - row 2: `Δr + h*(two*sin(r[k+1/2]) + scene*cos(r[k+1/2])/None + 2*v1) = 0`
        /// - row 3: `ΔNext*Model = h*Next[k+1]^4/(1 + Next[k+1]^2)`
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 4],
            residual: &mut [T; 4],
        ) {
            let Scene {
                two_M_11,
                two_M_12,
                h,
                h_a_x_type,
                two_M_21,
                two_M_22,
                two,
                scene_over_None,
                two_v1,
                Model_,
                ..
            } = *scene;
            let Step { two_x_x, s1, two_x_y, s2, two_r, Next_, .. } = *step;
            let [Delta_x_x, Delta_x_y, Delta_r, Delta_Next] = *unknowns;
            let [half, one] = [0.5, 1.0].map(T::constant);
            let v2 = two_M_11 * Delta_x_x + two_M_12 * Delta_x_y
                + h_a_x_type * (Delta_x_x + two_x_x) + s1;
            residual[0] = half * v2;
            let v3 = two_M_21 * Delta_x_x + two_M_22 * Delta_x_y
                + h_a_x_type * (Delta_x_y + two_x_y) + s2;
            residual[1] = half * v3;
            let (sin_r_mid, cos_r_mid) = (half * (Delta_r + two_r)).sin_cos();
            residual[2] = Delta_r
                + h * (two * sin_r_mid + scene_over_None * cos_r_mid + two_v1);
            let Next_next = Delta_Next + Next_;
            let Next_next_squared = Next_next * Next_next;
            let v4 = h * (one / (Next_next_squared + one))
                * (Next_next_squared * Next_next_squared);
            residual[3] = Model_ * Delta_Next - v4;
        }
        /// r(x) and the 6 structural non-zeros of its Jacobian, lines 22 to 24: 19 additions, 28 multiplications, 1 division, 2 calls.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 4],
            residual: &mut [T; 4],
            jacobian: &mut [[T; 4]; 4],
        ) {
            let Scene {
                two_M_11,
                M_12,
                two_M_12,
                h,
                h_a_x_type,
                M_21,
                two_M_21,
                two_M_22,
                two,
                scene_over_None,
                two_v1,
                Model_,
                c2,
                c3,
                two_h,
                four_h,
                ..
            } = *scene;
            let Step { two_x_x, s1, two_x_y, s2, two_r, Next_, .. } = *step;
            let [Delta_x_x, Delta_x_y, Delta_r, Delta_Next] = *unknowns;
            let [half, one, two_] = [0.5, 1.0, 2.0].map(T::constant);
            let v2 = two_M_11 * Delta_x_x + two_M_12 * Delta_x_y
                + h_a_x_type * (Delta_x_x + two_x_x) + s1;
            residual[0] = half * v2;
            jacobian[0][0] = c2;
            jacobian[0][1] = M_12;
            let v3 = two_M_21 * Delta_x_x + two_M_22 * Delta_x_y
                + h_a_x_type * (Delta_x_y + two_x_y) + s2;
            residual[1] = half * v3;
            jacobian[1][0] = M_21;
            jacobian[1][1] = c3;
            let (sin_r_mid, cos_r_mid) = (half * (Delta_r + two_r)).sin_cos();
            residual[2] = Delta_r
                + h * (two * sin_r_mid + scene_over_None * cos_r_mid + two_v1);
            let v5 = h * (two * cos_r_mid - scene_over_None * sin_r_mid) + two_;
            jacobian[2][2] = half * v5;
            let Next_next = Delta_Next + Next_;
            let Next_next_squared = Next_next * Next_next;
            let v6 = one / (Next_next_squared + one);
            let Next_next_to_4 = Next_next_squared * Next_next_squared;
            residual[3] = Model_ * Delta_Next - h * v6 * Next_next_to_4;
            jacobian[3][3] = two_h * Next_next * Next_next_to_4 * (v6 * v6) + Model_
                - four_h * Next_next * Next_next_squared * v6;
        }
        /// The state after the step: 4 additions.
        #[inline(always)]
        fn next(_scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 4]) -> [T; 4] {
            let Step { x_x, x_y, r, Next_, .. } = *step;
            let [Delta_x_x, Delta_x_y, Delta_r, Delta_Next] = *unknowns;
            [Delta_x_x + x_x, Delta_x_y + x_y, Delta_r + r, Delta_Next + Next_]
        }
        const HAS_CHANGE: bool = true;
        /// What the step adds to the state: no operations.
        #[inline(always)]
        fn change(_scene: &Scene<T>, _step: &Step<T>, unknowns: &[T; 4]) -> [T; 4] {
            let [Delta_x_x, Delta_x_y, Delta_r, Delta_Next] = *unknowns;
            [Delta_x_x, Delta_x_y, Delta_r, Delta_Next]
        }
        fn rounding(
            parameters: &super::Parameters<T>,
            h: T,
            t: T,
            state: &[T; 4],
            unknowns: &[T; 4],
        ) -> ([T; 4], [T; 4])
        where
            T: ::residua::Real,
        {
            ::residua::rounding::<Self, T>(parameters, h, t, state, unknowns)
        }
    }
}
/// What [`Increment`] iterates on: 2 of its 4 unknowns. The others enter linearly and are eliminated.
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
        two: T,
        scene_over_None: T,
        two_v1: T,
        Model_: T,
        two_h: T,
        four_h: T,
        h_a_x_type: T,
        c1: T,
        c2: T,
        c3: T,
        c4: T,
        two_M_12: T,
        two_M_21: T,
        c5: T,
    }
    /// What a step needs of the known state and t.
    #[derive(Clone, Copy)]
    pub struct Step<T> {
        r: T,
        two_r: T,
        Next_: T,
        s1: T,
        s2: T,
        s3: T,
        s4: T,
    }
    impl<T: ::core::marker::Copy> ::residua::Cache<T> for Scene<T> {
        const LEN: usize = 15;
        #[inline(always)]
        fn gather(from: impl ::core::ops::Fn(usize) -> T) -> Self {
            Self {
                h: from(0),
                two: from(1),
                scene_over_None: from(2),
                two_v1: from(3),
                Model_: from(4),
                two_h: from(5),
                four_h: from(6),
                h_a_x_type: from(7),
                c1: from(8),
                c2: from(9),
                c3: from(10),
                c4: from(11),
                two_M_12: from(12),
                two_M_21: from(13),
                c5: from(14),
            }
        }
        fn spread(&self, mut to: impl ::core::ops::FnMut(usize, T)) {
            to(0, self.h);
            to(1, self.two);
            to(2, self.scene_over_None);
            to(3, self.two_v1);
            to(4, self.Model_);
            to(5, self.two_h);
            to(6, self.four_h);
            to(7, self.h_a_x_type);
            to(8, self.c1);
            to(9, self.c2);
            to(10, self.c3);
            to(11, self.c4);
            to(12, self.two_M_12);
            to(13, self.two_M_21);
            to(14, self.c5);
        }
    }
    impl<T: ::residua::Scalar> ::residua::System<T> for super::IncrementCore {
        type Model = super::Model;
        type Unknowns = [T; 2];
        type Jacobian = [[T; 2]; 2];
        type Scene = Scene<T>;
        type Step = Step<T>;
        type Core = Self;
        const UNKNOWNS: &'static [::residua::description::Unknown] = &[
            ::residua::description::Unknown {
                name: "Δr",
                len: 1,
                measure: ::core::option::Option::Some(2..3),
                told: true,
            },
            ::residua::description::Unknown {
                name: "ΔNext",
                len: 1,
                measure: ::core::option::Option::Some(3..4),
                told: true,
            },
        ];
        const SOLVER: usize = 0;
        fn zeros() -> ([T; 2], [[T; 2]; 2]) {
            let zero = T::constant(0.0);
            ([zero; 2], [[zero; 2]; 2])
        }
        /// Once per run: 6 additions, 24 multiplications, 3 divisions, 5 calls.
        fn scene(parameters: &super::Parameters<T>, h: T) -> Scene<T> {
            let super::Parameters {
                r#type,
                T,
                two,
                scene: scene_,
                Model: Model_,
                None: None_,
                v1,
                a_x,
                a: [a_x_,
                a_y,
                a_z,
                ],
                M: [[M_11,
                M_12,
                ],
                [M_21,
                M_22,
                ],
                ],
                ..
            } = *parameters;
            let [half, two_, four] = [0.5, 2.0, 4.0].map(T::constant);
            let h_a_x_type = h * a_x * r#type;
            let c1 = two_ * M_11 + h_a_x_type;
            let c2 = two_ * M_22 + h_a_x_type;
            let c6 = c1 * c2 - four * M_12 * M_21;
            let c7 = h * (a_x_ * a_x_) + h * (a_y * a_y) + h * (a_z * a_z);
            let c8 = (half * c1).abs() * (half * c2).abs() + M_12.abs() * M_21.abs();
            Scene {
                h,
                two,
                scene_over_None: scene_ / None_,
                two_v1: two_ * v1,
                Model_,
                two_h: two_ * h,
                four_h: four * h,
                h_a_x_type,
                c1,
                c2,
                c3: two_ / c6,
                c4: c7 * T,
                two_M_12: two_ * M_12,
                two_M_21: two_ * M_21,
                c5: c8 * (four / c6).abs(),
            }
        }
        /// Once per step: 6 additions, 11 multiplications.
        #[inline(always)]
        fn step(scene: &Scene<T>, _t: T, state: &[T; 4]) -> Step<T> {
            let Scene { h_a_x_type, c1, c2, c3, c4, two_M_12, two_M_21, .. } = *scene;
            let [x_x, x_y, r, Next_] = *state;
            let two_ = T::constant(2.0);
            let s5 = c4 * x_x + h_a_x_type * x_x;
            let s6 = c4 * x_y + h_a_x_type * x_y;
            let s1 = c3 * (c2 * s5 - two_M_12 * s6);
            let s3 = c3 * (two_M_21 * s5 - c1 * s6);
            Step {
                r,
                two_r: two_ * r,
                Next_,
                s1,
                s2: x_x - s1,
                s3,
                s4: x_y + s3,
            }
        }
        #[inline(always)]
        fn guess(_scene: &Scene<T>, _step: &Step<T>) -> [T; 2] {
            let zero = T::constant(0.0);
            [zero, zero]
        }
        /// r(x), 2 equations after elimination: 7 additions, 9 multiplications, 1 division, 2 calls.
        fn residual(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 2],
            residual: &mut [T; 2],
        ) {
            let Scene { h, two, scene_over_None, two_v1, Model_, .. } = *scene;
            let Step { two_r, Next_, .. } = *step;
            let [Delta_r, Delta_Next] = *unknowns;
            let [half, one] = [0.5, 1.0].map(T::constant);
            let (sin_r_mid, cos_r_mid) = (half * (Delta_r + two_r)).sin_cos();
            residual[0] = Delta_r
                + h * (two * sin_r_mid + scene_over_None * cos_r_mid + two_v1);
            let Next_next = Delta_Next + Next_;
            let Next_next_squared = Next_next * Next_next;
            let v2 = h * (one / (Next_next_squared + one))
                * (Next_next_squared * Next_next_squared);
            residual[1] = Model_ * Delta_Next - v2;
        }
        /// r(x) and the 2 structural non-zeros of its Jacobian after elimination: 11 additions, 20 multiplications, 1 division, 2 calls.
        fn residual_and_jacobian(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 2],
            residual: &mut [T; 2],
            jacobian: &mut [[T; 2]; 2],
        ) {
            let Scene { h, two, scene_over_None, two_v1, Model_, two_h, four_h, .. } = *scene;
            let Step { two_r, Next_, .. } = *step;
            let [Delta_r, Delta_Next] = *unknowns;
            let [half, one, two_] = [0.5, 1.0, 2.0].map(T::constant);
            let (sin_r_mid, cos_r_mid) = (half * (Delta_r + two_r)).sin_cos();
            residual[0] = Delta_r
                + h * (two * sin_r_mid + scene_over_None * cos_r_mid + two_v1);
            let v3 = h * (two * cos_r_mid - scene_over_None * sin_r_mid) + two_;
            jacobian[0][0] = half * v3;
            let Next_next = Delta_Next + Next_;
            let Next_next_squared = Next_next * Next_next;
            let v4 = one / (Next_next_squared + one);
            let Next_next_to_4 = Next_next_squared * Next_next_squared;
            residual[1] = Model_ * Delta_Next - h * v4 * Next_next_to_4;
            jacobian[1][1] = two_h * Next_next * Next_next_to_4 * (v4 * v4) + Model_
                - four_h * Next_next * Next_next_squared * v4;
        }
        const HAS_CORRECTION: bool = true;
        /// J(x)⁻¹ r(x) in closed form, and the growth of rounding in it: 11 additions, 21 multiplications, 3 divisions, 2 calls.
        #[inline(always)]
        fn correction(
            scene: &Scene<T>,
            step: &Step<T>,
            unknowns: &[T; 2],
        ) -> ([T; 2], T) {
            let Scene { h, two, scene_over_None, two_v1, Model_, two_h, four_h, .. } = *scene;
            let Step { two_r, Next_, .. } = *step;
            let [Delta_r, Delta_Next] = *unknowns;
            let [zero, half, one, two_] = [0.0, 0.5, 1.0, 2.0].map(T::constant);
            let (sin_r_mid, cos_r_mid) = (half * (Delta_r + two_r)).sin_cos();
            let v5 = Delta_r
                + h * (two * sin_r_mid + scene_over_None * cos_r_mid + two_v1);
            let v3 = h * (two * cos_r_mid - scene_over_None * sin_r_mid) + two_;
            let Next_next = Delta_Next + Next_;
            let Next_next_squared = Next_next * Next_next;
            let v4 = one / (Next_next_squared + one);
            let Next_next_to_4 = Next_next_squared * Next_next_squared;
            let v6 = two_h * Next_next * Next_next_to_4 * (v4 * v4) + Model_
                - four_h * Next_next * Next_next_squared * v4;
            (
                [
                    two_ * (v5 * (one / v3)),
                    (Model_ * Delta_Next - h * v4 * Next_next_to_4) / v6,
                ],
                zero,
            )
        }
        /// The state after the step: 2 additions.
        #[inline(always)]
        fn next(_scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 2]) -> [T; 4] {
            let Step { r, Next_, s2, s4, .. } = *step;
            let [Delta_r, Delta_Next] = *unknowns;
            [s2, s4, Delta_r + r, Delta_Next + Next_]
        }
        const HAS_CHANGE: bool = true;
        /// What the step adds to the state: no operations.
        #[inline(always)]
        fn change(_scene: &Scene<T>, step: &Step<T>, unknowns: &[T; 2]) -> [T; 4] {
            let Step { s1, s3, .. } = *step;
            let [Delta_r, Delta_Next] = *unknowns;
            [-s1, s3, Delta_r, Delta_Next]
        }
        fn rounding(
            parameters: &super::Parameters<T>,
            h: T,
            t: T,
            state: &[T; 4],
            unknowns: &[T; 2],
        ) -> ([T; 2], [T; 4])
        where
            T: ::residua::Real,
        {
            ::residua::rounding::<Self, T>(parameters, h, t, state, unknowns)
        }
        /// Σ|terms|/|Σ terms| over the divisors: no operations.
        #[inline(always)]
        fn growth(scene: &Scene<T>, _step: &Step<T>, _unknowns: &[T; 2]) -> T {
            let Scene { c5, .. } = *scene;
            c5
        }
    }
}
/// Names, shapes, units and texts.
pub const DESCRIPTION: &::residua::Description = &::residua::Description {
    name: "names",
    doc: "Names that Rust or the emitted code has other plans for.",
    parameters: &[
        ::residua::description::Variable {
            name: "type",
            ascii: "type",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "T",
            ascii: "T",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "two",
            ascii: "two",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "scene",
            ascii: "scene",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "Model",
            ascii: "Model",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "None",
            ascii: "None",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "v1",
            ascii: "v1",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "a_x",
            ascii: "a_x",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "a",
            ascii: "a",
            rows: 3,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "M",
            ascii: "M",
            rows: 2,
            cols: 2,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "unused",
            ascii: "unused",
            rows: 4,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "almost_pi",
            ascii: "almost_pi",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
    ],
    states: &[
        ::residua::description::Variable {
            name: "x",
            ascii: "x",
            rows: 2,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "r",
            ascii: "r",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
        ::residua::description::Variable {
            name: "Next",
            ascii: "Next",
            rows: 1,
            cols: 1,
            unit: "1",
            dimensionless: true,
            doc: "",
        },
    ],
    outputs: &[],
    solvers: &[
        ::residua::description::Solver {
            form: "increment",
            unknowns: &[
                ::residua::description::Unknown {
                    name: "Δx",
                    len: 2,
                    measure: ::core::option::Option::Some(0..2),
                    told: true,
                },
                ::residua::description::Unknown {
                    name: "Δr",
                    len: 1,
                    measure: ::core::option::Option::Some(2..3),
                    told: true,
                },
                ::residua::description::Unknown {
                    name: "ΔNext",
                    len: 1,
                    measure: ::core::option::Option::Some(3..4),
                    told: true,
                },
            ],
            equations: &[
                ::residua::description::Equation {
                    text: "M*Δx + h*a_x*type*x[k+1/2] + h*a.T*a*T*x = 0",
                    line: 22,
                    len: 2,
                },
                ::residua::description::Equation {
                    text: "Δr + h*(two*sin(r[k+1/2]) + scene*cos(r[k+1/2])/None + 2*v1) = 0",
                    line: 23,
                    len: 1,
                },
                ::residua::description::Equation {
                    text: "ΔNext*Model = h*Next[k+1]^4/(1 + Next[k+1]^2)",
                    line: 24,
                    len: 1,
                },
            ],
            pattern: &[(0, 0), (0, 1), (1, 0), (1, 1), (2, 2), (3, 3)],
            counts: &[
                (
                    "scene",
                    ::residua::description::Count {
                        additions: 4,
                        multiplications: 21,
                        divisions: 1,
                        calls: 0,
                    },
                ),
                (
                    "step",
                    ::residua::description::Count {
                        additions: 0,
                        multiplications: 5,
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
                        additions: 15,
                        multiplications: 17,
                        divisions: 1,
                        calls: 2,
                    },
                ),
                (
                    "residual_and_jacobian",
                    ::residua::description::Count {
                        additions: 19,
                        multiplications: 28,
                        divisions: 1,
                        calls: 2,
                    },
                ),
                (
                    "next",
                    ::residua::description::Count {
                        additions: 4,
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
                            name: "Δr",
                            len: 1,
                            measure: ::core::option::Option::Some(2..3),
                            told: true,
                        },
                        ::residua::description::Unknown {
                            name: "ΔNext",
                            len: 1,
                            measure: ::core::option::Option::Some(3..4),
                            told: true,
                        },
                    ],
                    eliminated: &[
                        ::residua::description::Unknown {
                            name: "Δx",
                            len: 2,
                            measure: ::core::option::Option::Some(0..2),
                            told: true,
                        },
                    ],
                    lines: &[22],
                    pattern: &[(0, 0), (1, 1)],
                    counts: &[
                        (
                            "scene",
                            ::residua::description::Count {
                                additions: 6,
                                multiplications: 24,
                                divisions: 3,
                                calls: 5,
                            },
                        ),
                        (
                            "step",
                            ::residua::description::Count {
                                additions: 6,
                                multiplications: 11,
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
                                additions: 7,
                                multiplications: 9,
                                divisions: 1,
                                calls: 2,
                            },
                        ),
                        (
                            "residual_and_jacobian",
                            ::residua::description::Count {
                                additions: 11,
                                multiplications: 20,
                                divisions: 1,
                                calls: 2,
                            },
                        ),
                        (
                            "next",
                            ::residua::description::Count {
                                additions: 2,
                                multiplications: 0,
                                divisions: 0,
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
                                additions: 0,
                                multiplications: 0,
                                divisions: 0,
                                calls: 0,
                            },
                        ),
                        (
                            "correction",
                            ::residua::description::Count {
                                additions: 11,
                                multiplications: 21,
                                divisions: 3,
                                calls: 2,
                            },
                        ),
                    ],
                },
            ),
        },
    ],
    claims: &[],
    requirements: &[],
    has_flow: false,
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
                calls: 0,
            },
        ),
    ],
    operations: 267,
    scene: ::core::option::Option::None,
};
/// The model behind one face, for programs that pick models at run time.
pub static MODEL: ::residua::Catalogued = ::residua::Catalogued {
    description: DESCRIPTION,
    model: &::residua::erased::ErasedModel::<Model>::NEW,
    solvers: &[&::residua::erased::ErasedSolver::<Increment>::NEW],
    flow: ::core::option::Option::None,
    series: ::core::option::Option::None,
};
