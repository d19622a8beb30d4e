//! The 3D pendulum J ω̇ + ω × J ω = m g ρ × Rᵀe₃, Ṙ = R S(ω), which has no closed form: a converged reference.
//!
//! The equations are not written a second time. The generated `flow` of `spatial_group` is generic over its number,
//! so it is run in double-double arithmetic, and extrapolated. What two resolutions differ by is reported.

use residua::Flow;
use residua::Record;

use super::Double;
use super::Invalid;
use super::error::finite;
use super::error::positive;
use super::extrapolation;
use crate::dsl::spatial_group::Model;
use crate::dsl::spatial_group::Parameters;
use crate::dsl::spatial_group::State;

/// Angle turned in the longest step, rad. Shorter steps cost more, and so do longer ones, which need more columns.
const LONGEST_TURN: f64 = 1.5;

/// Difference between two resolutions that is as good as none after the final rounding.
const CONVERGED: f64 = 1e-18;

/// How often the steps are made shorter, by a half each time, until [`CONVERGED`] or else the best is taken.
const ATTEMPTS: usize = 3;

/// Difference that is not accepted as a reference, relative to the largest component.
const USELESS: f64 = 1e-6;

/// A rigid body held at a point. `T` is `f64`, or [`Double`] for data that no `f64` is, such as 9.81.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialPendulum<T = f64> {
    /// Mass, kg.
    pub m: T,
    /// Gravity along +e₃, m/s².
    pub g: T,
    /// Inertia about the pivot in the body frame, symmetric, kg m².
    pub j: [[T; 3]; 3],
    /// Centre of mass from the pivot in the body frame, m.
    pub rho: [T; 3],
}

/// Where the body is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialState {
    /// Angular velocity in the body frame, rad/s.
    pub omega: [f64; 3],
    /// Attitude, body to space, by rows.
    pub attitude: [[f64; 3]; 3],
}

/// A motion at chosen times.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// One per time.
    pub states: Vec<SpatialState>,
    /// The largest difference between these states and those of two thirds as many steps, before rounding to `f64`,
    /// rad/s or 1. The states themselves are closer to the truth by orders of magnitude, for the data as given.
    pub error: f64,
}

/// R = Rx(θx) Ry(θy) Rz(θz) of Cardan angles, in double-double arithmetic.
pub fn rotation(angles: [Double; 3]) -> [[Double; 3]; 3] {
    let [(sx, cx), (sy, cy), (sz, cz)] = angles.map(Double::sin_cos);
    [
        [cy * cz, -(cy * sz), sy],
        [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -(sx * cy)],
        [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy],
    ]
}

impl<T: Into<Double> + Copy> SpatialPendulum<T> {
    /// The motion from angular velocity `omega0` (rad/s, body frame) and `attitude0` (body to space, by rows) at
    /// t = 0, at the ascending `times` (s). The attitude is taken as it is: its rows stay as orthonormal as they are.
    pub fn solve<A: Into<Double> + Copy>(
        &self,
        omega0: [A; 3],
        attitude0: [[A; 3]; 3],
        times: &[f64],
    ) -> Result<Solution, Invalid> {
        let parameters = self.parameters()?;
        let mut start = [Double::ZERO; 12];
        for (to, from) in start
            .iter_mut()
            .zip(omega0.iter().chain(attitude0.as_flattened()))
        {
            *to = (*from).into();
            finite("omega0 or attitude0", to.to_f64())?;
        }
        check_times(times)?;

        let scene = Model::flow_scene(&parameters);
        let flow = |t: Double, y: &[Double; 12]| Model::flow(&scene, t, y);
        let mut longest = LONGEST_TURN / self.fastest(&start);
        let (mut states, mut error) = extrapolation::run(flow, start, times, longest);
        for _ in 1..ATTEMPTS {
            if error <= CONVERGED {
                break;
            }
            longest /= 2.0;
            (states, error) = extrapolation::run(flow, start, times, longest);
        }
        if error.is_nan() || error > USELESS {
            return Err(Invalid::NotConverged { error });
        }
        Ok(Solution {
            states: states.iter().map(state).collect(),
            error,
        })
    }

    /// ω·J ω/2 − m g ρ·Γ₃ with Γ₃ = Rᵀe₃, J: constant.
    pub fn energy(&self, state: &SpatialState) -> f64 {
        let omega = state.omega.map(Double::from);
        let weight = self.m.into() * self.g.into();
        let height = dot(
            self.rho.map(Into::into),
            state.attitude[2].map(Double::from),
        );
        (dot(omega, self.momentum(state)) * 0.5 - weight * height).to_f64()
    }

    /// Γ₃·J ω, kg m²/s: constant.
    pub fn vertical_momentum(&self, state: &SpatialState) -> f64 {
        dot(state.attitude[2].map(Double::from), self.momentum(state)).to_f64()
    }

    /// |J ω|², kg² m⁴/s²: constant where g = 0 or ρ = 0.
    pub fn momentum_squared(&self, state: &SpatialState) -> f64 {
        let momentum = self.momentum(state);
        dot(momentum, momentum).to_f64()
    }

    /// (J ω)₃, kg m²/s: constant for a top, symmetric about e₃ with ρ on that axis (Lagrange).
    pub fn spin_momentum(&self, state: &SpatialState) -> f64 {
        self.momentum(state)[2].to_f64()
    }

    fn momentum(&self, state: &SpatialState) -> [Double; 3] {
        let omega = state.omega.map(Double::from);
        self.j.map(|row| dot(row.map(Into::into), omega))
    }

    fn parameters(&self) -> Result<Parameters<Double>, Invalid> {
        positive("m", self.m.into().to_f64())?;
        finite("g", self.g.into().to_f64())?;
        let mut array = [Double::ZERO; 14];
        let numbers = [self.m].into_iter().chain(self.j.into_iter().flatten());
        for (to, from) in array
            .iter_mut()
            .zip(numbers.chain(self.rho).chain([self.g]))
        {
            *to = from.into();
            finite("j or rho", to.to_f64())?;
        }
        let j = self.j.map(|row| row.map(Into::into));
        if j[0][1] != j[1][0] || j[0][2] != j[2][0] || j[1][2] != j[2][1] {
            return Err(Invalid::NotSymmetric);
        }
        // Leading minors: the inertia is positive definite (Sylvester).
        let minor = j[0][0] * j[1][1] - j[0][1] * j[1][0];
        positive("j(1, 1)", j[0][0].to_f64())?;
        positive("the second minor of j", minor.to_f64())?;
        positive("the determinant of j", determinant(&j).to_f64())?;
        Ok(Parameters::from_array(array))
    }
}

impl<T: Into<Double> + Copy> SpatialPendulum<T> {
    /// Upper bound of |ω| plus the frequency of small swings, 1/s: all kinetic energy on the axis of least inertia,
    /// itself bounded by 1/tr J⁻¹.
    fn fastest(&self, start: &[Double; 12]) -> f64 {
        let j = self.j.map(|row| row.map(|j| j.into().to_f64()));
        let omega = [start[0], start[1], start[2]].map(Double::to_f64);
        let minors = j[0][0] * j[1][1] - j[0][1].powi(2) + j[0][0] * j[2][2] - j[0][2].powi(2)
            + j[1][1] * j[2][2]
            - j[1][2].powi(2);
        let j = self.j.map(|row| row.map(Into::into));
        let least = determinant(&j).to_f64() / minors;
        let rho = self.rho.map(|rho| rho.into().to_f64());
        let length = rho.iter().map(|rho| rho * rho).sum::<f64>().sqrt();
        let potential = (self.m.into() * self.g.into()).to_f64().abs() * length;
        let kinetic = 0.5
            * (0..3)
                .map(|i| omega[i] * dot(j[i], omega.map(Double::from)).to_f64())
                .sum::<f64>();
        (2.0 * (kinetic + 2.0 * potential) / least).sqrt() + (potential / least).sqrt()
    }
}

fn check_times(times: &[f64]) -> Result<(), Invalid> {
    let mut last = 0.0;
    for &value in times {
        finite("a time", value)?;
        if value < last {
            return Err(Invalid::TimesNotAscending { value });
        }
        last = value;
    }
    Ok(())
}

fn dot(a: [Double; 3], b: [Double; 3]) -> Double {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn determinant(a: &[[Double; 3]; 3]) -> Double {
    a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1])
        - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
        + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0])
}

fn state(y: &[Double; 12]) -> SpatialState {
    let y = State::from_array(*y);
    SpatialState {
        omega: y.omega.map(Double::to_f64),
        attitude: [y.Gamma1, y.Gamma2, y.Gamma3].map(|row| row.map(Double::to_f64)),
    }
}
