//! What holds for any expression: the normal form keeps its value, its derivative is that of dual numbers, what is printed
//! reads back; and the same file always becomes the same code.

use core::ops::Add;
use core::ops::Mul;

use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use residua::Scalar;
use residua_codegen::Quantity;
use residua_codegen::compile;
use residua_codegen::compile_scene;
use residua_codegen::dag::Dag;
use residua_codegen::dag::Elementary;
use residua_codegen::dag::Leaf;
use residua_codegen::dag::NodeId;
use residua_codegen::dag::Number;
use residua_codegen::differentiate::differentiate;
use residua_codegen::evaluate;
use residua_codegen::model::Shape;
use residua_codegen::source::read_scene;
use residua_codegen::source::read_source;
use residua_models::CATALOGUE;
use residua_models::SCENES;
use residua_models::exact::Double;
use residua_models::find;
use residua_tools::stress::Running;

/// An expression as somebody wrote it.
#[derive(Clone, Debug)]
enum Tree {
    Input(usize),
    Constant(i32, i32),
    Add(Box<Tree>, Box<Tree>),
    Subtract(Box<Tree>, Box<Tree>),
    Multiply(Box<Tree>, Box<Tree>),
    Divide(Box<Tree>, Box<Tree>),
    Power(Box<Tree>, i32),
    Call(Elementary, Box<Tree>, Option<Box<Tree>>),
}

/// The names of the inputs.
const INPUTS: [&str; 3] = ["a", "b", "c"];

/// Functions of one argument.
fn unary() -> impl Strategy<Value = Elementary> {
    let stumpff = [0, 1, 3].map(Elementary::Stumpff);
    let all: Vec<_> = Elementary::UNARY.into_iter().chain(stumpff).collect();
    proptest::sample::select(all)
}

fn trees() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        3 => (0..INPUTS.len()).prop_map(Tree::Input),
        1 => (-6..=6, 1..=5).prop_map(|(above, below)| Tree::Constant(above, below)),
    ];
    leaf.prop_recursive(6, 40, 2, |inner| {
        let one = inner.clone().prop_map(Box::new);
        let two = (one.clone(), one.clone());
        prop_oneof![
            two.clone().prop_map(|(a, b)| Tree::Add(a, b)),
            two.clone().prop_map(|(a, b)| Tree::Subtract(a, b)),
            two.clone().prop_map(|(a, b)| Tree::Multiply(a, b)),
            two.clone().prop_map(|(a, b)| Tree::Divide(a, b)),
            (one.clone(), -3..=4).prop_map(|(a, n)| Tree::Power(a, n)),
            (unary(), one.clone()).prop_map(|(f, a)| Tree::Call(f, a, None)),
            (
                proptest::sample::select(&[Elementary::Atan2, Elementary::Power]),
                two
            )
                .prop_map(|(f, (a, b))| Tree::Call(f, a, Some(b))),
        ]
    })
}

fn inputs() -> impl Strategy<Value = [f64; 3]> {
    let number = prop_oneof![8 => -3.0..3.0_f64, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-2.0)];
    [number.clone(), number.clone(), number]
}

impl Tree {
    /// As it is written, one operation after the other.
    fn evaluate<N: Number>(&self, inputs: &[N; 3]) -> N {
        let of = |tree: &Tree| tree.evaluate(inputs);
        match self {
            Tree::Input(i) => inputs[*i],
            Tree::Constant(above, below) => {
                let below = N::constant((*below).into(), 0.0).power(-1);
                N::constant((*above).into(), 0.0) * below
            }
            Tree::Add(a, b) => of(a) + of(b),
            Tree::Subtract(a, b) => of(a) + N::constant(-1.0, 0.0) * of(b),
            Tree::Multiply(a, b) => of(a) * of(b),
            Tree::Divide(a, b) => of(a) * of(b).power(-1),
            Tree::Power(a, 0) => of(a).power(1) * N::constant(0.0, 0.0) + N::constant(1.0, 0.0),
            Tree::Power(a, n) => of(a).power(*n),
            Tree::Call(function, a, b) => N::call(*function, of(a), b.as_ref().map(|b| of(b))),
        }
    }

    /// In normal form.
    fn build(&self, dag: &mut Dag) -> NodeId {
        match self {
            Tree::Input(i) => dag.leaf(Leaf::Unknown(*i)),
            Tree::Constant(above, below) => {
                dag.constant(BigRational::new(BigInt::from(*above), BigInt::from(*below)))
            }
            Tree::Add(a, b) => both(dag, a, b, Dag::add),
            Tree::Subtract(a, b) => both(dag, a, b, Dag::sub),
            Tree::Multiply(a, b) => both(dag, a, b, Dag::mul),
            Tree::Divide(a, b) => both(dag, a, b, Dag::div),
            Tree::Power(a, n) => {
                let (base, exponent) = (a.build(dag), dag.integer((*n).into()));
                dag.power(base, exponent)
            }
            Tree::Call(Elementary::Power, a, Some(b)) => both(dag, a, b, Dag::power),
            Tree::Call(function, a, b) => {
                let mut arguments = vec![a.build(dag)];
                arguments.extend(b.as_ref().map(|b| b.build(dag)));
                dag.call(*function, arguments)
            }
        }
    }
}

fn both(
    dag: &mut Dag,
    a: &Tree,
    b: &Tree,
    operation: impl Fn(&mut Dag, NodeId, NodeId) -> NodeId,
) -> NodeId {
    let (a, b) = (a.build(dag), b.build(dag));
    operation(dag, a, b)
}

fn at<N: Copy>(inputs: [N; 3]) -> impl Fn(Leaf) -> N {
    move |leaf| match leaf {
        Leaf::Unknown(i) => inputs[i],
        leaf => panic!("no input: {leaf:?}"),
    }
}

/// A value in 31 digits and how far `f64` would be from it; `None` where it is none or has lost half of its digits.
fn sound(value: Double, running: Running<f64>) -> Option<(Double, f64)> {
    let size = value.to_f64().abs();
    let is_sound = value.is_finite() && running.error <= 1e-8 * (1.0 + size) && size < 1e8;
    is_sound.then_some((value, running.error))
}

/// Numbers with a derivative, in 31 digits: ε² = 0 (Clifford, 1873). The rules are written out from the definition of each
/// function.
#[derive(Clone, Copy, Debug)]
struct Dual {
    value: Double,
    slope: Double,
}

impl Dual {
    fn chain(self, value: Double, slope: Double) -> Self {
        Self {
            value,
            slope: slope * self.slope,
        }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slope: self.value * other.slope + self.slope * other.value,
        }
    }
}

impl Number for Dual {
    fn constant(high: f64, low: f64) -> Self {
        Self {
            value: <Double as Number>::constant(high, low),
            slope: Double::from(0.0),
        }
    }

    fn power(self, exponent: i32) -> Self {
        let slope = match exponent {
            1 => Double::from(1.0),
            n => Double::from(f64::from(n)) * self.value.power(n - 1),
        };
        self.chain(self.value.power(exponent), slope)
    }

    fn call(function: Elementary, x: Self, y: Option<Self>) -> Self {
        let a = x.value;
        let one = Double::from(1.0);
        let two = Double::from(2.0);
        let value = Double::call(function, a, y.map(|y| y.value));
        match (function, y) {
            (Elementary::Atan2, Some(x_axis)) => {
                let (sine, cosine) = (x, x_axis);
                let square = a * a + cosine.value * cosine.value;
                let slope = (cosine.value * sine.slope - a * cosine.slope) / square;
                Self { value, slope }
            }
            (Elementary::Power, Some(exponent)) => {
                // aᵇ = exp(b ln a).
                let slope = value * (exponent.slope * Scalar::ln(a) + exponent.value * x.slope / a);
                Self { value, slope }
            }
            (Elementary::Sin, _) => x.chain(value, Scalar::cos(a)),
            (Elementary::Cos, _) => x.chain(value, -Scalar::sin(a)),
            (Elementary::Tan, _) => x.chain(value, one / (Scalar::cos(a) * Scalar::cos(a))),
            (Elementary::Asin, _) => x.chain(value, one / Scalar::cos(value)),
            (Elementary::Acos, _) => x.chain(value, -one / Scalar::sin(value)),
            (Elementary::Atan, _) => x.chain(value, one / (one + a * a)),
            (Elementary::Sinh, _) => x.chain(value, Scalar::cosh(a)),
            (Elementary::Cosh, _) => x.chain(value, Scalar::sinh(a)),
            (Elementary::Tanh, _) => x.chain(value, one / (Scalar::cosh(a) * Scalar::cosh(a))),
            (Elementary::Exp, _) => x.chain(value, value),
            (Elementary::Log, _) => x.chain(value, one / a),
            (Elementary::Sqrt, _) => x.chain(value, one / (two * value)),
            (Elementary::Abs, _) => x.chain(value, Scalar::sign(a)),
            (Elementary::Sign, _) => x.chain(value, Double::from(0.0)),
            (Elementary::Positive, _) => x.chain(value, (one + Scalar::sign(a)) / two),
            (Elementary::Stumpff(n), _) => {
                // By the quotient that defines it away from 0: s cₙ'(s) = (cₙ₋₁ − n cₙ)/2, and for n = 0 −c₁/2.
                let slope = match n {
                    0 => -Scalar::stumpff(a, 1) / two,
                    n => {
                        let multiple = Double::from(f64::from(n)) * value;
                        (Scalar::stumpff(a, n - 1) - multiple) / (two * a)
                    }
                };
                x.chain(value, slope)
            }
            (function, _) => unreachable!("{function:?} has two arguments"),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 4000,
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(20220412),
        max_global_rejects: 100_000,
        ..ProptestConfig::default()
    })]

    /// Both are 10¹⁰ times closer than `f64` would bring them.
    #[test]
    fn the_normal_form_keeps_the_value(tree in trees(), inputs in inputs()) {
        let mut dag = Dag::new();
        let root = tree.build(&mut dag);
        dag.verify().unwrap();
        let written = sound(
            tree.evaluate(&inputs.map(Double::from)),
            tree.evaluate(&inputs.map(Running::<f64>::exact)),
        );
        prop_assume!(written.is_some());
        let (expected, error) = written.unwrap();
        let value = dag.tape_of(&[root]).evaluate(at(inputs.map(Double::from)))[0];
        let off = (value - expected).to_f64().abs();
        prop_assert!(off <= 1e-10 * (error + 1e-16), "{} is {value:?}, not {expected:?}", text(&dag, root));
    }

    /// Where the derivative keeps half of its digits, dual numbers of twice as many find the same.
    #[test]
    fn derivatives_are_those_of_dual_numbers(tree in trees(), inputs in inputs(), by in 0..3_usize) {
        let mut dag = Dag::new();
        let root = tree.build(&mut dag);
        let entries = differentiate(&mut dag, &[root], INPUTS.len());
        let node = entries.iter().find(|entry| entry.col == by).map(|entry| entry.node);
        let node = node.unwrap_or_else(|| dag.integer(0));
        let written = sound(
            tree.evaluate(&inputs.map(Double::from)),
            tree.evaluate(&inputs.map(Running::<f64>::exact)),
        );
        let derived = sound(
            dag.tape_of(&[node]).evaluate(at(inputs.map(Double::from)))[0],
            dag.tape_of(&[node]).evaluate(at(inputs.map(Running::<f64>::exact)))[0],
        );
        prop_assume!(written.is_some() && derived.is_some());
        let mut duals = inputs.map(|x| Dual { value: Double::from(x), slope: Double::from(0.0) });
        duals[by].slope = Double::from(1.0);
        let expected = tree.evaluate(&duals).slope;
        prop_assume!(expected.is_finite());
        let (value, error) = derived.unwrap();
        let off = (value - expected).to_f64().abs();
        let most = error + 1e-12 * (1.0 + value.to_f64().abs());
        prop_assert!(off <= most, "{}: {value:?}, not {expected:?}", text(&dag, node));
    }

    /// Read as a value on the command line.
    #[test]
    fn what_is_printed_reads_back(tree in trees(), inputs in inputs()) {
        let mut dag = Dag::new();
        let root = tree.build(&mut dag);
        let text = text(&dag, root);
        prop_assume!(!text.contains('…'));
        let expected = dag.tape_of(&[root]).evaluate(at(inputs.map(Running::<f64>::exact)))[0];
        let exact = dag.tape_of(&[root]).evaluate(at(inputs.map(Double::from)))[0];
        prop_assume!(sound(exact, expected).is_some());
        let quantity = |name| Quantity { name, shape: Shape::SCALAR, unit: "1" };
        let symbols: Vec<_> = INPUTS.iter().zip(&inputs).map(|(name, x)| (quantity(name), core::slice::from_ref(x))).collect();
        let symbols: Vec<_> = symbols.iter().map(|(q, x)| (*q, *x)).collect();
        let read = evaluate(&text, quantity("y"), &symbols);
        prop_assert!(read.is_ok(), "{text}: {read:?}");
        let off = (read.unwrap()[0] - exact.to_f64()).abs();
        prop_assert!(off <= 2.0 * expected.error + 1e-15 * (1.0 + exact.to_f64().abs()), "{text}");
    }
}

fn text(dag: &Dag, root: NodeId) -> String {
    dag.text(root, |leaf| match leaf {
        Leaf::Unknown(i) => INPUTS[i].to_owned(),
        leaf => format!("{leaf:?}"),
    })
}

/// Hash maps of the generator are seeded anew for each; none of that shows.
#[test]
fn files_always_become_the_same_code() {
    for entry in CATALOGUE {
        let code = || compile(entry.name(), read_source(entry.source.as_bytes()).unwrap());
        let [first, second] =
            [code(), code()].map(|code| code.map_err(|_| ()).unwrap().to_string());
        assert!(first == second, "{}", entry.name());
    }
    let read = |model: &str| {
        find(model)
            .map(|entry| entry.source.to_owned())
            .map_err(|e| e.to_string())
    };
    for entry in SCENES {
        let code = || {
            compile_scene(
                entry.name(),
                read_scene(entry.source.as_bytes()).unwrap(),
                &read,
            )
        };
        let [first, second] =
            [code(), code()].map(|code| code.map_err(|_| ()).unwrap().to_string());
        assert!(first == second, "{}", entry.name());
    }
}
