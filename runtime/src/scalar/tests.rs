use crate::lanes::Lanes;
use crate::packed::Each;
use crate::scalar::Scalar;

/// Numbers x with max(x, 0).
const SIDES: [(f64, f64); 8] = [
    (-1.5, 0.0),
    (-5e-324, 0.0),
    (-0.0, 0.0),
    (0.0, 0.0),
    (0.3, 0.3),
    (f64::MAX, f64::MAX),
    (f64::INFINITY, f64::INFINITY),
    (f64::NEG_INFINITY, 0.0),
];

#[test]
fn what_is_not_positive_is_zero() {
    for (x, expected) in SIDES {
        let bits = expected.to_bits();
        assert_eq!(x.positive().to_bits(), bits, "{x}");
        assert_eq!(Lanes([x]).positive().0[0].to_bits(), bits, "{x}");
        assert_eq!(Each([x]).positive().0[0].to_bits(), bits, "{x}");
        assert_eq!((x as f32).positive(), expected as f32, "{x}");
    }
    assert!(f64::NAN.positive().is_nan() && f32::NAN.positive().is_nan());
    assert!(Lanes([f64::NAN]).positive().0[0].is_nan());
}

#[cfg(feature = "dual")]
#[test]
fn on_either_side_the_slope_is_that_side_s() {
    use num_dual::Dual64;
    for (x, value, slope) in [(-0.7, 0.0, 0.0), (0.7, 0.7, 1.0)] {
        let found = Dual64::new(x, 1.0).positive();
        assert_eq!((found.re, found.eps), (value, slope));
    }
    assert!(Dual64::new(f64::NAN, 1.0).positive().re.is_nan());
}
