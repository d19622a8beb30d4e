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

/// The most stages.
const MOST: usize = 16;

/// Newton's corrections of a node in double precision. From outside all zeros that are left each of them comes closer by a
/// factor of 1 − 1/s at least; more cost build time only.
const ROUGH_CORRECTIONS: usize = 60;

/// Those in double-double numbers, where each doubles the digits: 15 become 30, and once more for what the first has lost.
const CORRECTIONS: usize = 2;

impl<const S: usize> Tableau<S> {
    /// The coefficients, computed.
    pub(crate) const NEW: Self = Self::new();

    const fn new() -> Self {
        assert!(S >= 1 && S <= MOST, "1 to 16 stages");
        let c = nodes::<S>();
        let mut p = [[Extended::ZERO; MOST + 1]; S];
        let mut b = [Extended::ZERO; S];
        let mut legendre = [[Extended::ZERO; S]; S];
        let mut mu = [[Extended::ZERO; S]; S];
        let mut j = 0;
        while j < S {
            p[j] = polynomials(S, c[j]).0;
            // 1/b = Σ (2k + 1) Pₖ(c)², as ∫ℓⱼ² = bⱼ.
            let mut k = 0;
            let mut sum = Extended::ZERO;
            while k < S {
                let square = p[j][k].mul(p[j][k]);
                sum = sum.add(square.mul(Extended::new((2 * k + 1) as f64)));
                k += 1;
            }
            b[j] = Extended::ONE.div(sum);
            k = 0;
            while k < S {
                let weighted = p[j][k].mul(b[j]);
                legendre[k][j] = weighted.mul(Extended::new((2 * k + 1) as f64));
                k += 1;
            }
            j += 1;
        }
        let mut i = 0;
        while i < S {
            j = 0;
            while j < S {
                // P₁ − P₋₁, and Pₖ₊₁ − Pₖ₋₁.
                let mut sum = p[i][1].add(Extended::ONE);
                let mut k = 1;
                while k < S {
                    sum = sum.add(p[i][k + 1].sub(p[i][k - 1]).mul(p[j][k]));
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

/// The zeros of P_S: Newton's method from 1 with the zeros found so far divided out (Maehly 1954), and a last few corrections
/// without.
const fn nodes<const S: usize>() -> [Extended; S] {
    let mut rough = [0.0; S];
    let mut c = [Extended::ZERO; S];
    let mut found = 0;
    while found < S {
        let mut x = 1.0;
        let mut n = 0;
        while n < ROUGH_CORRECTIONS {
            let (p, slope) = rough_polynomial(S, x);
            let mut others = 0.0;
            let mut i = 0;
            while i < found {
                others += 1.0 / (x - rough[i]);
                i += 1;
            }
            x -= p / (slope - p * others);
            n += 1;
        }
        rough[found] = x;
        let mut exact = Extended::new(x);
        n = 0;
        while n < CORRECTIONS {
            let (p, slope) = polynomials(S, exact);
            exact = exact.sub(p[S].div(slope));
            n += 1;
        }
        c[S - 1 - found] = exact;
        found += 1;
    }
    c
}

/// P₀(x), …, Pₙ(x) and the derivative of the last, by (k + 1) Pₖ₊₁ = (2k + 1) y Pₖ − k Pₖ₋₁ and P'ₖ₊₁ = P'ₖ₋₁ + 2 (2k + 1) Pₖ in
/// y = 2x − 1.
const fn polynomials(n: usize, x: Extended) -> ([Extended; MOST + 1], Extended) {
    let y = x.add(x).sub(Extended::ONE);
    let mut p = [Extended::ONE; MOST + 1];
    p[1] = y;
    let (mut slope_below, mut slope) = (Extended::ZERO, Extended::new(2.0));
    let mut k = 1;
    while k < n {
        let (a, b) = (Extended::new((2 * k + 1) as f64), Extended::new(k as f64));
        let d = Extended::new((k + 1) as f64);
        p[k + 1] = y.mul(p[k]).mul(a).sub(p[k - 1].mul(b)).div(d);
        let slope_next = slope_below.add(p[k].add(p[k]).mul(a));
        (slope_below, slope) = (slope, slope_next);
        k += 1;
    }
    (p, slope)
}

/// Pₙ(x) and its derivative in double precision, n ≥ 1.
const fn rough_polynomial(n: usize, x: f64) -> (f64, f64) {
    let y = 2.0 * x - 1.0;
    let (mut below, mut p, mut slope_below, mut slope) = (1.0, y, 0.0, 2.0);
    let mut k = 1;
    while k < n {
        let (a, b) = ((2 * k + 1) as f64, k as f64);
        let next = (a * y * p - b * below) / (b + 1.0);
        let slope_next = slope_below + 2.0 * a * p;
        (below, p) = (p, next);
        (slope_below, slope) = (slope, slope_next);
        k += 1;
    }
    (p, slope)
}

#[cfg(test)]
mod tests;
