//! What a model is put through: runs made from its description, the same every time.

use rand::RngExt;
use rand::SeedableRng;
use rand::rngs::StdRng;
use residua::Catalogued;
use residua::description::Variable;

use residua_models::values;
use residua_models::values::size;

/// Any number would do; this one is fixed so that tables repeat.
const SEED: u64 = 20220412;

/// The step where it is not what is stressed, in s.
const STEP: f64 = 0.01;

/// A run to be made.
#[derive(Clone, Debug)]
pub struct Case {
    /// What is extreme about it.
    pub kind: Kind,
    /// Flat.
    pub parameters: Vec<f64>,
    /// Flat.
    pub start: Vec<f64>,
    /// The step.
    pub h: f64,
}

/// What is extreme about a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// The step, from 1e-8 to far beyond stability, and backwards.
    Step,
    /// All parameters, states and the step at random.
    Random,
    /// The same at random, back from where they end.
    Back,
    /// The same at random, in other units: each equation has a factor of its own then.
    Units,
    /// The same at random, in other frames.
    Frame,
    /// One parameter, 1e-8 to 1e8 times what it is, 0 or negative.
    Parameter,
    /// One component of the state: 0, the least number, huge, an angle or a direction next to a special one.
    State,
    /// All rates 0, or 1e2 to 1e5 times what they are.
    Spin,
    /// NaN or infinite input.
    NotFinite,
}

impl Kind {
    /// All, in the order of the table.
    pub const ALL: [Kind; 9] = [
        Kind::Step,
        Kind::Random,
        Kind::Back,
        Kind::Units,
        Kind::Frame,
        Kind::Parameter,
        Kind::State,
        Kind::Spin,
        Kind::NotFinite,
    ];

    /// The head of its column.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Step => "step",
            Kind::Random => "random",
            Kind::Back => "back",
            Kind::Units => "units",
            Kind::Frame => "frames",
            Kind::Parameter => "parameters",
            Kind::State => "states",
            Kind::Spin => "rates",
            Kind::NotFinite => "not finite",
        }
    }
}

/// The cases of a model, `random` of them at random.
pub fn cases(model: &Catalogued, random: usize) -> Vec<Case> {
    let parameters = values::defaults(model);
    let start = values::start(model, &parameters);
    let plain = Plain {
        model,
        parameters,
        start,
    };
    let mut cases = plain.steps();
    cases.extend(plain.random(random));
    cases.extend(plain.extreme_parameters());
    cases.extend(plain.extreme_states());
    cases.extend(plain.spins());
    cases.extend(plain.not_finite());
    cases
}

/// The run as the file has it.
struct Plain<'a> {
    model: &'a Catalogued,
    parameters: Vec<f64>,
    start: Vec<f64>,
}

impl Plain<'_> {
    fn case(&self, kind: Kind) -> Case {
        Case {
            kind,
            parameters: self.parameters.clone(),
            start: self.start.clone(),
            h: STEP,
        }
    }

    fn steps(&self) -> Vec<Case> {
        let sizes = [
            1e-8, 1e-5, 1e-3, 0.1, 0.5, 1.0, 3.0, 10.0, 1e3, 1e8, 1e200, 1e-300,
        ];
        let both = sizes.iter().flat_map(|h| [*h, -h]);
        both.map(|h| Case {
            h,
            ..self.case(Kind::Step)
        })
        .collect()
    }

    fn random(&self, count: usize) -> Vec<Case> {
        let mut rng = StdRng::seed_from_u64(SEED);
        let mut factor = |value: &mut f64| *value *= 10f64.powf(rng.random_range(-2.0..2.0));
        let mut cases = Vec::new();
        for i in 0..count {
            let mut case = self.case(Kind::Random);
            case.parameters.iter_mut().for_each(&mut factor);
            case.start = values::start(self.model, &case.parameters);
            case.h = 0.03;
            factor(&mut case.h);
            cases.push(case);
            // Every other one from another state as well.
            if i % 2 == 1 {
                let mut rng = StdRng::seed_from_u64(SEED + i as u64);
                for value in &mut cases[i].start {
                    *value += value.abs().max(1.0) * rng.random_range(-3.0..3.0);
                }
            }
        }
        cases
    }

    fn extreme_parameters(&self) -> Vec<Case> {
        let factors = [1e-8, 1e-4, 1e-2, 1e2, 1e4, 1e8, 0.0, -1.0, 1e160, 1e-160];
        let mut cases = Vec::new();
        for i in 0..self.parameters.len() {
            for factor in factors {
                let mut case = self.case(Kind::Parameter);
                // An entry that is 0 becomes one that is not.
                let value = if self.parameters[i] == 0.0 {
                    1.0
                } else {
                    self.parameters[i]
                };
                case.parameters[i] = value * factor;
                case.start = values::start(self.model, &case.parameters);
                cases.push(case);
            }
        }
        cases
    }

    fn extreme_states(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        let mut offset = 0;
        for variable in self.model.description.states {
            let own = offset..offset + size(variable);
            for i in own.clone() {
                for value in special(variable) {
                    for value in [value.next_down(), value, value.next_up()] {
                        let mut case = self.case(Kind::State);
                        case.start[i] = value;
                        cases.push(case);
                    }
                }
            }
            if is_direction(&self.start[own.clone()], variable) {
                cases.extend(self.directions(own.clone()));
            }
            offset = own.end;
        }
        let mut rest = self.case(Kind::State);
        rest.start.fill(0.0);
        cases.push(rest);
        cases
    }

    /// The state turned along each axis, exactly and by the last digit: upright, hanging, level.
    fn directions(&self, own: core::ops::Range<usize>) -> Vec<Case> {
        let mut cases = Vec::new();
        for axis in own.clone() {
            for (sign, aside) in [
                (1.0, 0.0),
                (-1.0, 0.0),
                (1.0, 1e-16),
                (-1.0, 1e-16),
                (-1.0, 1e-300),
            ] {
                let mut case = self.case(Kind::State);
                case.start[own.clone()].fill(aside);
                case.start[axis] = sign;
                cases.push(case);
            }
        }
        cases
    }

    fn spins(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        for rate in [0.0, 5e-324, 1e-160, 1e2, 1e3, 1e5, 1e8, 1e160] {
            let mut case = self.case(Kind::Spin);
            let mut offset = 0;
            for variable in self.model.description.states {
                let own = offset..offset + size(variable);
                if is_rate(variable) {
                    case.start[own.clone()].fill(rate);
                }
                offset = own.end;
            }
            cases.push(case);
        }
        cases
    }

    fn not_finite(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            cases.push(Case {
                h: value,
                ..self.case(Kind::NotFinite)
            });
            for i in 0..self.parameters.len() {
                let mut case = self.case(Kind::NotFinite);
                case.parameters[i] = value;
                cases.push(case);
            }
            for i in 0..self.start.len() {
                let mut case = self.case(Kind::NotFinite);
                case.start[i] = value;
                cases.push(case);
            }
        }
        cases.push(Case {
            h: 0.0,
            ..self.case(Kind::NotFinite)
        });
        cases
    }
}

/// Values that a component of the state may have trouble with.
fn special(variable: &Variable) -> Vec<f64> {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};
    let mut values = vec![0.0, 5e-324, 1e-160, 1.0, -1.0, 1e8, 1e160];
    if variable.unit == "rad" {
        values.extend([FRAC_PI_2, -FRAC_PI_2, PI, -PI, TAU, 100.0 * PI, 1e6]);
    }
    values
}

fn is_direction(start: &[f64], variable: &Variable) -> bool {
    let length: f64 = start.iter().map(|x| x * x).sum();
    variable.rows > 1 && variable.unit == "1" && (length - 1.0).abs() < 1e-9
}

fn is_rate(variable: &Variable) -> bool {
    variable.unit.ends_with("/s")
}
