//! Newton's correction J⁻¹ r of a small system in closed form.
//!
//! Being part of the graph, it shares what it can with residual and Jacobian, and what is constant in it is computed
//! once. Its pivots are chosen at build time; `growth` tells at run time where they should not have been.

use crate::dag::Dag;
use crate::dag::NodeId;
use crate::linear::growth;
use crate::linear::solve;
use crate::sample::Typical;
use crate::system::Correction;
use crate::system::Entry;

/// Most unknowns. Beyond, straight-line code is longer than what it saves in pivoting.
const MOST_UNKNOWNS: usize = 8;

/// The correction of `residual` with the structural non-zeros of its Jacobian; `None` if the system is large.
pub fn correct(
    dag: &mut Dag,
    residual: &[NodeId],
    jacobian: &[Entry],
    typical: &Typical,
) -> Option<Correction> {
    let n = residual.len();
    if n == 0 || n > MOST_UNKNOWNS {
        return None;
    }
    let zero = dag.integer(0);
    let mut a = vec![vec![zero; n]; n];
    for entry in jacobian {
        a[entry.row][entry.col] = entry.node;
    }
    let solution = solve(dag, &a, residual, typical)?;
    // Where an equation has one unknown there is no pivot to choose.
    let mut chosen = solution.divisors;
    chosen.retain(|divisor| !divisor.is_entry);
    Some(Correction {
        x: solution.x,
        growth: growth(dag, &chosen),
    })
}
