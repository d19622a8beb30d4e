//! Grammar, numbers and names. Mistakes are in `codegen/tests/diagnostics`.

use super::ascii_spelling;
use super::name::Spelling;
use super::parse;
use super::parse_expression;
use super::parse_unit;
use crate::ast::Ast;
use crate::ast::Binary;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::Item;
use crate::diagnostic::Range;
use proc_macro2::Span;
use proc_macro2::TokenStream;

/// The expression with all its brackets, in prefix form.
fn tree(text: &str) -> String {
    let tokens: TokenStream = text.parse().expect("lexes");
    let expression = parse_expression(tokens).unwrap_or_else(|errors| panic!("{errors}"));
    let mut texts: Vec<String> = Vec::new();
    for expr in &expression.exprs {
        let of = |id: &ExprId| texts[id.index()].clone();
        let list = |ids: &[ExprId]| ids.iter().map(of).collect::<Vec<_>>().join(" ");
        texts.push(match &expr.kind {
            ExprKind::Number(value) => value.to_string(),
            ExprKind::Name(name, None) => name.ascii.clone(),
            ExprKind::Name(name, Some(level)) => format!("{}@{level:?}", name.ascii),
            ExprKind::Increment(name) => format!("Delta({})", name.ascii),
            ExprKind::Rate(name) => format!("der({})", name.ascii),
            ExprKind::Neg(a) => format!("(neg {})", of(a)),
            ExprKind::Binary(operator, a, b) => {
                let sign = match operator {
                    Binary::Add => '+',
                    Binary::Sub => '-',
                    Binary::Mul => '*',
                    Binary::Div => '/',
                    Binary::Pow => '^',
                };
                format!("({sign} {} {})", of(a), of(b))
            }
            ExprKind::Transpose(a) => format!("(T {})", of(a)),
            ExprKind::Field(a, index) => format!("(field{index} {})", of(a)),
            ExprKind::Call(name, arguments) => format!("({} {})", name.ascii, list(arguments)),
            ExprKind::Component(a, indices) => format!("(at {} {})", of(a), list(indices)),
            ExprKind::Stack(entries) => format!("[{}]", list(entries)),
            ExprKind::Blocks(rows) => {
                let rows: Vec<_> = rows.iter().map(|row| format!("[{}]", list(row))).collect();
                format!("[{}]", rows.join(""))
            }
        });
    }
    texts.swap_remove(expression.root.index())
}

fn ast(text: &str) -> Ast {
    let tokens: TokenStream = text.parse().expect("lexes");
    parse("test", tokens).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn operators_bind_as_in_print() {
    assert_eq!(tree("a + b*c - d"), "(- (+ a (* b c)) d)");
    assert_eq!(tree("a/b*c"), "(* (/ a b) c)");
    assert_eq!(tree("-x^2"), "(neg (^ x 2))");
    assert_eq!(tree("2^-x^3"), "(^ 2 (neg (^ x 3)))");
    assert_eq!(tree("a^b^c"), "(^ a (^ b c))");
    assert_eq!(tree("a*-b"), "(* a (neg b))");
    assert_eq!(tree("--a"), "(neg (neg a))");
    assert_eq!(tree("(a + b)*c"), "(* (+ a b) c)");
    assert_eq!(tree("-a.T*b"), "(* (neg (T a)) b)");
    assert_eq!(tree("x^2.T"), "(^ x (T 2))");
}

#[test]
fn levels_components_and_matrices_are_told_apart() {
    assert_eq!(
        tree("x[k] + x[k+1] - x[k + 1/2]"),
        "(- (+ x@Now x@Next) x@Half)"
    );
    assert_eq!(tree("x[k-1]"), "x@Previous");
    assert_eq!(tree("x[k+1](2).x"), "(field1 (at x@Next 2))");
    assert_eq!(tree("A(1, 2)"), "(A 1 2)");
    assert_eq!(tree("(A*b).y"), "(field2 (* A b))");
    assert_eq!(tree("[a, b,]"), "[a b]");
    assert_eq!(tree("[[a, b], [c, d]]"), "[[a b][c d]]");
    assert_eq!(tree("[[u, v]]"), "[[u v]]");
    assert_eq!(tree("[[1, 0].T*x, 2]"), "[(* (T [1 0]) x) 2]");
    assert_eq!(tree("[[1, 0], 2]"), "[[1 0] 2]");
}

#[test]
fn rates_and_increments_have_two_spellings() {
    assert_eq!(tree("ω̇ - der(ω)"), "(- der(omega) der(omega))");
    assert_eq!(tree("ẋ1"), "der(x1)");
    assert_eq!(
        tree("ΔΓ1 - Delta(Gamma1)"),
        "(- Delta(Gamma1) Delta(Gamma1))"
    );
    assert_eq!(tree("Δ(ω)"), "Delta(omega)");
    assert_eq!(tree("Deltaω"), "Deltaomega");
}

#[test]
fn names_are_transliterated_letter_by_letter() {
    let pairs = [
        ("ω", "omega"),
        ("Γ1", "Gamma1"),
        ("ρ_c", "rho_c"),
        ("Γa", "Gammaa"),
        ("ϕ", "phi"),
        ("φ", "phi"),
        ("ϵ", "epsilon"),
        ("µ", "mu"),
        ("x_1", "x_1"),
    ];
    for (name, ascii) in pairs {
        assert_eq!(ascii_spelling(name).as_deref(), Some(ascii));
    }
    assert_eq!(ascii_spelling("é"), None);
    // rustc hands over composed letters, files may hold decomposed ones.
    for spelling in ["\u{1e8b}", "x\u{307}"] {
        let read = super::name::read(spelling, Range::of(Span::call_site()));
        assert!(matches!(read, Ok(Spelling::Rate(name)) if name.ascii == "x"));
    }
}

#[test]
fn numbers_are_exact() {
    assert_eq!(tree("9.81"), "981/100");
    assert_eq!(tree("1e-3"), "1/1000");
    assert_eq!(tree("2."), "2");
    assert_eq!(tree("1_000.5"), "2001/2");
    assert_eq!(tree("2.5E+2"), "250");
    assert_eq!(tree("0.1 + 0.2"), "(+ 1/10 1/5)");
    assert_eq!(tree("1e300").len(), 301);
}

#[test]
fn doc_lines_at_the_top_belong_to_the_model() {
    let model = ast("/// The model.\n/// More.\nparam m = 1;");
    assert_eq!(model.doc, ["The model.", "More."]);
    let model = ast("//! The model.\n/// Mass.\nparam m = 1;\n/// Length.\nparam l = 2;");
    assert_eq!(model.doc, ["The model."]);
    let docs = model.items.iter().map(|item| match item {
        Item::Parameter(declaration) => declaration.doc.concat(),
        _ => String::new(),
    });
    assert_eq!(docs.collect::<Vec<_>>(), ["Mass.", "Length."]);
}

#[test]
fn texts_keep_the_blanks_of_the_author_but_no_line_breaks() {
    let model = ast("residual { a*b +  c // why\n   - d = 0; }");
    let Item::Residual(equations, _) = &model.items[0] else {
        panic!("a residual");
    };
    assert_eq!(equations[0].text, "a*b + c - d = 0");
}

#[test]
fn claims_are_cut_into_blocks() {
    let blocks = |text: &str| {
        let model = ast(&format!("claim jacobian \"Eq. 1\" {{ {text} }}"));
        let Item::Claim(claim) = &model.items[0] else {
            panic!("a claim");
        };
        let texts = |row: &Vec<(ExprId, String)>| {
            let texts: Vec<_> = row.iter().map(|(_, text)| text.as_str()).collect();
            texts.join(", ")
        };
        claim
            .blocks
            .iter()
            .map(texts)
            .collect::<Vec<_>>()
            .join("; ")
    };
    assert_eq!(blocks("[[2*J, 0], [h*S(1), 4*I]]"), "2*J, 0; h*S(1), 4*I");
    assert_eq!(blocks("[a, b]"), "a; b");
    assert_eq!(blocks("2*J"), "2*J");
    assert_eq!(blocks("[[a, b]].T"), "[[a, b]].T");
}

#[test]
fn units_print_as_they_are_written() {
    for (text, printed) in [
        ("J", "J"),
        ("rad / s", "rad/s"),
        ("N * m", "N*m"),
        ("kg*m^2/s^2", "kg*m^2/s^2"),
        ("1", "1"),
        ("1/s", "1/s"),
        ("s^-1*m", "1/s*m"),
        ("m^(1/2)/kg^(-3/2)", "m^(1/2)*kg^(3/2)"),
        ("Ω", "ohm"),
        ("1*m/1", "m"),
    ] {
        let unit = |text: &str| parse_unit(text.parse().expect("lexes")).map(|u| u.to_string());
        let once = unit(text).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(once, printed);
        assert_eq!(unit(&once).ok(), Some(once));
    }
    assert!(parse_unit("m s".parse().expect("lexes")).is_err());
}

#[test]
fn a_plus_sign_in_front_says_nothing() {
    for (signed, plain) in [
        ("+x", "x"),
        ("-+x", "-x"),
        ("x^+2", "x^2"),
        ("a - +b", "a - b"),
    ] {
        assert_eq!(tree(signed), tree(plain));
    }
}

#[test]
fn long_chains_do_not_nest() {
    let deep = 20_000;
    assert!(tree(&format!("{}x", "-".repeat(100))).starts_with("(neg (neg"));
    for chain in ["-", "+", "1+", "1*", "2^", "2^-"] {
        let text = format!("{}x", chain.repeat(deep));
        let tokens: TokenStream = text.parse().expect("lexes");
        assert!(parse_expression(tokens).is_ok(), "{chain}");
    }
    for suffix in [".T", "(1)"] {
        let text = format!("x{}", suffix.repeat(deep));
        let tokens: TokenStream = text.parse().expect("lexes");
        assert!(parse_expression(tokens).is_ok(), "{suffix}");
    }
}
