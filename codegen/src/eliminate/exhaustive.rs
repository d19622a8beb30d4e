//! The best choice of unknowns of a small block: all of them are tried.

use super::Choice;
use super::LEAST_PIVOT;
use super::candidates::Candidates;
use crate::rank::smallest_pivot;

/// Most choices of equations to solve that are tried for each choice of unknowns.
const MOST_ROWS: usize = 64;

/// As many unknowns as possible, and of as many those whose equations are furthest from singular; `None` if every one
/// is needed. There are 2ⁿ choices of unknowns.
pub(super) fn exhaustive(candidates: &Candidates) -> Option<Choice> {
    let n = candidates.len();
    for kept in 0..n {
        let mut best: Option<(f64, Choice)> = None;
        for choice in combinations(n, kept) {
            let cols: Vec<usize> = (0..n).filter(|i| !choice.contains(i)).collect();
            let mask = cols.iter().fold(0, |mask, &i| mask | 1 << i);
            let linear = (0..n).filter(|&row| candidates.is_linear(row, mask));
            let linear: Vec<usize> = linear.collect();
            for rows in combinations(linear.len(), cols.len()).take(MOST_ROWS) {
                let rows: Vec<usize> = rows.iter().map(|&i| linear[i]).collect();
                let least = best.as_ref().map_or(LEAST_PIVOT, |(pivot, _)| *pivot);
                let mut pivot = f64::INFINITY;
                for matrix in &candidates.matrices {
                    let part = rows
                        .iter()
                        .map(|&i| cols.iter().map(|&j| matrix[i][j]).collect());
                    pivot = pivot.min(smallest_pivot(&part.collect::<Vec<_>>()));
                    if pivot <= least {
                        break;
                    }
                }
                if pivot > least {
                    let cols = cols.clone();
                    best = Some((pivot, Choice { rows, cols }));
                }
            }
        }
        if let Some((_, choice)) = best {
            return Some(choice);
        }
    }
    None
}

/// All choices of `k` of 0, …, n − 1 in lexicographic order.
fn combinations(n: usize, k: usize) -> impl Iterator<Item = Vec<usize>> {
    let mut next: Option<Vec<usize>> = (k <= n).then(|| (0..k).collect());
    std::iter::from_fn(move || {
        let current = next.clone()?;
        let last = (0..k).rev().find(|&i| current[i] < n - k + i);
        next = last.map(|i| {
            let mut following = current.clone();
            for (offset, place) in (i..k).enumerate() {
                following[place] = current[i] + 1 + offset;
            }
            following
        });
        Some(current)
    })
}

#[cfg(test)]
mod tests {
    use super::combinations;

    #[test]
    fn combinations_are_all_and_in_order() {
        let list: Vec<_> = combinations(4, 2).collect();
        let expected = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
        assert_eq!(list, expected);
        assert_eq!(combinations(3, 0).count(), 1);
        assert_eq!(combinations(2, 3).count(), 0);
    }
}
