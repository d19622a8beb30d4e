//! What is eliminated, and what is not.

use residua_codegen::Analysis;
use residua_codegen::analyse;
use residua_codegen::source::lex;

fn analysis(text: &str) -> Analysis {
    match analyse("eliminate", lex(text).expect("lexes")) {
        Ok(analysis) => analysis,
        Err(errors) => panic!("{errors}"),
    }
}

/// The unknowns of the core.
fn kept(text: &str) -> Vec<usize> {
    let core = analysis(text).systems.remove(0).core;
    core.expect("a core").reduced.unknowns
}

#[test]
fn a_block_without_a_solution_does_not_spoil_the_others() {
    // With a = 1 put in, nothing is left of the coefficient of b; a and c have nothing to do with it.
    let text = "state a; state b; state c;
        residual {
            a[k+1] = 1;
            (a[k+1] - 1)*b[k+1] = b;
            c[k+1] = c + h;
        }
        solve for next;
        start { a = 1; b = 0; c = 0; }";
    assert_eq!(kept(text), [1]);
}

/// A(y) z = y and one equation for each y, n of both; every entry of A is another function of all y.
fn coupled(n: usize) -> String {
    let mut text = String::new();
    for i in 0..n {
        text += &format!("state y{i}; state z{i};\n");
    }
    text += "residual {\n";
    for i in 0..n {
        let term = |j: usize| {
            let part = |k: usize| format!("0.{}*y{k}[k+1]", 1 + (3 * i + 5 * j + 7 * k) % 9);
            let parts: Vec<String> = (0..n).map(part).collect();
            let diagonal = if i == j { 9 } else { 0 };
            format!("({diagonal} + exp({}))*z{j}[k+1]", parts.join(" + "))
        };
        let terms: Vec<String> = (0..n).map(term).collect();
        text += &format!("{} = y{i};\n", terms.join(" + "));
        text += &format!("y{i}[k+1]^3 + y{i}[k+1] + sin(z{i}[k+1]) = y{i};\n");
    }
    let start: Vec<String> = (0..n).map(|i| format!("y{i} = 1; z{i} = 1;")).collect();
    format!("{text}}}\nsolve for next;\nstart {{ {} }}", start.join(" "))
}

#[test]
fn a_closed_form_that_takes_far_more_than_the_dense_solve_is_left_alone() {
    assert_eq!(kept(&coupled(2)).len(), 2);
    assert!(analysis(&coupled(6)).systems[0].core.is_none());
}
