//! Expressions over other inputs.

use super::Dag;
use super::Leaf;
use super::Node;
use super::NodeId;

impl Dag {
    /// `roots` with every leaf that `replacement` knows replaced.
    pub fn substitute(
        &mut self,
        roots: &[NodeId],
        replacement: impl Fn(Leaf) -> Option<NodeId>,
    ) -> Vec<NodeId> {
        let needed = self.reachable(roots);
        let mut replaced: Vec<NodeId> = (0..needed.len() as u32).map(NodeId).collect();
        for i in (0..needed.len()).filter(|&i| needed[i]) {
            replaced[i] = match self.nodes()[i].clone() {
                Node::Constant(_) | Node::Pi => continue,
                Node::Leaf(leaf) => replacement(leaf).unwrap_or(replaced[i]),
                node => self.rebuild(node, |id| replaced[id.index()]),
            };
        }
        roots.iter().map(|r| replaced[r.index()]).collect()
    }

    /// What `roots` of another graph need of it, each leaf as `leaf` gives it: for each node of `from` the one
    /// here, if it is needed.
    pub fn graft(
        &mut self,
        from: &Dag,
        roots: &[NodeId],
        mut leaf: impl FnMut(&mut Dag, Leaf) -> NodeId,
    ) -> Vec<Option<NodeId>> {
        let needed = from.reachable(roots);
        let mut grafted: Vec<Option<NodeId>> = vec![None; needed.len()];
        for i in (0..needed.len()).filter(|&i| needed[i]) {
            let node = match from.nodes()[i].clone() {
                Node::Leaf(l) => leaf(self, l),
                // Operands stand before users, so they are there.
                node => self.rebuild(node, |id| grafted[id.index()].unwrap_or(id)),
            };
            grafted[i] = Some(node);
        }
        grafted
    }

    /// `node` over other operands.
    fn rebuild(&mut self, node: Node, new: impl Fn(NodeId) -> NodeId) -> NodeId {
        match node {
            Node::Constant(value) => self.constant(value),
            Node::Pi => self.pi(),
            Node::Leaf(leaf) => self.leaf(leaf),
            Node::Sum(terms) => {
                let terms = terms.into_iter().map(|(c, n)| (c, new(n)));
                self.sum(terms.collect::<Vec<_>>())
            }
            Node::Product(factors) => {
                let factors = factors.into_iter().map(|(n, e)| (new(n), e));
                self.product(factors.collect::<Vec<_>>())
            }
            Node::Call(function, arguments) => {
                self.call(function, arguments.into_iter().map(new).collect())
            }
        }
    }
}
