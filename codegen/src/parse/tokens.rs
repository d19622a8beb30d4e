//! Token trees laid out flat, so that nothing later recurses over them.

use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use proc_macro2::Delimiter;
use proc_macro2::Literal;
use proc_macro2::Spacing;
use proc_macro2::Span;
use proc_macro2::TokenStream;
use proc_macro2::TokenTree;

/// Deepest nesting of brackets. The expression parser recurses once per bracket, so this bounds its
/// stack; formulas in print rarely pass five.
pub(super) const DEEPEST_NESTING: usize = 64;

/// Most tokens in one model. The largest model of the paper has some 700.
const MOST_TOKENS: usize = 100_000;

/// What a token is.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// An identifier, without `r#`.
    Ident(String),
    /// A single punctuation character.
    Punct(char),
    /// A number, string or character.
    Literal(Literal),
    /// An opening bracket and the index of the one that closes it.
    Open(Delimiter, usize),
    /// A closing bracket.
    Close(Delimiter),
}

/// A token and where it stands.
#[derive(Clone, Debug)]
pub(super) struct Token {
    /// What it is.
    pub(super) kind: Kind,
    /// Where it stands.
    pub(super) span: Span,
    /// A punctuation character directly followed by another one.
    pub(super) joint: bool,
}

/// A group whose end is still to come.
struct OpenGroup {
    rest: proc_macro2::token_stream::IntoIter,
    /// Index of the opening bracket; none for the invisible brackets of a macro expansion.
    open: Option<usize>,
    delimiter: Delimiter,
    close: Span,
}

/// Lays `tokens` out flat; fails if they nest too deeply or are too many.
pub(super) fn flatten(tokens: TokenStream) -> Result<Vec<Token>, Diagnostic> {
    let mut flat = Vec::new();
    let mut groups = Vec::new();
    let mut rest = tokens.into_iter();
    loop {
        if flat.len() > MOST_TOKENS {
            let span = flat.last().map_or_else(Span::call_site, |t: &Token| t.span);
            return Err(Diagnostic {
                range: Range::of(span),
                message: format!("the model has more than {MOST_TOKENS} tokens"),
                help: None,
            });
        }
        let Some(tree) = rest.next() else {
            let Some(group) = groups.pop() else {
                return Ok(flat);
            };
            rest = close(&mut flat, group);
            continue;
        };
        match tree {
            TokenTree::Group(group) => {
                if groups.len() == DEEPEST_NESTING {
                    return Err(too_deep(group.span_open()));
                }
                let inner = group.stream().into_iter();
                groups.push(open(&mut flat, &group, std::mem::replace(&mut rest, inner)));
            }
            TokenTree::Ident(ident) => {
                let text = ident.to_string();
                let text = text.strip_prefix("r#").unwrap_or(&text).to_owned();
                flat.push(Token::new(Kind::Ident(text), ident.span()));
            }
            TokenTree::Punct(punct) => flat.push(Token {
                kind: Kind::Punct(punct.as_char()),
                span: punct.span(),
                joint: punct.spacing() == Spacing::Joint,
            }),
            TokenTree::Literal(literal) => {
                let span = literal.span();
                flat.push(Token::new(Kind::Literal(literal), span));
            }
        }
    }
}

impl Token {
    fn new(kind: Kind, span: Span) -> Self {
        Self {
            kind,
            span,
            joint: false,
        }
    }

    /// The token as written.
    pub(super) fn text(&self) -> String {
        self.kind.text()
    }
}

impl Kind {
    /// A token of this kind as written.
    pub(super) fn text(&self) -> String {
        match self {
            Kind::Ident(text) => text.clone(),
            Kind::Punct(c) => c.to_string(),
            Kind::Literal(literal) => literal.to_string(),
            Kind::Open(delimiter, _) => brackets(*delimiter).0.to_owned(),
            Kind::Close(delimiter) => brackets(*delimiter).1.to_owned(),
        }
    }
}

/// The pair of brackets as written.
pub(super) fn brackets(delimiter: Delimiter) -> (&'static str, &'static str) {
    match delimiter {
        Delimiter::Parenthesis => ("(", ")"),
        Delimiter::Bracket => ("[", "]"),
        Delimiter::Brace => ("{", "}"),
        Delimiter::None => ("", ""),
    }
}

fn too_deep(span: Span) -> Diagnostic {
    Diagnostic {
        range: Range::of(span),
        message: format!("brackets are nested more than {DEEPEST_NESTING} deep"),
        help: Some("name the inner parts with `let`".to_owned()),
    }
}

fn open(
    flat: &mut Vec<Token>,
    group: &proc_macro2::Group,
    rest: proc_macro2::token_stream::IntoIter,
) -> OpenGroup {
    let delimiter = group.delimiter();
    let visible = delimiter != Delimiter::None;
    if visible {
        flat.push(Token::new(Kind::Open(delimiter, 0), group.span_open()));
    }
    OpenGroup {
        rest,
        open: visible.then(|| flat.len() - 1),
        delimiter,
        close: group.span_close(),
    }
}

fn close(flat: &mut Vec<Token>, group: OpenGroup) -> proc_macro2::token_stream::IntoIter {
    if let Some(open) = group.open {
        flat[open].kind = Kind::Open(group.delimiter, flat.len());
        flat.push(Token::new(Kind::Close(group.delimiter), group.close));
    }
    group.rest
}

/// The text of `tokens`, with one blank wherever the author left some space.
pub(super) fn text(tokens: &[Token]) -> String {
    let mut text = String::new();
    let mut previous: Option<Span> = None;
    for token in tokens {
        if previous.is_some_and(|p| p.end() != token.span.start()) {
            text.push(' ');
        }
        text.push_str(&token.text());
        previous = Some(token.span);
    }
    text
}
