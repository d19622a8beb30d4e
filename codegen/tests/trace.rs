//! The expression that is to blame where a model has no finite value.

use proc_macro2::TokenStream;
use residua_codegen::analyse;
use residua_codegen::ast::Form;
use residua_codegen::source::read_source;
use residua_codegen::trace::{Point, first_not_finite};

const MODEL: &str = "model! {
    param a = 2;
    state x;
    state y: [2];
    residual {
        Δx - h*sqrt(1 - x[k+1]^2) = 0;
        Δy - h*(y[k+1/2]/(x[k] - a) + exp(a*x[k+1])*y) = 0;
    }
    solve for increment;
    start { x = 0; y = [1, 2]; }
}";

/// As written, with its components.
type Written = (String, Vec<f64>);

/// The expression and its operands at a state and unknowns.
fn blamed(state: [f64; 3], unknowns: [f64; 3]) -> Option<(String, Vec<Written>)> {
    let tokens: TokenStream = read_source(MODEL.as_bytes()).unwrap();
    let model = analyse("m", tokens).unwrap().model;
    let point = Point {
        parameters: &[2.0],
        h: 0.1,
        t: 0.0,
        state: &state,
        unknowns: &unknowns,
    };
    let culprit = first_not_finite(&model, Form::Increment, &point).unwrap()?;
    let written = |valued: &residua_codegen::trace::Valued| {
        let (start, end) = (valued.range.start.start(), valued.range.end.end());
        let line = MODEL.lines().nth(start.line - 1).unwrap();
        line.chars()
            .take(end.column)
            .skip(start.column)
            .collect::<String>()
    };
    let operands = culprit
        .operands
        .iter()
        .map(|o| (written(o), o.values.clone()))
        .collect();
    Some((written(&culprit.whole), operands))
}

#[test]
fn finite_models_have_none() {
    assert_eq!(blamed([0.0, 1.0, 2.0], [0.1; 3]), None);
}

#[test]
fn the_innermost_expression_is_blamed() {
    let (whole, operands) = blamed([0.0, 1.0, 2.0], [3.0, 0.0, 0.0]).unwrap();
    assert_eq!(whole, "sqrt(1 - x[k+1]^2)");
    assert_eq!(operands, [("1 - x[k+1]^2".to_owned(), vec![-8.0])]);
    // In the second equation, where nothing is wrong in the first; both operands of a quotient are told.
    let (whole, operands) = blamed([2.0, 1.0, 2.0], [-1.5, 0.0, 0.0]).unwrap();
    assert_eq!(whole, "y[k+1/2]/(x[k] - a)");
    assert_eq!(operands[0], ("y[k+1/2]".to_owned(), vec![1.0, 2.0]));
    assert_eq!(operands[1].1, [0.0]);
}

#[test]
fn an_input_that_is_not_finite_is_blamed_itself() {
    let (whole, operands) = blamed([f64::NAN, 1.0, 2.0], [0.0; 3]).unwrap();
    assert_eq!((whole.as_str(), operands.len()), ("x[k+1]", 0));
}
