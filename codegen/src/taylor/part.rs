//! Quantities with their value and their coefficient of order n, and the recurrences of arithmetic.

use super::Builder;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::Node;
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
        let leaf = Leaf::Unknown(Series::sum(self.n_states, lane));
        self.dag.leaf(leaf)
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

    /// Order n of a b, if neither needs a sum or product of order n itself.
    fn whole_product(&mut self, a: [NodeId; 2], b: [NodeId; 2]) -> Option<NodeId> {
        if self.is_late(a[1]) || self.is_late(b[1]) {
            return None;
        }
        let [a, b] = if a[1] <= b[1] { [a, b] } else { [b, a] };
        let key = [a[1], b[1]];
        let lane = match self.whole.get(&key) {
            // Of equal order n, but not of equal order 0.
            Some(&lane) if self.products[lane].1 != [a[0], b[0]] => return None,
            Some(&lane) => lane,
            None => {
                self.products.push((key, [a[0], b[0]]));
                self.whole.insert(key, self.products.len() - 1);
                self.products.len() - 1
            }
        };
        let leaf = Leaf::Unknown(Series::product(self.n_states, lane));
        Some(self.dag.leaf(leaf))
    }

    /// Whether a node needs an inner sum or a product.
    fn is_late(&mut self, id: NodeId) -> bool {
        let first = self.n_states + Series::GIVEN;
        for index in self.is_late.len()..=id.index() {
            let node = NodeId(u32::try_from(index).expect("a graph of 2^32 nodes"));
            let is_late = match self.dag.node(node) {
                Node::Leaf(leaf) => matches!(leaf, Leaf::Unknown(i) if *i >= first),
                _ => {
                    let operands = self.dag.operands(node);
                    operands.iter().any(|operand| self.is_late[operand.index()])
                }
            };
            self.is_late.push(is_late);
        }
        self.is_late[id.index()]
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
                if let Some(whole) = self.whole_product([a.value, left], [b.value, right]) {
                    let newest = Some(whole);
                    return Part { value, newest };
                }
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
