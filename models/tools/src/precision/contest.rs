//! Who takes part: schemes on formulations.

use super::integrator::Integrator;
use super::problem::Formulation;
use super::problem::Problem;
use super::row::OURS;
use residua_models::effort::Effort;
use residua_models::effort::Visit;

/// The steps and tolerances that are tried, coarsest first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ladders {
    /// From this step to that one, s: those of T/2ᵏ that lie between.
    pub steps: (f64, f64),
    /// From this tolerance to that one: the powers of ten that lie between.
    pub tolerances: (f64, f64),
}

/// One of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rung {
    /// T/2ᵏ
    Step {
        /// The step, s.
        h: f64,
        /// 2ᵏ
        steps: u64,
    },
    /// For the error control of the scheme, relative and absolute.
    Tolerance(f64),
}

type Solve<'a> = dyn Fn(Rung, Option<Visit<'_>>) -> Result<(Vec<f64>, Effort), String> + 'a;

/// A scheme on a formulation.
pub struct Contestant<'a> {
    /// The formulation.
    pub formulation: &'a Formulation,
    /// The name of the scheme.
    pub scheme: String,
    /// Whose it is: [`OURS`], or the name of a crate.
    pub by: &'static str,
    /// Its order in theory, of schemes with a fixed one.
    pub order: Option<usize>,
    /// What is tried.
    pub rungs: Vec<Rung>,
    solve: Box<Solve<'a>>,
}

impl Contestant<'_> {
    /// The state at the end, and what it took. States on the way are shown to a visitor, if there is one.
    ///
    /// # Errors
    /// Where the run fails, in words.
    pub fn solve(
        &self,
        rung: Rung,
        visit: Option<Visit<'_>>,
    ) -> Result<(Vec<f64>, Effort), String> {
        (self.solve)(rung, visit)
    }
}

impl Ladders {
    /// The steps to the time `until`.
    pub fn steps(&self, until: f64) -> Vec<Rung> {
        let (coarse, fine) = self.steps;
        let rungs = (0..u64::BITS - 1).map(|k| {
            let steps = 1 << k;
            let h = until / steps as f64;
            (h, steps)
        });
        // Decimal ends of a ladder are meant to be on it.
        let inside = |h: f64| h <= coarse * (1.0 + 1e-9) && h >= fine * (1.0 - 1e-9);
        let rungs = rungs.filter(|(h, _)| inside(*h));
        rungs.map(|(h, steps)| Rung::Step { h, steps }).collect()
    }

    /// The tolerances.
    pub fn tolerances(&self) -> Vec<Rung> {
        let (coarse, fine) = self.tolerances;
        let first = -(coarse.log10() + 1e-9).floor() as i32;
        let last = -(fine.log10() - 1e-9).ceil() as i32;
        let rungs = (first..=last).map(|k| format!("1e-{k}").parse().unwrap_or(f64::NAN));
        rungs.map(Rung::Tolerance).collect()
    }
}

/// All schemes on all formulations of a problem, ours first.
pub fn contestants<'a>(problem: &'a Problem, ladders: &Ladders) -> Vec<Contestant<'a>> {
    let mut list = Vec::new();
    for formulation in &problem.formulations {
        for integrator in Integrator::of(formulation.case.model) {
            let (case, until) = (&formulation.case, problem.until);
            let order = integrator.order();
            list.push(Contestant {
                formulation,
                scheme: integrator.name(),
                by: OURS,
                order,
                rungs: match order {
                    Some(_) => ladders.steps(until),
                    None => ladders.tolerances(),
                },
                solve: Box::new(move |rung, visit| integrator.solve(case, until, rung, visit)),
            });
        }
    }
    #[cfg(feature = "rivals")]
    for formulation in &problem.formulations {
        list.extend(rivals(problem.until, formulation, ladders));
    }
    list
}

/// Schemes of others.
#[cfg(feature = "rivals")]
fn rivals<'a>(
    until: f64,
    formulation: &'a Formulation,
    ladders: &Ladders,
) -> impl Iterator<Item = Contestant<'a>> {
    use residua_models::rivals::Rival;
    use residua_models::rivals::Task;
    let rungs = ladders.tolerances();
    let rivals = formulation.entry.rivals.into_iter();
    rivals.flat_map(move |rivals| {
        let rungs = rungs.clone();
        Rival::ALL.into_iter().map(move |rival| {
            let case = &formulation.case;
            let solve = move |rung, visit: Option<Visit<'_>>| match rung {
                Rung::Step { .. } => Err("it chooses its own steps".to_owned()),
                Rung::Tolerance(tolerance) => {
                    let task = Task {
                        parameters: &case.parameters,
                        start: &case.start,
                        until,
                        tolerance,
                    };
                    rivals.solve(rival, &task, visit)
                }
            };
            Contestant {
                formulation,
                scheme: rival.scheme().to_owned(),
                by: rival.package(),
                order: None,
                rungs: rungs.clone(),
                solve: Box::new(solve),
            }
        })
    })
}
