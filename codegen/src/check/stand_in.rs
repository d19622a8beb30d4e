//! A model to stand in for one with mistakes.

use super::definitions;
use super::definitions::written_shape;
use super::symbols::Kind;
use super::symbols::Symbols;
use super::typing::Typing;
use crate::ast::Ast;
use crate::ast::ExprId;
use crate::ast::Form;
use crate::ast::OutputKind;
use crate::diagnostic::Errors;
use crate::model::Equation;
use crate::model::Expr;
use crate::model::Model;
use crate::model::Op;
use crate::model::Output;
use crate::model::Parameter;
use crate::model::Shape;
use crate::model::State;
use crate::model::Variable;
use crate::unit::Unit;
use num_rational::BigRational;
use num_traits::Zero;

/// Zero, the first of the expressions.
const ZERO: ExprId = ExprId(0);

/// A model that declares what `ast` declares, as far as that can be told, and in which everything is zero
/// and stays so. Code that names the variables of a model with mistakes compiles with this one.
pub fn stand_in(ast: &Ast) -> Model {
    let mut ignored = Errors::default();
    let symbols = Symbols::collect(ast, &mut ignored).settled();
    let units = definitions::units(&symbols, &mut ignored);
    let mut typing = Typing::new(&ast.exprs, &symbols, Some(Unit::ONE), ignored);
    typing.define(&units);
    let parameters = typing.variables(Kind::Parameter).into_iter();
    let parameters = parameters.map(|(_, variable)| Parameter {
        variable,
        default: ZERO,
    });
    let states = typing.variables(Kind::State).into_iter();
    let states: Vec<State> = states
        .map(|(_, variable)| State {
            variable,
            start: ZERO,
            solved: false,
            update: Some(ZERO),
        })
        .collect();

    let expr = |op, shape| Expr {
        op,
        shape: Some(shape),
        range: ast.range,
    };
    let zero = expr(Op::Number(BigRational::zero()), Shape::SCALAR);
    let rates = states.iter().enumerate();
    let rates = rates.map(|(i, state)| expr(Op::Rate(i), state.variable.shape));
    let flow = states.iter().enumerate().map(|(i, state)| Equation {
        lhs: ExprId(1 + i as u32),
        rhs: ZERO,
        shape: state.variable.shape,
        text: String::new(),
        range: ast.range,
    });
    Model {
        name: ast.name.clone(),
        doc: ast.doc.clone(),
        parameters: parameters.collect(),
        exprs: std::iter::once(zero).chain(rates).collect(),
        flow: flow.collect(),
        states,
        unknowns: Vec::new(),
        solved: Vec::new(),
        absent: Vec::new(),
        residual: Vec::new(),
        outputs: outputs(&mut typing),
        forms: vec![Form::Next, Form::Increment],
        claims: Vec::new(),
        requirements: Vec::new(),
    }
}

/// The invariants and observables, scalars where neither type nor value says otherwise.
fn outputs(typing: &mut Typing) -> Vec<Output> {
    let symbols = typing.symbols;
    let mut offset = 0;
    let mut outputs = Vec::new();
    for (_, symbol) in symbols.of_kind(Kind::Output(OutputKind::Observable)) {
        let (Kind::Output(kind), Some(value)) = (symbol.kind, symbol.value) else {
            continue;
        };
        let value = typing.expression(value);
        let shape = symbol.ty.and_then(written_shape);
        let shape = shape.or(typing.ty(value).shape()).unwrap_or(Shape::SCALAR);
        let variable = Variable {
            name: symbol.name.clone(),
            shape,
            unit: Unit::ONE,
            symbols: "1".to_owned(),
            doc: Vec::new(),
            offset,
        };
        offset += shape.len();
        outputs.push(Output {
            variable,
            kind,
            value: ZERO,
        });
    }
    outputs
}
