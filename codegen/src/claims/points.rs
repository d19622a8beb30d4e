//! Equal or not, at generic points.

use super::bounded::Bounded;
use super::bounded::Verdict;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::dag::Tape;
use crate::sample::Typical;
use std::cell::OnceCell;

/// Points that have to agree. More find rarer coincidences; each costs one evaluation of the graph.
pub const POINTS: u64 = 8;

/// How large the inputs are, round by round of [`POINTS`] points. Others than 1 are for what cancels or overflows there;
/// where every round has been tried and no point could tell, a claim is taken as wrong.
const SCALES: [f64; 8] = [1.0, 1.0, 0.1, 10.0, 0.01, 100.0, 1e-3, 1e3];

/// The value of every node that is compared, at each point as soon as it is needed.
pub(super) struct Points<'a> {
    typical: &'a Typical,
    tape: Tape<Bounded>,
    /// The position of each node on the tape, if it is there.
    positions: Vec<Option<usize>>,
    /// Where the model itself has no value, a claim need not have one.
    model: Vec<NodeId>,
    values: Vec<OnceCell<Vec<Bounded>>>,
}

/// What a node is compared with: a factor and another node, or 0.
type Other = Option<(Bounded, NodeId)>;

impl<'a> Points<'a> {
    /// The points for comparing `nodes` of a model that consists of the nodes `model`.
    pub(super) fn new(
        dag: &Dag,
        typical: &'a Typical,
        model: &[NodeId],
        nodes: impl Iterator<Item = NodeId>,
    ) -> Self {
        let mut roots = Vec::new();
        let mut positions = vec![None; dag.nodes().len()];
        for node in nodes.chain(model.iter().copied()) {
            if positions[node.index()].is_none() {
                positions[node.index()] = Some(roots.len());
                roots.push(node);
            }
        }
        let n_points = POINTS as usize * SCALES.len();
        Self {
            typical,
            tape: dag.tape_of(&roots),
            positions,
            model: model.to_vec(),
            values: vec![OnceCell::new(); n_points],
        }
    }

    /// Values of `printed` and `factor` · `derived` at the first generic point where they differ, if there is
    /// one; NaN if no point can tell.
    pub(super) fn disagreement(
        &self,
        printed: NodeId,
        derived: NodeId,
        factor: Bounded,
    ) -> Option<(f64, f64)> {
        if printed == derived && factor.is_one() {
            return None;
        }
        self.search(printed, Some((factor, derived)))
    }

    /// The value of `printed` at the first generic point where it is not 0, and 0, as for
    /// [`Points::disagreement`].
    pub(super) fn remainder(&self, printed: NodeId) -> Option<(f64, f64)> {
        self.search(printed, None)
    }

    /// The number that `printed` is times `derived` at every point, if there is one that is not 0.
    pub(super) fn ratio(&self, printed: NodeId, derived: NodeId) -> Option<Bounded> {
        let ratios = (0..self.values.len())
            .map(|point| self.value(point, printed) * self.value(point, derived).inverse());
        let precise = ratios
            .filter(|ratio| ratio.relative_error().is_finite())
            .take(POINTS as usize)
            .min_by(|a, b| a.relative_error().total_cmp(&b.relative_error()))?;
        let holds = self.disagreement(printed, derived, precise).is_none();
        holds.then_some(precise)
    }

    fn search(&self, printed: NodeId, other: Other) -> Option<(f64, f64)> {
        let (mut equal, mut similar) = (0, 0);
        for point in 0..self.values.len() {
            let a = self.value(point, printed);
            let b = other.map_or(Bounded::exact(0.0), |(factor, derived)| {
                factor * self.value(point, derived)
            });
            match a.compare(b) {
                Verdict::Equal => equal += 1,
                Verdict::Similar => similar += 1,
                Verdict::Different => return Some((a.shown(), b.shown())),
                Verdict::OneSided if self.model_has_values(point) => {
                    return Some((a.shown(), b.shown()));
                }
                Verdict::OneSided | Verdict::Undecided => {}
            }
            if equal == POINTS {
                return None;
            }
        }
        (equal + similar == 0).then_some((f64::NAN, f64::NAN))
    }

    fn model_has_values(&self, point: usize) -> bool {
        let mut values = self.model.iter().map(|&node| self.value(point, node));
        values.all(|value| value.is_known() && !value.is_outside())
    }

    fn value(&self, point: usize, node: NodeId) -> Bounded {
        let values = self.values[point].get_or_init(|| {
            let scale = SCALES[point / POINTS as usize];
            let leaf = |leaf: Leaf| self.typical.value_with_sign(point as u64, leaf);
            self.tape.evaluate(|l| Bounded::exact(scale * leaf(l)))
        });
        let position = self.positions[node.index()].expect("only nodes of the claims are compared");
        values[position]
    }
}
