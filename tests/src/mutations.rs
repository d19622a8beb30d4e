//! Ways to break the code that some test must notice, one at a time: every derivative rule, every rule of the normal
//! form, every outcome of Newton's method, and how a step moves the state on.
//!
//! `cargo run --release -p residua-tests --example mutate` breaks them and writes `tests/MUTATIONS.md`.

/// A mistake to make.
#[derive(Debug)]
pub struct Mutation {
    /// What it breaks.
    pub rule: &'static str,
    /// In which file.
    pub file: &'static str,
    /// A text that occurs there once.
    pub from: &'static str,
    /// What to put in its place.
    pub to: &'static str,
}

const fn mutation(
    rule: &'static str,
    file: &'static str,
    from: &'static str,
    to: &'static str,
) -> Mutation {
    Mutation {
        rule,
        file,
        from,
        to,
    }
}

const DERIVATIVES: &str = "codegen/src/differentiate.rs";
const NORMAL: &str = "codegen/src/normal.rs";
const CALLS: &str = "codegen/src/normal/calls.rs";
const ONE_SIDED: &str = "codegen/src/normal/one_sided.rs";
const THOROUGH: &str = "runtime/src/newton/thorough.rs";
const DAMPING: &str = "runtime/src/newton/damping.rs";
const NEWTON: &str = "runtime/src/newton.rs";
const RATE: &str = "runtime/src/newton/rate.rs";
const STEPPER: &str = "runtime/src/stepper.rs";
const SHIFTS: &str = "runtime/src/shifts.rs";
const UNKNOWNS: &str = "runtime/src/resolution/unknowns.rs";
const EQUATIONS: &str = "runtime/src/resolution/equations.rs";
const ROUNDED: &str = "runtime/src/scalar/rounded.rs";
const CONTEXT: &str = "codegen/src/lower/context.rs";

/// All of them.
#[rustfmt::skip]
pub const ALL: &[Mutation] = &[
    // Derivatives.
    mutation("an input has the derivative 1", DERIVATIVES, "Node::Leaf(_) => dag.integer(1)", "Node::Leaf(_) => dag.integer(2)"),
    mutation("a sum keeps its coefficients", DERIVATIVES, "Some((c.clone(), of(*n)?))", "Some((BigRational::one(), of(*n)?))"),
    mutation("a product has a term for every factor", DERIVATIVES, "(0..factors.len())\n                .filter_map", "(0..1)\n                .filter_map"),
    mutation("a power brings its exponent down", DERIVATIVES, "(rational(exponent.into()), dag.product(term))", "(rational(1), dag.product(term))"),
    mutation("a power lowers its exponent", DERIVATIVES, "term[i].1 -= 1;", "term[i].1 -= 0;"),
    mutation("the chain rule multiplies by the inner derivative", DERIVATIVES, "dag.mul(outer, inner)", "outer"),
    mutation("sin' = cos", DERIVATIVES, "Elementary::Sin => dag.call(Elementary::Cos, vec![x])", "Elementary::Sin => dag.call(Elementary::Sin, vec![x])"),
    mutation("cos' = −sin", DERIVATIVES, "dag.neg(sin)", "sin"),
    mutation("tan' = 1 + tan²", DERIVATIVES, "let square = dag.mul(tan, tan);\n            dag.add(one, square)", "let square = dag.mul(tan, tan);\n            dag.sub(one, square)"),
    mutation("asin' = 1/√(1 − x²)", DERIVATIVES, "let complement = dag.sub(one, square);", "let complement = dag.add(one, square);"),
    mutation("acos' = −asin'", DERIVATIVES, "dag.neg(positive)", "positive"),
    mutation("atan' = 1/(1 + x²)", DERIVATIVES, "let below = dag.add(one, square);\n            dag.product([(below, -1)])", "let below = dag.add(one, square);\n            dag.product([(below, -2)])"),
    mutation("∂atan2/∂y = x/(x² + y²)", DERIVATIVES, "if i == 0 { x } else { dag.neg(y) }", "if i == 0 { y } else { dag.neg(y) }"),
    mutation("∂atan2/∂x = −y/(x² + y²)", DERIVATIVES, "if i == 0 { x } else { dag.neg(y) }", "if i == 0 { x } else { y }"),
    mutation("sinh' = cosh", DERIVATIVES, "Elementary::Sinh => dag.call(Elementary::Cosh, vec![x])", "Elementary::Sinh => dag.call(Elementary::Sinh, vec![x])"),
    mutation("cosh' = sinh", DERIVATIVES, "Elementary::Cosh => dag.call(Elementary::Sinh, vec![x])", "Elementary::Cosh => dag.call(Elementary::Cosh, vec![x])"),
    mutation("tanh' = 1 − tanh²", DERIVATIVES, "let square = dag.mul(tanh, tanh);\n            dag.sub(one, square)", "let square = dag.mul(tanh, tanh);\n            dag.add(one, square)"),
    mutation("exp' = exp", DERIVATIVES, "Elementary::Exp => dag.call(Elementary::Exp, vec![x])", "Elementary::Exp => one"),
    mutation("log' = 1/x", DERIVATIVES, "Elementary::Log => dag.product([(x, -1)])", "Elementary::Log => dag.product([(x, -2)])"),
    mutation("√' = 1/(2√)", DERIVATIVES, "dag.scale(BigRational::new(1.into(), 2.into()), inverse)", "inverse"),
    mutation("abs' = sign", DERIVATIVES, "Elementary::Abs => dag.call(Elementary::Sign, vec![x])", "Elementary::Abs => one"),
    mutation("sign' = 0", DERIVATIVES, "Elementary::Sign => dag.integer(0)", "Elementary::Sign => dag.integer(1)"),
    mutation("max(x, 0)' = (1 + sign)/2", DERIVATIVES, "let twice = dag.add(one, sign);", "let twice = dag.sub(one, sign);"),
    mutation("∂x^y/∂x = y x^(y−1)", DERIVATIVES, "let lower = dag.sub(y, one);", "let lower = dag.add(y, one);"),
    mutation("∂x^y/∂y = x^y ln x", DERIVATIVES, "dag.mul(power, log)", "power"),
    mutation("cₙ' has the term n/2 cₙ₊₂", DERIVATIVES, "BigRational::new(n.into(), 2.into())", "BigRational::new(n.into(), 3.into())"),
    mutation("cₙ' has the term −1/2 cₙ₊₁", DERIVATIVES, "BigRational::new((-1).into(), 2.into())", "BigRational::new(1.into(), 2.into())"),
    // What derivatives do not tell.
    mutation("an unknown in a function is not eliminated from it", "codegen/src/eliminate/candidates.rs", "couplings[row][col] |= (curved >> unknown & 1) << col;", "couplings[row][col] |= (curved >> unknown & 0) << col;"),
    mutation("equations are solved after all that is in them", "codegen/src/structure.rs", "pairs.chain(needs)", "pairs.chain(needs.take(0))"),
    mutation("a flow has no functions of its rates", "codegen/src/explicit.rs", "if is_curved || stands_in_function {", "if is_curved {"),
    // The normal form.
    mutation("a − b subtracts", NORMAL, "(-BigRational::one(), b)])", "(BigRational::one(), b)])"),
    mutation("−a is −1 a", NORMAL, "self.scale(-BigRational::one(), a)", "self.scale(BigRational::one(), a)"),
    mutation("a multiple of a number is a number", NORMAL, "let value = times(value, coefficient);", "let value = value + coefficient;"),
    mutation("a multiple of a multiple multiplies", NORMAL, "let coefficient = times(&coefficient, inner);\n        if coefficient.is_zero()", "if coefficient.is_zero()"),
    mutation("a/b divides", NORMAL, "self.product([(a, 1), (b, -1)])", "self.product([(a, 1), (b, 1)])"),
    mutation("a sum in a sum is merged with its coefficient", NORMAL, "(times(&outer, inner), core)", "(inner, core)"),
    mutation("equal terms are added up", NORMAL, "Some(last) if last.1 == id => last.0 = shortened(&last.0 + coefficient)", "Some(last) if last.1 == id => last.0 -= coefficient"),
    mutation("a multiple of a sum is multiplied out", NORMAL, ".map(|(c, n)| (times(c, coefficient.clone()), *n))", ".map(|(c, n)| (c.clone(), *n))"),
    mutation("the content −1 turns signs", NORMAL, "terms.into_iter().map(|(c, n)| (-c, n)).collect()", "terms"),
    mutation("terms are divided by their content", NORMAL, "BigRational::from_integer(above * (content.denom() / c.denom()))", "BigRational::from_integer(above)"),
    mutation("numbers in a product are taken out", NORMAL, "Node::Constant(value) if folds(value, exponent) => {\n                    coefficient = times(&coefficient, power(value, exponent));", "Node::Constant(value) if folds(value, exponent) => {\n                    coefficient = times(&coefficient, value.clone());"),
    mutation("the coefficient of a factor is raised with it", NORMAL, "coefficient = times(&coefficient, power(&terms[0].0, exponent));", "coefficient = times(&coefficient, terms[0].0.clone());"),
    mutation("a product in a product is raised with it", NORMAL, "(*n, e * exponent)", "(*n, *e)"),
    mutation("√x √x = x", NORMAL, "open.push((argument[0], total / 2));", "open.push((argument[0], total));"),
    mutation("exponents of a factor add up", NORMAL, "Some(factor) => factor.1 += exponent", "Some(factor) => factor.1 = exponent"),
    mutation("0 times anything is 0", NORMAL, "if coefficient.is_zero() {\n            return self.integer(0);", "if coefficient.is_zero() {\n            return self.integer(1);"),
    mutation("a^(n/2) is a root to the n", CALLS, "return self.product([(root, halves)]);", "return self.product([(root, 1)]);"),
    mutation("a^n is a product", CALLS, "return self.product([(base, whole)]);", "return self.product([(base, 2)]);"),
    mutation("√n² is the size of n", CALLS, "if root.1 % 2 != 0", "if root.1 % 2 == 0"),
    mutation("what is no square keeps its root", CALLS, "if !is_square || coefficient", "if coefficient"),
    mutation("odd functions give their sign back", CALLS, "return if parity(function) == Parity::Odd {", "return if parity(function) == Parity::Even {"),
    mutation("arguments of odd and even functions lose their sign", CALLS, "let positive = self.scale(-coefficient, core);", "let positive = self.scale(coefficient, core);"),
    mutation("sin 0 and its kin are 0", CALLS, "| Elementary::Tanh => x.is_zero().then(BigRational::zero)", "| Elementary::Tanh => x.is_zero().then(BigRational::one)"),
    mutation("cosh 0 = exp 0 = 1", CALLS, "Elementary::Cosh | Elementary::Exp => x.is_zero().then(BigRational::one)", "Elementary::Cosh | Elementary::Exp => x.is_zero().then(BigRational::zero)"),
    mutation("log 1 = acos 1 = 0", CALLS, "Elementary::Log | Elementary::Acos => x.is_one().then(BigRational::zero)", "Elementary::Log | Elementary::Acos => x.is_one().then(BigRational::one)"),
    mutation("atan2(0, positive) = 0", CALLS, "(x.is_zero() && right).then(BigRational::zero)", "x.is_zero().then(BigRational::zero)"),
    mutation("roots of squares are exact", CALLS, "(&root * &root == *x).then_some(root)", "Some(root)"),
    mutation("abs of a number", CALLS, "Elementary::Abs => Some(x.abs())", "Elementary::Abs => Some(x.clone())"),
    mutation("sign of a number", CALLS, "Elementary::Sign => Some(x.signum())", "Elementary::Sign => Some(x.abs())"),
    mutation("max(x, 0) of a number", CALLS, "Elementary::Positive => Some(x.max(&BigRational::zero()).clone())", "Elementary::Positive => Some(x.clone())"),
    mutation("cₙ(0) = 1/n!", CALLS, "(1..=n).map(BigInt::from).product()", "(1..n).map(BigInt::from).product()"),
    mutation("sin and cos at quarter turns", CALLS, "let shift = if function == Elementary::Sin { 0 } else { 1 };", "let shift = if function == Elementary::Sin { 0 } else { 3 };"),
    mutation("content takes a common factor, not any", NORMAL, "small.iter().fold(0, |g, t| t.0.gcd(&g))", "small.iter().fold(0, |g, t| t.0.max(g))"),
    mutation("what vanishes on one side is one function", NORMAL, "if let Some(folded) = self.one_sided(&terms, one) {", "if let (true, Some(folded)) = (terms.len() == 2, self.one_sided(&terms, one)) {"),
    mutation("abs(x) + x = 2 max(x, 0)", ONE_SIDED, "Elementary::Abs => (&[1, -1], 2)", "Elementary::Abs => (&[1, -1], 1)"),
    mutation("abs(x) − x = 2 max(−x, 0)", ONE_SIDED, "if is_same { x } else { self.neg(x) }", "x"),
    mutation("max(x, 0) + x is no function of one side", ONE_SIDED, "Elementary::Positive => (&[-1], 1)", "Elementary::Positive => (&[1, -1], 1)"),
    mutation("x and f(x) of one function of one side have one factor", ONE_SIDED, "terms.contains(&(times(c, signed.clone()), *core))", "terms.iter().any(|term| term.1 == *core)"),
    mutation("max(x, 0) has a kink", "codegen/src/schedule.rs", "Elementary::Abs | Elementary::Sign | Elementary::Positive", "Elementary::Abs | Elementary::Sign"),
    // Newton's method: how each outcome is reached.
    mutation("a correction is subtracted", NEWTON, "*x = *x - *correction;", "*x = *x + *correction;"),
    mutation("quick corrections must be enough", NEWTON, "all & (c.abs() <= *enough)", "all | (c.abs() <= *enough)"),
    mutation("a first correction is not trusted if it is a surprise", NEWTON, "all & ((c.abs() <= times * before.abs()) | (c.abs() <= *harmless))", "all & ((c.abs() <= times * before.abs()) | (*harmless <= c.abs()))"),
    mutation("a later correction is vouched for by the one before", NEWTON, "\n                && self.is_settled(known, &x, &before, &correction)\n", "\n"),
    mutation("the next correction is told by the last two", RATE, "e * e * e <= T::constant(RATE_MARGIN) * tolerance * before * before", "e * e * e <= T::constant(RATE_MARGIN) * tolerance"),
    mutation("what is enough shrinks with the unknown", NEWTON, "all & (c.abs() <= *enough) & (c.abs() <= *part * *scale)", "all & (c.abs() <= *enough) & (*part * *scale >= T::constant(0.0))"),
    mutation("a correction that ends a step alone is small", RATE, "(T::constant(RATE_MARGIN) * tolerance).sqrt()", "T::constant(RATE_MARGIN).sqrt()"),
    mutation("a correction that may have crossed a kink is smaller", RATE, "true => tolerance,", "true => tolerance.sqrt(),"),
    mutation("corrections whose rounding grows are not trusted", NEWTON, "(growth <= most_growth::<T>()).then_some(correction)", "(growth >= T::constant(0.0)).then_some(correction)"),
    mutation("what a solver learnt is forgotten with the state", NEWTON, "self.shifts = Shifts::new(self.x);\n        self.trust = 0;", ""),
    mutation("not finite: residual", THOROUGH, "            require_finite(&self.r)?;\n", ""),
    mutation("not finite: unknowns", THOROUGH, "            require_finite(&self.x)?;\n", ""),
    mutation("an infinite slope is no convergence", THOROUGH, "self.j.entries().iter().any(is_infinite)", "false"),
    mutation("singular", THOROUGH, "self.j.solve(&self.r).ok_or(Failure::Singular)?", "self.j.solve(&self.r).unwrap_or(self.r)"),
    mutation("converged: within the tolerance", THOROUGH, "let within = length <= self.settings.tolerance * scale;", "let within = length <= T::constant(1e-3) * scale;"),
    mutation("converged: a first correction within it needs a smaller residual", THOROUGH, "fell.all(|fell| fell) || self.residual_is_rounding(known)", "fell.all(|_| true) || self.residual_is_rounding(known)"),
    mutation("converged: by the rate of two corrections", RATE, "is_telling(before) && e * e <= T::constant(RATE_MARGIN) * tolerance * before", "is_telling(before) && e * e <= T::constant(1e4) * tolerance * before"),
    mutation("converged: only corrections near the solution tell the rate", RATE, "is_telling(before) && e * e <=", "e * e <="),
    mutation("at the floor: the residual is rounding", THOROUGH, "self.residual_is_rounding(known)\n                && self", "self"),
    mutation("at the floor: unknowns have digits", THOROUGH, "self.residual_is_rounding(known)\n                && self.undetermined(&correction, known).is_none()", "self.residual_is_rounding(known)"),
    mutation("diverged", THOROUGH, "return Err(Failure::Diverged);", "return Err(Failure::Stalled);"),
    mutation("diverged: only consecutive growths count", THOROUGH, "                growths = 0;\n", ""),
    mutation("corrections that make the residual larger are shortened", DAMPING, "if squares(&r) <= most {", "if true {"),
    mutation("a shortened correction is shorter", DAMPING, "part = T::constant(0.5) * part;", "part = T::constant(1.0) * part;"),
    mutation("the reason of a failure is that of whole corrections", THOROUGH, "        self.history = history;\n        Err(fault)", "        Err(self.fault(Failure::Stalled))"),
    mutation("stalled", THOROUGH, "        Err(Failure::Stalled)\n    }\n\n    /// Whether the residual after", "        Err(Failure::Diverged)\n    }\n\n    /// Whether the residual after"),
    mutation("blame: what is not finite comes first", THOROUGH, "if let Some((row, value)) = first_not_finite(r) {", "if let Some((row, value)) = first_not_finite(r).filter(|_| false) {"),
    mutation("blame: the largest residual", THOROUGH, "if value.abs() > most {\n            (largest", "if value.abs() < most {\n            (largest"),
    // How a step moves the state on.
    mutation("a failed step leaves the state", STEPPER, "        require_finite(&next)?;\n        check(", "        (*state, *lost) = (next, lost_then);\n        require_finite(&next)?;\n        check("),
    mutation("what is eliminated must be known", STEPPER, "if !is_trusted::<S, T>(scene, &step, &x) {", "if false {"),
    mutation("what follows from the unknowns must be known", STEPPER, "if times > most_growth::<T>() {", "if false {"),
    mutation("equations must be resolved by the format", STEPPER, "if !self.is_within_reach(&next)\n", "if false\n"),
    mutation("an edge is no lack of digits", UNKNOWNS, "is_another(&down, i) && (", "is_another(&down, i) || ("),
    mutation("a row that vanishes is resolved", UNKNOWNS, " && is_saturated(i)", ""),
    mutation("an equation that loses its digits is refused", EQUATIONS, "return Some(drowned(Place::Equation(i), times));", "continue;"),
    mutation("what is eliminated does not lose its digits", EQUATIONS, "return Some(drowned(Place::State(i), times));", "continue;"),
    mutation("data that move by a few ε make up for rounding", EQUATIONS, "error <= T::constant(ROUNDING) * T::EPSILON * size + T::LEAST", "error < T::constant(0.0)"),
    mutation("an update is computed as it stands", EQUATIONS, ".filter(|i| solver.solves_for(*i))", ".filter(|_| true)"),
    mutation("an iterate that is rounding solves the equations", EQUATIONS, "holds.all(|holds| holds)", "holds.all(|_| true)"),
    mutation("an iterate that is rounding is one of few", EQUATIONS, "(0..n).all(|i| is_told(&j, r, i, n))", "true"),
    mutation("errors of a sum add up", ROUNDED, "Self::of(self.value + other.value, self.error + other.error)", "Self::of(self.value + other.value, self.error - other.error)"),
    mutation("errors of a product are magnified by its factors", ROUNDED, "self.value.abs() * other.error + other.value.abs() * self.error", "self.error + other.error"),
    mutation("errors of a quotient are divided", ROUNDED, "Self::of(quotient, inherited / other.value.abs())", "Self::of(quotient, inherited)"),
    mutation("errors of a function follow its slope", ROUNDED, "error: change + own,", "error: own,"),
    mutation("every operation rounds", ROUNDED, "error: inherited + own,", "error: inherited,"),
    mutation("time goes on", "runtime/src/integration.rs", "if t0 + h == t0 {", "if false {"),
    mutation("a state that has grown is looked at again", STEPPER, "all & (x.abs() < *reach)", "all & (*reach >= T::constant(0.0)) & x.is_finite()"),
    mutation("starts of a run of steps are those of each step", SHIFTS, "self.rest = self.all_but_last(self.order, 0);", "self.rest = self.all_but_last(self.order, 1);"),
    mutation("what is eliminated must fulfil all equations", STEPPER, "            if S::HAS_CORE {\n                full.check(t, state, next)", "            if false {\n                full.check(t, state, next)"),
    mutation("sums of increments remember their rounding", STEPPER, "return compensated_sums(state, &change, lost);", "return (compensated_sums(state, &change, lost).0, *lost);"),
    mutation("without `update` the state becomes x[k+1]", CONTEXT, "None => next.extend(self.at_level(i, Level::Next).entries)", "None => next.extend(self.at_level(i, Level::Half).entries)"),
    mutation("with `update` it becomes that", CONTEXT, "Some(update) => next.extend(self.components(update, state.variable.shape))", "Some(_) => next.extend(self.known(i).entries)"),
    mutation("a change is what is added", "codegen/src/change.rs", "is_sum.then(|| dag.sub(next, known))", "is_sum.then(|| dag.add(next, known))"),
    mutation("the guess of x[k+1] is x", CONTEXT, "guesses.extend(self.known(i).entries);", "guesses.extend(vec![self.dag.integer(1); shape.len()]);"),
    // Data and their requirements.
    mutation("A > B: positive definite", "runtime/src/requirement.rs", "let is_positive = pivot > zero;", "let is_positive = k > 0 || pivot > zero;"),
    mutation("A > B: symmetric", "runtime/src/requirement.rs", "if !is_symmetric {", "if false {"),
    mutation("A >= B: may be singular", "runtime/src/requirement.rs", "Relation::GreaterOrEqual => (left, right, 1.0)", "Relation::GreaterOrEqual => (left, right, -1.0)"),
    mutation("a < b: all components", "runtime/src/requirement.rs", "left.iter().zip(right).all(|(a, b)|", "left.iter().zip(right).any(|(a, b)|"),
];
