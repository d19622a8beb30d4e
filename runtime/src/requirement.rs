//! What the data of a run must be like: how two sides compare, and which requirements are not met.

use crate::description::Requirement;
use crate::model::Model;
use crate::scalar::Real;

/// Roundings that an entry of a matrix may have been through before it is compared, in units of ε times its size.
const ROUNDINGS: f64 = 8.0;

/// How the two sides of a requirement compare. NaN compares with nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// `a < b`
    Less,
    /// `a <= b`
    LessOrEqual,
    /// `a > b`
    Greater,
    /// `a >= b`
    GreaterOrEqual,
}

impl Relation {
    /// Every component of `left` is less, or whatever the relation is, than that of `right`.
    pub fn holds_for_all<T: Real, const N: usize>(self, left: &[T; N], right: &[T; N]) -> bool {
        left.iter().zip(right).all(|(a, b)| match self {
            Relation::Less => a < b,
            Relation::LessOrEqual => a <= b,
            Relation::Greater => a > b,
            Relation::GreaterOrEqual => a >= b,
        })
    }

    /// The quadratic forms compare (Loewner's order): `A > B` where A − B is symmetric and positive definite, `A >= B`
    /// where it may be singular. An entry (i, j) counts as known to 8 N ε √(dᵢ dⱼ), dᵢ being the larger of the entries
    /// (i, i) of both, so that units do not matter: what is singular up to that is `>=` and not `>`.
    #[expect(clippy::needless_range_loop, reason = "indices as in the textbook")]
    pub fn holds_for_matrices<T: Real, const N: usize>(
        self,
        left: &[[T; N]; N],
        right: &[[T; N]; N],
    ) -> bool {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let (large, small, slack) = match self {
            Relation::Less => (right, left, -1.0),
            Relation::LessOrEqual => (right, left, 1.0),
            Relation::Greater => (left, right, -1.0),
            Relation::GreaterOrEqual => (left, right, 1.0),
        };
        let rounding = T::constant(ROUNDINGS * N as f64) * T::EPSILON;
        let mut scales = [one; N];
        for i in 0..N {
            let (a, b) = (large[i][i].abs(), small[i][i].abs());
            let largest = if a > b { a } else { b };
            if largest > zero {
                scales[i] = largest.sqrt();
            }
        }
        let mut d = [[zero; N]; N];
        for i in 0..N {
            for j in 0..N {
                d[i][j] = (large[i][j] - small[i][j]) / scales[i] / scales[j];
            }
        }
        for i in 0..N {
            for j in 0..i {
                // What is not a number is not symmetric either.
                let is_symmetric = (d[i][j] - d[j][i]).abs() <= rounding;
                if !is_symmetric {
                    return false;
                }
            }
        }
        // Symmetric Gaussian elimination: positive definite is what has positive pivots (Golub and Van Loan, 4.2).
        for i in 0..N {
            d[i][i] = d[i][i] + T::constant(slack) * rounding;
        }
        for k in 0..N {
            let pivot = d[k][k];
            let is_positive = pivot > zero;
            if !is_positive {
                return false;
            }
            for i in k + 1..N {
                let factor = d[i][k] / pivot;
                for j in k + 1..N {
                    d[i][j] = d[i][j] - factor * d[k][j];
                }
            }
        }
        true
    }
}

/// The requirements of the model file that the data of a run do not meet.
///
/// ```
/// # mod pendulum { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/src/specimens/pendulum.rs")); }
/// use pendulum::{Model, Parameters};
/// use residua::{Model as _, unmet};
///
/// let parameters = Parameters { c: 4.0, ..Parameters::default() };
/// let start = Model::start(&parameters);
/// for requirement in unmet::<Model, f64>(&parameters, 0.01, &start) {
///     eprintln!("warning: {} (line {})", requirement.otherwise, requirement.line);
/// }
/// ```
pub fn unmet<M: Model<T>, T: Real>(
    parameters: &M::Parameters,
    h: T,
    start: &M::State,
) -> impl Iterator<Item = &'static Requirement> {
    let all = M::DESCRIPTION.requirements.iter().enumerate();
    all.filter(move |(i, _)| !M::meets(*i, parameters, h, start))
        .map(|(_, requirement)| requirement)
}

#[cfg(test)]
mod tests;
