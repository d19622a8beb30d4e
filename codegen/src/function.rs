//! The functions of the language: one table.

/// A function that a model may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// `sin(x)`
    Sin,
    /// `cos(x)`
    Cos,
    /// `tan(x)`
    Tan,
    /// `asin(x)`
    Asin,
    /// `acos(x)`
    Acos,
    /// `atan(x)`
    Atan,
    /// `atan2(y, x)`
    Atan2,
    /// `sinh(x)`
    Sinh,
    /// `cosh(x)`
    Cosh,
    /// `tanh(x)`
    Tanh,
    /// `exp(x)`; of a skew matrix the rotation `exp(S(v))`.
    Exp,
    /// `log(x)`, natural; of a rotation the skew matrix A with `exp(A)` = it.
    Log,
    /// `sqrt(x)`
    Sqrt,
    /// `abs(x)`
    Abs,
    /// `sign(x)`: −1, 0 or 1; the derivative of `abs`.
    Sign,
    /// `max(a, b)`, the larger.
    Max,
    /// `min(a, b)`, the smaller.
    Min,
    /// `sinc(x) = sin(x)/x`, 1 at 0.
    Sinc,
    /// `cosc(x) = (1 − cos(x))/x²`, 1/2 at 0.
    Cosc,
    /// `stumpff(n, s) = Σ (−s)^j / (n + 2j)!`, n a literal: the small-angle family.
    Stumpff,
    /// `norm(v) = sqrt(v.T*v)`
    Norm,
    /// `dot(a, b) = a.T*b`
    Dot,
    /// `cross(a, b)`, 3-vectors.
    Cross,
    /// `S(a)`: scalar → 2×2, 3-vector → 3×3 skew matrix.
    Skew,
    /// `vee(A)`: inverse of `S` on the skew part: 2×2 → scalar, 3×3 → 3-vector.
    Vee,
    /// `cay(A) = (I − A)⁻¹(I + A)` of a skew 2×2 or 3×3 matrix.
    Cay,
    /// `dexp(A) = Σ Aʲ/(j + 1)!` of a skew 3×3 matrix.
    Dexp,
    /// `dexpinv(A) = dexp(A)⁻¹`
    Dexpinv,
    /// `Rx(a)`: rotation about x.
    Rx,
    /// `Ry(a)`: rotation about y.
    Ry,
    /// `Rz(a)`: rotation about z.
    Rz,
    /// `diag(a, b, ...)` or `diag(v)`.
    Diag,
    /// `trace(A)`
    Trace,
    /// `det(A)`, up to 3×3.
    Det,
    /// `inv(A)`, up to 3×3, through the adjugate.
    Inv,
}

/// Name of each function in the language and how many arguments it takes; `usize::MAX` is "any".
pub const TABLE: &[(&str, Function, usize)] = &[
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("tan", Function::Tan, 1),
    ("asin", Function::Asin, 1),
    ("acos", Function::Acos, 1),
    ("atan", Function::Atan, 1),
    ("atan2", Function::Atan2, 2),
    ("sinh", Function::Sinh, 1),
    ("cosh", Function::Cosh, 1),
    ("tanh", Function::Tanh, 1),
    ("exp", Function::Exp, 1),
    ("log", Function::Log, 1),
    ("sqrt", Function::Sqrt, 1),
    ("abs", Function::Abs, 1),
    ("sign", Function::Sign, 1),
    ("max", Function::Max, 2),
    ("min", Function::Min, 2),
    ("sinc", Function::Sinc, 1),
    ("cosc", Function::Cosc, 1),
    ("stumpff", Function::Stumpff, 2),
    ("norm", Function::Norm, 1),
    ("dot", Function::Dot, 2),
    ("cross", Function::Cross, 2),
    ("S", Function::Skew, 1),
    ("vee", Function::Vee, 1),
    ("cay", Function::Cay, 1),
    ("dexp", Function::Dexp, 1),
    ("dexpinv", Function::Dexpinv, 1),
    ("Rx", Function::Rx, 1),
    ("Ry", Function::Ry, 1),
    ("Rz", Function::Rz, 1),
    ("diag", Function::Diag, usize::MAX),
    ("trace", Function::Trace, 1),
    ("det", Function::Det, 1),
    ("inv", Function::Inv, 1),
];

/// What the language leaves out: a Newton iteration needs derivatives everywhere.
pub const NO_CONDITIONALS: &str =
    "comparisons stand in `require` only, and there are no conditionals";

impl Function {
    /// The function called `name`, if there is one.
    pub fn named(name: &str) -> Option<Function> {
        TABLE.iter().find(|row| row.0 == name).map(|row| row.1)
    }

    /// Its name in the language.
    pub fn name(self) -> &'static str {
        TABLE
            .iter()
            .find(|row| row.1 == self)
            .map_or("?", |row| row.0)
    }
}
