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
