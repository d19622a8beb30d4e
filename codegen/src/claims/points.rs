//! Equal or not, at generic points.

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::sample::Sample;

/// Points tried. More find rarer coincidences; each costs one evaluation of the graph.
pub const POINTS: u64 = 8;

/// Largest relative difference of equal expressions: a few hundred roundings.
const TOLERANCE: f64 = 1e-10;

/// The value of every node at each point.
pub(super) struct Points(Vec<Vec<f64>>);

impl Points {
    pub(super) fn new(dag: &Dag) -> Self {
        Self(
            (0..POINTS)
                .map(|p| Sample::generic(p).evaluate(dag))
                .collect(),
        )
    }

    /// Values of `printed` and `factor` · `derived` at the first generic point where they differ, if there is
    /// one.
    pub(super) fn disagreement(
        &self,
        printed: NodeId,
        derived: NodeId,
        factor: f64,
    ) -> Option<(f64, f64)> {
        if printed == derived && factor == 1.0 {
            return None;
        }
        let finite: Vec<_> = self.finite(printed, derived, factor).collect();
        if finite.is_empty() {
            return Some((f64::NAN, f64::NAN));
        }
        finite.into_iter().find(|(a, b)| !close(*a, *b))
    }

    /// The number that `printed` is times `derived` at every point, if there is one that is not 0.
    pub(super) fn ratio(&self, printed: NodeId, derived: NodeId) -> Option<f64> {
        let large = |(_, b): &(f64, f64)| b.abs() > TOLERANCE.sqrt();
        let (a, b) = self.finite(printed, derived, 1.0).find(large)?;
        let ratio = a / b;
        let holds = self.disagreement(printed, derived, ratio).is_none();
        (holds && ratio.abs() > TOLERANCE).then_some(ratio)
    }

    fn finite(
        &self,
        printed: NodeId,
        derived: NodeId,
        factor: f64,
    ) -> impl Iterator<Item = (f64, f64)> {
        let values = self
            .0
            .iter()
            .map(move |p| (p[printed.index()], factor * p[derived.index()]));
        values.filter(|(a, b)| a.is_finite() && b.is_finite())
    }
}

/// Equal but for rounding.
pub(super) fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= TOLERANCE * a.abs().max(b.abs()).max(1.0)
}
