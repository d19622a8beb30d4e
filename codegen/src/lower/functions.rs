//! The functions of the language on matrices of nodes.

use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::NodeId;
use crate::function::Function;
use crate::matrix::Matrix;
use crate::matrix::add_all;
use crate::model::Shape;
use crate::normal::rational;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// `function` of `arguments`, whose number and shapes `check` has approved.
///
/// # Errors
/// Says what is wrong with arguments whose values matter: a matrix that is not skew, an order that is
/// not a literal.
pub fn apply(dag: &mut Dag, function: Function, arguments: &[Matrix]) -> Result<Matrix, String> {
    let first = &arguments[0];
    let scalar = |dag: &mut Dag, f: Elementary| {
        let nodes = arguments.iter().map(|a| a.entries[0]).collect();
        Ok(Matrix::scalar(dag.call(f, nodes)))
    };
    match function {
        Function::Sin => scalar(dag, Elementary::Sin),
        Function::Cos => scalar(dag, Elementary::Cos),
        Function::Tan => scalar(dag, Elementary::Tan),
        Function::Asin => scalar(dag, Elementary::Asin),
        Function::Acos => scalar(dag, Elementary::Acos),
        Function::Atan => scalar(dag, Elementary::Atan),
        Function::Atan2 => scalar(dag, Elementary::Atan2),
        Function::Sinh => scalar(dag, Elementary::Sinh),
        Function::Cosh => scalar(dag, Elementary::Cosh),
        Function::Tanh => scalar(dag, Elementary::Tanh),
        Function::Log if first.shape.is_scalar() => scalar(dag, Elementary::Log),
        Function::Log => logarithm(dag, first),
        Function::Sqrt => scalar(dag, Elementary::Sqrt),
        Function::Abs => scalar(dag, Elementary::Abs),
        Function::Sign => scalar(dag, Elementary::Sign),
        Function::Max => Ok(largest(dag, arguments)),
        Function::Min => Ok(smallest(dag, arguments)),
        Function::Exp if first.shape.is_scalar() => scalar(dag, Elementary::Exp),
        Function::Exp => axis(dag, "exp", first).map(|v| exponential(dag, &v)),
        Function::Cay => axis(dag, "cay", first).map(|v| cayley(dag, &v)),
        Function::Dexp => axis(dag, "dexp", first).map(|v| tangent(dag, &v)),
        Function::Dexpinv => axis(dag, "dexpinv", first).map(|v| tangent_inverse(dag, &v)),
        Function::Sinc => Ok(small_angle(dag, 1, first.entries[0])),
        Function::Cosc => Ok(small_angle(dag, 2, first.entries[0])),
        Function::Stumpff => {
            let order = dag.as_constant(first.entries[0]).filter(|n| n.is_integer());
            let order = order
                .and_then(|n| n.to_u32())
                .filter(|n| *n <= HIGHEST_ORDER)
                .ok_or_else(|| {
                    format!("the order of stumpff must be a whole number from 0 to {HIGHEST_ORDER}")
                })?;
            let argument = arguments[1].entries[0];
            Ok(Matrix::scalar(
                dag.call(Elementary::Stumpff(order), vec![argument]),
            ))
        }
        Function::Norm => {
            let square = first.dot(dag, first);
            Ok(Matrix::scalar(dag.call(Elementary::Sqrt, vec![square])))
        }
        Function::Dot => Ok(Matrix::scalar(first.dot(dag, &arguments[1]))),
        Function::Cross => Ok(skew(dag, first).product(dag, &arguments[1])),
        Function::Skew => Ok(skew(dag, first)),
        Function::Vee => Ok(vee(dag, first)),
        Function::Rx => Ok(turn(dag, first.entries[0], 0)),
        Function::Ry => Ok(turn(dag, first.entries[0], 1)),
        Function::Rz => Ok(turn(dag, first.entries[0], 2)),
        Function::Diag => Ok(diagonal(dag, arguments)),
        Function::Trace => {
            let diagonal: Vec<_> = (0..first.shape.rows).map(|i| first.at(i, i)).collect();
            Ok(Matrix::scalar(add_all(dag, &diagonal)))
        }
        Function::Det => Ok(Matrix::scalar(first.determinant(dag))),
        Function::Inv => inverse(dag, first),
    }
}

/// Highest order of `stumpff` that a model may write; derivatives raise it further.
const HIGHEST_ORDER: u32 = 16;

/// max(a, b), and max(x, 0) as the function that it is.
fn largest(dag: &mut Dag, arguments: &[Matrix]) -> Matrix {
    let [a, b] = [0, 1].map(|i| arguments[i].entries[0]);
    let largest = match (dag.is_zero(a), dag.is_zero(b)) {
        (true, _) => dag.call(Elementary::Positive, vec![b]),
        (_, true) => dag.call(Elementary::Positive, vec![a]),
        _ => {
            let difference = dag.sub(a, b);
            where_positive(dag, difference, [a, b])
        }
    };
    Matrix::scalar(largest)
}

/// min(a, b) = −max(−a, −b)
fn smallest(dag: &mut Dag, arguments: &[Matrix]) -> Matrix {
    let negated = [0, 1].map(|i| Matrix::scalar(dag.neg(arguments[i].entries[0])));
    let largest = largest(dag, &negated);
    Matrix::scalar(dag.neg(largest.entries[0]))
}

/// a where d > 0, else b: a max(sign d, 0) + b sign(max(1/2 − sign d, 0)).
///
/// One factor is 1 and the other 0, so that nothing of the one that is taken is lost, however large the other; both have the
/// derivative 0.
fn where_positive(dag: &mut Dag, d: NodeId, [a, b]: [NodeId; 2]) -> NodeId {
    let sign = dag.call(Elementary::Sign, vec![d]);
    let is_positive = dag.call(Elementary::Positive, vec![sign]);
    let half = dag.constant(BigRational::new(1.into(), 2.into()));
    let rest = dag.sub(half, sign);
    let rest = dag.call(Elementary::Positive, vec![rest]);
    let is_not = dag.call(Elementary::Sign, vec![rest]);
    let [a, b] = [(a, is_positive), (b, is_not)].map(|(x, is)| dag.mul(x, is));
    dag.add(a, b)
}

/// cₙ(x²)
fn small_angle(dag: &mut Dag, n: u32, x: NodeId) -> Matrix {
    let square = dag.mul(x, x);
    Matrix::scalar(dag.call(Elementary::Stumpff(n), vec![square]))
}

/// S(a): `[[0, -a], [a, 0]]` of a scalar, `S(a) b = a × b` of a 3-vector.
fn skew(dag: &mut Dag, a: &Matrix) -> Matrix {
    let zero = dag.integer(0);
    let minus = a.map(|e| dag.neg(e)).entries;
    match a.entries.as_slice() {
        [x] => Matrix::from_rows([[zero, minus[0]], [*x, zero]]),
        [x, y, z] => Matrix::from_rows([
            [zero, minus[2], *y],
            [*z, zero, minus[0]],
            [minus[1], *x, zero],
        ]),
        _ => unreachable!("check admits scalars and 3-vectors only"),
    }
}

/// The inverse of S on the skew part (A − Aᵀ)/2.
fn vee(dag: &mut Dag, a: &Matrix) -> Matrix {
    let half = BigRational::new(1.into(), 2.into());
    let mut part =
        |i: usize, j: usize| dag.sum([(half.clone(), a.at(i, j)), (-half.clone(), a.at(j, i))]);
    if a.shape.rows == 2 {
        Matrix::scalar(part(1, 0))
    } else {
        Matrix::vector(vec![part(2, 1), part(0, 2), part(1, 0)])
    }
}

/// v where A = S(v).
fn axis(dag: &mut Dag, function: &str, a: &Matrix) -> Result<Matrix, String> {
    let minus_transpose = a.transpose().map(|e| dag.neg(e));
    if a.entries != minus_transpose.entries {
        return Err(format!(
            "{function} of a matrix is known for skew matrices only, such as {function}(S(v))"
        ));
    }
    Ok(vee(dag, a))
}

/// exp(S(v)): Rodrigues' formula I + c₁(v·v) S(v) + c₂(v·v) S(v)², without a singularity at 0.
fn exponential(dag: &mut Dag, v: &Matrix) -> Matrix {
    if v.shape.is_scalar() {
        let sin = dag.call(Elementary::Sin, v.entries.clone());
        let cos = dag.call(Elementary::Cos, v.entries.clone());
        let minus_sin = dag.neg(sin);
        return Matrix::from_rows([[cos, minus_sin], [sin, cos]]);
    }
    let square = v.dot(dag, v);
    let linear = dag.call(Elementary::Stumpff(1), vec![square]);
    let quadratic = dag.call(Elementary::Stumpff(2), vec![square]);
    rodrigues(dag, v, linear, quadratic)
}

/// cay(S(v)) = (I − S(v))⁻¹ (I + S(v)) = I + 2/(1 + v·v) (S(v) + S(v)²).
fn cayley(dag: &mut Dag, v: &Matrix) -> Matrix {
    let one = dag.integer(1);
    let square = v.dot(dag, v);
    let below = dag.add(one, square);
    let inverse = dag.product([(below, -1)]);
    let factor = dag.scale(rational(2), inverse);
    if v.shape.is_scalar() {
        let above = dag.sub(one, square);
        let cos = dag.mul(above, inverse);
        let sin = dag.mul(factor, v.entries[0]);
        let minus_sin = dag.neg(sin);
        return Matrix::from_rows([[cos, minus_sin], [sin, cos]]);
    }
    rodrigues(dag, v, factor, factor)
}

/// dexp(S(v)) = I + c₂(v·v) S(v) + c₃(v·v) S(v)²: exp(S(v + dv)) = exp(S(dexp(S(v)) dv)) exp(S(v)) to first order (Iserles,
/// Munthe-Kaas, Nørsett and Zanna, Lie-group methods, Acta Numerica 9, 2000, appendix B).
fn tangent(dag: &mut Dag, v: &Matrix) -> Matrix {
    let square = v.dot(dag, v);
    let linear = dag.call(Elementary::Stumpff(2), vec![square]);
    let quadratic = dag.call(Elementary::Stumpff(3), vec![square]);
    rodrigues(dag, v, linear, quadratic)
}

/// Its inverse I − S(v)/2 + e S(v)² with e = (1 − c₁/(2 c₂))/(v·v) = (c₃ − 2 c₄)/(2 c₂), which has no gap at 0.
fn tangent_inverse(dag: &mut Dag, v: &Matrix) -> Matrix {
    let square = v.dot(dag, v);
    let [second, third, fourth] = [2, 3, 4].map(|n| dag.call(Elementary::Stumpff(n), vec![square]));
    let above = dag.sum([(rational(1), third), (rational(-2), fourth)]);
    let below = dag.scale(rational(2), second);
    let quadratic = dag.div(above, below);
    let minus_half = dag.constant(BigRational::new((-1).into(), 2.into()));
    rodrigues(dag, v, minus_half, quadratic)
}

/// The skew matrix A with exp(A) = R, of a rotation R by less than a half turn.
///
/// In space A = S(2 atan(|w|)/|w| w) with w = tan(θ/2) n = 2 vee(R)/(1 + tr R).
fn logarithm(dag: &mut Dag, rotation: &Matrix) -> Result<Matrix, String> {
    let sine = vee(dag, rotation);
    let diagonal: Vec<_> = (0..rotation.shape.rows)
        .map(|i| rotation.at(i, i))
        .collect();
    let trace = add_all(dag, &diagonal);
    if sine.shape.is_scalar() {
        let cosine = dag.scale(BigRational::new(1.into(), 2.into()), trace);
        let angle = dag.call(Elementary::Atan2, vec![sine.entries[0], cosine]);
        return Ok(skew(dag, &Matrix::scalar(angle)));
    }
    // Near I all factors are near 1, and none takes digits from numbers that have few.
    let quarter = BigRational::new(1.into(), 4.into());
    let one = dag.integer(1);
    let below = dag.sum([(quarter.clone(), one), (quarter.clone(), trace)]);
    if dag.is_zero(below) {
        return Err("log of a half turn, which turns about both senses of its axis".into());
    }
    let double = sine.map(|x| dag.div(x, below));
    let square = double.dot(dag, &double);
    let square = dag.scale(quarter, square);
    let factor = arctangent(dag, square);
    let axis = double.map(|x| dag.mul(factor, x));
    Ok(skew(dag, &axis))
}

/// Halvings of an angle below a quarter turn, and terms of the series for what is left, below π/32: the next one is less
/// than 3e-22.
const HALVINGS: usize = 4;
const TERMS: i64 = 10;

/// atan(x)/x of s = x², without a gap at 0: atan(x) = 2 atan(x/2d) with 2d = 1 + √(1 + x²), and Σ (−s)ʲ/(2j + 1) in the end.
fn arctangent(dag: &mut Dag, mut square: NodeId) -> NodeId {
    let one = dag.integer(1);
    let half = BigRational::new(1.into(), 2.into());
    let mut factors = Vec::new();
    for _ in 0..HALVINGS {
        let sum = dag.add(one, square);
        let root = dag.call(Elementary::Sqrt, vec![sum]);
        let divisor = dag.sum([(half.clone(), one), (half.clone(), root)]);
        factors.push((divisor, -1));
        let quotient = dag.product([(square, 1), (divisor, -2)]);
        square = dag.scale(half.pow(2), quotient);
    }
    let coefficient = |j: i64| BigRational::new(1.into(), (2 * j + 1).into());
    let mut series = dag.constant(coefficient(TERMS - 1));
    for j in (0..TERMS - 1).rev() {
        let rest = dag.mul(square, series);
        series = dag.sum([(coefficient(j), one), (rational(-1), rest)]);
    }
    factors.push((series, 1));
    dag.product(factors)
}

/// I + a S(v) + b S(v)²
fn rodrigues(dag: &mut Dag, v: &Matrix, a: NodeId, b: NodeId) -> Matrix {
    let one = dag.integer(1);
    let skew = skew(dag, v);
    let square = skew.product(dag, &skew);
    let identity = Matrix::diagonal(dag, skew.shape, one);
    let linear = skew.map(|e| dag.mul(a, e));
    let quadratic = square.map(|e| dag.mul(b, e));
    let sum = identity.zip(&linear, |x, y| dag.add(x, y));
    sum.zip(&quadratic, |x, y| dag.add(x, y))
}

/// Rotation by `angle` about coordinate axis `i`.
fn turn(dag: &mut Dag, angle: NodeId, i: usize) -> Matrix {
    let sin = dag.call(Elementary::Sin, vec![angle]);
    let cos = dag.call(Elementary::Cos, vec![angle]);
    let minus_sin = dag.neg(sin);
    let (zero, one) = (dag.integer(0), dag.integer(1));
    let mut entries = vec![zero; 9];
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    entries[4 * i] = one;
    entries[4 * j] = cos;
    entries[4 * k] = cos;
    entries[3 * j + k] = minus_sin;
    entries[3 * k + j] = sin;
    Matrix {
        shape: Shape { rows: 3, cols: 3 },
        entries,
    }
}

/// The square matrix with the entries of `arguments` on its diagonal.
fn diagonal(dag: &mut Dag, arguments: &[Matrix]) -> Matrix {
    let diagonal: Vec<_> = arguments.iter().flat_map(|a| a.entries.clone()).collect();
    let zero = dag.integer(0);
    let n = diagonal.len();
    let mut entries = vec![zero; n * n];
    for (i, entry) in diagonal.into_iter().enumerate() {
        entries[i * n + i] = entry;
    }
    Matrix {
        shape: Shape { rows: n, cols: n },
        entries,
    }
}

/// A⁻¹ up to 3×3: the adjugate over the determinant.
fn inverse(dag: &mut Dag, a: &Matrix) -> Result<Matrix, String> {
    let determinant = a.determinant(dag);
    if dag.is_zero(determinant) {
        return Err("inv of a matrix whose determinant is zero".into());
    }
    Ok(a.adjugate(dag).map(|e| dag.div(e, determinant)))
}
