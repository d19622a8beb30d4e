//! The planar pendulum J θ̈ = −m g l sin θ, in closed form for every start.
//!
//! With Ω² = m g l/J, w = |ω₀|/(2 Ω) and k² = sin²(θ₀/2) + w², k′² = 1 − k² = cos²(θ₀/2) − w²:
//!
//! - k < 1, it swings: sin(θ/2) = k sn u, cos(θ/2) = dn u, ω = 2 Ω k cn u with u = Ω t + u₀ and modulus k;
//! - k > 1, it rotates: θ/2 = ± am u, ω = ± 2 Ω k dn u with u = Ω k t + u₀ and modulus 1/k;
//! - k = 1, the separatrix, is the second with sn = tanh, dn = sech: it takes forever to reach the top.
//!
//! Source: Whittaker, *Analytical Dynamics*, § 44; Abramowitz and Stegun, 16.4 and 17.6; DLMF 22.19(i).

use super::Double;
use super::Elliptic;
use super::Invalid;
use super::error::finite;
use super::error::positive;

/// |cos(θ₀/2) − w| up to which a start counts as on the separatrix: what double-double data of 31 digits leave open.
const ON_THE_SEPARATRIX: f64 = 1e-29;

/// The exact motion of one planar pendulum. The numbers given are taken as they are, every bit of them.
#[derive(Clone, Debug)]
pub struct PlanarPendulum {
    regime: Regime,
    theta0: Double,
    energy: Double,
    /// 2 π times the turns in θ₀, which leaves |θ₀| ≤ π.
    turns: Double,
    /// +1 or −1: the sense of a rotation.
    sense: f64,
    /// k, also where it exceeds 1.
    modulus: Double,
    /// √|1 − k²|
    complement: Double,
    /// du/dt, 1/s
    rate: Double,
    /// ω at sn u = 0, rad/s
    peak: Double,
    /// u at t = 0
    start: Double,
    elliptic: Elliptic,
}

/// Where the pendulum is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarState {
    /// Angle from the lowest point, with full turns counted, rad.
    pub theta: f64,
    /// Angular velocity, rad/s.
    pub omega: f64,
}

/// What the pendulum does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime {
    /// It hangs at rest.
    Hanging,
    /// It swings between two turning points.
    Swinging,
    /// It creeps up to the top, and came from there.
    Separatrix,
    /// It stands at rest on the top.
    Upright,
    /// It turns over and over.
    Rotating,
}

impl PlanarPendulum {
    /// Of mass `m` (kg), inertia `j` about the pivot (kg m²), centre of mass at `l` (m) in gravity `g` (m/s²),
    /// started at `theta0` (rad) with `omega0` (rad/s).
    pub fn new(m: f64, j: f64, l: f64, g: f64, theta0: f64, omega0: f64) -> Result<Self, Invalid> {
        Self::from_doubles([m, j, l, g, theta0, omega0].map(Double::from))
    }

    /// The same with each number a decimal, so that 9.81 is 981/100, which no `f64` is.
    pub fn from_decimals(
        m: &str,
        j: &str,
        l: &str,
        g: &str,
        theta0: &str,
        omega0: &str,
    ) -> Result<Self, Invalid> {
        let read = |name, text: &str| text.parse().map_err(|_| Invalid::NotDecimal { name });
        Self::from_doubles([
            read("m", m)?,
            read("j", j)?,
            read("l", l)?,
            read("g", g)?,
            read("theta0", theta0)?,
            read("omega0", omega0)?,
        ])
    }

    fn from_doubles([m, j, l, g, theta0, omega0]: [Double; 6]) -> Result<Self, Invalid> {
        for (name, value) in [("m", m), ("j", j), ("l", l), ("g", g)] {
            positive(name, value.to_f64())?;
        }
        finite("theta0", theta0.to_f64())?;
        finite("omega0", omega0.to_f64())?;

        let weight = m * g * l;
        let frequency = (weight / j).sqrt();
        positive("m g l/j", frequency.to_f64())?;
        let whole_turns = |n: f64| Double::PI * 2.0 * n;
        let mut turns = whole_turns((theta0 / whole_turns(1.0)).to_f64().round());
        if (theta0 - turns).abs() > Double::PI {
            // Half a turn, rounded up: counted down, θ₀ near π stays as it is.
            turns = whole_turns((theta0 / whole_turns(1.0)).to_f64().trunc());
        }
        let (sin, cos) = ((theta0 - turns) / 2.0).sin_cos();
        let sense = if omega0.to_f64() < 0.0 { -1.0 } else { 1.0 };
        let w = omega0 / (frequency * 2.0);
        let modulus = (sin.squared() + w.squared()).sqrt();
        finite("omega0/sqrt(m g l/j)", modulus.to_f64())?;

        let excess = cos - w.abs();
        let complement = (excess.abs() * (cos + w.abs())).sqrt();
        let regime = if modulus == Double::ZERO {
            Regime::Hanging
        } else if excess.abs().to_f64() > ON_THE_SEPARATRIX {
            if excess.to_f64() > 0.0 {
                Regime::Swinging
            } else {
                Regime::Rotating
            }
        } else if w.abs().to_f64() > ON_THE_SEPARATRIX {
            Regime::Separatrix
        } else {
            Regime::Upright
        };

        let (elliptic, rate, start) = match regime {
            Regime::Swinging => {
                let elliptic = Elliptic::new(modulus, complement);
                let start = elliptic.argument(sin / modulus, w / modulus);
                (elliptic, frequency, start)
            }
            Regime::Rotating => {
                let elliptic = Elliptic::new(Double::ONE / modulus, complement / modulus);
                let start = elliptic.argument(sin * sense, cos);
                (elliptic, frequency * modulus, start)
            }
            Regime::Separatrix => {
                let elliptic = Elliptic::new(Double::ONE, Double::ZERO);
                let start = elliptic.argument(sin * sense, cos);
                (elliptic, frequency, start)
            }
            Regime::Hanging | Regime::Upright => (
                Elliptic::new(Double::ZERO, Double::ONE),
                frequency,
                Double::ZERO,
            ),
        };
        Ok(Self {
            regime,
            theta0,
            energy: j * omega0.squared() / 2.0 - weight * (cos.squared() - sin.squared()),
            turns,
            sense,
            modulus,
            complement,
            rate,
            peak: frequency * modulus * 2.0,
            start,
            elliptic,
        })
    }

    /// The state at time `t` (s), before the start too: exact to the last rounding.
    ///
    /// All digits but the last are lost only where the motion itself multiplies 2⁻¹⁰⁰ to 2⁻⁵³, such as after
    /// 10¹⁴ periods.
    pub fn at(&self, t: f64) -> PlanarState {
        let (theta, omega) = match self.regime {
            Regime::Hanging | Regime::Upright => (self.theta0, Double::ZERO),
            Regime::Swinging => {
                let jacobi = self.elliptic.at(self.rate * t + self.start);
                let half = (self.modulus * jacobi.sn).atan2(jacobi.dn);
                (self.turns + half * 2.0, self.peak * jacobi.cn)
            }
            Regime::Separatrix | Regime::Rotating => {
                let jacobi = self.elliptic.at(self.rate * t + self.start);
                let turned = jacobi.am * 2.0 * self.sense;
                (self.turns + turned, self.peak * jacobi.dn * self.sense)
            }
        };
        PlanarState {
            theta: theta.to_f64(),
            omega: omega.to_f64(),
        }
    }

    /// What it does.
    pub fn regime(&self) -> Regime {
        self.regime
    }

    /// The time of a full swing, 4 K(k)/Ω, or of a full turn, 2 K(1/k)/(Ω k), s.
    pub fn period(&self) -> Option<f64> {
        let quarters = match self.regime {
            Regime::Swinging => 4.0,
            Regime::Rotating => 2.0,
            Regime::Hanging | Regime::Separatrix | Regime::Upright => return None,
        };
        let quarter = self.elliptic.quarter_period()?;
        Some((quarter * quarters / self.rate).to_f64())
    }

    /// The largest angle of a swing, 2 asin k, rad.
    pub fn amplitude(&self) -> Option<f64> {
        let swings = self.regime == Regime::Swinging;
        swings.then(|| (self.modulus.atan2(self.complement) * 2.0).to_f64())
    }

    /// J ω²/2 − m g l cos θ, J
    pub fn energy(&self) -> f64 {
        self.energy.to_f64()
    }
}
