//! The Stumpff functions without branches, for small arguments.

/// Largest |s| of the series, 4: an angle of 2 rad. In a step angles are small.
const LARGEST: f64 = 4.0;

/// Terms of the series. The first one left out is below 4¹³/27!, 10⁻²⁰ of the sum.
const TERMS: usize = 13;

/// Largest n.
const ORDERS: usize = 9;

/// cₙ(s) = Σ (−s)ʲ / (n + 2j)!; NaN for |s| > 4 and for n > 8.
#[inline(always)]
pub(super) fn stumpff(n: u32, s: f64) -> f64 {
    let Some(coefficients) = INVERSE_FACTORIALS.get(n as usize) else {
        return f64::NAN;
    };
    let s = if s.abs() <= LARGEST { s } else { f64::NAN };
    let mut sum = coefficients[TERMS - 1];
    for j in (0..TERMS - 1).rev() {
        sum = coefficients[j] - s * sum;
    }
    sum
}

/// 1/(n + 2j)! in row n, column j.
const INVERSE_FACTORIALS: [[f64; TERMS]; ORDERS] = inverse_factorials();

const fn inverse_factorials() -> [[f64; TERMS]; ORDERS] {
    let mut rows = [[0.0; TERMS]; ORDERS];
    let mut n = 0;
    while n < ORDERS {
        let mut j = 0;
        while j < TERMS {
            rows[n][j] = 1.0 / factorial(n + 2 * j);
            j += 1;
        }
        n += 1;
    }
    rows
}

/// n!, exact up to n = 22.
const fn factorial(n: usize) -> f64 {
    let mut product = 1.0;
    let mut k = 2;
    while k <= n {
        product *= k as f64;
        k += 1;
    }
    product
}
