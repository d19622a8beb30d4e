//! Which equation contains which unknown, and what follows for the order of solution.

use std::collections::BTreeSet;

/// The structural non-zeros of a square system.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// For each equation the unknowns in it, ascending.
    rows: Vec<Vec<usize>>,
}

impl Pattern {
    /// From (equation, unknown) pairs of a system of size `n`.
    pub fn new(n: usize, pairs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut rows = vec![BTreeSet::new(); n];
        for (row, col) in pairs {
            rows[row].insert(col);
        }
        Self {
            rows: rows.into_iter().map(|r| r.into_iter().collect()).collect(),
        }
    }

    /// For each unknown the equation that is solved for it, as far as there is one: a maximum
    /// matching by augmenting paths.
    pub fn matching(&self) -> Vec<Option<usize>> {
        let n = self.rows.len();
        let mut equation_of = vec![None; n];
        let mut unknown_of = vec![None; n];
        for start in 0..n {
            let Some((free, reached_from)) = self.augmenting_path(start, &equation_of) else {
                continue;
            };
            let mut next = Some(free);
            while let Some(col) = next {
                let row = reached_from[col];
                next = unknown_of[row].replace(col);
                equation_of[col] = Some(row);
            }
        }
        equation_of
    }

    /// From equation `start` over unknowns already given away to one that is still free; for each
    /// unknown on the way the equation it was reached from.
    fn augmenting_path(
        &self,
        start: usize,
        equation_of: &[Option<usize>],
    ) -> Option<(usize, Vec<usize>)> {
        let mut reached_from = vec![usize::MAX; self.rows.len()];
        let mut open = vec![start];
        while let Some(row) = open.pop() {
            for &col in &self.rows[row] {
                if reached_from[col] != usize::MAX {
                    continue;
                }
                reached_from[col] = row;
                match equation_of[col] {
                    Some(taken) => open.push(taken),
                    None => return Some((col, reached_from)),
                }
            }
        }
        None
    }

    /// The block-triangular form for a perfect matching: sets of equations with the unknowns they
    /// determine, each set needing only those before it.
    pub fn blocks(&self, equation_of: &[usize]) -> Vec<(Vec<usize>, Vec<usize>)> {
        let mut unknown_of = vec![0; self.rows.len()];
        for (col, &row) in equation_of.iter().enumerate() {
            unknown_of[row] = col;
        }
        let needs = |row: usize| self.rows[row].iter().map(|&col| equation_of[col]).collect();
        strong_components(self.rows.len(), needs)
            .into_iter()
            .map(|mut rows| {
                rows.sort_unstable();
                let mut cols: Vec<_> = rows.iter().map(|&r| unknown_of[r]).collect();
                cols.sort_unstable();
                (rows, cols)
            })
            .collect()
    }
}

/// Strongly connected components, those needed by others first (Tarjan 1972, with its own stack).
fn strong_components(n: usize, needs: impl Fn(usize) -> Vec<usize>) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let mut order = vec![UNSEEN; n];
    let mut low = vec![UNSEEN; n];
    let mut on_path = vec![false; n];
    let mut path = Vec::new();
    let mut components = Vec::new();
    let mut clock = 0;
    for root in 0..n {
        if order[root] != UNSEEN {
            continue;
        }
        let mut open: Vec<(usize, Vec<usize>)> = vec![(root, needs(root))];
        order[root] = clock;
        low[root] = clock;
        clock += 1;
        path.push(root);
        on_path[root] = true;
        while let Some((node, rest)) = open.last_mut() {
            let node = *node;
            if let Some(next) = rest.pop() {
                if order[next] == UNSEEN {
                    order[next] = clock;
                    low[next] = clock;
                    clock += 1;
                    path.push(next);
                    on_path[next] = true;
                    open.push((next, needs(next)));
                } else if on_path[next] {
                    low[node] = low[node].min(order[next]);
                }
                continue;
            }
            open.pop();
            if let Some((parent, _)) = open.last() {
                low[*parent] = low[*parent].min(low[node]);
            }
            if low[node] == order[node] {
                let start = path.iter().position(|&p| p == node).unwrap_or(0);
                let component = path.split_off(start);
                for member in &component {
                    on_path[*member] = false;
                }
                components.push(component);
            }
        }
    }
    components
}

#[cfg(test)]
mod tests;
