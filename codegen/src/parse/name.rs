//! Identifiers: one name in two spellings, Greek and ASCII.

use crate::ast::Name;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use unicode_normalization::UnicodeNormalization;

/// U+0307, the dot of a rate.
const DOT: char = '\u{307}';

/// U+0308, the two dots of a second rate.
const TWO_DOTS: char = '\u{308}';

/// What an identifier says.
#[derive(Clone, Debug)]
pub(super) enum Spelling {
    /// `ω`
    Plain(Name),
    /// `ω̇`: the rate of ω.
    Rate(Name),
    /// `Δω`: the increment of ω.
    Increment(Name),
}

/// Reads an identifier; fails if it has no ASCII spelling.
pub(super) fn read(identifier: &str, range: Range) -> Result<Spelling, Diagnostic> {
    let complain = |message: String, help: &str| Diagnostic {
        range,
        message,
        help: Some(help.to_owned()),
    };
    let mut letters: Vec<char> = identifier.nfd().collect();
    let increment = letters.len() > 1 && letters[0] == 'Δ';
    if increment {
        letters.remove(0);
    }
    let rate = letters.get(1) == Some(&DOT);
    if rate {
        letters.remove(1);
    }
    if letters.get(1) == Some(&TWO_DOTS) {
        let message = format!("`{identifier}` is a second rate, expected at most one dot");
        let help = "make the velocity a state and write its rate";
        return Err(complain(message, help));
    }
    if increment && rate {
        let message = format!("`{identifier}` is the increment of a rate, expected one of the two");
        let help = "Δ belongs to a state; der(x) in a residual is Δx/h";
        return Err(complain(message, help));
    }
    let display: String = letters.iter().copied().nfc().collect();
    let Some(ascii) = transliterate(&letters) else {
        let message = format!("`{identifier}` has no ASCII spelling");
        let help = "names are made of Latin and Greek letters, digits and `_`; \
                    a dot above the first letter means the rate";
        return Err(complain(message, help));
    };
    let name = Name {
        ascii,
        display,
        range,
    };
    Ok(match (increment, rate) {
        (true, _) => Spelling::Increment(name),
        (_, true) => Spelling::Rate(name),
        _ => Spelling::Plain(name),
    })
}

/// The ASCII spelling of a plain name, however it is typed: `ω1` and `omega1` both give `omega1`.
pub fn ascii_spelling(name: &str) -> Option<String> {
    transliterate(&name.nfd().collect::<Vec<_>>())
}

fn transliterate(letters: &[char]) -> Option<String> {
    let mut ascii = String::new();
    for &letter in letters {
        if letter.is_ascii_alphanumeric() || letter == '_' {
            ascii.push(letter);
        } else {
            ascii.push_str(greek(letter)?);
        }
    }
    Some(ascii)
}

/// The name of a Greek letter, as LaTeX spells it.
fn greek(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' => "delta",
        'ε' | 'ϵ' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' | 'ϑ' => "theta",
        'ι' => "iota",
        'κ' | 'ϰ' => "kappa",
        'λ' => "lambda",
        'μ' | 'µ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'ο' => "omicron",
        'π' | 'ϖ' => "pi",
        'ρ' | 'ϱ' => "rho",
        'σ' | 'ς' => "sigma",
        'τ' => "tau",
        'υ' => "upsilon",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'Α' => "Alpha",
        'Β' => "Beta",
        'Γ' => "Gamma",
        'Δ' => "Delta",
        'Ε' => "Epsilon",
        'Ζ' => "Zeta",
        'Η' => "Eta",
        'Θ' | 'ϴ' => "Theta",
        'Ι' => "Iota",
        'Κ' => "Kappa",
        'Λ' => "Lambda",
        'Μ' => "Mu",
        'Ν' => "Nu",
        'Ξ' => "Xi",
        'Ο' => "Omicron",
        'Π' => "Pi",
        'Ρ' => "Rho",
        'Σ' => "Sigma",
        'Τ' => "Tau",
        'Υ' => "Upsilon",
        'Φ' => "Phi",
        'Χ' => "Chi",
        'Ψ' => "Psi",
        'Ω' => "Omega",
        _ => return None,
    })
}
