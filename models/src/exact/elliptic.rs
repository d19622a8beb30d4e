//! Jacobi's elliptic functions in double-double arithmetic, by Landen's descending transformation.
//!
//! With k₀ = k and kⱼ₊₁ = (1 − kⱼ′)/(1 + kⱼ′), so that the moduli go to 0 quadratically, and at an argument
//! vⱼ = (1 + kⱼ₊₁) vⱼ₊₁,
//!
//! sn vⱼ = (1 + kⱼ₊₁) sn vⱼ₊₁/(1 + kⱼ₊₁ sn² vⱼ₊₁), cn vⱼ = cn vⱼ₊₁ dn vⱼ₊₁/(1 + kⱼ₊₁ sn² vⱼ₊₁),
//!
//! until sn = sin, cn = cos. Written in the complementary modulus no difference cancels, however close k
//! comes to 0 or to 1.
//!
//! Source: Abramowitz and Stegun, *Handbook of Mathematical Functions*, 16.12 and 17.3.6; DLMF 22.7(i), 22.20.

use super::double::Double;
use residua::Scalar;

/// Moduli below no longer change 31 digits: sn and sin differ by k²/4.
const NEGLIGIBLE: f64 = 1e-17;

/// The elliptic functions of one modulus 0 ≤ k ≤ 1.
#[derive(Clone, Debug)]
pub struct Elliptic {
    /// Largest modulus first. Empty for k = 0.
    levels: Vec<Level>,
    /// ∏ (1 + kⱼ) = 2 K/π, how much longer the quarter period is than that of sin; None for k = 1.
    stretch: Option<Double>,
}

/// One step of the transformation.
#[derive(Clone, Copy, Debug)]
struct Level {
    /// kⱼ′²
    complement_squared: Double,
    /// kⱼ₊₁
    next: Double,
    /// kⱼ₊₁′²
    next_complement_squared: Double,
}

/// The elliptic functions at one argument.
#[derive(Clone, Copy, Debug)]
pub struct Jacobi {
    /// The amplitude am u, which grows by π with each half period 2 K.
    pub am: Double,
    /// sn u = sin am u
    pub sn: Double,
    /// cn u = cos am u
    pub cn: Double,
    /// dn u = √(1 − k² sn² u)
    pub dn: Double,
}

impl Elliptic {
    /// For the modulus k and k′ = √(1 − k²), both given because the smaller does not follow from the larger.
    pub fn new(modulus: Double, complement: Double) -> Self {
        let (mut k, mut complement) = (modulus, complement);
        let mut levels = Vec::new();
        if complement.to_f64() <= 0.0 {
            return Self {
                levels,
                stretch: None,
            };
        }
        let mut stretch = Double::ONE;
        while k.to_f64() > NEGLIGIBLE {
            let sum = Double::ONE + complement;
            let next = (k / sum).squared();
            let next_complement = complement.sqrt() * 2.0 / sum;
            levels.push(Level {
                complement_squared: complement.squared(),
                next,
                next_complement_squared: next_complement.squared(),
            });
            stretch = stretch * (Double::ONE + next);
            (k, complement) = (next, next_complement);
        }
        Self {
            levels,
            stretch: Some(stretch),
        }
    }

    /// The quarter period K = π/2 ∏ (1 + kⱼ); None where it is infinite, for k = 1.
    pub fn quarter_period(&self) -> Option<Double> {
        self.stretch.map(|stretch| stretch * Double::PI / 2.0)
    }

    /// am u, sn u, cn u and dn u.
    pub fn at(&self, u: Double) -> Jacobi {
        let Some(stretch) = self.stretch else {
            return hyperbolic(u);
        };
        let v = u / stretch;
        let half_turns = (v / Double::PI).to_f64().round();
        let (mut sn, mut cn) = (v - Double::PI * half_turns).sin_cos();
        let mut dn = Double::ONE;
        for level in self.levels.iter().rev() {
            let denominator = Double::ONE + level.next * sn.squared();
            sn = (Double::ONE + level.next) * sn / denominator;
            cn = cn * dn / denominator;
            dn = (cn.squared() + level.complement_squared * sn.squared()).sqrt();
        }
        let am = Double::PI * half_turns + sn.atan2(cn);
        if half_turns.rem_euclid(2.0) == 1.0 {
            (sn, cn) = (-sn, -cn);
        }
        Jacobi { am, sn, cn, dn }
    }

    /// The argument u in [−2 K, 2 K] at which sn u and cn u are as given: the transformation backwards.
    ///
    /// From 1 + kⱼ₊₁ sn² vⱼ₊₁ = 2/(1 + dn vⱼ), and x = cn² vⱼ₊₁ from its product with dn² = x + k′² (1 − x).
    pub fn argument(&self, sn: Double, cn: Double) -> Double {
        let Some(stretch) = self.stretch else {
            let u = ((Double::ONE + sn.abs()) / cn).ln();
            return if sn.to_f64() < 0.0 { -u } else { u };
        };
        let (mut s, mut c) = (sn, cn.abs());
        for level in &self.levels {
            let dn = (c.squared() + level.complement_squared * s.squared()).sqrt();
            let half_denominator = Double::ONE / (Double::ONE + dn);
            let product = (c * half_denominator * 2.0).squared();
            let linear = level.next_complement_squared;
            let root = (linear.squared() + level.next.squared() * product * 4.0).sqrt();
            s = s * half_denominator * 2.0 / (Double::ONE + level.next);
            c = (product * 2.0 / (linear + root)).sqrt();
        }
        let angle = s.atan2(if cn.to_f64() < 0.0 { -c } else { c });
        angle * stretch
    }
}

/// k = 1: sn = tanh, cn = dn = sech, am the Gudermannian (Abramowitz and Stegun 16.6).
fn hyperbolic(u: Double) -> Jacobi {
    let e = (-u.abs()).exp();
    let sum = Double::ONE + e.squared();
    let sn = u.tanh();
    let cn = e * 2.0 / sum;
    Jacobi {
        am: sn.atan2(cn),
        sn,
        cn,
        dn: cn,
    }
}
