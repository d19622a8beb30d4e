use super::stage;
use crate::dag::Dag;
use crate::dag::Elementary;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::normal::rational;
use crate::schedule::Count;
use crate::schedule::Op;
use crate::schedule::Schedule;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// Splitting reorders sums and products; nested powers in random graphs amplify the rounding, a wrong
/// value would be off in its first digits.
const ROUNDING: f64 = 1e-9;

fn parameter(dag: &mut Dag, i: usize) -> NodeId {
    dag.leaf(Leaf::Parameter(i))
}

fn state(dag: &mut Dag, i: usize) -> NodeId {
    dag.leaf(Leaf::State(i))
}

fn unknown(dag: &mut Dag, i: usize) -> NodeId {
    dag.leaf(Leaf::Unknown(i))
}

fn iteration(dag: &Dag, roots: Vec<NodeId>) -> Schedule {
    stage(dag, &[("residual", Rate::Iteration, roots)])
}

fn count(schedule: &Schedule, kernel: &str) -> Count {
    schedule.count(schedule.kernel(kernel).unwrap())
}

fn leaf_value(leaf: Leaf) -> f64 {
    match leaf {
        Leaf::Parameter(i) => 1.25 + 0.375 * i as f64,
        Leaf::StepSize => 0.1,
        Leaf::Time => 0.7,
        Leaf::State(i) => 0.5 - 0.3 * i as f64,
        Leaf::Unknown(i) => -0.2 + 0.45 * i as f64,
        Leaf::Variation(_) => f64::NAN,
    }
}

/// What emitted code computes, value by value.
fn evaluate(schedule: &Schedule) -> Vec<f64> {
    let mut known: Vec<f64> = Vec::new();
    for value in &schedule.values {
        let at = |v: &ValueId| known[v.index()];
        let number = |c: &BigRational| c.to_f64().unwrap();
        known.push(match &value.op {
            Op::Constant(c) => number(c),
            Op::Pi => std::f64::consts::PI,
            Op::Leaf(leaf) => leaf_value(*leaf),
            Op::Sum(terms) => terms.iter().map(|(c, v)| number(c) * at(v)).sum(),
            Op::Product {
                coefficient,
                numerator,
                denominator,
            } => {
                let above: f64 = numerator.iter().map(at).product();
                number(coefficient) * above / denominator.iter().map(at).product::<f64>()
            }
            Op::Call(Elementary::Sin, x) => at(&x[0]).sin(),
            Op::Call(Elementary::Cos, x) => at(&x[0]).cos(),
            Op::Call(other, _) => unreachable!("no test graph calls {other:?}"),
        });
    }
    known
}

fn assert_preserves(dag: &Dag, roots: &[NodeId]) {
    let schedule = iteration(dag, roots.to_vec());
    let expected = dag.evaluate(leaf_value);
    let found = evaluate(&schedule);
    for (node, value) in roots
        .iter()
        .zip(&schedule.kernel("residual").unwrap().roots)
    {
        let (expected, found) = (expected[node.index()], found[value.index()]);
        let scale = expected.abs().max(1.0);
        assert!(
            (expected - found).abs() <= ROUNDING * scale,
            "{expected} became {found}"
        );
    }
}

#[test]
fn coefficient_goes_to_the_slowest_factors() {
    let mut dag = Dag::new();
    let (h, m) = (dag.leaf(Leaf::StepSize), parameter(&mut dag, 0));
    let x = unknown(&mut dag, 0);
    let product = dag.product([(h, 1), (m, 1), (x, 1)]);
    let root = dag.scale(rational(2), product);
    let schedule = iteration(&dag, vec![root]);
    assert_eq!(schedule.scene.len(), 1);
    assert_eq!(schedule.step.len(), 0);
    let Op::Product {
        coefficient,
        numerator,
        ..
    } = &schedule.value(schedule.scene[0]).op
    else {
        panic!("the scene holds a product");
    };
    assert_eq!((coefficient, numerator.len()), (&rational(2), 2));
    let expected = Count {
        multiplications: 1,
        ..Count::default()
    };
    assert_eq!(count(&schedule, "residual"), expected);
}

#[test]
fn slower_terms_are_added_up_before() {
    let mut dag = Dag::new();
    let (p, q) = (parameter(&mut dag, 0), parameter(&mut dag, 1));
    let (s, x) = (state(&mut dag, 0), unknown(&mut dag, 0));
    let terms = [p, q, s, x].map(|n| (rational(1), n));
    let root = dag.sum(terms);
    let schedule = iteration(&dag, vec![root]);
    for kernel in ["scene", "step", "residual"] {
        assert_eq!(count(&schedule, kernel).additions, 1, "{kernel}");
    }
    assert_eq!((schedule.scene.len(), schedule.step.len()), (1, 1));
}

#[test]
fn division_by_a_parameter_is_a_cached_reciprocal() {
    let mut dag = Dag::new();
    let inertia = parameter(&mut dag, 0);
    let (x, y) = (unknown(&mut dag, 0), unknown(&mut dag, 1));
    let root = dag.product([(x, 1), (inertia, -1), (y, -2)]);
    let schedule = iteration(&dag, vec![root]);
    assert_eq!(count(&schedule, "scene").divisions, 1);
    assert_eq!(count(&schedule, "residual").divisions, 1);
    assert_preserves(&dag, &[root]);
}

#[test]
fn common_divisor_is_divided_by_once() {
    let mut dag = Dag::new();
    let [x, y, z] = [0, 1, 2].map(|i| unknown(&mut dag, i));
    let roots = [dag.div(x, z), dag.div(y, z)];
    let schedule = iteration(&dag, roots.to_vec());
    assert_eq!(count(&schedule, "residual").divisions, 1);
    assert_preserves(&dag, &roots);
}

#[test]
fn powers_of_one_divisor_take_one_division() {
    let mut dag = Dag::new();
    let [x, y] = [0, 1].map(|i| unknown(&mut dag, i));
    let roots = [
        dag.product([(x, 1), (y, -1)]),
        dag.product([(x, 2), (y, -2)]),
        dag.product([(y, -3)]),
    ];
    let schedule = iteration(&dag, roots.to_vec());
    assert_eq!(count(&schedule, "residual").divisions, 1);
    assert_preserves(&dag, &roots);
}

#[test]
fn terms_of_equal_weight_are_added_up_first() {
    let mut dag = Dag::new();
    let (now, next) = (state(&mut dag, 0), unknown(&mut dag, 0));
    let x = unknown(&mut dag, 1);
    let terms = [(4, next), (-4, now), (1, x)].map(|(c, n)| (rational(c), n));
    let root = dag.sum(terms);
    let schedule = iteration(&dag, vec![root]);
    let expected = Count {
        additions: 2,
        multiplications: 1,
        ..Count::default()
    };
    assert_eq!(count(&schedule, "residual"), expected);
    assert_eq!(count(&schedule, "step"), Count::default());
    assert_preserves(&dag, &[root]);
}

#[test]
fn signs_are_taken_into_sums_and_never_cached() {
    let mut dag = Dag::new();
    let (p, s) = (parameter(&mut dag, 0), state(&mut dag, 0));
    let (x, y) = (unknown(&mut dag, 0), unknown(&mut dag, 1));
    let terms = [(1, x), (-2, y), (-3, s)].map(|(c, n)| (rational(c), n));
    let sum = dag.sum(terms);
    let roots = vec![sum, dag.neg(p), p];
    let schedule = iteration(&dag, roots.clone());
    assert_eq!(schedule.scene.len(), 1);
    let root = schedule.kernel("residual").unwrap().roots[0];
    assert!(!schedule.value(root).op.is_negation());
    assert_preserves(&dag, &roots);
}

#[test]
fn powers_share_their_squares() {
    let mut dag = Dag::new();
    let x = unknown(&mut dag, 0);
    let roots: Vec<_> = [2, 4, 5, 7].map(|e| dag.product([(x, e)])).to_vec();
    let schedule = iteration(&dag, roots.clone());
    // x², (x²)², x·x⁴, and x·x²·x⁴ = (x·x⁴)·x².
    assert_eq!(count(&schedule, "residual").multiplications, 4);
    assert_preserves(&dag, &roots);
}

#[test]
fn common_pairs_are_computed_once() {
    let mut dag = Dag::new();
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| unknown(&mut dag, i));
    let products = [
        dag.product([(a, 1), (b, 1), (c, 1)]),
        dag.product([(a, 1), (b, 1), (d, 1)]),
    ];
    let schedule = iteration(&dag, products.to_vec());
    assert_eq!(count(&schedule, "residual").multiplications, 3);
    let minus = rational(-1);
    let left = dag.sum([(rational(1), a), (minus.clone(), b), (rational(1), c)]);
    let right = dag.sum([(minus, a), (rational(1), b), (rational(1), d)]);
    let schedule = iteration(&dag, vec![left, right]);
    assert_eq!(count(&schedule, "residual").additions, 3);
    assert_preserves(&dag, &[products[0], products[1], left, right]);
}

#[test]
fn nothing_is_cached_that_faster_code_does_not_use() {
    let mut dag = Dag::new();
    let (p, q) = (parameter(&mut dag, 0), parameter(&mut dag, 1));
    let (s, x) = (state(&mut dag, 0), unknown(&mut dag, 0));
    let unused = dag.mul(p, q);
    let step = dag.product([(p, 1), (q, 1), (s, 1)]);
    let root = dag.add(step, x);
    let schedule = iteration(&dag, vec![root]);
    // Only p·q, which the step needs, and p·q·s, which the residual needs: no p, q or s.
    assert_eq!((schedule.scene.len(), schedule.step.len()), (1, 1));
    assert_eq!(dag.rate(unused), Rate::Scene);
}

#[test]
fn numbers_are_never_cached() {
    let mut dag = Dag::new();
    let x = unknown(&mut dag, 0);
    let number = dag.constant(BigRational::new(981.into(), 100.into()));
    let roots = vec![dag.add(x, number), number];
    let schedule = iteration(&dag, roots.clone());
    assert!(schedule.scene.is_empty());
    assert_preserves(&dag, &roots);
}

#[test]
fn opposite_differences_are_one_value() {
    let mut dag = Dag::new();
    let (now, next) = (state(&mut dag, 0), unknown(&mut dag, 0));
    let roots = vec![dag.sub(now, next), dag.sub(next, now)];
    let schedule = iteration(&dag, roots.clone());
    assert_eq!(count(&schedule, "residual").additions, 1);
    assert_preserves(&dag, &roots);
}

#[test]
fn random_graphs_keep_their_values_and_their_bytes() {
    for seed in 0..60 {
        let (dag, roots) = random_graph(seed);
        assert_preserves(&dag, &roots);
        let texts = [0, 1].map(|_| format!("{:?}", iteration(&dag, roots.clone())));
        assert_eq!(texts[0], texts[1]);
    }
}

/// Sums, products and sines of earlier nodes, chosen by a linear congruential generator.
fn random_graph(seed: u64) -> (Dag, Vec<NodeId>) {
    let mut random = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut below = move |n: usize| {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (random >> 33) as usize % n
    };
    let mut dag = Dag::new();
    let mut nodes = vec![
        dag.leaf(Leaf::StepSize),
        dag.leaf(Leaf::Time),
        dag.integer(3),
        dag.pi(),
    ];
    for i in 0..3 {
        nodes.extend([
            parameter(&mut dag, i),
            state(&mut dag, i),
            unknown(&mut dag, i),
        ]);
    }
    for _ in 0..40 {
        let [a, b, c] = [0, 1, 2].map(|_| nodes[below(nodes.len())]);
        let numbers = [1, -1, 2, 3].map(rational);
        let node = match below(4) {
            0 => dag.sum([a, b, c].map(|n| (numbers[below(4)].clone(), n))),
            1 => dag.product([(a, 1), (b, 1 + below(2) as i32)]),
            2 => dag.call(Elementary::Sin, vec![a]),
            _ => {
                // 2 + cos b is safe to divide by.
                let cos = dag.call(Elementary::Cos, vec![b]);
                let two = dag.integer(2);
                let divisor = dag.add(two, cos);
                dag.product([(c, 1), (divisor, -1 - below(2) as i32)])
            }
        };
        let sine = dag.call(Elementary::Sin, vec![node]);
        nodes.push(if below(3) == 0 { sine } else { node });
    }
    let roots = nodes.split_off(nodes.len() - 12);
    (dag, roots)
}
