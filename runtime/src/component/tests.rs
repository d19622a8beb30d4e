use std::string::ToString;

use super::Component;
use crate::description::Variable;

const fn variable(name: &'static str, rows: usize, cols: usize) -> Variable {
    Variable {
        name,
        ascii: name,
        rows,
        cols,
        unit: "1",
        dimensionless: true,
        doc: "",
    }
}

static VARIABLES: [Variable; 4] = [
    variable("ω", 1, 1),
    variable("Γ", 3, 1),
    variable("J", 2, 2),
    variable("q", 4, 1),
];

#[test]
fn components_are_named_as_in_the_file() {
    let names = [
        "ω", "Γ.x", "Γ.y", "Γ.z", "J(1,1)", "J(1,2)", "J(2,1)", "J(2,2)", "q(1)", "q(2)",
    ];
    for (position, name) in names.into_iter().enumerate() {
        let variables = &VARIABLES;
        let component = Component {
            variables,
            position,
        };
        assert_eq!(component.to_string(), name);
    }
}

#[test]
fn a_position_outside_the_description_is_named_by_its_number() {
    let variables = &VARIABLES;
    let component = Component {
        variables,
        position: 12,
    };
    assert_eq!(component.to_string(), "component 12");
}
