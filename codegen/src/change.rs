//! What a step adds to the state, for sums that remember what rounding takes from them.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use num_traits::One;

/// The next state less the known one; `None` if a component of the next state is not the known one plus something,
/// for then the difference would be no more exact than the state.
pub fn change(dag: &mut Dag, next: &[NodeId]) -> Option<Vec<NodeId>> {
    let components = next.iter().enumerate();
    components
        .map(|(i, &next)| {
            let known = dag.leaf(Leaf::State(i));
            let is_sum = match dag.node(next) {
                Node::Sum(terms) => terms.iter().any(|(c, term)| *term == known && c.is_one()),
                _ => next == known,
            };
            is_sum.then(|| dag.sub(next, known))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::change;
    use crate::dag::Dag;
    use crate::dag::Leaf;

    #[test]
    fn only_sums_have_a_change() {
        let mut dag = Dag::new();
        let (x, dx) = (dag.leaf(Leaf::State(0)), dag.leaf(Leaf::Unknown(0)));
        let (sum, product) = (dag.add(x, dx), dag.mul(x, dx));
        assert_eq!(change(&mut dag, &[sum]), Some(vec![dx]));
        assert_eq!(change(&mut dag, &[product]), None);
        let zero = dag.integer(0);
        assert_eq!(change(&mut dag, &[x]), Some(vec![zero]));
        let other = dag.leaf(Leaf::State(1));
        assert_eq!(change(&mut dag, &[other]), None);
    }
}
