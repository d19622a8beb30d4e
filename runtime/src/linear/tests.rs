use super::SquareMatrix;

#[test]
fn rows_are_exchanged_for_a_zero_pivot() {
    let matrix = [[0.0, 2.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!(matrix.solve(&[7.0, 1.0, 2.0]), Some([1.0, 2.0, 3.0]));
}

#[test]
fn rows_come_first() {
    let matrix: [[f32; 2]; 2] = [[1.0, 2.0], [0.0, 1.0]];
    assert_eq!(matrix.solve(&[5.0, 2.0]), Some([1.0, 2.0]));
    assert_eq!(matrix.entries(), [1.0, 2.0, 0.0, 1.0]);
}

#[test]
fn a_singular_matrix_has_no_solution() {
    assert_eq!([[1.0, 2.0], [2.0, 4.0]].solve(&[1.0, 1.0]), None);
}

#[test]
fn equations_may_have_any_units() {
    fn solve<const N: usize>(scale: f64) -> [f64; N]
    where
        [[f64; N]; N]: SquareMatrix<f64, Vector = [f64; N]>,
    {
        // x₁ + 1e8 xₖ and such, solved by ones; the first equation in other units.
        let mut a = [[0.0; N]; N];
        let mut b = [0.0; N];
        for (i, row) in a.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = 1.0 / (1.0 + (i + 2 * j) as f64);
            }
            row[i] += 1.0;
        }
        a[0][N - 1] += 1e8;
        for (row, b) in a.iter_mut().zip(&mut b) {
            *b = row.iter().sum();
        }
        a[0] = a[0].map(|entry| entry * scale);
        b[0] *= scale;
        a.solve(&b).unwrap()
    }
    for scale in [1.0, 1e-200, 1e160] {
        let off = |x: &[f64]| x.iter().fold(0.0, |most: f64, x| most.max((x - 1.0).abs()));
        assert!(off(&solve::<2>(scale)) < 1e-14, "{scale:e}");
        assert!(off(&solve::<8>(scale)) < 1e-14, "{scale:e}");
    }
}
