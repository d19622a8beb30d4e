use super::Relation;

fn sides(relation: Relation, left: [[f64; 3]; 3]) -> (bool, bool) {
    let zero = [[0.0; 3]; 3];
    let swapped = match relation {
        Relation::Less => Relation::Greater,
        Relation::LessOrEqual => Relation::GreaterOrEqual,
        Relation::Greater => Relation::Less,
        Relation::GreaterOrEqual => Relation::LessOrEqual,
    };
    (
        relation.holds_for_matrices(&left, &zero),
        swapped.holds_for_matrices(&zero, &left),
    )
}

/// vᵀv for v = (a, b, c): of rank 1.
fn dyad(v: [f64; 3]) -> [[f64; 3]; 3] {
    v.map(|a| v.map(|b| a * b))
}

#[test]
fn definite_semidefinite_and_indefinite_matrices() {
    // 2 on the diagonal and −1 beside it: eigenvalues 2, 2 ± √2.
    let definite = [[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 2.0]];
    // Eigenvalues 3, 3, −1 + … : the minor of rows 1 and 2 is 1 − 4.
    let indefinite = [[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let singular = dyad([0.1, 0.7, -0.3]);
    for (matrix, strict, loose) in [
        (definite, true, true),
        (indefinite, false, false),
        (singular, false, true),
        ([[0.0; 3]; 3], false, true),
        (definite.map(|row| row.map(|x| -x)), false, false),
    ] {
        assert_eq!(sides(Relation::Greater, matrix), (strict, strict));
        assert_eq!(sides(Relation::GreaterOrEqual, matrix), (loose, loose));
    }
}

#[test]
fn units_of_rows_do_not_matter() {
    let mut matrix = [[2.0, -1.0, 0.0], [-1.0, 2.0, -1.0], [0.0, -1.0, 2.0]];
    let units = [1e-9, 1.0, 1e7];
    for i in 0..3 {
        for j in 0..3 {
            matrix[i][j] *= units[i] * units[j];
        }
    }
    assert_eq!(sides(Relation::Greater, matrix), (true, true));
}

#[test]
fn what_is_not_symmetric_or_no_number_is_not_definite() {
    let skewed = [[2.0, 1.0, 0.0], [-1.0, 2.0, 0.0], [0.0, 0.0, 1.0]];
    assert_eq!(sides(Relation::GreaterOrEqual, skewed), (false, false));
    for (i, j) in [(0, 0), (2, 2), (0, 1), (2, 0)] {
        let mut matrix = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]];
        (matrix[i][j], matrix[j][i]) = (f64::NAN, f64::NAN);
        assert_eq!(sides(Relation::GreaterOrEqual, matrix), (false, false));
    }
}

#[test]
fn components_compare_all() {
    let (low, high) = ([1.0, 2.0], [2.0, 2.0]);
    assert!(Relation::LessOrEqual.holds_for_all(&low, &high));
    assert!(!Relation::Less.holds_for_all(&low, &high));
    assert!(Relation::Less.holds_for_all(&low, &[1.5, 2.5]));
    assert!(Relation::GreaterOrEqual.holds_for_all(&high, &low));
    assert!(!Relation::Greater.holds_for_all(&high, &low));
    assert!(!Relation::LessOrEqual.holds_for_all(&[f64::NAN, 0.0], &[1.0, 1.0]));
}
