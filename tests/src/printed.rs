//! What `residua errata` says, beside what is coded by hand.

use nalgebra::SMatrix;
use residua_tools::errata::newton::Plan;
use residua_tools::errata::{Errata, Verdict, errata};

/// Relative difference of entries that are equal: a few roundings of terms of order one.
pub const ROUNDING: f64 = 1e-12;

/// The claims of a model of the catalogue.
pub fn all(model: &str) -> Errata {
    let entry = residua_models::find(model).expect("in the catalogue");
    errata(entry, &Plan::default()).expect("a model of the catalogue")
}

/// One of them, about the model itself.
pub fn verdict(model: &str, kind: &str, label: &str) -> Verdict {
    let claims = all(model).claims.into_iter();
    let mut found = claims.filter(|c| c.kind == kind && c.label == label && c.of.is_none());
    found.next().unwrap_or_else(|| panic!("{kind} {label}"))
}

/// Where two lists of numbers differ, counted from 1.
pub fn unequal(printed: &[f64], right: &[f64]) -> Vec<usize> {
    assert_eq!(printed.len(), right.len());
    let pairs = printed.iter().zip(right).enumerate();
    let differ =
        pairs.filter(|(_, (a, b))| (*a - *b).abs() > ROUNDING * a.abs().max(b.abs()).max(1.0));
    differ.map(|(i, _)| i + 1).collect()
}

/// The generator names the entries that differ here.
pub fn named(verdict: &Verdict, n_cols: usize, unequal: &[usize]) {
    let position = |(row, col): (usize, usize)| (row - 1) * n_cols + col;
    let mut places: Vec<usize> = verdict
        .differences
        .iter()
        .map(|d| position((d.row, d.col)))
        .collect();
    // The generator goes block by block.
    places.sort_unstable();
    assert!(!verdict.right, "{}", verdict.label);
    assert_eq!(places, unequal, "{}", verdict.label);
}

/// Row by row.
pub fn rows<const N: usize, const M: usize>(matrix: &SMatrix<f64, N, M>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}
