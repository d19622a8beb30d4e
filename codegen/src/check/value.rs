//! A lone value, such as one from the command line.

use super::context;
use super::context::Context;
use super::symbols::Kind;
use super::symbols::Symbols;
use super::typing::Typing;
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
use crate::model::Shape;
use crate::unit::Unit;
use num_rational::BigRational;
use num_traits::Zero;

/// Checks `value`, which is to have `shape` and may use `parameters`, given by name and shape. It is the
/// one output of the model that comes back, the parameters of which have no meaningful defaults. Units
/// are not compared: a number on the command line has none.
///
/// # Errors
/// As [`super::check`].
pub fn check_value(
    value: &Expression,
    parameters: &[(Name, Shape)],
    shape: Shape,
) -> Result<Model, Errors> {
    let ast = file(value, parameters, shape);
    let mut errors = Errors::default();
    let symbols = Symbols::collect(&ast, &mut errors);
    let units = vec![None; symbols.list.len()];
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
        residual: Vec::new(),
        flow: Vec::new(),
        outputs: typing.outputs(&units),
        exprs: std::mem::take(&mut typing.exprs),
        forms: Vec::new(),
        claims: Vec::new(),
    };
    typing.into_errors().or(model)
}

/// `param p = 0; observe … = value;`
fn file(value: &Expression, parameters: &[(Name, Shape)], shape: Shape) -> Ast {
    let range = value.exprs[value.root.index()].range;
    let mut exprs = value.exprs.clone();
    let zero = ExprId(exprs.len() as u32);
    exprs.push(Expr {
        kind: ExprKind::Number(BigRational::zero()),
        range,
    });
    let ty = |shape: Shape| TypeExpr {
        shape: Some((vec![shape.rows, shape.cols], None)),
        unit: None,
    };
    let parameters = parameters.iter().map(|(name, shape)| {
        Item::Parameter(Declaration {
            doc: Vec::new(),
            name: name.clone(),
            ty: ty(*shape),
            value: Some(zero),
        })
    });
    // No parameter can have the empty name.
    let output = Item::Output(Output {
        doc: Vec::new(),
        kind: OutputKind::Observable,
        name: Name {
            ascii: String::new(),
            display: "value".to_owned(),
            range,
        },
        ty: ty(shape),
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
