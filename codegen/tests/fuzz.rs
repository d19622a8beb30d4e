//! Whatever the tokens, the generator answers with a model or with mistakes, and soon.

use proc_macro2::TokenStream;
use proc_macro2::TokenTree;
use residua_codegen::Quantity;
use residua_codegen::analyse;
use residua_codegen::analyse_scene;
use residua_codegen::ast::KEYWORDS;
use residua_codegen::compile;
use residua_codegen::compile_scene;
use residua_codegen::evaluate;
use residua_codegen::expand;
use residua_codegen::model::Shape;
use residua_codegen::source::lex;
use residua_codegen::source::read_scene;
use residua_codegen::source::read_source;
use std::fs;
use std::path::Path;

/// A model with every statement of the language.
const GOOD: &str = include_str!("complete.model.in");

/// Words and signs that mean something besides those that begin a statement, and some that do not.
const WORDS: &[&str] = &[
    "for",
    "next",
    "increment",
    "jacobian",
    "\"Eq. 1\"",
    "x",
    "y",
    "ω",
    "Γ",
    "Δω",
    "ω̇",
    "Δ",
    "der",
    "Delta",
    "k",
    "h",
    "t",
    "I",
    "pi",
    "S",
    "sin",
    "exp",
    "diag",
    "inv",
    "cross",
    "stumpff",
    "T",
    "kg",
    "m",
    "s",
    "0",
    "1",
    "2",
    "9.81",
    "1e-3",
    "127",
    "1f64",
    "'c'",
    "é",
    "=",
    ";",
    ":",
    ",",
    ".",
    "+",
    "-",
    "*",
    "/",
    "^",
    "#",
    "!",
    "'a",
    "_",
];

/// A scene of it with every statement.
const SCENE: &str = "model complete;
    fix m = 2; fix J = diag(1, 1, 1); fix ρ = [0, 0, 0.3]; fix g = 9.81;
    let R0 = Rx(pi/3)*Ry(0.1);
    start { R = R0; ω = [0.5, 0, 0]; x = 0; }
    step 0.1; until 100; form next; keep ω, tilt;";

/// Words of scenes.
const SCENE_WORDS: &[&str] = &[
    "model",
    "complete",
    "fix",
    "let",
    "start",
    "step",
    "until",
    "keep",
    "form",
    "next",
    "increment",
    "m",
    "J",
    "ρ",
    "g",
    "c",
    "R",
    "ω",
    "x",
    "v",
    "F",
    "e3",
    "tilt",
    "energy",
    "R0",
    "h",
    "t",
    "I",
    "pi",
    "diag",
    "0",
    "1",
    "-1",
    "1e400",
    "=",
    ";",
    ",",
    ".",
    "*",
    "/",
    "[",
    "]",
    "é",
    "\"a\"",
];

const SEED: u64 = 0x2545_f491_4f6c_dd1d;

/// Marsaglia's xorshift, period 2⁶⁴ − 1.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n as u64) as usize
    }

    fn word(&mut self) -> &'static str {
        let i = self.below(KEYWORDS.len() + WORDS.len());
        KEYWORDS.iter().chain(WORDS).nth(i).expect("one of them")
    }
}

/// The tokens of a text one by one, brackets included.
fn words(tokens: TokenStream, words: &mut Vec<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => {
                let text = group.to_string();
                words.extend(text.chars().next().map(String::from));
                self::words(group.stream(), words);
                words.extend(text.chars().last().map(String::from));
            }
            other => words.push(other.to_string()),
        }
    }
}

/// Runs the generator; true if it found a model.
fn survives(text: &str) -> bool {
    let Ok(tokens) = lex(text) else {
        return false;
    };
    match analyse("fuzz", tokens) {
        Ok(_) => true,
        Err(errors) => {
            assert!(!errors.to_string().is_empty());
            false
        }
    }
}

#[test]
fn the_complete_model_is_right() {
    let tokens = lex(GOOD).expect("lexes");
    let mistakes = analyse("complete", tokens).map_or_else(|e| e.to_string(), |_| String::new());
    assert_eq!(mistakes, "");
}

#[test]
fn token_soup_is_survived() {
    let mut random = Random(SEED);
    for _ in 0..2000 {
        let mut text = String::new();
        let mut open = Vec::new();
        for _ in 0..random.below(60) {
            match random.below(8) {
                0 => {
                    let pair = [("(", ")"), ("[", "]"), ("{", "}")][random.below(3)];
                    text.push_str(pair.0);
                    open.push(pair.1);
                }
                1 => text.push_str(open.pop().unwrap_or(";")),
                _ => text.push_str(random.word()),
            }
            text.push(' ');
        }
        text.extend(open.into_iter().rev());
        survives(&text);
    }
}

#[test]
fn mutated_models_are_survived() {
    let mut good = Vec::new();
    words(lex(GOOD).expect("lexes"), &mut good);
    let mut random = Random(SEED);
    let mut models = 0;
    for _ in 0..2000 {
        let mut words = good.clone();
        for _ in 0..=random.below(3) {
            let (i, j) = (random.below(words.len()), random.below(words.len()));
            match random.below(5) {
                0 => drop(words.remove(i)),
                1 => words.insert(i, words[j].clone()),
                2 => words.swap(i, j),
                3 => words[i] = words[j].clone(),
                _ => words[i] = random.word().to_owned(),
            }
        }
        models += usize::from(survives(&words.join(" ")));
    }
    // Some mutations, such as 1 for 2, leave a model; if none did, the test would test little.
    assert!(models > 10, "{models}");
}

/// Runs the generator on a scene; true if it found one.
fn scene_survives(text: &str) -> bool {
    let Ok(tokens) = lex(text) else {
        return false;
    };
    let model = |_: &str| Ok(format!("model! {{ {GOOD} }}"));
    match analyse_scene("fuzz", tokens, &model) {
        Ok(_) => true,
        Err(errors) => {
            assert!(!errors.to_string().is_empty());
            false
        }
    }
}

#[test]
fn mutated_scenes_are_survived() {
    let tokens = lex(SCENE).expect("lexes");
    let model = |_: &str| Ok(format!("model! {{ {GOOD} }}"));
    let mistakes = analyse_scene("complete", tokens.clone(), &model);
    assert_eq!(
        mistakes.map_or_else(|e| e.to_string(), |_| String::new()),
        ""
    );
    let mut good = Vec::new();
    words(tokens, &mut good);
    let mut random = Random(SEED);
    let mut scenes = 0;
    for round in 0..400 {
        let mut words = good.clone();
        for _ in 0..=round % 2 {
            let (i, j) = (random.below(words.len()), random.below(words.len()));
            match random.below(5) {
                0 => drop(words.remove(i)),
                1 => words.insert(i, words[j].clone()),
                2 => words.swap(i, j),
                3 => words[i] = words[j].clone(),
                _ => words[i] = SCENE_WORDS[random.below(SCENE_WORDS.len())].to_owned(),
            }
        }
        scenes += usize::from(scene_survives(&words.join(" ")));
    }
    assert!(scenes > 10, "{scenes}");
}

/// What a fuzzer has found worth keeping, in `tests/fuzz/corpus`: `cargo +nightly fuzz run --fuzz-dir tests/fuzz model` goes on
/// from there.
#[test]
fn inputs_that_were_found_are_survived() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/fuzz/corpus");
    let mut files = 0;
    for target in ["model", "parse", "scene", "value"] {
        for entry in fs::read_dir(corpus.join(target)).expect(target) {
            let bytes = fs::read(entry.expect("a file").path()).expect("a file");
            files += 1;
            if let Ok(tokens) = read_source(&bytes) {
                let code = || match compile("fuzz", tokens.clone()) {
                    Ok(code) => code.to_string(),
                    Err(_) => expand("fuzz", tokens.clone()).to_string(),
                };
                assert_eq!(code(), code());
            }
            if let Ok(tokens) = read_scene(&bytes) {
                let read = |_: &str| Ok(format!("model! {{ {GOOD} }}"));
                if let Err(errors) = compile_scene("fuzz", tokens, &read) {
                    assert!(!errors.to_string().is_empty());
                }
            }
            if let Ok(text) = core::str::from_utf8(&bytes) {
                let target = Quantity {
                    name: "x",
                    shape: Shape::SCALAR,
                    unit: "1",
                };
                if let Err(message) = evaluate(text, target, &[]) {
                    assert!(!message.is_empty());
                }
            }
        }
    }
    assert!(files >= 150, "{files}");
}
