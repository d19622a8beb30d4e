//! Values put into the graphs: fixed parameters, and components that are 0.

use super::Solver;
use super::Unfit;
use super::zeros::Zeros;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::model::Model;
use crate::scene::Wishes;
use crate::system::Discrete;
use crate::system::Entry;
use crate::system::Equations;

/// For each component of the parameters whether it is fixed.
pub(super) fn components(model: &Model, wishes: &Wishes) -> Vec<bool> {
    let parameters = model.parameters.iter().zip(&wishes.fixed);
    parameters
        .flat_map(|(p, fixed)| vec![fixed.is_some(); p.variable.shape.len()])
        .collect()
}

/// The equations with fixed parameters put in; the defaults stay as they are.
pub(super) fn equations(equations: &Equations, is_fixed: &[bool]) -> Result<Equations, Unfit> {
    let Equations {
        defaults,
        start,
        outputs,
        requirements,
        flow,
        ..
    } = equations;
    let mut dag = Dag::new();
    let values = values(&mut dag, equations);
    let put_in = |dag: &mut Dag, leaf: Leaf| match leaf {
        Leaf::Parameter(i) if is_fixed[i] => values[i],
        _ => dag.leaf(leaf),
    };
    // The discrete equations may do without what the continuous ones divide by.
    let flow = flow.as_deref().filter(|rates| {
        let grafted = dag.graft(&equations.dag, rates, put_in);
        vanishing_divisors(&dag, &equations.dag, &grafted).is_empty()
    });
    let rates = flow.unwrap_or_default();
    let required = requirements.concat();
    let roots = [defaults, start, outputs, &required, rates].concat();
    let grafted = graft(&mut dag, &equations.dag, &roots, put_in)?;
    let at =
        |roots: &[NodeId]| -> Vec<NodeId> { roots.iter().map(|r| grafted[r.index()]).collect() };
    Ok(Equations {
        defaults: at(defaults),
        start: at(start),
        outputs: at(outputs),
        requirements: requirements.iter().map(|sides| at(sides)).collect(),
        flow: flow.map(at),
        dag,
    })
}

/// The solver with fixed parameters put in.
pub(super) fn solver(
    discrete: &Discrete,
    jacobian: &[Entry],
    equations: &Equations,
    is_fixed: &[bool],
) -> Result<Solver, Unfit> {
    let Discrete {
        residual,
        guess,
        next,
        ..
    } = discrete;
    let mut dag = Dag::new();
    let values = values(&mut dag, equations);
    let entries: Vec<NodeId> = jacobian.iter().map(|e| e.node).collect();
    let roots = [residual.as_slice(), guess, next, &entries].concat();
    let grafted = graft(&mut dag, &discrete.dag, &roots, |dag, leaf| match leaf {
        Leaf::Parameter(i) if is_fixed[i] => values[i],
        _ => dag.leaf(leaf),
    })?;
    let at = |roots: &[NodeId]| roots.iter().map(|r| grafted[r.index()]).collect();
    Ok(Solver {
        residual: at(residual),
        guess: at(guess),
        next: at(next),
        jacobian: moved(jacobian, &grafted),
        dag,
    })
}

/// The values of the parameters, which depend on nothing.
fn values(dag: &mut Dag, equations: &Equations) -> Vec<NodeId> {
    let defaults = &equations.defaults;
    let values = dag.graft(&equations.dag, defaults, |dag, leaf| dag.leaf(leaf));
    let zero = dag.integer(0);
    let at = |node: &NodeId| values[node.index()].unwrap_or(zero);
    defaults.iter().map(at).collect()
}

/// Every needed node of `from` in `dag`; what is not needed is 0.
fn graft(
    dag: &mut Dag,
    from: &Dag,
    roots: &[NodeId],
    leaf: impl FnMut(&mut Dag, Leaf) -> NodeId,
) -> Result<Vec<NodeId>, Unfit> {
    let grafted = dag.graft(from, roots, leaf);
    if vanishing_divisors(dag, from, &grafted).is_empty() {
        let zero = dag.integer(0);
        Ok(grafted.into_iter().map(|n| n.unwrap_or(zero)).collect())
    } else {
        Err(Unfit::DivisionByZero)
    }
}

/// The nodes of `from` that are divided by and have become 0.
pub(super) fn vanishing_divisors(dag: &Dag, from: &Dag, grafted: &[Option<NodeId>]) -> Vec<NodeId> {
    let needed = from.nodes().iter().zip(grafted).filter(|n| n.1.is_some());
    let divisors = needed.flat_map(|(node, _)| match node {
        Node::Product(factors) => factors.iter().filter(|f| f.1 < 0).map(|f| f.0).collect(),
        _ => Vec::new(),
    });
    let is_zero = |node: &NodeId| grafted[node.index()].is_some_and(|n| dag.is_zero(n));
    divisors.filter(is_zero).collect()
}

fn moved(entries: &[Entry], grafted: &[NodeId]) -> Vec<Entry> {
    let moved = |e: &Entry| Entry {
        node: grafted[e.node.index()],
        ..*e
    };
    entries.iter().map(moved).collect()
}

/// The solver at zero `zeros`, its Jacobian without the entries that vanish there.
pub(super) fn with_zeros(solver: &Solver, zeros: &Zeros) -> Solver {
    let mut dag = solver.dag.clone();
    let zero = dag.integer(0);
    let entries: Vec<NodeId> = solver.jacobian.iter().map(|e| e.node).collect();
    let lists = [&solver.residual, &solver.guess, &solver.next, &entries];
    let [residual, guess, next, entries] =
        lists.map(|roots| dag.substitute(roots, |leaf| zeros.contain(leaf).then_some(zero)));
    let jacobian = solver.jacobian.iter().zip(entries);
    let jacobian = jacobian.map(|(e, node)| Entry { node, ..*e });
    let jacobian = jacobian.filter(|e| !dag.is_zero(e.node)).collect();
    Solver {
        residual,
        guess,
        next,
        jacobian,
        dag,
    }
}

/// Outputs and flow at zero `zeros`.
pub(super) fn equations_with_zeros(equations: &Equations, zeros: &Zeros) -> Equations {
    let mut dag = equations.dag.clone();
    let zero = dag.integer(0);
    let mut put_in =
        |roots: &[NodeId]| dag.substitute(roots, |leaf| zeros.contain(leaf).then_some(zero));
    let outputs = put_in(&equations.outputs);
    let requirements = equations.requirements.iter();
    let requirements = requirements.map(|sides| put_in(sides)).collect();
    let flow = equations.flow.as_deref().map(put_in);
    Equations {
        defaults: equations.defaults.clone(),
        start: equations.start.clone(),
        outputs,
        requirements,
        flow,
        dag,
    }
}
