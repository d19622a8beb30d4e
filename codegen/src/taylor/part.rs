//! Quantities with their value and their coefficient of order n, and the recurrences of arithmetic.

use super::Builder;
use crate::dag::Elementary;
use crate::dag::NodeId;
use crate::system::Series;
use num_rational::BigRational;

/// A quantity along the motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// At the start of the step.
    pub(super) value: NodeId,
    /// Its coefficient of order n; `None` for what does not change with time.
    pub(super) newest: Option<NodeId>,
}

impl Part {
    /// What does not change with time.
    pub(super) fn fixed(value: NodeId) -> Self {
        Self {
            value,
            newest: None,
        }
    }
}

impl Builder {
    /// A node of the flow.
    pub(super) fn part(&self, id: NodeId) -> Part {
        Part {
            value: id,
            newest: self.newest[id.index()],
        }
    }

    /// A new inner sum, its series to be told later: they may depend on it.
    pub(super) fn reserve(&mut self) -> (usize, NodeId) {
        let lane = self.lanes.len();
        let zero = self.dag.integer(0);
        self.lanes.push([zero, zero]);
        (lane, self.inner(lane))
    }

    fn inner(&mut self, lane: usize) -> NodeId {
        self.dag.leaf(Series::inner(self.n_states, lane))
    }

    /// ⟨a, b⟩ of two series that are known apart from it.
    fn inner_product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let key = [a.min(b), a.max(b)];
        let known = self.sums.get(&key).copied();
        let lane = known.unwrap_or_else(|| {
            let (lane, _) = self.reserve();
            self.lanes[lane] = key;
            self.sums.insert(key, lane);
            lane
        });
        self.inner(lane)
    }

    /// n aₙ
    pub(super) fn weighted(&mut self, newest: NodeId) -> NodeId {
        let n = self.dag.leaf(Series::order(self.n_states));
        self.dag.mul(n, newest)
    }

    /// a / n
    pub(super) fn over_order(&mut self, a: NodeId) -> NodeId {
        let inverse = self.dag.leaf(Series::inverse_order(self.n_states));
        self.dag.mul(inverse, a)
    }

    /// 1 / a
    pub(super) fn inverse(&mut self, a: NodeId) -> NodeId {
        self.dag.product([(a, -1)])
    }

    /// a b
    pub(super) fn times(&mut self, a: Part, b: Part) -> Part {
        let value = self.dag.mul(a.value, b.value);
        let newest = match (a.newest, b.newest) {
            (None, None) => None,
            (Some(newest), None) => Some(self.dag.mul(newest, b.value)),
            (None, Some(newest)) => Some(self.dag.mul(a.value, newest)),
            (Some(left), Some(right)) => {
                let inner = self.inner_product(left, right);
                let first = self.dag.mul(a.value, right);
                let last = self.dag.mul(left, b.value);
                let outer = self.dag.add(first, last);
                Some(self.dag.add(outer, inner))
            }
        };
        Part { value, newest }
    }

    /// a / b
    pub(super) fn quotient(&mut self, a: Part, b: Part) -> Part {
        let value = self.dag.div(a.value, b.value);
        let Some(below) = b.newest else {
            let newest = a.newest.map(|newest| self.dag.div(newest, b.value));
            return Part { value, newest };
        };
        let (lane, inner) = self.reserve();
        let outer = self.dag.mul(value, below);
        let known = self.dag.add(outer, inner);
        let zero = self.dag.integer(0);
        let rest = self.dag.sub(a.newest.unwrap_or(zero), known);
        let inverse = self.inverse(b.value);
        let newest = self.dag.mul(rest, inverse);
        self.lanes[lane] = [below, newest];
        Part {
            value,
            newest: Some(newest),
        }
    }

    /// √a
    pub(super) fn root(&mut self, a: Part) -> Part {
        let value = self.dag.call(Elementary::Sqrt, vec![a.value]);
        let Some(inside) = a.newest else {
            return Part::fixed(value);
        };
        let (lane, inner) = self.reserve();
        let rest = self.dag.sub(inside, inner);
        let half = BigRational::new(1.into(), 2.into());
        let inverse = self.inverse(value);
        let half_inverse = self.dag.scale(half, inverse);
        let newest = self.dag.mul(rest, half_inverse);
        self.lanes[lane] = [newest, newest];
        Part {
            value,
            newest: Some(newest),
        }
    }

    /// y with y' d = a', of the order 0 given.
    pub(super) fn integral_of_quotient(&mut self, value: NodeId, a: NodeId, d: Part) -> Part {
        let inverse = self.inverse(d.value);
        let newest = match d.newest {
            None => self.dag.mul(a, inverse),
            Some(below) => {
                let (lane, inner) = self.reserve();
                let inner = self.over_order(inner);
                let rest = self.dag.sub(a, inner);
                let newest = self.dag.mul(rest, inverse);
                self.lanes[lane] = [self.weighted(newest), below];
                newest
            }
        };
        Part {
            value,
            newest: Some(newest),
        }
    }
}
