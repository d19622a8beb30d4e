//! The recurrences of elementary functions.

use super::Builder;
use super::part::Part;
use super::refusal;
use crate::dag::Elementary;
use crate::dag::NodeId;
use crate::normal::rational;

impl Builder {
    /// f(a, …), the node `id`.
    pub(super) fn call(
        &mut self,
        id: NodeId,
        function: Elementary,
        arguments: &[NodeId],
    ) -> Result<Option<NodeId>, String> {
        if let Some(known) = self.companions.get(&id) {
            return Ok(Some(*known));
        }
        let a = self.part(arguments[0]);
        if function == Elementary::Atan2 {
            let x = self.part(arguments[1]);
            return Ok(self.angle(id, a, x));
        }
        if function == Elementary::Power {
            let exponent = self.part(arguments[1]);
            return Ok(Some(self.power(id, a, exponent)));
        }
        let Some(newest) = a.newest else {
            return Ok(None);
        };
        Ok(Some(match function {
            Elementary::Sqrt => return Ok(self.root(a).newest),
            Elementary::Exp => self.exponential(id, newest),
            Elementary::Log => self.with_quotient(id, newest, a),
            Elementary::Sin => self.turn(a.value, newest, [function, Elementary::Cos], -1)[0],
            Elementary::Cos => self.turn(a.value, newest, [Elementary::Sin, function], -1)[1],
            Elementary::Sinh => self.turn(a.value, newest, [function, Elementary::Cosh], 1)[0],
            Elementary::Cosh => self.turn(a.value, newest, [Elementary::Sinh, function], 1)[1],
            Elementary::Tan => self.tangent(id, newest, 1),
            Elementary::Tanh => self.tangent(id, newest, -1),
            Elementary::Atan => {
                let below = self.one_and_square(a, 1);
                self.with_quotient(id, newest, below)
            }
            Elementary::Asin => {
                let below = self.one_and_square(a, -1);
                let root = self.root(below);
                self.with_quotient(id, newest, root)
            }
            Elementary::Acos => {
                let below = self.one_and_square(a, -1);
                let root = self.root(below);
                let opposite = self.dag.neg(newest);
                self.with_quotient(id, opposite, root)
            }
            Elementary::Abs | Elementary::Sign | Elementary::Positive | Elementary::Stumpff(_) => {
                return Err(refusal(function));
            }
            Elementary::Atan2 | Elementary::Power => unreachable!("functions of two arguments"),
        }))
    }

    /// y with y' d = a'
    fn with_quotient(&mut self, value: NodeId, a: NodeId, d: Part) -> NodeId {
        let part = self.integral_of_quotient(value, a, d);
        part.newest.expect("a series by construction")
    }

    /// 1 ± a²
    fn one_and_square(&mut self, a: Part, sign: i64) -> Part {
        let square = self.times(a, a);
        let one = self.dag.integer(1);
        let terms = [(rational(1), one), (rational(sign), square.value)];
        Part {
            value: self.dag.sum(terms),
            newest: square.newest.map(|n| self.dag.scale(rational(sign), n)),
        }
    }

    /// y₀ aₙ u + ⟨D a, u⟩/n with the lane for u, which is `partner`.
    fn integral(&mut self, partner: NodeId, a: NodeId) -> (usize, NodeId) {
        let (lane, inner) = self.reserve();
        let inner = self.over_order(inner);
        let outer = self.dag.mul(partner, a);
        (lane, self.dag.add(outer, inner))
    }

    fn exponential(&mut self, id: NodeId, a: NodeId) -> NodeId {
        let (lane, newest) = self.integral(id, a);
        self.lanes[lane] = [self.weighted(a), newest];
        newest
    }

    /// s and c with s' = c a', c' = ± s a'.
    fn turn(&mut self, angle: NodeId, a: NodeId, pair: [Elementary; 2], sign: i64) -> [NodeId; 2] {
        let [sin, cos] = pair.map(|f| self.dag.call(f, vec![angle]));
        let (first, sine) = self.integral(cos, a);
        let (second, opposite) = self.integral(sin, a);
        let cosine = self.dag.scale(rational(sign), opposite);
        let weighted = self.weighted(a);
        self.lanes[first] = [weighted, cosine];
        self.lanes[second] = [weighted, sine];
        self.companions.insert(sin, sine);
        self.companions.insert(cos, cosine);
        [sine, cosine]
    }

    /// y with y' = (1 ± y²) a'
    fn tangent(&mut self, id: NodeId, a: NodeId, sign: i64) -> NodeId {
        let square = self.dag.mul(id, id);
        let one = self.dag.integer(1);
        let slope = self.dag.sum([(rational(1), one), (rational(sign), square)]);
        let (lane, newest) = self.integral(slope, a);
        let part = Part {
            value: id,
            newest: Some(newest),
        };
        let slope = self.one_and_square(part, sign);
        let slope = slope.newest.expect("a series by construction");
        self.lanes[lane] = [self.weighted(a), slope];
        newest
    }

    /// atan2(y, x): φ' (x² + y²) = x y' − y x'.
    fn angle(&mut self, id: NodeId, y: Part, x: Part) -> Option<NodeId> {
        if y.newest.is_none() && x.newest.is_none() {
            return None;
        }
        let squares = [self.times(x, x), self.times(y, y)];
        let zero = self.dag.integer(0);
        let newest = squares.map(|s| s.newest.unwrap_or(zero));
        let below = Part {
            value: self.dag.add(squares[0].value, squares[1].value),
            newest: Some(self.dag.add(newest[0], newest[1])),
        };
        let [left, right] = [(y, x), (x, y)].map(|(a, b)| self.moment(a, b));
        let above = self.dag.sub(left, right);
        Some(self.with_quotient(id, above, below))
    }

    /// Order n of ∫ b a': aₙ b₀ + ⟨D a, b⟩/n
    fn moment(&mut self, a: Part, b: Part) -> NodeId {
        let Some(newest) = a.newest else {
            return self.dag.integer(0);
        };
        let Some(other) = b.newest else {
            return self.dag.mul(newest, b.value);
        };
        let (lane, sum) = self.integral(b.value, newest);
        self.lanes[lane] = [self.weighted(newest), other];
        sum
    }

    /// a^c: p' a = c a' p for a fixed exponent, and exp(c ln a) else.
    fn power(&mut self, id: NodeId, a: Part, exponent: Part) -> NodeId {
        if let (Some(base), None) = (a.newest, exponent.newest) {
            return self.fixed_power(id, [a.value, base], exponent.value);
        }
        let value = self.dag.call(Elementary::Log, vec![a.value]);
        let log = match a.newest {
            Some(newest) => self.integral_of_quotient(value, newest, a),
            None => Part::fixed(value),
        };
        let product = self.times(exponent, log);
        let zero = self.dag.integer(0);
        self.exponential(id, product.newest.unwrap_or(zero))
    }

    fn fixed_power(&mut self, id: NodeId, [base, a]: [NodeId; 2], exponent: NodeId) -> NodeId {
        let (up, rising) = self.integral(id, a);
        let (down, falling) = self.reserve();
        let falling = self.over_order(falling);
        let rising = self.dag.mul(exponent, rising);
        let rest = self.dag.sub(rising, falling);
        let inverse = self.inverse(base);
        let newest = self.dag.mul(rest, inverse);
        self.lanes[up] = [self.weighted(a), newest];
        self.lanes[down] = [self.weighted(newest), a];
        newest
    }
}
