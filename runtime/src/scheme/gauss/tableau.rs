//! The coefficients of Gauss–Legendre collocation, computed at build time in double-double arithmetic.
//!
//! With the shifted Legendre polynomials Pₖ, orthogonal on [0, 1] with ∫Pₖ² = 1/(2k + 1):
//!
//! - the nodes c are the zeros of P_s,
//! - the Lagrange polynomials of the nodes are ℓⱼ(θ) = bⱼ Σₖ (2k + 1) Pₖ(cⱼ) Pₖ(θ), k < s,
//! - so a(θ)ⱼ = ∫₀^θ ℓⱼ = bⱼ/2 Σₖ Pₖ(cⱼ) (Pₖ₊₁(θ) − Pₖ₋₁(θ)) with P₋₁ = −1.
//!
//! Source: Hairer and Wanner, *Solving Ordinary Differential Equations II*, IV.5; the symplectic form μᵢⱼ = aᵢⱼ/bⱼ with
//! μᵢⱼ + μⱼᵢ = 1 in floating point, too: Antoñana, Makazaga and Murua, *Reducing and monitoring round-off error
//! propagation for symplectic implicit Runge–Kutta schemes*, Numer. Algorithms 76 (2017).

use crate::scheme::extended::Extended;

/// The coefficients of `S` stages.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tableau<const S: usize> {
    /// Nodes, ascending.
    pub(crate) c: [Extended; S],
    /// Weights.
    pub(crate) b: [Extended; S],
    /// μᵢⱼ = aᵢⱼ/bⱼ
    pub(crate) mu: [[Extended; S]; S],
    /// (2k + 1) bⱼ Pₖ(cⱼ), from rates at the nodes to the coefficients of their polynomial: row k, column j.
    pub(crate) legendre: [[Extended; S]; S],
}

/// Newton's corrections of a node. From outside all zeros each of them comes closer; twelve digits more or fewer in
/// the start do not matter, and forty suffice for any s ≤ 16.
const CORRECTIONS: usize = 60;

impl<const S: usize> Tableau<S> {
    /// The coefficients, computed.
    pub(crate) const NEW: Self = Self::new();

    const fn new() -> Self {
        assert!(S >= 1 && S <= 16, "1 to 16 stages");
        let c = nodes::<S>();
        let mut b = [Extended::ZERO; S];
        let mut legendre = [[Extended::ZERO; S]; S];
        let mut mu = [[Extended::ZERO; S]; S];
        let mut j = 0;
        while j < S {
            // 1/b = Σ (2k + 1) Pₖ(c)², as ∫ℓⱼ² = bⱼ.
            let mut k = 0;
            let mut sum = Extended::ZERO;
            while k < S {
                let (p, _) = polynomial(k, c[j]);
                sum = sum.add(p.mul(p).mul(Extended::new((2 * k + 1) as f64)));
                k += 1;
            }
            b[j] = Extended::ONE.div(sum);
            k = 0;
            while k < S {
                let (p, _) = polynomial(k, c[j]);
                legendre[k][j] = p.mul(b[j]).mul(Extended::new((2 * k + 1) as f64));
                k += 1;
            }
            j += 1;
        }
        let mut i = 0;
        while i < S {
            j = 0;
            while j < S {
                let mut sum = Extended::ZERO;
                let mut k = 0;
                while k < S {
                    let (above, _) = polynomial(k + 1, c[i]);
                    let below = if k == 0 {
                        Extended::new(-1.0)
                    } else {
                        polynomial(k - 1, c[i]).0
                    };
                    let (p, _) = polynomial(k, c[j]);
                    sum = sum.add(above.sub(below).mul(p));
                    k += 1;
                }
                mu[i][j] = sum.mul(Extended::new(0.5));
                j += 1;
            }
            i += 1;
        }
        Self { c, b, mu, legendre }
    }
}

/// The zeros of P_S: Newton's method from 1 with the zeros found so far divided out (Maehly 1954).
const fn nodes<const S: usize>() -> [Extended; S] {
    let mut c = [Extended::ZERO; S];
    let mut found = 0;
    while found < S {
        let mut x = Extended::ONE;
        let mut n = 0;
        while n < CORRECTIONS {
            let (p, slope) = polynomial(S, x);
            let mut others = Extended::ZERO;
            let mut i = 0;
            // While far away, only; the last corrections are Newton's own.
            while i < found && n + 6 < CORRECTIONS {
                others = others.add(Extended::ONE.div(x.sub(c[S - 1 - i])));
                i += 1;
            }
            x = x.sub(p.div(slope.sub(p.mul(others))));
            n += 1;
        }
        c[S - 1 - found] = x;
        found += 1;
    }
    c
}

/// Pₙ(x) and its derivative, by (k + 1) Pₖ₊₁ = (2k + 1) y Pₖ − k Pₖ₋₁ in y = 2x − 1.
const fn polynomial(n: usize, x: Extended) -> (Extended, Extended) {
    let y = x.add(x).sub(Extended::ONE);
    let (mut below, mut p) = (Extended::ZERO, Extended::ONE);
    let (mut slope_below, mut slope) = (Extended::ZERO, Extended::ZERO);
    let mut k = 0;
    while k < n {
        let (a, b) = (Extended::new((2 * k + 1) as f64), Extended::new(k as f64));
        let d = Extended::new((k + 1) as f64);
        let next = y.mul(p).mul(a).sub(below.mul(b)).div(d);
        let inner = y.mul(slope).add(p.add(p));
        let slope_next = inner.mul(a).sub(slope_below.mul(b)).div(d);
        (below, p) = (p, next);
        (slope_below, slope) = (slope, slope_next);
        k += 1;
    }
    (p, slope)
}

#[cfg(test)]
mod tests;
