//! Values to a schedule: what is needed, in which order, and what is cached.

use super::split::Rooted;
use super::values::Values;
use crate::dag::Rate;
use crate::schedule::Kernel;
use crate::schedule::Op;
use crate::schedule::Schedule;
use crate::schedule::Value;
use crate::schedule::ValueId;

/// Drops what no kernel needs, numbers the rest operands first, and lists what each kernel computes
/// and what the caches hold.
pub(super) fn order(values: Values, rooted: &[Rooted]) -> Schedule {
    let roots: Vec<ValueId> = rooted.iter().flat_map(|k| k.2.iter().copied()).collect();
    let needed = postorder(&values.list, &roots, |_| true);
    let mut number = vec![None; values.list.len()];
    for (new, old) in (0..).map(ValueId).zip(&needed) {
        number[old.index()] = Some(new);
    }
    let renumber = |v: ValueId| number[v.index()].expect("a value that a kernel needs");
    let list: Vec<Value> = needed
        .iter()
        .map(|old| {
            let Value { op, rate } = &values.list[old.index()];
            Value {
                op: renumbered(op, renumber),
                rate: *rate,
            }
        })
        .collect();
    let wanted: Vec<Kernel> = rooted
        .iter()
        .map(|(name, rate, roots)| {
            kernel(
                &list,
                name,
                *rate,
                roots.iter().map(|r| renumber(*r)).collect(),
            )
        })
        .collect();
    with_caches(list, wanted)
}

/// Adds the kernels `scene` and `step`, whose results are what the others look up.
fn with_caches(list: Vec<Value>, wanted: Vec<Kernel>) -> Schedule {
    let step = kernel(
        &list,
        "step",
        Rate::Step,
        looked_up(&list, &wanted, Rate::Step),
    );
    let mut users = wanted;
    users.insert(0, step);
    let scene = kernel(
        &list,
        "scene",
        Rate::Scene,
        looked_up(&list, &users, Rate::Scene),
    );
    users.insert(0, scene);
    Schedule {
        scene: users[0].roots.clone(),
        step: users[1].roots.clone(),
        values: list,
        kernels: users,
    }
}

fn kernel(list: &[Value], name: &'static str, rate: Rate, roots: Vec<ValueId>) -> Kernel {
    let is_own = |v: ValueId| {
        let Value { op, rate: own } = &list[v.index()];
        op.is_negation() || *own == rate && !op.is_given()
    };
    let body = postorder(list, &roots, is_own);
    Kernel {
        name,
        rate,
        roots,
        body,
    }
}

/// The values of `rate` that faster kernels look up, in value order.
fn looked_up(list: &[Value], kernels: &[Kernel], rate: Rate) -> Vec<ValueId> {
    let mut is_used = vec![false; list.len()];
    for kernel in kernels.iter().filter(|k| k.rate > rate) {
        let inner = kernel
            .body
            .iter()
            .flat_map(|v| list[v.index()].op.operands());
        for used in inner.chain(kernel.roots.iter().copied()) {
            is_used[used.index()] = true;
        }
    }
    (0..)
        .map(ValueId)
        .zip(list)
        .filter(|(id, v)| is_used[id.index()] && v.rate == rate)
        .filter(|(_, v)| !v.op.is_number() && !v.op.is_negation())
        .map(|(id, _)| id)
        .collect()
}

/// The values that `roots` need among those that `is_wanted` accepts, operands first, each as late
/// as possible.
pub(super) fn postorder(
    list: &[Value],
    roots: &[ValueId],
    is_wanted: impl Fn(ValueId) -> bool,
) -> Vec<ValueId> {
    let mut is_open = vec![true; list.len()];
    let mut ordered = Vec::new();
    let mut stack: Vec<(ValueId, bool)> = roots.iter().rev().map(|r| (*r, false)).collect();
    while let Some((id, is_ready)) = stack.pop() {
        if is_ready {
            ordered.push(id);
        } else if is_open[id.index()] && is_wanted(id) {
            is_open[id.index()] = false;
            stack.push((id, true));
            let operands = list[id.index()].op.operands();
            stack.extend(operands.into_iter().rev().map(|o| (o, false)));
        }
    }
    ordered
}

fn renumbered(op: &Op, renumber: impl Fn(ValueId) -> ValueId) -> Op {
    let all = |list: &[ValueId]| list.iter().map(|v| renumber(*v)).collect();
    match op {
        Op::Constant(_) | Op::Pi | Op::Leaf(_) => op.clone(),
        Op::Sum(terms) => Op::Sum(
            terms
                .iter()
                .map(|(c, v)| (c.clone(), renumber(*v)))
                .collect(),
        ),
        Op::Product {
            coefficient,
            numerator,
            denominator,
        } => Op::Product {
            coefficient: coefficient.clone(),
            numerator: all(numerator),
            denominator: all(denominator),
        },
        Op::Call(function, arguments) => Op::Call(*function, all(arguments)),
    }
}
