//! Statements.

use super::Parser;
use super::advice::missing_operator;
use super::cursor::Cursor;
use super::cursor::Parsed;
use super::tokens::Kind;
use super::types;
use crate::ast::Declaration;
use crate::ast::ExprKind;
use crate::ast::Form;
use crate::ast::Item;
use crate::ast::KEYWORDS;
use crate::ast::Name;
use crate::ast::Output;
use crate::ast::OutputKind;
use crate::ast::TypeExpr;
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Range;
use crate::similar::most_similar;
use num_rational::BigRational;
use num_traits::Zero;
use proc_macro2::Delimiter;

/// Least Jaro-Winkler similarity, from 0 to 1, of a word to the keyword it was meant to be.
/// `parameter` has 0.91 to `param`, `invariants` 0.98, unrelated words less than 0.7.
const SIMILAR: f64 = 0.88;

/// True where a statement begins.
pub(super) fn is_keyword(kind: Option<&Kind>) -> bool {
    matches!(kind, Some(Kind::Ident(text)) if KEYWORDS.contains(&text.as_str()))
}

impl Parser {
    /// The statement that the cursor stands at; `doc` are the lines above it.
    pub(super) fn statement(&mut self, cursor: &mut Cursor, doc: Vec<String>) -> Parsed<Item> {
        let keyword = cursor.here();
        let word = match cursor.peek() {
            Some(Kind::Ident(word)) => word.as_str(),
            _ => return Err(no_statement(*cursor)),
        };
        if !KEYWORDS.contains(&word) {
            return Err(no_statement(*cursor));
        }
        cursor.skip();
        if matches!(word, "flow" | "residual" | "update" | "start")
            && !cursor.peeks_open(Delimiter::Brace)
        {
            return Err(no_block(word, keyword, cursor));
        }
        match word {
            "param" => self.valued(cursor, doc, "a default").map(Item::Parameter),
            "unknown" => self.valued(cursor, doc, "a first guess").map(Item::Unknown),
            "state" => self.state(cursor, doc).map(Item::State),
            "let" => self.abbreviation(cursor),
            "flow" => Ok(Item::Flow(
                self.equations(cursor, "write `der(x) = …;`")?,
                keyword,
            )),
            "residual" => Ok(Item::Residual(
                self.equations(cursor, "write `… = 0;`")?,
                keyword,
            )),
            "update" => Ok(Item::Update(self.assignments(cursor)?, keyword)),
            "start" => Ok(Item::Start(self.assignments(cursor)?, keyword)),
            "solve" => self.solve_for(cursor, keyword),
            "invariant" => self.output(cursor, doc, OutputKind::Invariant),
            "observe" => self.output(cursor, doc, OutputKind::Observable),
            "require" if cursor.peeks_word("claim") => self.claim(cursor, keyword, true),
            "require" => self.requirement(cursor),
            _ => self.claim(cursor, keyword, false),
        }
    }

    /// What a declaration with a mistake still declares, the cursor at its keyword.
    pub(super) fn remnant(&mut self, mut cursor: Cursor) -> Option<Item> {
        let keyword = cursor.peek().cloned();
        cursor.skip();
        let name = declared_name(&mut cursor).ok()?;
        let range = name.range;
        let ty = types::parse(&mut cursor).unwrap_or_default();
        let declaration = Declaration {
            doc: Vec::new(),
            name,
            ty,
            value: None,
        };
        let Some(Kind::Ident(keyword)) = keyword else {
            return None;
        };
        let kind = match keyword.as_str() {
            "param" => return Some(Item::Parameter(declaration)),
            "state" => return Some(Item::State(declaration)),
            "invariant" => OutputKind::Invariant,
            "observe" => OutputKind::Observable,
            _ => return None,
        };
        Some(Item::Output(Output {
            doc: Vec::new(),
            kind,
            name: declaration.name,
            ty: declaration.ty,
            value: self.push(ExprKind::Number(BigRational::zero()), range),
        }))
    }

    /// `NAME: TYPE = VALUE;` of a parameter or an unknown; `value` says what the value is.
    fn valued(
        &mut self,
        cursor: &mut Cursor,
        doc: Vec<String>,
        value: &str,
    ) -> Parsed<Declaration> {
        let name = declared_name(cursor)?;
        let ty = types::parse(cursor)?;
        if !cursor.eat_punct('=') {
            let mut diagnostic = cursor.unexpected(&format!("`=` and {value}"));
            diagnostic.help = unit_without_colon(*cursor, &ty);
            return Err(diagnostic);
        }
        let value = Some(self.expression(cursor)?);
        self.semicolon(cursor)?;
        Ok(Declaration {
            doc,
            name,
            ty,
            value,
        })
    }

    fn state(&mut self, cursor: &mut Cursor, doc: Vec<String>) -> Parsed<Declaration> {
        let name = declared_name(cursor)?;
        let ty = types::parse(cursor)?;
        if cursor.peeks_punct('=') {
            let mut diagnostic = cursor.unexpected("`;`");
            let name = &name.display;
            diagnostic.help = Some(format!("a state begins in `start {{ {name} = …; }}`"));
            return Err(diagnostic);
        }
        self.semicolon(cursor)?;
        Ok(Declaration {
            doc,
            name,
            ty,
            value: None,
        })
    }

    fn abbreviation(&mut self, cursor: &mut Cursor) -> Parsed<Item> {
        let name = declared_name(cursor)?;
        if !cursor.eat_punct('=') {
            let mut diagnostic = cursor.unexpected("`=`");
            if cursor.peeks_punct(':') {
                diagnostic.help = Some("the type of a `let` is that of its value".to_owned());
            }
            return Err(diagnostic);
        }
        let value = self.expression(cursor)?;
        self.semicolon(cursor)?;
        Ok(Item::Let(name, value))
    }

    fn output(&mut self, cursor: &mut Cursor, doc: Vec<String>, kind: OutputKind) -> Parsed<Item> {
        let name = declared_name(cursor)?;
        let ty = types::parse(cursor)?;
        if !cursor.eat_punct('=') {
            let mut diagnostic = cursor.unexpected("`=` and a value");
            diagnostic.help = unit_without_colon(*cursor, &ty);
            return Err(diagnostic);
        }
        let value = self.expression(cursor)?;
        self.semicolon(cursor)?;
        Ok(Item::Output(Output {
            doc,
            kind,
            name,
            ty,
            value,
        }))
    }

    fn solve_for(&mut self, cursor: &mut Cursor, keyword: Range) -> Parsed<Item> {
        if !cursor.eat_word("for") {
            return Err(cursor.unexpected("`for`"));
        }
        let mut forms = Vec::new();
        loop {
            let range = cursor.here();
            let form = [Form::Next, Form::Increment]
                .into_iter()
                .find(|form| cursor.eat_word(form.keyword()));
            let form = form.ok_or_else(|| cursor.unexpected("`next` or `increment`"))?;
            forms.push((form, range));
            if !cursor.eat_punct(',') {
                break;
            }
        }
        if cursor.peeks_word("next") || cursor.peeks_word("increment") {
            let mut diagnostic = cursor.unexpected("`,` or `;`");
            diagnostic.help = Some("write `solve for next, increment;`".to_owned());
            return Err(diagnostic);
        }
        self.semicolon(cursor)?;
        Ok(Item::SolveFor(forms, keyword))
    }

    /// The end of a statement. Where the next one plainly begins, a missing `;` is a mistake of its
    /// own and reading goes on.
    pub(super) fn semicolon(&mut self, cursor: &mut Cursor) -> Parsed<()> {
        if cursor.eat_punct(';') {
            return Ok(());
        }
        let begins_assignment = matches!(cursor.peek(), Some(Kind::Ident(_)))
            && matches!(cursor.peek_at(1), Some(Kind::Punct('=')));
        let ends = cursor.is_at_end()
            || cursor.starts_a_line()
            || is_keyword(cursor.peek())
            || begins_assignment;
        if !ends {
            return Err(missing_operator(*cursor, "an operator or `;`"));
        }
        let message = format!("expected `;` after this, found {}", cursor.found());
        self.errors.push(cursor.previous(), message);
        Ok(())
    }
}

/// The name behind a keyword. A keyword in its place is taken for a name, which `check` rejects,
/// unless it begins the next statement.
fn declared_name(cursor: &mut Cursor) -> Parsed<Name> {
    let next = cursor.peek_at(1);
    if is_keyword(cursor.peek()) && matches!(next, Some(Kind::Ident(_) | Kind::Open(..))) {
        return Err(cursor.unexpected("a name"));
    }
    cursor.expect_name()
}

/// `param m kg = 2`: the colon is missing.
fn unit_without_colon(cursor: Cursor, ty: &TypeExpr) -> Option<String> {
    let no_type = ty.shape.is_none() && ty.unit.is_none();
    let looks_like_a_type = matches!(cursor.peek(), Some(Kind::Ident(_) | Kind::Open(..)));
    (no_type && looks_like_a_type && !cursor.starts_a_line())
        .then(|| "write `:` before a shape or a unit".to_owned())
}

/// No brace behind the keyword of a block, the rest of which is passed.
fn no_block(word: &str, keyword: Range, cursor: &mut Cursor) -> Diagnostic {
    let found = cursor.found();
    while !cursor.is_at_end() && !is_keyword(cursor.peek()) {
        cursor.skip();
    }
    Diagnostic {
        range: keyword,
        message: format!("expected `{{` behind `{word}`, found {found}"),
        help: None,
    }
}

/// No keyword here.
fn no_statement(cursor: Cursor) -> Diagnostic {
    let mut diagnostic = cursor.unexpected("a statement");
    let Some(Kind::Ident(word)) = cursor.peek() else {
        return diagnostic;
    };
    let best = most_similar(word, KEYWORDS.iter().map(|k| (*k, k)), SIMILAR);
    diagnostic.help = match (best, cursor.peek_at(1)) {
        (Some(keyword), _) => Some(format!("did you mean `{keyword}`?")),
        (None, Some(Kind::Punct('='))) => Some(format!("write `let {word} = …;`")),
        (None, _) => Some(format!("a statement begins with {}", KEYWORDS.join(", "))),
    };
    diagnostic
}
