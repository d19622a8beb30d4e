//! Nodes and weights against digits computed elsewhere, and what any tableau of Gauss fulfils.

use super::Tableau;
use crate::scheme::extended::Extended;

/// A decimal number to the last bit of a double-double, near enough: 10⁻ᵏ divided out digit by digit.
fn decimal(text: &str) -> Extended {
    let mut value = Extended::ZERO;
    for digit in text.bytes().filter(u8::is_ascii_digit) {
        value = value
            .mul(Extended::new(10.0))
            .add(Extended::new(f64::from(digit - b'0')));
    }
    let places = text.len() - 1 - text.find('.').expect("a point");
    (0..places).fold(value, |value, _| value.div(Extended::new(10.0)))
}

/// The last of 30 digits.
const LAST: f64 = 1e-30;

fn assert_close(found: Extended, expected: Extended) {
    let off = found.sub(expected).hi.abs();
    assert!(off <= LAST, "{found:?}, {expected:?}: {off:e}");
}

/// Computed with mpmath 1.3 in 60 digits; Abramowitz and Stegun, *Handbook of Mathematical Functions*, table 25.4, has
/// 15 of them.
#[test]
fn nodes_and_weights_have_thirty_digits() {
    fn check<const S: usize>(c: [&str; S], b: [&str; S]) {
        let tableau = const { Tableau::<S>::NEW };
        for i in 0..S {
            assert_close(tableau.c[i], decimal(c[i]));
            assert_close(tableau.b[i], decimal(b[i]));
        }
    }
    check(
        [
            "0.2113248654051871177454256097490213",
            "0.7886751345948128822545743902509787",
        ],
        ["0.5", "0.5"],
    );
    check(
        [
            "0.11270166537925831148207346002176",
            "0.5",
            "0.88729833462074168851792653997824",
        ],
        [
            "0.2777777777777777777777777777777778",
            "0.4444444444444444444444444444444444",
            "0.2777777777777777777777777777777778",
        ],
    );
    check(
        [
            "0.04691007703066800360118656085030352",
            "0.2307653449471584544818427896498956",
            "0.5",
            "0.7692346550528415455181572103501044",
            "0.9530899229693319963988134391496965",
        ],
        [
            "0.1184634425280945437571320203599587",
            "0.2393143352496832340206457574178191",
            "0.2844444444444444444444444444444444",
            "0.2393143352496832340206457574178191",
            "0.1184634425280945437571320203599587",
        ],
    );
    check(
        [
            "0.0198550717512318841582195657152635",
            "0.1016667612931866302042230317620848",
            "0.2372337950418355070911304754053768",
            "0.408282678752175097530261928819908",
            "0.591717321247824902469738071180092",
            "0.7627662049581644929088695245946232",
            "0.8983332387068133697957769682379152",
            "0.9801449282487681158417804342847365",
        ],
        [
            "0.0506142681451881295762656771549811",
            "0.1111905172266872352721779972131204",
            "0.1568533229389436436689811009933007",
            "0.1813418916891809914825752246385978",
            "0.1813418916891809914825752246385978",
            "0.1568533229389436436689811009933007",
            "0.1111905172266872352721779972131204",
            "0.0506142681451881295762656771549811",
        ],
    );
}

/// C(s) and B(2s) (Hairer and Wanner, *Solving Ordinary Differential Equations II*, IV.5): Σⱼ aᵢⱼ cⱼᵏ⁻¹ = cᵢᵏ/k for
/// k ≤ s, Σ bᵢ cᵢᵏ⁻¹ = 1/k for k ≤ 2s; and bᵢaᵢⱼ + bⱼaⱼᵢ = bᵢbⱼ.
#[test]
fn the_simplifying_assumptions_hold() {
    fn check<const S: usize>() {
        let Tableau { c, b, mu, .. } = const { Tableau::<S>::NEW };
        let power = |x: Extended, k: usize| (0..k).fold(Extended::ONE, |p, _| p.mul(x));
        for k in 1..=2 * S {
            let sum = |weights: &dyn Fn(usize) -> Extended| {
                (0..S).fold(Extended::ZERO, |sum, j| {
                    sum.add(weights(j).mul(power(c[j], k - 1)))
                })
            };
            let part = Extended::ONE.div(Extended::new(k as f64));
            assert_close(sum(&|j| b[j]), part);
            for i in (0..S).filter(|_| k <= S) {
                assert_close(sum(&|j| mu[i][j].mul(b[j])), part.mul(power(c[i], k)));
            }
        }
        for (i, row) in mu.iter().enumerate() {
            for (value, transposed) in row.iter().zip(&mu) {
                assert_close(value.add(transposed[i]), Extended::ONE);
            }
        }
    }
    check::<1>();
    check::<2>();
    check::<4>();
    check::<6>();
    check::<8>();
}
