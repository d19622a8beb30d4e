//! Graph → [`Schedule`]: at which rate each part of an expression is computed.
//!
//! In comes a graph and the functions wanted from it; out comes a list of values in which every sum
//! and product is split by rate. After this point nothing is computed more often than its operands
//! change, and every value exists once.
//!
//! ```text
//! 2 h m g l (Γ⁺ + Γ)  →  scene:     c = 2 h m g l
//!                        iteration: c · (Γ⁺ + Γ)
//! x / (J y)           →  scene:     c = 1 / J
//!                        iteration: c · x / y
//! ```

mod balance;
mod order;
mod share;
mod split;
mod values;

#[cfg(test)]
mod tests;

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::dag::Rate;
use crate::schedule::Expansion;
use crate::schedule::Program;
use crate::schedule::Schedule;
use crate::schedule::Solver;
use crate::system::Core;
use crate::system::Entry;
use crate::system::Equations;
use crate::system::Series;
use crate::system::System;
use split::Rooted;
use values::Values;

/// Cycles until newest coefficients are there, counted from their rates.
const NEWEST: u32 = 4;

/// The same for a product of them: two sums of products and a way into lanes and out.
const PRODUCT: u32 = 20;

/// A function wanted from a graph: its name, when it is called, and its results.
pub type Wanted = (&'static str, Rate, Vec<NodeId>);

/// Splits everything that `kernels` need by rate.
///
/// A kernel finds slower values in the caches that the kernels `scene` and `step` fill, and computes
/// those of its own rate. No root may be faster than its kernel.
pub fn stage(dag: &Dag, kernels: &[Wanted]) -> Schedule {
    let (values, roots) = shared(dag, kernels);
    let schedule = order::order(values, &roots);
    debug_assert_eq!(schedule.verify(), Ok(()));
    schedule
}

/// What is wanted, split by rate, and what is common computed once.
fn shared(dag: &Dag, kernels: &[Wanted]) -> (Values, Vec<Rooted>) {
    let (mut values, roots) = split::split(dag, kernels);
    share::reciprocals(&mut values);
    share::pairs(&mut values);
    share::signs(&mut values, &roots);
    (values, roots)
}

/// The schedules of a whole model.
pub fn program(
    equations: &Equations,
    systems: &[System],
    series: Option<Result<Series, String>>,
) -> Program {
    let one = |name, rate, roots: &[NodeId]| stage(&equations.dag, &[(name, rate, roots.to_vec())]);
    Program {
        defaults: one("defaults", Rate::Scene, &equations.defaults),
        start: one("start", Rate::Scene, &equations.start),
        outputs: one("outputs", Rate::Step, &equations.outputs),
        flow: equations
            .flow
            .as_ref()
            .map(|roots| one("flow", Rate::Step, roots)),
        series: series.map(|series| Ok(expansion(&series?))),
        solvers: systems.iter().map(solver).collect(),
    }
}

fn expansion(series: &Series) -> Expansion {
    let next = series.coefficients.iter().copied();
    let next = next.chain(rows(&series.sums, series.zero)).collect();
    let kernels = [
        ("rates", Rate::Iteration, series.rates.clone()),
        ("starts", Rate::Iteration, rows(&series.starts, series.zero)),
        (
            "factors",
            Rate::Iteration,
            rows(&series.products, series.zero),
        ),
        ("next", Rate::Iteration, next),
    ];
    let (mut values, roots) = shared(&series.dag, &kernels);
    let n_states = series.coefficients.len();
    let arrival = |i: usize| match i.checked_sub(n_states + Series::GIVEN) {
        None => NEWEST,
        Some(lane) if lane % 2 == 1 => PRODUCT,
        Some(_) => 0,
    };
    balance::balance(&mut values, &roots, arrival);
    let schedule = order::order(values, &roots);
    debug_assert_eq!(schedule.verify(), Ok(()));
    Expansion {
        schedule,
        n_sums: series.sums.len(),
        n_products: series.products.len(),
    }
}

/// First the left and then the right side of `lanes`, each in full rows.
fn rows(lanes: &[[NodeId; 2]], zero: NodeId) -> Vec<NodeId> {
    let filling = Expansion::rows(lanes.len()) * Expansion::ROW - lanes.len();
    let side = |side: usize| {
        let own = lanes.iter().map(move |lane| lane[side]);
        own.chain(std::iter::repeat_n(zero, filling))
    };
    side(0).chain(side(1)).collect()
}

fn solver(system: &System) -> Solver {
    let correction = system.correction.as_ref().map(|correction| {
        let roots = correction.x.iter().chain([&correction.growth]);
        ("correction", Rate::Iteration, roots.copied().collect())
    });
    let core = system.core.as_ref().map(|core| {
        let Core {
            reduced,
            jacobian,
            change,
        } = core;
        let kernels = kernels(&reduced.residual, jacobian, &reduced.guess, &reduced.next);
        let growth = ("growth", Rate::Iteration, vec![reduced.growth]);
        let kernels = kernels.into_iter().chain([growth]).chain(adding(change));
        let kernels: Vec<Wanted> = kernels.chain(correction.clone()).collect();
        Box::new(Solver {
            form: system.form,
            pattern: jacobian.iter().map(|e| (e.row, e.col)).collect(),
            schedule: stage(&system.dag, &kernels),
            unknowns: reduced.unknowns.clone(),
            solved: reduced.solved.clone(),
            core: None,
        })
    });
    let kernels = kernels(
        &system.residual,
        &system.jacobian,
        &system.guess,
        &system.next,
    );
    let correction = correction.filter(|_| core.is_none());
    let kernels = kernels.into_iter().chain(adding(&system.change));
    let kernels: Vec<Wanted> = kernels.chain(correction).collect();
    Solver {
        form: system.form,
        pattern: system.jacobian.iter().map(|e| (e.row, e.col)).collect(),
        schedule: stage(&system.dag, &kernels),
        unknowns: (0..system.residual.len()).collect(),
        solved: Vec::new(),
        core,
    }
}

fn adding(change: &Option<Vec<NodeId>>) -> Option<Wanted> {
    let change = change.as_ref()?;
    Some(("change", Rate::Iteration, change.clone()))
}

fn kernels(
    residual: &[NodeId],
    jacobian: &[Entry],
    guess: &[NodeId],
    next: &[NodeId],
) -> [Wanted; 4] {
    let mut rows = Vec::with_capacity(residual.len() + jacobian.len());
    for (row, &root) in residual.iter().enumerate() {
        rows.push(root);
        let own = jacobian.iter().filter(|e| e.row == row);
        rows.extend(own.map(|e| e.node));
    }
    // The guess is called once per step, but from outside the step kernel: as a kernel of the
    // fastest rate it finds everything it needs in the caches.
    [
        ("guess", Rate::Iteration, guess.to_vec()),
        ("residual", Rate::Iteration, residual.to_vec()),
        ("residual_and_jacobian", Rate::Iteration, rows),
        ("next", Rate::Iteration, next.to_vec()),
    ]
}
