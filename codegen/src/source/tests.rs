use super::*;

fn refusal(text: &str) -> String {
    read_source(text.as_bytes()).map_or_else(|e| e.to_string(), |tokens| format!("read: {tokens}"))
}

#[test]
fn the_tokens_inside_the_braces_are_read() {
    assert_eq!(refusal("model! { state x; }"), "read: state x ;");
    assert_eq!(
        refusal("// } a comment\nresidua::model! { state x; };"),
        "read: state x ;"
    );
}

#[test]
fn whatever_is_no_model_file_is_refused_with_its_place() {
    assert_eq!(refusal(""), "1:1: expected `model! { … }`");
    assert_eq!(refusal("fn main() {}"), "1:1: expected `model! { … }`");
    assert_eq!(refusal("model! [ ]"), "1:1: expected `model! { … }`");
    let twice = "model! { }\nmodel! { }";
    assert_eq!(
        refusal(twice),
        "2:1: expected nothing but one `model! { … }` in the file"
    );
    assert_eq!(
        refusal("use x;\nmodel! { }"),
        "1:1: expected nothing but one `model! { … }` in the file"
    );
}

#[test]
fn brackets_are_told_by_line_and_column() {
    assert_eq!(
        refusal("model! {\n  let a = (1 + 2;\n}"),
        "3:1: this `}` does not close the `(` of line 2"
    );
    assert_eq!(
        refusal("model! {\n  let a = [1;\n"),
        "2:11: this `[` is never closed"
    );
    assert_eq!(refusal("model! { } )"), "1:12: this `)` closes nothing");
}

#[test]
fn comments_and_strings_may_hold_brackets() {
    let text = "model! { /* ( /* [ */ */ claim jacobian \"a) \\\" (\" { } // {\n }";
    assert!(read_source(text.as_bytes()).is_ok(), "{}", refusal(text));
}

#[test]
fn deep_nesting_large_files_and_other_encodings_are_refused() {
    let deep = format!("model! {{ {} }}", "(".repeat(100_000));
    assert_eq!(
        refusal(&deep),
        format!(
            "1:{}: brackets nest more than {DEEPEST} deep",
            10 + DEEPEST - 1
        )
    );
    let large = " ".repeat(LARGEST + 1);
    assert_eq!(
        refusal(&large),
        "1:1: the file has 1048577 bytes, expected at most 1048576"
    );
    let error = read_source(b"model! {\n  // \xe9\n}").expect_err("Latin-1");
    assert_eq!(error.to_string(), "2:6: byte 14 (0xe9) is not UTF-8");
}

#[test]
fn what_rust_cannot_lex_is_left_to_rustc() {
    let error = read_source("model! { x' = 1\u{0}; }".as_bytes()).expect_err("no token");
    assert!(error.lexical);
}
