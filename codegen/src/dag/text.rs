//! Nodes as a person would write them, for reports.

use super::Dag;
use super::Elementary;
use super::Leaf;
use super::Node;
use super::NodeId;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;

/// Longest text of a node; what goes beyond is cut, since a shared node is written out at each use.
const LONGEST: usize = 240;

impl Dag {
    /// `id` in the notation of the language, with `name` for the leaves.
    pub fn text(&self, id: NodeId, name: impl Fn(Leaf) -> String) -> String {
        let needed = self.reachable(&[id]);
        let mut texts: Vec<Text> = Vec::with_capacity(id.index() + 1);
        for (i, node) in self.nodes[..=id.index()].iter().enumerate() {
            let text = if needed[i] {
                write(node, &texts, &name)
            } else {
                Text::default()
            };
            texts.push(text.cut());
        }
        texts.swap_remove(id.index()).text
    }
}

/// How tightly the outermost operator of a text binds.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    #[default]
    Sum,
    Product,
    Power,
    Atom,
}

#[derive(Clone, Default)]
struct Text {
    text: String,
    binding: Binding,
}

impl Text {
    fn atom(text: String) -> Self {
        Self {
            text,
            binding: Binding::Atom,
        }
    }

    fn within(&self, binding: Binding) -> String {
        if self.binding < binding {
            format!("({})", self.text)
        } else {
            self.text.clone()
        }
    }

    fn cut(mut self) -> Self {
        if self.text.chars().count() > LONGEST {
            self.text = self.text.chars().take(LONGEST).chain(['…']).collect();
            self.binding = Binding::Atom;
        }
        self
    }
}

fn write(node: &Node, texts: &[Text], name: &impl Fn(Leaf) -> String) -> Text {
    match node {
        Node::Constant(value) => number(value),
        Node::Pi => Text::atom("π".into()),
        Node::Leaf(leaf) => Text::atom(name(*leaf)),
        Node::Sum(terms) => sum(terms, texts),
        Node::Product(factors) => product(factors, texts),
        Node::Call(Elementary::Power, arguments) => {
            let operands = arguments
                .iter()
                .map(|a| texts[a.index()].within(Binding::Atom));
            Text {
                text: operands.collect::<Vec<_>>().join("^"),
                binding: Binding::Power,
            }
        }
        Node::Call(function, arguments) => {
            let arguments: Vec<_> = arguments
                .iter()
                .map(|a| texts[a.index()].text.clone())
                .collect();
            let (open, close) = (opening(*function), closing(*function));
            Text::atom(format!("{open}{}{close}", arguments.join(", ")))
        }
    }
}

fn number(value: &BigRational) -> Text {
    let binding = if value.is_negative() {
        Binding::Sum
    } else if value.is_integer() {
        Binding::Atom
    } else {
        Binding::Product
    };
    Text {
        text: decimal(value).unwrap_or_else(|| value.to_string()),
        binding,
    }
}

/// `9.81` for 981/100; nothing for 1/2 and where decimals do not end after a few places.
fn decimal(value: &BigRational) -> Option<String> {
    if !value.is_integer() && value.denom() <= &BigInt::from(4) {
        return None;
    }
    let mut scale = BigInt::one();
    for places in 0..=6 {
        let scaled = value * BigRational::from_integer(scale.clone());
        if scaled.is_integer() {
            let digits = format!("{:0>width$}", scaled.to_integer().abs(), width = places + 1);
            let (whole, fraction) = digits.split_at(digits.len() - places);
            let sign = if value.is_negative() { "-" } else { "" };
            let point = if places == 0 { "" } else { "." };
            return Some(format!("{sign}{whole}{point}{fraction}"));
        }
        scale *= 10;
    }
    None
}

fn sum(terms: &[(BigRational, NodeId)], texts: &[Text]) -> Text {
    let mut text = String::new();
    for (i, (coefficient, id)) in terms.iter().enumerate() {
        let operator = match (i, coefficient.is_negative()) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        text.push_str(operator);
        let size = coefficient.abs();
        if size.is_one() {
            text.push_str(&texts[id.index()].within(Binding::Product));
        } else if texts[id.index()].text == "1" {
            text.push_str(&number(&size).text);
        } else {
            text.push_str(&number(&size).text);
            text.push('*');
            text.push_str(&texts[id.index()].within(Binding::Product));
        }
    }
    let scaled = terms.len() == 1 && terms[0].0.is_positive();
    Text {
        text,
        binding: if scaled {
            Binding::Product
        } else {
            Binding::Sum
        },
    }
}

fn product(factors: &[(NodeId, i32)], texts: &[Text]) -> Text {
    let written = |(id, exponent): &(NodeId, i32)| {
        let base = &texts[id.index()];
        match exponent.abs() {
            1 => base.within(Binding::Power),
            power => format!("{}^{power}", base.within(Binding::Atom)),
        }
    };
    let above: Vec<_> = factors.iter().filter(|f| f.1 > 0).map(written).collect();
    let below: Vec<_> = factors.iter().filter(|f| f.1 < 0).map(written).collect();
    let numerator = if above.is_empty() {
        "1".to_string()
    } else {
        above.join("*")
    };
    let text = match below.len() {
        0 => numerator,
        1 => format!("{numerator}/{}", below[0]),
        _ => format!("{numerator}/({})", below.join("*")),
    };
    let power = factors.len() == 1 && factors[0].1 > 0;
    Text {
        text,
        binding: if power {
            Binding::Power
        } else {
            Binding::Product
        },
    }
}

/// What stands before the arguments.
fn opening(function: Elementary) -> String {
    match function {
        Elementary::Sin => "sin(".into(),
        Elementary::Cos => "cos(".into(),
        Elementary::Tan => "tan(".into(),
        Elementary::Asin => "asin(".into(),
        Elementary::Acos => "acos(".into(),
        Elementary::Atan => "atan(".into(),
        Elementary::Atan2 => "atan2(".into(),
        Elementary::Sinh => "sinh(".into(),
        Elementary::Cosh => "cosh(".into(),
        Elementary::Tanh => "tanh(".into(),
        Elementary::Exp => "exp(".into(),
        Elementary::Log => "log(".into(),
        Elementary::Sqrt => "sqrt(".into(),
        Elementary::Abs => "abs(".into(),
        Elementary::Sign => "sign(".into(),
        Elementary::Positive => "max(".into(),
        Elementary::Power => "(".into(),
        Elementary::Stumpff(n) => format!("stumpff({n}, "),
    }
}

/// What stands behind them.
fn closing(function: Elementary) -> &'static str {
    match function {
        Elementary::Positive => ", 0)",
        _ => ")",
    }
}
