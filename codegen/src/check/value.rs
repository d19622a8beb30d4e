//! Checks a lone value, such as one from the command line.

use super::Assembly;
use super::context::Context;
use super::statements::Statements;
use super::symbols::Kind;
use super::symbols::Symbols;
use super::typing::Typing;
use crate::ast::Ast;
use crate::ast::Declaration;
use crate::ast::Expression;
use crate::ast::Item;
use crate::ast::Name;
use crate::ast::OutputKind;
use crate::ast::TypeExpr;
use crate::diagnostic::Errors;
use crate::diagnostic::Range;
use crate::model::Model;
use crate::model::Output;
use crate::model::Parameter;
use crate::model::Shape;
use crate::model::Variable;
use crate::unit::Unit;
use proc_macro2::Span;

/// A model that consists of `value` alone, as its one output of `shape`, over `parameters` given by
/// name and shape. Units are not compared: a number on the command line has none.
///
/// # Errors
/// As [`super::check`].
pub fn check_value(
    value: &Expression,
    parameters: &[(Name, Shape)],
    shape: Shape,
) -> Result<Model, Errors> {
    let range = Range::of(Span::call_site());
    let declaration = |(name, shape): &(Name, Shape)| {
        let ty = TypeExpr {
            shape: Some((vec![shape.rows, shape.cols], None)),
            unit: None,
        };
        Item::Parameter(Declaration {
            doc: Vec::new(),
            name: name.clone(),
            ty,
            value: None,
        })
    };
    let ast = Ast {
        name: String::new(),
        doc: Vec::new(),
        items: parameters.iter().map(declaration).collect(),
        exprs: value.exprs.clone(),
        range,
    };
    let symbols = Symbols::collect(&ast, &mut Errors::default());
    let mut typing = Typing::new(&ast.exprs, &symbols, Unit::ONE, Errors::default());
    typing.lenient = true;
    typing.declare();
    let root = typing.expression_in(value.root, Context::Value);
    let name = Name {
        ascii: "value".into(),
        display: "value".into(),
        range,
    };
    let variable = Variable {
        name,
        shape,
        unit: Unit::ONE,
        doc: Vec::new(),
        offset: 0,
    };
    let statements = Statements::default();
    let mut assembly = Assembly {
        typing,
        symbols: &symbols,
        statements,
        ast: &ast,
    };
    assembly.fit(root, &variable, false);
    let parameters = assembly.variables(Kind::Parameter);
    // Stands for a default; nobody asks for it.
    let default = assembly.typing.poison(range);
    let parameters = parameters
        .into_iter()
        .map(|variable| Parameter { variable, default });
    let parameters = parameters.collect();
    let Assembly { typing, .. } = assembly;
    let model = Model {
        name: String::new(),
        doc: Vec::new(),
        parameters,
        states: Vec::new(),
        unknowns: Vec::new(),
        solved: Vec::new(),
        exprs: typing.exprs,
        residual: Vec::new(),
        flow: Vec::new(),
        outputs: vec![Output {
            variable,
            kind: OutputKind::Observable,
            value: root,
        }],
        forms: Vec::new(),
        claims: Vec::new(),
    };
    typing.errors.or(model)
}
