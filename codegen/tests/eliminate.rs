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

#[test]
fn what_decides_over_a_jump_is_kept() {
    // Linear in x and v but for the jump, whose derivative is 0.
    let friction = "state x; state v;
        residual { Δx = h*v[k+1]; Δv = -h*(x[k+1] + 0.3*sign(v[k+1])); }
        solve for next;
        start { x = 1; v = 0; }";
    assert_eq!(kept(friction), [1]);
    // The second equation alone tells v, once x is known.
    let relay = "state x; state v;
        residual { Δx = h*v[k+1]; Δv = -2*h*sign(x[k+1]); }
        solve for next;
        start { x = 1; v = 0; }";
    assert_eq!(kept(relay).len(), 1);
    // One beside every jump.
    let wave = "state x; state v;
        residual { Δx = h*v[k+1]; Δv = -h*atan(tan(x[k+1])); }
        solve for next;
        start { x = 1; v = 0; }";
    assert_eq!(kept(wave).len(), 1);
    // Nothing of x is in the derivative, nor of v.
    let identity = "state x; state v; state w;
        residual { Δx = h*v[k+1]; Δv = -h*(cos(x[k+1])^2 + sin(x[k+1])^2); Δw = h*atan2(v[k+1], 2*v[k+1]); }
        solve for next;
        start { x = 1; v = 0; w = 0; }";
    assert!(!kept(identity).is_empty());
    let rates = "state x; flow { der(x) = -x - 0.3*sign(der(x)); }
        residual { Δx = 0; } start { x = 1; }";
    let errors = analyse("eliminate", lex(rates).expect("lexes")).err();
    let message = errors.expect("a jump is not linear").to_string();
    assert!(message.contains("linear in the rates"), "{message}");
}

#[test]
fn more_unknowns_than_are_compared_are_kept_for_a_jump_too() {
    // A chain of masses, of which neighbours rub on each other.
    let n = 12;
    let mut text = String::new();
    for i in 0..n {
        text += &format!("state x{i}; state v{i};\n");
    }
    text += "residual {\n";
    for i in 0..n {
        let rub = |i: usize| format!("sign(v{i}[k+1] - v{}[k+1])", i + 1);
        let below = if i > 0 { rub(i - 1) } else { "0".to_owned() };
        let above = if i + 1 < n { rub(i) } else { "0".to_owned() };
        text +=
            &format!("Δx{i} = h*v{i}[k+1]; Δv{i} = h*(0.1*{below} - 0.1*{above} - x{i}[k+1]);\n");
    }
    text += "} solve for next; start {";
    for i in 0..n {
        text += &format!("x{i} = 0; v{i} = {i};");
    }
    let kept = kept(&(text + "}"));
    // Every other one is what the jumps are decided by.
    assert!((0..n).all(|i| kept.contains(&(2 * i + 1))), "{kept:?}");
}
