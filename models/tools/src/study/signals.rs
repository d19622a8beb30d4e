//! What a component of a model is, told by its course and not by its name.
//!
//! Two models of one body may call the same thing θ, atan2(Γ.x, Γ.y) or 4 atan η. Along the continuous
//! equations from one start they take the same values, whatever they are called; so that is how they are
//! matched. An angle counted in full turns is not one that jumps by 2π; their sines and cosines are equal.

use super::case::Case;
use super::distance::largest_size;
use residua::description::Variable;
use residua::erased::Sample;
use residua::erased::Scheme;
use residua_models::values::size;
use std::ops::ControlFlow;

/// Steps per second of the runs that signals are matched on.
const FINENESS: f64 = 4000.0;
/// Instants of such a run at which signals are compared.
const LOOKS: u64 = 64;
/// Largest difference of equal signals, relative to the size of their variables: RK4 with that step leaves 1e-12
/// of slow motions and 1e-5 of a body that turns at 100 rad/s for 10 s.
const EQUAL: f64 = 1e-4;
/// Smallest change of a signal that says something, relative likewise.
const MOVES: f64 = 1e-2;

/// Angles up to here are counted alike by everyone; larger ones count by their sines and cosines. Components of
/// rotation matrices stay below.
const WITHIN_A_TURN: f64 = 1.5;

/// What can be read off a state: the components of states and observables, and the sine and cosine of those
/// without unit, which may be angles. Invariants are left out: they are equal by being constant.
#[derive(Clone, Debug, Default)]
pub struct Signals {
    /// The values, sines and cosines behind what they are of.
    pub values: Vec<f64>,
    /// What each is.
    kinds: Vec<Kind>,
}

#[derive(Clone, Copy, Debug)]
struct Kind {
    /// Position of the variable among all.
    variable: usize,
    /// Position of the signal that this is the sine or cosine of.
    of: Option<usize>,
}

impl Signals {
    /// The signals of `case` at `t` and `state`, of a run with step `h`.
    pub fn read(case: &Case, h: f64, t: f64, state: &[f64]) -> Self {
        let description = case.model.description;
        let outputs = case.outputs(h, t, state);
        let mut signals = Signals::default();
        let mut rest = state;
        for (position, variable) in description.states.iter().enumerate() {
            let (own, others) = rest.split_at(size(variable));
            signals.push(position, variable, own);
            rest = others;
        }
        let mut rest = outputs.as_slice();
        for (position, output) in description.outputs.iter().enumerate() {
            let (own, others) = rest.split_at(size(&output.variable));
            if !output.invariant {
                signals.push(description.states.len() + position, &output.variable, own);
            }
            rest = others;
        }
        signals
    }

    fn push(&mut self, position: usize, variable: &Variable, values: &[f64]) {
        for &value in values {
            let of = self.values.len();
            self.push_one(position, None, value);
            if variable.dimensionless {
                self.push_one(position, Some(of), value.sin());
                self.push_one(position, Some(of), value.cos());
            }
        }
    }

    fn push_one(&mut self, variable: usize, of: Option<usize>, value: f64) {
        self.kinds.push(Kind { variable, of });
        self.values.push(value);
    }
}

/// The signals along an accurate solution of the continuous equations, at equal distances.
#[derive(Clone, Debug, Default)]
pub struct Course {
    moments: Vec<Signals>,
    scales: Vec<f64>,
}

impl Course {
    /// From the start of `case` to the time `until`, or as far as the solution can be followed. Without continuous
    /// equations there is none.
    pub fn new(case: &Case, until: f64) -> Self {
        let mut moments = Vec::new();
        let every = (until * FINENESS / LOOKS as f64).ceil() as u64;
        let steps = every * LOOKS;
        let h = until / steps as f64;
        let mut run = case.run(h, steps);
        run.every = every;
        if let Some(flow) = case.model.flow {
            // A course that breaks off is one that says less.
            let _ = flow.simulate(Scheme::RungeKutta4, &run, &mut |sample: Sample<'_>| {
                moments.push(Signals::read(case, h, sample.t, sample.state));
                ControlFlow::Continue(())
            });
        }
        let scales = scales(&moments);
        Self { moments, scales }
    }

    fn len(&self) -> usize {
        self.moments.first().map_or(0, |first| first.values.len())
    }

    fn signal(&self, i: usize) -> impl Iterator<Item = f64> {
        self.moments.iter().map(move |moment| moment.values[i])
    }

    /// The size of each signal.
    pub fn scales(&self) -> &[f64] {
        &self.scales
    }

    fn moves(&self, i: usize) -> bool {
        let start = self.signal(i).next().unwrap_or(0.0);
        let far = MOVES * self.scales[i];
        self.signal(i).any(|value| (value - start).abs() > far)
    }

    /// Whether it may be an angle that leaves the range in which everyone counts it alike.
    fn may_turn(&self, i: usize) -> bool {
        let kinds = &self.moments[0].kinds;
        let has_sine = kinds.get(i + 1).is_some_and(|kind| kind.of == Some(i));
        has_sine && self.signal(i).any(|value| value.abs() > WITHIN_A_TURN)
    }

    fn equals(&self, i: usize, other: &Course, j: usize) -> bool {
        let near = EQUAL * self.scales[i];
        let mut pairs = self.signal(i).zip(other.signal(j));
        pairs.all(|(a, b)| (a - b).abs() <= near)
    }
}

/// The largest value of any component of a signal's variable, 1 for a variable that vanishes.
fn scales(moments: &[Signals]) -> Vec<f64> {
    let Some(first) = moments.first() else {
        return Vec::new();
    };
    let values = |i: usize| moments.iter().map(|m| m.values[i]).collect::<Vec<_>>();
    let sizes: Vec<f64> = (0..first.values.len())
        .map(|i| largest_size(&values(i)))
        .collect();
    let kin = |i: usize, j: usize| {
        let (a, b) = (first.kinds[i], first.kinds[j]);
        a.variable == b.variable && a.of.is_some() == b.of.is_some()
    };
    let group = |i: usize| {
        let same = (0..sizes.len()).filter(|&j| kin(i, j));
        same.map(|j| sizes[j]).fold(0.0, f64::max)
    };
    let sizes: Vec<f64> = (0..sizes.len()).map(group).collect();
    let or_one = |size: f64| if size > 0.0 { size } else { 1.0 };
    sizes.into_iter().map(or_one).collect()
}

/// Which signals of one model are which of another.
#[derive(Clone, Debug)]
pub struct Correspondence {
    /// Positions in the signals of the first and of the second.
    pub pairs: Vec<(usize, usize)>,
}

impl Correspondence {
    /// Matches the signals of two models by their courses in one or more motions.
    pub fn new(one: &[&Course], other: &[&Course]) -> Self {
        let (Some(first), Some(second)) = (one.first(), other.first()) else {
            return Self { pairs: Vec::new() };
        };
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        let mut is_matched = vec![false; first.len()];
        for i in 0..first.len() {
            let of = first.moments[0].kinds[i].of;
            let says_nothing = !one.iter().any(|course| course.moves(i));
            if says_nothing || of.is_some_and(|of| is_matched[of]) {
                continue;
            }
            if one.iter().any(|course| course.may_turn(i)) {
                continue;
            }
            let is_equal = |&j: &usize| {
                let mut courses = one.iter().zip(other);
                courses.all(|(one, other)| one.equals(i, other, j))
            };
            if let Some(j) = (0..second.len()).find(is_equal) {
                is_matched[i] = true;
                pairs.push((i, j));
            }
        }
        Self { pairs }
    }

    /// Largest difference of matched signals, each relative to its scale.
    pub fn difference(&self, one: &[f64], other: &[f64], scales: &[f64]) -> f64 {
        let pairs = self.pairs.iter();
        let differences: Vec<f64> = pairs
            .map(|&(i, j)| (one[i] - other[j]) / scales[i])
            .collect();
        largest_size(&differences)
    }
}
