use super::*;
use crate::dag::Leaf;
use crate::sample::Sample;

/// Every elementary function, with arguments inside its domain at the sample points.
fn every_function(dag: &mut Dag) -> Vec<NodeId> {
    let (x, y) = (dag.leaf(Leaf::Unknown(0)), dag.leaf(Leaf::Unknown(1)));
    let two = dag.integer(2);
    let positive = dag.add(two, x);
    let small = dag.scale(BigRational::new(1.into(), 3.into()), x);
    let stumpff = [0, 1, 2, 3].map(Elementary::Stumpff);
    let unary = Elementary::UNARY.into_iter().chain(stumpff);
    let of = |function| match function {
        Elementary::Log | Elementary::Sqrt => positive,
        _ => small,
    };
    let mut roots: Vec<NodeId> = unary.map(|f| dag.call(f, vec![of(f)])).collect();
    roots.push(dag.call(Elementary::Power, vec![positive, y]));
    roots.push(dag.call(Elementary::Atan2, vec![y, positive]));
    let product = dag.product([(x, 3), (y, 2), (positive, -2)]);
    roots.push(product);
    let sin = dag.call(Elementary::Sin, vec![product]);
    roots.push(dag.mul(sin, positive));
    roots
}

#[test]
fn derivatives_match_central_differences() {
    let mut dag = Dag::new();
    let roots = every_function(&mut dag);
    let entries = differentiate(&mut dag, &roots, 2);
    // Step and bound of a central difference: error h²/6 f''' + ε/h f at h = 1e-5.
    let (step, bound) = (1e-5, 1e-8);
    for number in 0..20 {
        let point = Sample::generic(number);
        let exact = point.evaluate(&dag);
        for (row, root) in roots.iter().enumerate() {
            for col in 0..2 {
                let shifted = |by: f64| {
                    let leaf =
                        |l: Leaf| point.value(l) + if l == Leaf::Unknown(col) { by } else { 0.0 };
                    dag.evaluate(leaf)[root.index()]
                };
                let difference = (shifted(step) - shifted(-step)) / (2.0 * step);
                let entry = entries.iter().find(|e| e.row == row && e.col == col);
                let found = entry.map_or(0.0, |e| exact[e.node.index()]);
                assert!(
                    (found - difference).abs() <= bound * difference.abs().max(1.0),
                    "root {row}, unknown {col}: {found} {difference}"
                );
            }
        }
    }
}

#[test]
fn what_does_not_depend_has_no_entry() {
    let mut dag = Dag::new();
    let (x, y) = (dag.leaf(Leaf::Unknown(0)), dag.leaf(Leaf::Unknown(1)));
    let state = dag.leaf(Leaf::State(0));
    let first = dag.mul(x, state);
    let cancelled = dag.sub(y, y);
    let second = dag.add(cancelled, x);
    let entries = differentiate(&mut dag, &[first, second], 2);
    let places: Vec<_> = entries.iter().map(|e| (e.row, e.col)).collect();
    assert_eq!(places, [(0, 0), (1, 0)]);
    assert_eq!(entries[0].node, state);
}

/// Nested functions: x ↦ sin(x) repeated. The derivative must grow linearly, not exponentially.
#[test]
fn derivative_of_a_nested_graph_is_linear_in_its_size() {
    let mut sizes = Vec::new();
    for depth in [100, 200, 400] {
        let mut dag = Dag::new();
        let x = dag.leaf(Leaf::Unknown(0));
        let mut node = x;
        for _ in 0..depth {
            let sin = dag.call(Elementary::Sin, vec![node]);
            node = dag.add(sin, node);
            node = dag.mul(node, node);
        }
        differentiate(&mut dag, &[node], 1);
        sizes.push(dag.nodes().len());
    }
    assert!(
        sizes[2] - sizes[1] <= 2 * (sizes[1] - sizes[0]) + 100,
        "{sizes:?}"
    );
}

/// As `abs` has the mean of its slopes at its kink, so has max(x, 0).
#[test]
fn slopes_beside_and_at_the_kink() {
    let mut dag = Dag::new();
    let x = dag.leaf(Leaf::Unknown(0));
    let positive = dag.call(Elementary::Positive, vec![x]);
    let entries = differentiate(&mut dag, &[positive], 1);
    for (at, slope) in [(-1e-300, 0.0), (0.0, 0.5), (1e-300, 1.0)] {
        assert_eq!(dag.evaluate(|_| at)[entries[0].node.index()], slope);
    }
}
