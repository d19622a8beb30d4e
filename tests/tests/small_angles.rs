//! Functions of rotations from the least denormal angle to a full turn, as generated: in `f64` and `f32` against 31 digits.

use residua::Model as _;
use residua::Record;
use residua::Scalar;
use residua_models::exact::Double;

/// All of them, as outputs.
mod angles {
    residua::model! {
        //! Functions of a rotation vector.
        /// rotation vector
        state v: [3] rad;
        residual { Δv = 0; }
        solve for next;
        start { v = [0, 0, 0]; }
        observe rotation: [3, 3] = exp(S(v));
        observe cayley: [3, 3] = cay(S(v));
        observe tangent: [3, 3] = dexp(S(v));
        observe inverse: [3, 3] = dexpinv(S(v));
        observe identity: [3, 3] = dexpinv(S(v))*dexp(S(v));
        observe logarithm: [3, 3] = log(exp(S(v)));
        observe series: [3] = [sinc(v.x), cosc(v.x), stumpff(3, v.x^2)];
    }
}

use angles::Model;
use angles::Outputs;

/// Units of rounding, of the largest entry and times 1 + |v|, that each may be off by: an angle that is rounded turns by as
/// much more or less. A product of two matrices adds three roundings, the
/// inverse its pole at a full turn, the logarithm of a rotation one at a half turn: they are asked for up to a tenth of a radian
/// from there.
const BOUNDS: [(&str, f64, f64); GROUPS] = [
    ("exp", TURN, 2.0),
    ("cay", TURN, 2.0),
    ("dexp", TURN, 2.0),
    ("dexpinv", TURN, 10.0),
    ("dexpinv dexp", TURN, 40.0),
    ("log exp", 0.5 * TURN, 10.0),
    ("sinc, cosc, c3", TURN, 2.0),
];

const TURN: f64 = core::f64::consts::TAU;

/// Groups of entries.
const GROUPS: usize = 7;
type Groups<T> = [Vec<T>; GROUPS];

fn outputs<T: Scalar>(v: [T; 3]) -> Groups<T> {
    let parameters = angles::Parameters::default();
    let zero = T::constant(0.0);
    let state = angles::State::from_array(v);
    let outputs: Outputs<T> = Model::outputs(&parameters, zero, zero, &state);
    let all = outputs.to_array();
    let all: &[T] = all.as_ref();
    let mut groups = all.chunks(9).map(<[T]>::to_vec);
    core::array::from_fn(|_| groups.next().expect("as many outputs"))
}

/// Angles of all sizes, in radians, and evenly up to a tenth of a radian before a full turn.
fn angles() -> impl Iterator<Item = f64> {
    let powers = (-1074..=2).map(|e| 1.37 * f64::powi(2.0, e));
    powers.chain((1..=618).map(|i| 0.01 * f64::from(i)))
}

/// Axes: each alone, and two of no special direction.
const AXES: [[f64; 3]; 5] = [
    [1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.48, -0.6, 0.64],
    [-0.8, 0.36, 0.48],
];

/// The worst error of each group, in units of ε (1 + |v|) times the largest entry, with numbers rounded by `to`; of the
/// least numbers, of which there is no half, 64 may be lost: a product has its coefficient last.
fn worst<T: Scalar>(
    epsilon: f64,
    least: f64,
    to: impl Fn(f64) -> T,
    from: impl Fn(T) -> f64,
) -> [f64; GROUPS] {
    let mut worst = [0.0_f64; GROUPS];
    for angle in angles() {
        for axis in AXES {
            let v = axis.map(|x| to(x * angle));
            let exact = outputs(v.map(|x| Double::from(from(x))));
            let groups = worst.iter_mut().zip(outputs(v)).zip(&exact).zip(BOUNDS);
            for (((worst, found), exact), (_, pole, _)) in groups {
                if angle > pole - 0.1 {
                    continue;
                }
                let size = exact.iter().fold(0.0, |m: f64, x| m.max(x.to_f64().abs()));
                for (found, exact) in found.iter().zip(exact) {
                    let off = (Double::from(from(*found)) - *exact).to_f64().abs();
                    let off = off - f64::min(off, 64.0 * least);
                    assert!(off.is_finite(), "{angle:e} {axis:?}");
                    *worst = worst.max(off / (epsilon * (1.0 + angle) * size));
                }
            }
        }
    }
    worst
}

#[test]
fn functions_of_rotations_have_no_gap_in_either_precision() {
    let double = worst(f64::EPSILON, 5e-324, |x| x, |x| x);
    let single = worst(f32::EPSILON.into(), 1.4e-45, |x| x as f32, f64::from);
    for (((name, _, bound), double), single) in BOUNDS.into_iter().zip(double).zip(single) {
        println!("{name}: {double:.2} ε in f64, {single:.2} ε in f32");
        assert!(
            double <= bound && single <= bound,
            "{name}: {double} {single}"
        );
    }
}

/// What they are, in 31 digits: exp is the limit of its definition, dexp its derivative, dexpinv and log the inverses.
#[test]
fn they_are_what_they_are_called() {
    for angle in [1e-300, 1e-9, 1e-3, 0.5, 2.0, 3.1, 6.0] {
        for axis in AXES {
            let v = axis.map(|x| Double::from(x * angle));
            let [rotation, cayley, tangent, _, identity, logarithm, _] = outputs(v);
            let power = power_series(v);
            for (found, expected) in rotation
                .iter()
                .zip(&power[0])
                .chain(tangent.iter().zip(&power[1]))
            {
                assert!(
                    (*found - *expected).to_f64().abs() < 1e-27,
                    "{angle} {axis:?}"
                );
            }
            for (i, entry) in identity.iter().enumerate() {
                let one = Double::from(if i % 4 == 0 { 1.0 } else { 0.0 });
                assert!((*entry - one).to_f64().abs() < 1e-26, "{angle} {axis:?}");
            }
            let s = skew(v);
            if angle < core::f64::consts::PI {
                for (found, expected) in logarithm.iter().zip(s) {
                    assert!(
                        (*found - expected).to_f64().abs() < 1e-20 * angle,
                        "{angle} {axis:?}"
                    );
                }
            }
            // (I − S) cay = I + S.
            for i in 0..3 {
                for j in 0..3 {
                    let product = (0..3).fold(cayley[3 * i + j], |sum, k| {
                        sum - s[3 * i + k] * cayley[3 * k + j]
                    });
                    let one = Double::from(if i == j { 1.0 } else { 0.0 });
                    assert!((product - one - s[3 * i + j]).to_f64().abs() < 1e-28);
                }
            }
        }
    }
}

fn skew([x, y, z]: [Double; 3]) -> [Double; 9] {
    let o = Double::from(0.0);
    [o, -z, y, z, o, -x, -y, x, o]
}

/// Σ Sʲ/j! and Σ Sʲ/(j + 1)!, sixty terms.
fn power_series(v: [Double; 3]) -> [[Double; 9]; 2] {
    let s = skew(v);
    let mut term = core::array::from_fn(|i| Double::from(if i % 4 == 0 { 1.0 } else { 0.0 }));
    let mut sums = [term, term];
    for j in 1..60 {
        let before = term;
        term = core::array::from_fn(|i| {
            let (row, column) = (i / 3, i % 3);
            let sum = (0..3).fold(Double::from(0.0), |sum, k| {
                sum + before[3 * row + k] * s[3 * k + column]
            });
            sum / Double::from(f64::from(j))
        });
        for i in 0..9 {
            sums[0][i] = sums[0][i] + term[i];
            sums[1][i] = sums[1][i] + term[i] / Double::from(f64::from(j + 1));
        }
    }
    sums
}
