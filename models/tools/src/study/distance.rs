//! Largest components, NaN included.

/// Largest component of |a − b|, infinite if one is not finite.
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| a - b);
    largest(differences)
}

/// Largest |a|, infinite if a component is not finite.
pub fn largest_size(a: &[f64]) -> f64 {
    largest(a.iter().copied())
}

/// `f64::max` would drop a NaN.
fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest: f64, value| match value.is_nan() {
        true => f64::INFINITY,
        false => largest.max(value.abs()),
    })
}
