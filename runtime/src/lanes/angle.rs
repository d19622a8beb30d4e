//! Sine and cosine without branches.
//!
//! The argument is reduced to |y| ≤ π/4 by multiples of π/2 in parts (Cody and Waite, *Software Manual for the
//! Elementary Functions*, 1980), exactly, with what is rounded carried along; then minimax polynomials (Ng, *Argument
//! Reduction for Huge Arguments*, 1992, with the coefficients of FDLIBM 5.3, `k_sin.c` and `k_cos.c`). No fused
//! multiply-add, so all machines have the same result.

/// Largest |x| that is reduced, rad: 2²⁰ quarter turns, the products of which with 33 bits are exact.
const LARGEST: f64 = 1_048_576.0 * core::f64::consts::FRAC_PI_2;

/// 1.5·2⁵²: numbers added to it are rounded to integers, which then stand in the last bits.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// π/2 in three parts of 33 bits and the rest, to 151 bits.
const PARTS: [f64; 4] = [
    f64::from_bits(0x3FF9_21FB_5440_0000),
    f64::from_bits(0x3DD0_B461_1A60_0000),
    f64::from_bits(0x3BA3_198A_2E00_0000),
    f64::from_bits(0x397B_839A_2520_49C1),
];

/// Of x³, x⁵, …, x¹³.
const SINE: [f64; 6] = [
    f64::from_bits(0xBFC5_5555_5555_5549),
    f64::from_bits(0x3F81_1111_1110_F8A6),
    f64::from_bits(0xBF2A_01A0_19C1_61D5),
    f64::from_bits(0x3EC7_1DE3_57B1_FE7D),
    f64::from_bits(0xBE5A_E5E6_8A2B_9CEB),
    f64::from_bits(0x3DE5_D93A_5ACF_D57C),
];

/// Of x⁴, x⁶, …, x¹⁴.
const COSINE: [f64; 6] = [
    f64::from_bits(0x3FA5_5555_5555_554C),
    f64::from_bits(0xBF56_C16C_16C1_5177),
    f64::from_bits(0x3EFA_01A0_19CB_1590),
    f64::from_bits(0xBE92_7E4F_809C_52AD),
    f64::from_bits(0x3E21_EE9E_BDB4_B1C4),
    f64::from_bits(0xBDA8_FAE9_BE88_38D4),
];

/// (sin x, cos x); NaN beyond [`LARGEST`].
#[inline(always)]
pub(super) fn sin_cos(x: f64) -> (f64, f64) {
    let x = if x.abs() <= LARGEST { x } else { f64::NAN };
    let shifted = x * core::f64::consts::FRAC_2_PI + TO_INTEGER;
    let quarters = shifted - TO_INTEGER;
    let (y, rest) = reduced(x, quarters);
    let (sin, cos) = (sine(y, rest), cosine(y, rest));

    // The quarter turn modulo 4: odd ones swap, and two bits are signs.
    let turn = shifted.to_bits();
    let (a, b) = if turn & 1 == 0 {
        (sin, cos)
    } else {
        (cos, sin)
    };
    let negate = |value: f64, bit: u64| f64::from_bits(value.to_bits() ^ ((bit & 1) << 63));
    (negate(a, turn >> 1), negate(b, (turn >> 1) ^ turn))
}

/// x − n π/2 as a sum of two numbers, the second less than half a unit in the last place of the first.
#[inline(always)]
fn reduced(x: f64, n: f64) -> (f64, f64) {
    let r = x - n * PARTS[0];
    let (r, first) = difference(r, n * PARTS[1]);
    let (r, second) = difference(r, n * PARTS[2]);
    let rest = first + second - n * PARTS[3];
    let y = r + rest;
    (y, rest - (y - r))
}

/// a − b and what is rounded off it (Knuth's two-sum).
#[inline(always)]
fn difference(a: f64, b: f64) -> (f64, f64) {
    let rounded = a - b;
    let virtual_b = a - rounded;
    let virtual_a = rounded + virtual_b;
    (rounded, (a - virtual_a) + (virtual_b - b))
}

/// sin(y + rest), |y| ≤ π/4
#[inline(always)]
fn sine(y: f64, rest: f64) -> f64 {
    let z = y * y;
    let w = z * z;
    let [s1, s2, s3, s4, s5, s6] = SINE;
    let tail = s2 + z * (s3 + z * s4) + z * w * (s5 + z * s6);
    let v = z * y;
    y - ((z * (0.5 * rest - v * tail) - rest) - v * s1)
}

/// cos(y + rest), |y| ≤ π/4
#[inline(always)]
fn cosine(y: f64, rest: f64) -> f64 {
    let z = y * y;
    let w = z * z;
    let [c1, c2, c3, c4, c5, c6] = COSINE;
    let tail = z * (c1 + z * (c2 + z * c3)) + w * w * (c4 + z * (c5 + z * c6));
    let half = 0.5 * z;
    let head = 1.0 - half;
    head + (((1.0 - head) - half) + (z * tail - y * rest))
}
