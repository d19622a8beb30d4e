//! Roots of error estimates, to about a percent: all that the length of a step needs.

/// Digits of a double behind the point.
const DIGITS: u32 = 52;
/// The exponent of 1.
const ONE: f64 = 1023.0;

/// log₂ x for x > 0, off by 0.09 at most: log₂(1 + m) ≈ m (Mitchell 1962).
#[inline]
pub(super) fn log2(x: f64) -> f64 {
    x.to_bits() as i64 as f64 / (1_u64 << DIGITS) as f64 - ONE
}

/// x^(−1/n), to 1 % for n ≥ 8 and 7 % for n ≥ 1; infinite for 0, and 0 or less for what is infinite or NaN.
#[inline]
pub(super) fn root(x: f64, n: usize) -> f64 {
    if x == 0.0 {
        return f64::INFINITY;
    }
    if !x.is_finite() {
        return f64::NAN;
    }
    let exponent = -log2(x) / n as f64;
    let whole = floor(exponent);
    let rest = exponent - whole;
    // 2ʳ for 0 ≤ r < 1, exact at both ends.
    let power = 1.0 + rest * (0.6565 + 0.3435 * rest);
    power * f64::from_bits(((whole + ONE).max(0.0) as u64).min(2046) << DIGITS)
}

/// The largest whole number that is not above x, |x| < 2⁵³.
fn floor(x: f64) -> f64 {
    let towards_zero = x as i64 as f64;
    if towards_zero > x {
        towards_zero - 1.0
    } else {
        towards_zero
    }
}

#[cfg(test)]
mod tests {
    use super::log2;
    use super::root;

    #[test]
    fn roots_are_as_good_as_they_say() {
        for n in 1..=24 {
            let worst = if n < 8 { 0.07 } else { 0.01 };
            for k in -600..600 {
                let x = 1.7_f64.powi(k);
                let exact = x.powf(-1.0 / n as f64);
                if exact > 1e-300 && exact < 1e300 {
                    assert!((root(x, n) / exact - 1.0).abs() < worst, "{x:e} {n}");
                }
            }
        }
        assert!((log2(0.1) - 0.1_f64.log2()).abs() < 0.09);
    }
}
