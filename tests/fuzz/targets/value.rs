//! Values as they stand on the command line: as many numbers as there are components, or a message.
#![no_main]

use libfuzzer_sys::fuzz_target;
use residua_codegen::model::Shape;
use residua_codegen::{Quantity, evaluate};

fuzz_target!(|text: &str| {
    let quantity = |name, shape, unit| Quantity { name, shape, unit };
    let matrix = Shape { rows: 3, cols: 3 };
    let mass = quantity("m", Shape::SCALAR, "kg");
    let inertia = quantity("J", matrix, "kg*m^2");
    let numbers: Vec<f64> = (1..=9).map(f64::from).collect();
    let symbols = [(mass, &numbers[..1]), (inertia, &numbers[..])];
    for target in [mass, inertia, quantity("Γ", Shape::vector(3), "1")] {
        match evaluate(text, target, &symbols) {
            Ok(values) => assert_eq!(values.len(), target.shape.len()),
            Err(message) => assert!(!message.is_empty()),
        }
    }
});
