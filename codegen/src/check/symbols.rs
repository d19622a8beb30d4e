//! The names that a model declares.

use crate::ast::Ast;
use crate::ast::ExprId;
use crate::ast::Item;
use crate::ast::KEYWORDS;
use crate::ast::Name;
use crate::ast::OutputKind;
use crate::ast::TypeExpr;
use crate::diagnostic::Errors;
use crate::function::Function;
use std::collections::BTreeMap;

/// Shortest name for which a misspelling is guessed: with fewer letters everything is similar.
const SHORTEST_GUESSED: usize = 3;

/// Latin letters and the Greek ones that they are taken for.
const LOOKALIKES: [(&str, &str); 8] = [
    ("a", "alpha"),
    ("n", "eta"),
    ("o", "sigma"),
    ("p", "rho"),
    ("u", "mu"),
    ("v", "nu"),
    ("w", "omega"),
    ("y", "gamma"),
];

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Parameter,
    State,
    Unknown,
    Let,
    Output(OutputKind),
}

impl Kind {
    /// The kind in words.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Kind::Parameter => "a parameter",
            Kind::State => "a state",
            Kind::Unknown => "an unknown",
            Kind::Let => "a `let`",
            Kind::Output(OutputKind::Invariant) => "an invariant",
            Kind::Output(OutputKind::Observable) => "an observable",
        }
    }
}

/// A name that is there without being declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Builtin {
    Pi,
    Identity,
    StepSize,
    Time,
    Counter,
    Rate,
    Increment,
}

impl Builtin {
    /// The builtin called `ascii`.
    pub(super) fn named(ascii: &str) -> Option<Builtin> {
        Some(match ascii {
            "pi" => Builtin::Pi,
            "I" => Builtin::Identity,
            "h" => Builtin::StepSize,
            "t" => Builtin::Time,
            "k" => Builtin::Counter,
            "der" => Builtin::Rate,
            "Delta" => Builtin::Increment,
            _ => return None,
        })
    }

    /// What it is, in words.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Builtin::Pi => "the number π",
            Builtin::Identity => "the identity matrix",
            Builtin::StepSize => "the step size",
            Builtin::Time => "the time",
            Builtin::Counter => "the step counter of `x[k+1]`",
            Builtin::Rate => "the rate `der(x)`",
            Builtin::Increment => "the increment `Delta(x)`",
        }
    }
}

/// A declaration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Symbol<'a> {
    pub(super) kind: Kind,
    /// Position among the declarations of its kind, invariants and observables counted together.
    pub(super) index: usize,
    pub(super) name: &'a Name,
    pub(super) doc: &'a [String],
    /// Shape and unit; a `let` has none.
    pub(super) ty: Option<&'a TypeExpr>,
    /// Default, first guess or value; a state has none.
    pub(super) value: Option<ExprId>,
    /// The name has another meaning as well, which is complained about; nothing is known of it.
    pub(super) contested: bool,
}

/// All declarations in file order.
#[derive(Debug)]
pub(super) struct Symbols<'a> {
    pub(super) list: Vec<Symbol<'a>>,
    by_name: BTreeMap<&'a str, usize>,
}

impl<'a> Symbols<'a> {
    /// Collects the declarations; complains about reserved and repeated names.
    pub(super) fn collect(ast: &'a Ast, errors: &mut Errors) -> Self {
        let mut symbols = Symbols {
            list: Vec::new(),
            by_name: BTreeMap::new(),
        };
        for mut symbol in ast.items.iter().filter_map(declaration) {
            let name = symbol.name;
            complain_if_reserved(symbol.kind, name, errors);
            symbol.contested = Builtin::named(&name.ascii).is_some();
            let position = symbols.list.len();
            let first = *symbols.by_name.entry(&name.ascii).or_insert(position);
            if first != position {
                errors.push(name.range, duplicate(name, &symbols.list[first]));
                // No expression names an output, so its name is in doubt only where it was first.
                if matches!(symbol.kind, Kind::Output(_)) {
                    continue;
                }
                symbol.contested = true;
                symbols.list[first].contested = true;
            }
            symbol.index = symbols.of_kind(symbol.kind).count();
            symbols.list.push(symbol);
        }
        symbols
    }

    /// The first declaration of each name that is not reserved, none of them contested any more.
    pub(super) fn settled(self) -> Self {
        let mut settled = Symbols {
            list: Vec::new(),
            by_name: BTreeMap::new(),
        };
        for symbol in self.list {
            let ascii = symbol.name.ascii.as_str();
            if Builtin::named(ascii).is_none() && !settled.by_name.contains_key(ascii) {
                settled.by_name.insert(ascii, settled.list.len());
                settled.list.push(Symbol {
                    index: settled.of_kind(symbol.kind).count(),
                    contested: false,
                    ..symbol
                });
            }
        }
        settled
    }

    /// Position in the list of the declaration of `name`.
    pub(super) fn find(&self, name: &Name) -> Option<usize> {
        self.by_name.get(name.ascii.as_str()).copied()
    }

    /// True if `name` is declared with a meaning that is in doubt.
    pub(super) fn is_contested(&self, name: &Name) -> bool {
        self.find(name).is_some_and(|i| self.list[i].contested)
    }

    /// True if the meaning of some name is in doubt.
    pub(super) fn any_contested(&self) -> bool {
        self.list.iter().any(|symbol| symbol.contested)
    }

    /// The declarations of one kind, in file order, with their positions in the list.
    pub(super) fn of_kind(&self, kind: Kind) -> impl Iterator<Item = (usize, &Symbol<'a>)> {
        let same = move |other: Kind| match (kind, other) {
            (Kind::Output(_), Kind::Output(_)) => true,
            _ => kind == other,
        };
        self.list
            .iter()
            .enumerate()
            .filter(move |(_, symbol)| same(symbol.kind))
    }

    /// What the author of an unknown name may have meant.
    pub(super) fn similar(&self, name: &Name) -> Option<&str> {
        let lookalike = LOOKALIKES.iter().find(|pair| pair.0 == name.ascii);
        let distance = |candidate: &str| {
            let looks_alike = lookalike.is_some_and(|pair| pair.1 == candidate);
            if looks_alike || candidate.eq_ignore_ascii_case(&name.ascii) {
                return Some(0);
            }
            let shortest = candidate.len().min(name.ascii.len());
            let distance = strsim::damerau_levenshtein(candidate, &name.ascii);
            (shortest >= SHORTEST_GUESSED && distance <= 1 + shortest / 6).then_some(distance)
        };
        let usable = self
            .list
            .iter()
            .filter(|symbol| !matches!(symbol.kind, Kind::Output(_)))
            .map(|symbol| symbol.name);
        let nearest = usable
            .clone()
            .filter_map(|candidate| Some((distance(&candidate.ascii)?, candidate)))
            .min_by_key(|(distance, _)| *distance)
            .map(|(_, candidate)| candidate);
        // Short names are guessed where only one comes near.
        let mut near = usable.filter(|candidate| is_near(&candidate.ascii, &name.ascii));
        let only = near.next().filter(|_| near.next().is_none());
        nearest.or(only).map(|candidate| candidate.display.as_str())
    }
}

/// True for short names that differ in one character behind the first: `b` and `bb`, `m1` and `m2`.
fn is_near(a: &str, b: &str) -> bool {
    a.chars().next() == b.chars().next() && strsim::damerau_levenshtein(a, b) == 1
}

fn duplicate(name: &Name, first: &Symbol) -> String {
    let (shown, other, line) = (&name.display, &first.name.display, first.name.range.line());
    if shown == other {
        format!("`{shown}` is already {} in line {line}", first.kind.noun())
    } else {
        format!("`{shown}` and `{other}` in line {line} are one name")
    }
}

/// The declaration in a statement, its index still to be found.
fn declaration(item: &Item) -> Option<Symbol<'_>> {
    let (kind, name, doc, ty, value) = match item {
        Item::Parameter(d) => (
            Kind::Parameter,
            &d.name,
            d.doc.as_slice(),
            Some(&d.ty),
            d.value,
        ),
        Item::State(d) => (Kind::State, &d.name, d.doc.as_slice(), Some(&d.ty), None),
        Item::Unknown(d) => (
            Kind::Unknown,
            &d.name,
            d.doc.as_slice(),
            Some(&d.ty),
            d.value,
        ),
        Item::Let(name, value) => (Kind::Let, name, [].as_slice(), None, Some(*value)),
        Item::Output(o) => (
            Kind::Output(o.kind),
            &o.name,
            o.doc.as_slice(),
            Some(&o.ty),
            Some(o.value),
        ),
        Item::Flow(..)
        | Item::Residual(..)
        | Item::SolveFor(..)
        | Item::Update(..)
        | Item::Start(..)
        | Item::Claim(_)
        | Item::Requirement(_) => return None,
    };
    Some(Symbol {
        kind,
        index: 0,
        name,
        doc,
        ty,
        value,
        contested: false,
    })
}

/// Complains about a name that is not free.
pub(super) fn complain_if_reserved(kind: Kind, name: &Name, errors: &mut Errors) {
    // No expression names an output, so an invariant may be called `norm`.
    let is_output = matches!(kind, Kind::Output(_));
    let ascii = name.ascii.as_str();
    let meaning = if let Some(builtin) = Builtin::named(ascii) {
        builtin.noun()
    } else if Function::named(ascii).is_some() && !is_output {
        "a function"
    } else if KEYWORDS.contains(&ascii) || ascii == "for" {
        "a keyword"
    } else {
        return;
    };
    let message = format!("`{}` is {meaning}, expected another name", name.display);
    errors.push(name.range, message);
}
