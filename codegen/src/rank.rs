//! Rows of a matrix that say the same thing.

/// Largest pivot of a matrix without full rank, per row, its rows and columns scaled to 1: rounding. A regular
/// matrix of a model would need terms 1e14 apart after scaling to come near it.
const ROUNDING: f64 = 1e-14;

/// Smallest weight of a row that takes part in a dependence.
const TAKES_PART: f64 = 1e-8;

/// The rows of a vanishing combination, if the square matrix has one: Gaussian elimination with complete
/// pivoting, which keeps account of the combinations that it makes.
pub fn dependent_rows(matrix: &[Vec<f64>]) -> Option<Vec<usize>> {
    let n = matrix.len();
    let mut rows = scaled(matrix);
    for (i, row) in rows.iter_mut().enumerate() {
        row.extend((0..n).map(|j| if i == j { 1.0 } else { 0.0 }));
    }
    for k in 0..n {
        let (mut pivot, mut at) = (0.0, (k, k));
        for (i, row) in rows.iter().enumerate().skip(k) {
            for (j, entry) in row[..n].iter().enumerate().skip(k) {
                if entry.abs() > pivot {
                    (pivot, at) = (entry.abs(), (i, j));
                }
            }
        }
        if pivot <= ROUNDING * n as f64 {
            let weights = &rows[k][n..];
            return Some((0..n).filter(|&i| weights[i].abs() > TAKES_PART).collect());
        }
        rows.swap(k, at.0);
        rows.iter_mut().for_each(|row| row.swap(k, at.1));
        let (done, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / done[k][k];
            for (entry, above) in row.iter_mut().zip(&done[k]) {
                *entry -= factor * above;
            }
        }
    }
    None
}

/// The smallest pivot of a square matrix under complete pivoting; 0 for one without full rank or with an entry that
/// is not finite.
pub fn smallest_pivot(matrix: &[Vec<f64>]) -> f64 {
    let n = matrix.len();
    let mut rows = matrix.to_vec();
    let mut smallest = f64::INFINITY;
    for k in 0..n {
        let places = (k..n).flat_map(|i| (k..n).map(move |j| (i, j)));
        let largest =
            places.max_by(|&(i, j), &(r, s)| rows[i][j].abs().total_cmp(&rows[r][s].abs()));
        let Some((i, j)) = largest else { break };
        let pivot = rows[i][j].abs();
        if pivot == 0.0 || !pivot.is_finite() {
            return 0.0;
        }
        smallest = smallest.min(pivot);
        rows.swap(k, i);
        rows.iter_mut().for_each(|row| row.swap(k, j));
        let (done, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / done[k][k];
            for (entry, above) in row.iter_mut().zip(&done[k]).skip(k) {
                *entry -= factor * above;
            }
        }
    }
    smallest
}

/// The matrix with the largest entry of each row, then of each column, scaled to 1.
fn scaled(matrix: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let largest = |values: &mut dyn Iterator<Item = f64>| {
        let size = values.fold(0.0, |size: f64, v| size.max(v.abs()));
        if size > 0.0 { size } else { 1.0 }
    };
    let mut rows = matrix.to_vec();
    for row in &mut rows {
        let size = largest(&mut row.iter().copied());
        row.iter_mut().for_each(|entry| *entry /= size);
    }
    for j in 0..matrix.len() {
        let size = largest(&mut rows.iter().map(|row| row[j]));
        rows.iter_mut().for_each(|row| row[j] /= size);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::dependent_rows;

    #[test]
    fn regular_rows_are_independent() {
        assert_eq!(dependent_rows(&[vec![0.0, 1.0], vec![1.0, 0.0]]), None);
        assert_eq!(dependent_rows(&[vec![1e-200, 0.0], vec![5.0, 1e200]]), None);
    }

    #[test]
    fn the_rows_of_a_combination_are_found() {
        let matrix = [
            vec![1.0, 2.0, 3.0],
            vec![0.0, 7.0, 1.0],
            vec![-0.1, -0.2, -0.3],
        ];
        assert_eq!(dependent_rows(&matrix), Some(vec![0, 2]));
    }

    #[test]
    fn a_row_of_zeros_stands_alone() {
        assert_eq!(
            dependent_rows(&[vec![1.0, 2.0], vec![0.0, 0.0]]),
            Some(vec![1])
        );
    }
}
