//! What a person would call a value: `h_m_g_l`, `sin_theta_mid`, `Delta_Gamma_x`.

use super::expression::method;
use super::number;
use super::variables::Variables;
use crate::dag::Leaf;
use crate::schedule::Op;
use crate::schedule::Schedule;
use crate::schedule::ValueId;
use num_rational::BigRational;
use num_traits::One;
use num_traits::Signed;
use num_traits::Zero;

/// Longest name that still reads faster than the expression it stands for.
const LONGEST: usize = 28;

/// A name for a value.
#[derive(Clone)]
struct Phrase {
    text: String,
    /// May stand inside a longer name; `a_plus_b` may not.
    is_word: bool,
}

/// now·x[k] + next·x[k+1] of one state component.
#[derive(Clone)]
struct Levels {
    state: usize,
    now: BigRational,
    next: BigRational,
}

/// A name for each value of `schedule`, where there is a good one.
pub(super) fn phrases(schedule: &Schedule, variables: &Variables) -> Vec<Option<String>> {
    let mut levels: Vec<Option<Levels>> = Vec::with_capacity(schedule.values.len());
    let mut phrases: Vec<Option<Phrase>> = Vec::with_capacity(schedule.values.len());
    for value in &schedule.values {
        let own = levels_of(&value.op, &levels, variables);
        let phrase = own
            .as_ref()
            .and_then(|own| level_name(own, variables))
            .filter(|_| !matches!(value.op, Op::Leaf(_)))
            .or_else(|| phrase(&value.op, &phrases, variables))
            .filter(|p| p.text.len() <= LONGEST || value.op.is_given());
        levels.push(own);
        phrases.push(phrase);
    }
    phrases.into_iter().map(|p| p.map(|p| p.text)).collect()
}

fn levels_of(op: &Op, known: &[Option<Levels>], variables: &Variables) -> Option<Levels> {
    match op {
        Op::Leaf(Leaf::State(state)) => Some(Levels {
            state: *state,
            now: BigRational::one(),
            next: BigRational::zero(),
        }),
        Op::Leaf(Leaf::Unknown(i)) => {
            let (state, is_increment) = variables.advanced[*i]?;
            let one = BigRational::one();
            Some(Levels {
                state,
                now: if is_increment {
                    -&one
                } else {
                    BigRational::zero()
                },
                next: one,
            })
        }
        Op::Sum(terms) => {
            let mut total: Option<Levels> = None;
            for (coefficient, id) in terms {
                let term = known[id.index()].as_ref()?;
                let sum = total.get_or_insert(Levels {
                    state: term.state,
                    now: BigRational::zero(),
                    next: BigRational::zero(),
                });
                if sum.state != term.state {
                    return None;
                }
                sum.now += coefficient * &term.now;
                sum.next += coefficient * &term.next;
            }
            total
        }
        Op::Product {
            coefficient,
            numerator,
            denominator,
        } => match (numerator.as_slice(), denominator.as_slice()) {
            ([factor], []) => {
                let factor = known[factor.index()].as_ref()?;
                Some(Levels {
                    state: factor.state,
                    now: coefficient * &factor.now,
                    next: coefficient * &factor.next,
                })
            }
            _ => None,
        },
        Op::Constant(_) | Op::Pi | Op::Leaf(_) | Op::Call(..) => None,
    }
}

/// `omega_sum` for x[k] + x[k+1], and so on for the combinations that schemes are made of.
fn level_name(levels: &Levels, variables: &Variables) -> Option<Phrase> {
    let name = variables.name(Leaf::State(levels.state));
    let (one, half) = (BigRational::one(), BigRational::new(1.into(), 2.into()));
    let is = |now: &BigRational, next: &BigRational| levels.now == *now && levels.next == *next;
    let text = if is(&one, &one) {
        format!("{name}_sum")
    } else if is(&half, &half) {
        format!("{name}_mid")
    } else if is(&BigRational::zero(), &one) {
        format!("{name}_next")
    } else if is(&-&one, &one) {
        format!("Delta_{name}")
    } else {
        return None;
    };
    Some(Phrase {
        text,
        is_word: true,
    })
}

fn phrase(op: &Op, known: &[Option<Phrase>], variables: &Variables) -> Option<Phrase> {
    let word = |id: &ValueId| {
        let phrase = known[id.index()].as_ref().filter(|p| p.is_word)?;
        Some(phrase.text.clone())
    };
    let (text, is_word) = match op {
        Op::Constant(value) => (number::name(&value.abs())?, true),
        Op::Pi => ("pi".to_string(), true),
        Op::Leaf(leaf) => (variables.name(*leaf).to_string(), true),
        Op::Sum(terms) => match terms.as_slice() {
            [(coefficient, value)] => (scaled(coefficient, word(value)?)?, true),
            [(c, a), (d, b)] if c.is_one() && d.abs().is_one() => {
                let operator = if d.is_negative() { "minus" } else { "plus" };
                (format!("{}_{operator}_{}", word(a)?, word(b)?), false)
            }
            _ => return None,
        },
        Op::Product {
            coefficient,
            numerator,
            denominator,
        } => (product(coefficient, numerator, denominator, word)?, true),
        Op::Call(function, arguments) => {
            let arguments: Option<Vec<String>> = arguments.iter().map(word).collect();
            (
                format!("{}_{}", method(*function), arguments?.join("_")),
                true,
            )
        }
    };
    Some(Phrase { text, is_word })
}

fn scaled(coefficient: &BigRational, name: String) -> Option<String> {
    let sign = if coefficient.is_negative() {
        "minus_"
    } else {
        ""
    };
    if coefficient.abs().is_one() {
        return Some(format!("{sign}{name}"));
    }
    Some(format!(
        "{sign}{}_{name}",
        number::name(&coefficient.abs())?
    ))
}

fn product(
    coefficient: &BigRational,
    numerator: &[ValueId],
    denominator: &[ValueId],
    word: impl Fn(&ValueId) -> Option<String>,
) -> Option<String> {
    let mut words: Vec<String> = Vec::new();
    if !coefficient.is_one() || numerator.is_empty() {
        words.push(number::name(coefficient)?);
    }
    match numerator {
        [a, b] if a == b => words.push(square(&word(a)?)),
        _ => {
            for factor in numerator {
                words.push(word(factor)?);
            }
        }
    }
    for divisor in denominator {
        words.extend(["over".to_string(), word(divisor)?]);
    }
    Some(words.join("_"))
}

/// The name of the square of `name`.
fn square(name: &str) -> String {
    if let Some(base) = name.strip_suffix("_squared") {
        format!("{base}_to_4")
    } else if let Some(base) = name.strip_suffix("_to_4") {
        format!("{base}_to_8")
    } else {
        format!("{name}_squared")
    }
}
