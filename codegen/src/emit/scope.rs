//! Identifiers: legal in Rust and unique in their scope.

use crate::model::Shape;
use proc_macro2::Ident;
use proc_macro2::Span;
use std::collections::HashMap;
use std::collections::HashSet;

/// Items and variants whose name in a `let` would be a pattern instead of a variable.
const PATTERNS: &[&str] = &[
    "Model",
    "Next",
    "NextCore",
    "Increment",
    "IncrementCore",
    "MODEL",
    "DESCRIPTION",
    "None",
    "Some",
    "Ok",
    "Err",
];

/// Arguments of emitted functions.
const ARGUMENTS: &[&str] = &[
    "parameters",
    "state",
    "scene",
    "step",
    "unknowns",
    "newest",
    "order",
    "sums",
    "products",
    "residual",
    "jacobian",
];

/// The identifiers of one scope.
pub(super) struct Scope {
    taken: HashSet<String>,
    /// The last number tried for each prefix: all before it are taken.
    numbers: HashMap<char, usize>,
}

impl Scope {
    /// The fields of a struct.
    pub(super) fn fields() -> Self {
        Self {
            taken: HashSet::new(),
            numbers: HashMap::new(),
        }
    }

    /// Variables.
    pub(super) fn variables() -> Self {
        Self {
            taken: PATTERNS.iter().map(|name| (*name).to_string()).collect(),
            numbers: HashMap::new(),
        }
    }

    /// Variables of a function with arguments.
    pub(super) fn function() -> Self {
        let mut scope = Self::variables();
        scope
            .taken
            .extend(ARGUMENTS.iter().map(|name| (*name).to_string()));
        scope
    }

    /// `wish`, or something close to it if that is taken.
    pub(super) fn claim(&mut self, wish: &str) -> Ident {
        let mut name = wish.to_string();
        let mut n = 1;
        while !self.taken.insert(identifier(&name).to_string()) {
            n += 1;
            name = if n == 2 {
                format!("{wish}_")
            } else {
                format!("{wish}_{n}")
            };
        }
        identifier(&name)
    }

    /// The first of `prefix1`, `prefix2`, … that is free.
    pub(super) fn number(&mut self, prefix: char) -> Ident {
        let n = self.numbers.entry(prefix).or_insert(1);
        while !self.taken.insert(format!("{prefix}{n}")) {
            *n += 1;
        }
        identifier(&format!("{prefix}{n}"))
    }
}

/// `name` as Rust spells it: keywords are raw or, where that is not allowed, get an underscore.
pub(super) fn identifier(name: &str) -> Ident {
    let span = Span::call_site();
    match name {
        "self" | "Self" | "super" | "crate" | "_" => Ident::new(&format!("{name}_"), span),
        // A keyword since edition 2024 that syn does not count yet.
        "gen" => Ident::new_raw(name, span),
        _ if syn::parse_str::<Ident>(name).is_err() => Ident::new_raw(name, span),
        _ => Ident::new(name, span),
    }
}

/// The components of `name`, row by row: `Γ` is `Gamma_x`, `Gamma_y`; `R` is `R_11`, `R_12`, ….
pub(super) fn components(name: &str, shape: Shape) -> Vec<String> {
    if shape.is_scalar() {
        return vec![name.to_string()];
    }
    let component = |i: usize| match (shape.cols, shape.rows) {
        (1, 2 | 3) => format!("{name}_{}", ["x", "y", "z"][i]),
        (1, _) => format!("{name}_{}", i + 1),
        (cols, rows) => {
            let separator = if rows.max(cols) > 9 { "_" } else { "" };
            format!("{name}_{}{separator}{}", i / cols + 1, i % cols + 1)
        }
    };
    (0..shape.len()).map(component).collect()
}
