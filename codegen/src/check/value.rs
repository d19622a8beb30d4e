//! A lone value, such as one from the command line.

use super::context;
use super::context::Context;
use super::definitions;
use super::symbols::Kind;
use super::symbols::Symbols;
use super::typing::Typing;
use super::values::Strictness;
use crate::ast::Ast;
use crate::ast::Declaration;
use crate::ast::Expr;
use crate::ast::ExprId;
use crate::ast::ExprKind;
use crate::ast::Expression;
use crate::ast::Item;
use crate::ast::Name;
use crate::ast::Output;
use crate::ast::OutputKind;
use crate::ast::TypeExpr;
use crate::diagnostic::Errors;
use crate::model::Model;
use crate::unit::Unit;
use num_rational::BigRational;
use num_traits::Zero;

/// Checks `value` of `target`, which may use `parameters`. It is the one output of the model that comes
/// back, the parameters of which have no meaningful defaults. As with a start value, bare numbers carry
/// the unit of the target.
///
/// # Errors
/// As [`super::check`].
pub fn check_value(
    value: &Expression,
    target: &(Name, TypeExpr),
    parameters: &[(Name, TypeExpr)],
) -> Result<Model, Errors> {
    let ast = file(value, target, parameters);
    let mut errors = Errors::default();
    let symbols = Symbols::collect(&ast, &mut errors);
    let units = definitions::units(&symbols, &mut errors);
    let mut typing = Typing::new(&ast.exprs, &symbols, Some(Unit::ONE), errors);
    let output = Kind::Output(OutputKind::Observable);
    context::check_values(&mut typing, output, Context::Value);
    typing.define(&units);
    let model = Model {
        name: String::new(),
        doc: Vec::new(),
        parameters: typing.parameters(),
        states: Vec::new(),
        unknowns: Vec::new(),
        solved: Vec::new(),
        absent: Vec::new(),
        residual: Vec::new(),
        flow: Vec::new(),
        outputs: typing.outputs(&units, Strictness::Lax),
        exprs: std::mem::take(&mut typing.exprs),
        forms: Vec::new(),
        claims: Vec::new(),
        requirements: Vec::new(),
    };
    typing.into_errors().or(model)
}

/// `param p = 0; observe target = value;`
fn file(value: &Expression, target: &(Name, TypeExpr), parameters: &[(Name, TypeExpr)]) -> Ast {
    let range = value.exprs[value.root.index()].range;
    let mut exprs = value.exprs.clone();
    let zero = ExprId(exprs.len() as u32);
    exprs.push(Expr {
        kind: ExprKind::Number(BigRational::zero()),
        range,
    });
    let parameters = parameters.iter().map(|(name, ty)| {
        Item::Parameter(Declaration {
            doc: Vec::new(),
            name: name.clone(),
            ty: ty.clone(),
            value: Some(zero),
        })
    });
    let (name, ty) = target.clone();
    // The target may be a parameter itself, and no parameter can have the empty name.
    let output = Item::Output(Output {
        doc: Vec::new(),
        kind: OutputKind::Observable,
        name: Name {
            ascii: String::new(),
            ..name
        },
        ty,
        value: value.root,
    });
    Ast {
        name: String::new(),
        doc: Vec::new(),
        items: parameters.chain([output]).collect(),
        exprs,
        range,
    }
}
