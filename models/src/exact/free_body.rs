//! The free rigid body J ω̇ + ω × J ω = 0 in its principal axes, J₁ < J₂ < J₃ (Euler), in closed form.
//!
//! With the energy E = ω·J ω/2 and the momentum L = |J ω|, where L² ≥ 2 E J₂ (turning about the third axis),
//!
//! ω = (± A₁ cn u, A₂ sn u, ± A₃ dn u), u = ν t + u₀,
//!
//! A₁² = (2 E J₃ − L²)/(J₁ (J₃ − J₁)), A₂² = (2 E J₃ − L²)/(J₂ (J₃ − J₂)), A₃² = (L² − 2 E J₁)/(J₃ (J₃ − J₁)),
//! ν² = (J₃ − J₂)(L² − 2 E J₁)/(J₁ J₂ J₃), k′² = (J₃ − J₁)(L² − 2 E J₂)/((J₃ − J₂)(L² − 2 E J₁)).
//!
//! Otherwise the first and the third axis change places, and all differences of moments their signs. Axes that come
//! in another order are sorted: an exchange of two turns the sign of every ω̇ᵢ, and so does ω → −ω, so that both
//! together leave the equations as they are.
//!
//! Source: Landau and Lifshitz, *Mechanics*, § 37.

use super::Double;
use super::Elliptic;
use super::Invalid;
use super::error::finite;
use super::error::positive;

/// The exact angular velocity of one free body.
#[derive(Clone, Debug)]
pub struct FreeBody {
    /// Which component of the body is first, second, third below.
    axes: [usize; 3],
    /// Signed so that ω = (a₁ cn, a₂ sn, a₃ dn), the exchange of axes undone.
    amplitudes: [Double; 3],
    motion: Motion,
}

#[derive(Clone, Debug)]
enum Motion {
    /// About a principal axis, or with equal moments: ω stays as it was.
    Steady,
    /// u = rate · t + start.
    Elliptic {
        elliptic: Elliptic,
        rate: Double,
        start: Double,
    },
}

impl FreeBody {
    /// Of principal moments `j` (kg m²), in any order, with angular velocity `omega0` (rad/s) at t = 0.
    pub fn new<T: Into<Double>>(j: [T; 3], omega0: [T; 3]) -> Result<Self, Invalid> {
        let (j, omega0) = (j.map(Into::into), omega0.map(Into::into));
        for (j, omega) in j.iter().zip(&omega0) {
            positive("a principal moment", j.to_f64())?;
            finite("omega0", omega.to_f64())?;
        }
        let mut axes = [0, 1, 2];
        axes.sort_by(|&a, &b| j[a].to_f64().total_cmp(&j[b].to_f64()));
        let squares = |axes: [usize; 3]| axes.map(|i| omega0[i].squared());
        // L² − 2 E J₂, free of cancellation but where it is 0.
        let middle = |axes: [usize; 3]| {
            let ([w1, _, w3], [j1, j2, j3]) = (squares(axes), axes.map(|i| j[i]));
            j3 * (j3 - j2) * w3 - j1 * (j2 - j1) * w1
        };
        let sign = if is_even(axes) { 1.0 } else { -1.0 };
        if middle(axes).to_f64() < 0.0 {
            axes.swap(0, 2);
        }
        let [w1, w2, w3] = axes.map(|i| omega0[i] * sign);
        let [j1, j2, j3] = axes.map(|i| j[i]);
        let s = squares(axes);

        // 2 E J₃ − L² and L² − 2 E J₁, both negative after the exchange.
        let low = j1 * (j3 - j1) * s[0] + j2 * (j3 - j2) * s[1];
        let high = j2 * (j2 - j1) * s[1] + j3 * (j3 - j1) * s[2];
        let still = [w1, w2, w3].iter().filter(|w| w.to_f64() == 0.0).count() >= 2;
        if still || low.to_f64() == 0.0 || high.to_f64() == 0.0 || j3 == j2 {
            return Ok(Self {
                axes: [0, 1, 2],
                amplitudes: omega0,
                motion: Motion::Steady,
            });
        }
        let a1 = (low / (j1 * (j3 - j1))).sqrt();
        let a2 = (low / (j2 * (j3 - j2))).sqrt();
        let a3 = (high / (j3 * (j3 - j1))).sqrt();
        let sense = if w3.to_f64() < 0.0 { -1.0 } else { 1.0 };
        let divisor = (j3 - j2) * high;
        let modulus = ((j2 - j1) * low / divisor).sqrt();
        let complement = ((j3 - j1) * middle(axes) / divisor).abs().sqrt();
        let elliptic = Elliptic::new(modulus, complement);
        let start = elliptic.argument(w2 / a2, w1 * sense / a1);
        Ok(Self {
            axes,
            amplitudes: [a1 * sense * sign, a2 * sign, a3 * sense * sign],
            motion: Motion::Elliptic {
                elliptic,
                rate: (divisor / (j1 * j2 * j3)).sqrt(),
                start,
            },
        })
    }

    /// ω in the body frame at time `t` (s), rad/s: exact to the last rounding.
    pub fn at(&self, t: f64) -> [f64; 3] {
        let factors = match &self.motion {
            Motion::Steady => [Double::ONE; 3],
            Motion::Elliptic {
                elliptic,
                rate,
                start,
            } => {
                let jacobi = elliptic.at(*rate * t + *start);
                [jacobi.cn, jacobi.sn, jacobi.dn]
            }
        };
        let mut omega = [0.0; 3];
        for i in 0..3 {
            omega[self.axes[i]] = (self.amplitudes[i] * factors[i]).to_f64();
        }
        omega
    }

    /// The time after which ω is the same again, 4 K/ν, s.
    pub fn period(&self) -> Option<f64> {
        let Motion::Elliptic { elliptic, rate, .. } = &self.motion else {
            return None;
        };
        Some((elliptic.quarter_period()? * 4.0 / *rate).to_f64())
    }
}

/// Whether (0, 1, 2) becomes `axes` by turning alone.
fn is_even(axes: [usize; 3]) -> bool {
    (axes[0] + 1) % 3 == axes[1]
}
