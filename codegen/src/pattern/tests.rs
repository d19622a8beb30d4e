use super::*;

#[test]
fn a_matching_is_found_where_the_first_choice_must_be_taken_back() {
    // Equation 0 takes unknown 0 first, which is the only one of equation 1.
    let pattern = Pattern::new(3, [(0, 0), (0, 1), (1, 0), (2, 1), (2, 2)]);
    let matching = pattern.matching();
    assert!(matching.iter().all(Option::is_some), "{matching:?}");
    assert_eq!(matching[0], Some(1));
}

#[test]
fn a_singular_pattern_leaves_an_unknown_over() {
    // Equations 0 and 1 both contain unknown 0 only.
    let pattern = Pattern::new(3, [(0, 0), (1, 0), (2, 1), (2, 2)]);
    assert_eq!(pattern.matching().iter().flatten().count(), 2);
}

#[test]
fn every_matching_is_as_large_as_brute_force_finds() {
    let n = 4;
    for bits in 0u32..1 << 16 {
        if bits % 37 != 0 {
            continue;
        }
        let contains = |i: usize, j: usize| bits >> (i * n + j) & 1 == 1;
        let pairs = (0..n * n)
            .map(|k| (k / n, k % n))
            .filter(|&(i, j)| contains(i, j));
        let found = Pattern::new(n, pairs).matching();
        for (col, row) in found.iter().enumerate() {
            assert!(row.is_none_or(|row| contains(row, col)));
        }
        assert_eq!(
            found.iter().flatten().count(),
            largest(n, 0, 0, &contains),
            "{bits:b}"
        );
    }
}

/// Size of the largest matching of equations `row..` with unknowns outside `used`.
fn largest(n: usize, row: usize, used: u32, contains: &dyn Fn(usize, usize) -> bool) -> usize {
    if row == n {
        return 0;
    }
    let skipped = largest(n, row + 1, used, contains);
    (0..n)
        .filter(|&col| used >> col & 1 == 0 && contains(row, col))
        .map(|col| 1 + largest(n, row + 1, used | 1 << col, contains))
        .fold(skipped, usize::max)
}

#[test]
fn blocks_come_in_the_order_they_are_needed() {
    // Unknowns 1 and 2 together, then 0, then 3 which needs 0.
    let pattern = Pattern::new(
        4,
        [
            (0, 0),
            (0, 1),
            (1, 1),
            (1, 2),
            (2, 1),
            (2, 2),
            (3, 3),
            (3, 0),
        ],
    );
    let matching: Vec<_> = pattern.matching().into_iter().flatten().collect();
    let blocks = pattern.blocks(&matching);
    assert_eq!(
        blocks,
        [
            (vec![1, 2], vec![1, 2]),
            (vec![0], vec![0]),
            (vec![3], vec![3])
        ]
    );
}
