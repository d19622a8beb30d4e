use super::*;
use crate::dag::Leaf;
use crate::dag::Number;
use crate::sample::Sample;

fn x(dag: &mut Dag, i: usize) -> NodeId {
    dag.leaf(Leaf::State(i))
}

fn ratio(a: i64, b: i64) -> BigRational {
    BigRational::new(a.into(), b.into())
}

#[test]
fn sums_cancel_and_collect() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let sum = dag.add(a, b);
    assert_eq!(dag.sub(sum, a), b);
    let twice = dag.add(a, a);
    assert_eq!(twice, dag.scale(rational(2), a));
    let nothing = dag.sub(sum, sum);
    assert!(dag.is_zero(nothing));
}

#[test]
fn multiples_of_a_sum_share_it() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let difference = dag.sub(a, b);
    let reverse = dag.sub(b, a);
    let mean = dag.sum([(ratio(1, 2), a), (ratio(-1, 2), b)]);
    assert_eq!(dag.split_coefficient(reverse), (rational(-1), difference));
    assert_eq!(dag.split_coefficient(mean), (ratio(1, 2), difference));
    let decimal = dag.scale(ratio(981, 100), difference);
    assert_eq!(
        dag.split_coefficient(decimal),
        (ratio(981, 100), difference)
    );
}

#[test]
fn products_collect_powers_and_roots() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let product = dag.mul(a, b);
    assert_eq!(dag.div(product, b), a);
    let root = dag.call(Elementary::Sqrt, vec![product]);
    assert_eq!(dag.mul(root, root), product);
    let three = dag.integer(3);
    let scaled = dag.mul(product, three);
    assert_eq!(dag.split_coefficient(scaled), (rational(3), product));
}

#[test]
fn roots_of_squares_are_magnitudes() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let root = |dag: &mut Dag, factors: &[(NodeId, i32)], scale: i64| {
        let product = dag.product(factors.iter().copied());
        let scaled = dag.scale(rational(scale), product);
        dag.call(Elementary::Sqrt, vec![scaled])
    };
    let magnitude = dag.call(Elementary::Abs, vec![a]);
    assert_eq!(root(&mut dag, &[(a, 2)], 1), magnitude);
    let thrice = dag.scale(rational(3), magnitude);
    assert_eq!(root(&mut dag, &[(a, 2)], 9), thrice);
    let expected = dag.product([(magnitude, 3), (b, -2)]);
    assert_eq!(root(&mut dag, &[(a, 6), (b, -4)], 1), expected);
    for kept in [
        root(&mut dag, &[(a, 2), (b, 1)], 1),
        root(&mut dag, &[(a, 2)], -1),
    ] {
        assert!(matches!(dag.node(kept), Node::Call(Elementary::Sqrt, _)));
    }
}

#[test]
fn functions_are_exact_where_their_values_are() {
    let mut dag = Dag::new();
    let pi = dag.pi();
    let half_turn = dag.scale(ratio(1, 2), pi);
    let cos = dag.call(Elementary::Cos, vec![half_turn]);
    let sin = dag.call(Elementary::Sin, vec![half_turn]);
    assert!(dag.is_zero(cos));
    assert_eq!(sin, dag.integer(1));
    let nine_quarters = dag.constant(ratio(9, 4));
    let root = dag.call(Elementary::Sqrt, vec![nine_quarters]);
    assert_eq!(dag.as_constant(root), Some(&ratio(3, 2)));
    let zero = dag.integer(0);
    let c3 = dag.call(Elementary::Stumpff(3), vec![zero]);
    assert_eq!(dag.as_constant(c3), Some(&ratio(1, 6)));
}

#[test]
fn odd_and_even_functions_take_no_sign() {
    let mut dag = Dag::new();
    let a = x(&mut dag, 0);
    let minus = dag.neg(a);
    let (sin, cos) = (Elementary::Sin, Elementary::Cos);
    let (plus_sin, minus_sin) = (dag.call(sin, vec![a]), dag.call(sin, vec![minus]));
    assert_eq!(minus_sin, dag.neg(plus_sin));
    assert_eq!(dag.call(cos, vec![a]), dag.call(cos, vec![minus]));
}

#[test]
fn towers_of_powers_stay_bounded() {
    let mut dag = Dag::new();
    let sixty_four = dag.integer(64);
    let mut tower = dag.constant(ratio(981, 100));
    for _ in 0..20 {
        tower = dag.power(tower, sixty_four);
    }
    let a = x(&mut dag, 0);
    let mut leaf_tower = a;
    for _ in 0..20 {
        leaf_tower = dag.power(leaf_tower, sixty_four);
    }
    assert_eq!(dag.verify(), Ok(()));
}

/// |x| ± x and max(x, 0) − x, for x an input, a sum and multiples of it, at any scale and in any order.
#[test]
fn one_sided_sums_are_one_function() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let difference = dag.sub(a, b);
    let scaled = dag.scale(ratio(7, 10), difference);
    let (minus_a, minus) = (dag.neg(a), dag.neg(scaled));
    for x in [a, minus_a, difference, scaled, minus] {
        let opposite = dag.neg(x);
        let abs = dag.call(Elementary::Abs, vec![x]);
        let [above, below] = [x, opposite].map(|x| dag.call(Elementary::Positive, vec![x]));
        for scale in [ratio(1, 2), ratio(-1, 2), ratio(-3, 7)] {
            let twice = &scale * rational(2);
            let folds = [
                (abs, 1, (twice.clone(), above)),
                (abs, -1, (twice, below)),
                (above, -1, (scale.clone(), below)),
                (below, 1, (scale.clone(), above)),
            ];
            for (f, sign, (factor, expected)) in folds {
                let terms = [(scale.clone(), f), (&scale * rational(sign), x)];
                let expected = dag.scale(factor, expected);
                assert_eq!(dag.sum(terms.clone()), expected);
                assert_eq!(dag.sum(terms.into_iter().rev()), expected);
            }
        }
    }
    assert_eq!(dag.verify(), Ok(()));
}

#[test]
fn other_sums_with_one_sided_parts_stay_sums() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let abs = dag.call(Elementary::Abs, vec![a]);
    let positive = dag.call(Elementary::Positive, vec![a]);
    let sin = dag.call(Elementary::Sin, vec![a]);
    let twice = dag.scale(rational(2), a);
    let others = [
        (abs, b),
        (abs, twice),
        (positive, a),
        (positive, b),
        (sin, a),
    ];
    for (f, x) in others {
        let sum = dag.add(f, x);
        assert_eq!(dag.sub(sum, x), f);
        assert!(matches!(dag.node(sum), Node::Sum(terms) if terms.len() == 2));
    }
}

/// A chain in which each sum contains the one before must not cost the square of its length.
#[test]
fn chains_of_sums_stay_linear() {
    let mut dag = Dag::new();
    let mut sum = x(&mut dag, 0);
    for i in 1..2000 {
        let next = x(&mut dag, i);
        let square = dag.mul(next, next);
        sum = dag.add(sum, square);
    }
    let terms: usize = dag
        .nodes()
        .iter()
        .map(|n| match n {
            Node::Sum(terms) => terms.len(),
            _ => 0,
        })
        .sum();
    assert!(terms < 2000 * 2 * MERGED, "{terms} terms");
}

/// Random expressions: the constructors must give the value of the plain computation.
#[test]
fn normal_form_preserves_values() {
    let mut bits = 0x2545_F491_4F6C_DD1D_u64;
    let mut random = move |n: u64| {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        (bits >> 11) % n
    };
    let point = Sample::generic(3);
    for _ in 0..300 {
        let mut dag = Dag::new();
        let mut nodes: Vec<(NodeId, f64)> = (0..4)
            .map(|i| (x(&mut dag, i), point.value(Leaf::State(i))))
            .collect();
        for _ in 0..40 {
            let (a, va) = nodes[random(nodes.len() as u64) as usize];
            let (b, vb) = nodes[random(nodes.len() as u64) as usize];
            let c = random(7) as i64 - 3;
            let new = match random(7) {
                0 => (dag.add(a, b), va + vb),
                1 => (dag.sub(a, b), va - vb),
                2 => (dag.mul(a, b), va * vb),
                3 => (dag.scale(ratio(c, 2), a), c as f64 / 2.0 * va),
                4 => (dag.call(Elementary::Sin, vec![a]), va.sin()),
                5 => (dag.call(Elementary::Cos, vec![a]), va.cos()),
                _ => (dag.call(Elementary::Stumpff(2), vec![b]), {
                    let root = vb.abs().sqrt();
                    if vb.abs() < 1e-6 {
                        0.5
                    } else if vb > 0.0 {
                        (1.0 - root.cos()) / vb
                    } else {
                        (1.0 - root.cosh()) / vb
                    }
                }),
            };
            if new.1.abs() < 1e6 {
                nodes.push(new);
            }
        }
        assert_eq!(dag.verify(), Ok(()));
        let values = point.evaluate(&dag);
        for (id, expected) in nodes {
            let found = values[id.index()];
            // Forty operations on numbers below 1e6, some of them cancelling.
            assert!(
                (found - expected).abs() <= 1e-7 * expected.abs().max(1.0),
                "{found} {expected}"
            );
        }
    }
}

/// Functions of exact numbers and of parts of π are numbers where they are known to be, and no other ones.
#[test]
fn functions_of_numbers_are_what_they_are() {
    let stumpff = [0, 3].map(Elementary::Stumpff);
    let unary = Elementary::UNARY.into_iter().chain(stumpff);
    let numbers = [
        (-9, 4),
        (-2, 1),
        (-1, 1),
        (0, 1),
        (1, 4),
        (1, 2),
        (1, 1),
        (2, 1),
        (9, 4),
    ];
    let check = |dag: &Dag, root: NodeId, exact: f64, what: &str| {
        let found = dag.evaluate(|_| f64::NAN)[root.index()];
        let is_right = (found - exact).abs() <= 1e-14 * exact.abs().max(1.0);
        assert!(is_right || !exact.is_finite(), "{what}: {found} {exact}");
    };
    for function in unary {
        for (above, below) in numbers {
            let mut dag = Dag::new();
            let value = above as f64 / below as f64;
            let number = dag.constant(ratio(above, below));
            let root = dag.call(function, vec![number]);
            let exact = f64::call(function, value, None);
            check(&dag, root, exact, &format!("{function:?} {value}"));
            let pi = dag.pi();
            let root = dag.scale(ratio(above, below), pi);
            let root = dag.call(function, vec![root]);
            let exact = f64::call(function, value * core::f64::consts::PI, None);
            if exact.abs() < 1e10 {
                check(&dag, root, exact, &format!("{function:?} {value} π"));
            }
        }
    }
    for (y, x) in [(0, 1), (0, -1), (1, 0), (-1, 0), (2, 3), (0, 2)] {
        let mut dag = Dag::new();
        let arguments = vec![dag.integer(y), dag.integer(x)];
        let root = dag.call(Elementary::Atan2, arguments);
        let exact = f64::atan2(y as f64, x as f64);
        check(&dag, root, exact, &format!("atan2({y}, {x})"));
    }
}

#[test]
fn what_is_known_is_folded() {
    let mut dag = Dag::new();
    let (zero, one) = (dag.integer(0), dag.integer(1));
    for function in [
        Elementary::Sin,
        Elementary::Tan,
        Elementary::Asin,
        Elementary::Atan,
        Elementary::Sinh,
        Elementary::Tanh,
        Elementary::Sqrt,
    ] {
        assert_eq!(dag.call(function, vec![zero]), zero, "{function:?}");
    }
    for function in [Elementary::Cos, Elementary::Cosh, Elementary::Exp] {
        assert_eq!(dag.call(function, vec![zero]), one, "{function:?}");
    }
    for function in [Elementary::Log, Elementary::Acos] {
        assert_eq!(dag.call(function, vec![one]), zero, "{function:?}");
    }
    let (quarters, halves) = (dag.constant(ratio(9, 4)), dag.constant(ratio(3, 2)));
    assert_eq!(dag.call(Elementary::Sqrt, vec![quarters]), halves);
    assert_eq!(dag.call(Elementary::Atan2, vec![zero, one]), zero);
}

#[test]
fn powers_of_products_and_halves_keep_their_value() {
    let mut dag = Dag::new();
    let (a, b) = (x(&mut dag, 0), x(&mut dag, 1));
    let product = dag.mul(a, b);
    let cube = dag.product([(product, 3)]);
    let exponent = dag.constant(ratio(3, 2));
    let root = dag.power(a, exponent);
    let values = dag.evaluate(|leaf| if leaf == Leaf::State(0) { 4.0 } else { 3.0 });
    assert_eq!(values[cube.index()], 1728.0);
    assert_eq!(values[root.index()], 8.0);
    let inverse = dag.product([(product, -2), (a, 2)]);
    assert_eq!(inverse, dag.product([(b, -2)]));
}

#[test]
fn numbers_beyond_all_measure_are_rounded() {
    let mut dag = Dag::new();
    let third = dag.constant(BigRational::new(1.into(), 3.into()));
    let long = dag.constant(BigRational::new((i64::MAX - 1).into(), i64::MAX.into()));
    let (mut product, mut sum) = (third, third);
    for _ in 0..300 {
        product = dag.mul(product, long);
        sum = dag.add(sum, product);
    }
    let value = |number: &BigRational| number.to_f64().expect("a number");
    let exact = (1.0 / 3.0) * (-300.0 / (i64::MAX as f64)).exp();
    let found = dag.as_constant(product).expect("a number");
    assert!(
        found.numer().bits() + found.denom().bits() <= BITS,
        "{found}"
    );
    assert!((value(found) - exact).abs() <= f64::EPSILON * exact);
    let found = value(dag.as_constant(sum).expect("a number"));
    let exact = 301.0 / 3.0;
    assert!((found - exact).abs() <= 4.0 * f64::EPSILON * exact);
}
