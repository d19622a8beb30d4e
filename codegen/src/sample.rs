//! Generic points: fixed pseudo-random values for every input, where two different expressions
//! almost surely differ.

use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;

/// A generic point, given by its number.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    number: u64,
}

impl Sample {
    /// The `number`-th point.
    pub fn generic(number: u64) -> Self {
        Self { number }
    }

    /// The value of an input: parameters, h and t between 0.3 and 1.7, states, unknowns and their variations between
    /// −1 and 1.
    pub fn value(self, leaf: Leaf) -> f64 {
        let (kind, index) = match leaf {
            Leaf::Parameter(i) => (1, i),
            Leaf::StepSize => (2, 0),
            Leaf::Time => (3, 0),
            Leaf::State(i) => (4, i),
            Leaf::Unknown(i) => (5, i),
            Leaf::Variation(i) => (6, i),
        };
        let unit = mix(self.number << 40 ^ kind << 32 ^ index as u64);
        if kind <= 3 {
            0.3 + 1.4 * unit
        } else {
            2.0 * unit - 1.0
        }
    }

    /// The `index`-th of a list of signs, ±1.
    fn sign(self, index: usize) -> f64 {
        let unit = mix(self.number << 40 ^ 7 << 32 ^ index as u64);
        if unit < 0.5 { -1.0 } else { 1.0 }
    }

    /// The same, but with the step `h`.
    pub fn value_with_step(self, leaf: Leaf, h: f64) -> f64 {
        match leaf {
            Leaf::StepSize => h,
            _ => self.value(leaf),
        }
    }

    /// The value of every node at this point.
    pub fn evaluate(self, dag: &Dag) -> Vec<f64> {
        dag.evaluate(|leaf| self.value(leaf))
    }
}

/// Points with the parameters as the file has them, generic otherwise: what is singular there would be so in every run
/// that leaves the parameters alone. Off-diagonal moments of inertia that are 0 are no pivots.
#[derive(Clone, Debug)]
pub struct Typical {
    parameters: Vec<f64>,
}

impl Typical {
    /// The points with these defaults, which are constant.
    pub fn new(dag: &Dag, defaults: &[NodeId]) -> Self {
        Self {
            parameters: dag.tape(defaults).evaluate(|_| f64::NAN),
        }
    }

    /// The value of an input at the `number`-th point, with the step `h`.
    pub fn value(&self, number: u64, leaf: Leaf, h: f64) -> f64 {
        match leaf {
            Leaf::Parameter(i) => self.parameters[i],
            _ => Sample::generic(number).value_with_step(leaf, h),
        }
    }

    /// The value of an input at the `number`-th point, generic but with the sign that a parameter has in the file; t and
    /// parameters that are 0 there have both signs.
    pub fn value_with_sign(&self, number: u64, leaf: Leaf) -> f64 {
        let sample = Sample::generic(number);
        let value = sample.value(leaf);
        match leaf {
            Leaf::Parameter(i) if self.parameters[i] == 0.0 => value * sample.sign(i + 1),
            Leaf::Parameter(i) => value.copysign(self.parameters[i]),
            Leaf::Time => value * sample.sign(0),
            Leaf::StepSize | Leaf::State(_) | Leaf::Unknown(_) | Leaf::Variation(_) => value,
        }
    }
}

/// A number in [0, 1) from the bits of `seed` (SplitMix64: Steele, Lea, Flood 2014).
fn mix(seed: u64) -> f64 {
    let mut z = seed
        .wrapping_mul(0x9E37_79B9_7F4A_7C15)
        .wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^= z >> 31;
    (z >> 11) as f64 / (1u64 << 53) as f64
}
