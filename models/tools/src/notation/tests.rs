use super::{components, power_of_ten, unit, value};
use residua::description::Variable;

fn variable(rows: usize, cols: usize) -> Variable {
    Variable {
        name: "q",
        ascii: "q",
        rows,
        cols,
        unit: "1",
        dimensionless: true,
        doc: "",
    }
}

#[test]
fn components_are_named_by_axis_number_or_place() {
    assert_eq!(components(&variable(1, 1)), ["q"]);
    assert_eq!(components(&variable(3, 1)), ["q.x", "q.y", "q.z"]);
    assert_eq!(components(&variable(4, 1)), ["q.1", "q.2", "q.3", "q.4"]);
    assert_eq!(
        components(&variable(2, 2)),
        ["q.11", "q.12", "q.21", "q.22"]
    );
    assert_eq!(components(&variable(1, 10))[9], "q.1_10");
}

#[test]
fn units_are_printed_with_raised_exponents() {
    assert_eq!(unit("kg*m^2/s^2"), "kg·m²/s²");
    assert_eq!(unit("m^(1/2)*s^-10"), "m^(1/2)·s⁻¹⁰");
    assert_eq!(power_of_ten(-14), "10⁻¹⁴");
}

#[test]
fn values_are_printed_as_the_language_writes_them() {
    assert_eq!(value(&[0.48], (1, 1)), "0.48");
    assert_eq!(value(&[0.0, -1.0, 1.0 / 3.0], (3, 1)), "[0, -1, 0.333333]");
    assert_eq!(value(&[1.0, 0.0, 0.0, 1.0], (2, 2)), "[[1, 0], [0, 1]]");
    assert_eq!(value(&[100.0], (1, 1)), "100");
    assert_eq!(value(&[1234567.0], (1, 1)), "1234567");
    assert_eq!(value(&[1.5e-9], (1, 1)), "1.500e-9");
}
