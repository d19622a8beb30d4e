//! The tableau in the numbers of a run, padded to eight stages.

use super::tableau::Tableau;
use crate::packed::Arithmetic;
use crate::packed::Packed;
use crate::packed::Work;
use crate::scalar::Real;

/// Stages at most: those of one vector.
pub(crate) const LANES: usize = 8;

/// Eight numbers, one of each stage.
pub(crate) type Row<T> = [T; LANES];

/// Coefficients of `stages` stages. What pads them is 0, and the last node.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Coefficients<T> {
    pub(crate) stages: usize,
    /// Nodes.
    pub(crate) c: Row<T>,
    /// Weights.
    pub(crate) b: Row<T>,
    /// Columns of μᵢⱼ = aᵢⱼ/bⱼ, with μᵢⱼ + μⱼᵢ = 1 exactly.
    pub(crate) mu: [Row<T>; LANES],
    /// Columns of (2k + 1) Pₖ(cⱼ), which takes h bⱼ f(Xⱼ) to the coefficients of h f: column j, row k.
    pub(crate) legendre: [Row<T>; LANES],
}

impl<T: Real> Coefficients<T> {
    /// Those of 1 to 8 stages; fewer or more are taken for these.
    pub(crate) fn new(stages: usize) -> Self {
        match stages {
            0 | 1 => Self::of(const { &Tableau::<1>::NEW }),
            2 => Self::of(const { &Tableau::<2>::NEW }),
            3 => Self::of(const { &Tableau::<3>::NEW }),
            4 => Self::of(const { &Tableau::<4>::NEW }),
            5 => Self::of(const { &Tableau::<5>::NEW }),
            6 => Self::of(const { &Tableau::<6>::NEW }),
            7 => Self::of(const { &Tableau::<7>::NEW }),
            _ => Self::of(const { &Tableau::<8>::NEW }),
        }
    }

    fn of<const S: usize>(tableau: &Tableau<S>) -> Self {
        let zero = T::constant(0.0);
        let (mut c, mut b) = ([tableau.c[S - 1].to(); LANES], [zero; LANES]);
        let (mut mu, mut legendre) = ([[zero; LANES]; LANES], [[zero; LANES]; LANES]);
        for i in 0..S {
            c[i] = tableau.c[i].to();
            b[i] = tableau.b[i].to();
            for j in 0..S {
                // The larger of a pair is at least 1/2, so that the difference from 1 is exact.
                mu[j][i] = match tableau.mu[i][j].hi {
                    _ if i == j => T::constant(0.5),
                    large if large > 0.5 => tableau.mu[i][j].to(),
                    _ => T::constant(1.0) - tableau.mu[j][i].to(),
                };
                legendre[j][i] = tableau.legendre[i][j].div(tableau.b[j]).to();
            }
        }
        Self {
            stages: S,
            c,
            b,
            mu,
            legendre,
        }
    }

    /// h bᵢ, the sum of which is h.
    pub(crate) fn weights(&self, h: T) -> Row<T> {
        let mut weights = self.b.map(|b| h * b);
        if self.stages >= 3 {
            let last = self.stages - 1;
            let inner = weights[1..last]
                .iter()
                .fold(T::constant(0.0), |sum, w| sum + *w);
            let outer = (h - inner) / T::constant(2.0);
            (weights[0], weights[last]) = (outer, outer);
        }
        weights
    }

    /// The trapezoidal rule as collocation at both ends, Lobatto IIIA.
    pub(crate) fn trapezoidal() -> Self {
        let [zero, half, one] = [0.0, 0.5, 1.0].map(T::constant);
        let row = [zero; LANES];
        let mut rule = Self {
            stages: 2,
            c: [one; LANES],
            b: row,
            mu: [row; LANES],
            legendre: [row; LANES],
        };
        rule.c[0] = zero;
        (rule.b[0], rule.b[1]) = (half, half);
        (rule.mu[0][1], rule.mu[1][1]) = (one, one);
        (rule.legendre[0][0], rule.legendre[1][0]) = (one, one);
        (rule.legendre[0][1], rule.legendre[1][1]) = (-one, one);
        rule
    }
}

impl<T: Packed> Coefficients<T> {
    /// Columns of the matrix that takes h bⱼ f(Xⱼ) of one step to Σⱼ aᵢⱼ h f of one that starts at `from` of it and has
    /// `ratio` times its length, by the polynomial of the rates.
    pub(crate) fn extrapolation(&self, from: T, ratio: T) -> [Row<T>; LANES] {
        T::work(Extrapolation {
            coefficients: self,
            from,
            ratio,
        })
    }
}

/// a xᵢ
#[inline]
pub(crate) fn scaled<T: Real>(a: T, x: Row<T>) -> Row<T> {
    x.map(|x| a * x)
}

/// a + xᵢ
#[inline(always)]
pub(crate) fn shifted<T: Real>(a: T, x: Row<T>) -> Row<T> {
    x.map(|x| a + x)
}

/// [`Coefficients::extrapolation`], all stages of the new step side by side.
struct Extrapolation<'a, T> {
    coefficients: &'a Coefficients<T>,
    from: T,
    ratio: T,
}

impl<T: Packed> Work<T> for Extrapolation<'_, T> {
    type Output = [Row<T>; LANES];

    /// μ applied to h' bₖ/h Σₘ Pₘ(from + ratio cₖ) (2m + 1) Pₘ(cⱼ)
    #[inline(always)]
    fn run<A: Arithmetic<T>>(self, arithmetic: A) -> [Row<T>; LANES] {
        let Self {
            coefficients,
            from,
            ratio,
        } = self;
        let [mut x, mut weights] = [coefficients.c, coefficients.b];
        for (x, weight) in x.iter_mut().zip(&mut weights) {
            *x = from + ratio * *x;
            *weight = ratio * *weight;
        }
        let polynomials = legendre_rows(&x);
        let mut columns = coefficients.legendre;
        for column in &mut columns {
            let mut rates = arithmetic.combine(&polynomials, column);
            for (rate, weight) in rates.iter_mut().zip(&weights) {
                *rate = *weight * *rate;
            }
            *column = arithmetic.combine(&coefficients.mu, &rates);
        }
        columns
    }
}

/// P₀, …, P₇ of the shifted Legendre polynomials, each at all of `x`.
#[inline(always)]
#[expect(clippy::needless_range_loop, reason = "indices as in the formula")]
fn legendre_rows<T: Real>(x: &Row<T>) -> [Row<T>; LANES] {
    let one = T::constant(1.0);
    let mut p = [[one; LANES]; LANES];
    for (p, x) in p[1].iter_mut().zip(x) {
        *p = *x + *x - one;
    }
    for k in 1..LANES - 1 {
        let next = (k + 1) as f64;
        let [a, b] = [(2 * k + 1) as f64 / next, k as f64 / next].map(T::constant);
        for i in 0..LANES {
            p[k + 1][i] = a * p[1][i] * p[k][i] - b * p[k - 1][i];
        }
    }
    p
}

/// P₀(x), …, P₇(x) of the shifted Legendre polynomials.
pub(crate) fn legendre<T: Real>(x: T) -> Row<T> {
    legendre_rows(&[x; LANES]).map(|row| row[0])
}
