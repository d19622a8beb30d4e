//! Types of expressions: a shape, and a unit for each component.

use crate::model::Shape;
use crate::unit::Unit;

/// The unit of one component. An exact zero has any unit, written `None`; so has a component whose
/// unit is in doubt after a mistake, so that one mistake gives one message.
pub(super) type ComponentUnit = Option<Unit>;

/// The type of an expression.
#[derive(Clone, Debug)]
pub(super) enum Type {
    /// In doubt after a mistake.
    Poison,
    /// A multiple of `I`; its surroundings decide its size.
    Multiple(ComponentUnit),
    /// A shape and the unit of each component, row by row.
    Matrix(Shape, Vec<ComponentUnit>),
}

impl Type {
    /// A scalar.
    pub(super) fn scalar(unit: ComponentUnit) -> Self {
        Type::Matrix(Shape::SCALAR, vec![unit])
    }

    /// A matrix with one unit throughout.
    pub(super) fn uniform(shape: Shape, unit: ComponentUnit) -> Self {
        Type::Matrix(shape, vec![unit; shape.len()])
    }

    /// The shape if it is known.
    pub(super) fn shape(&self) -> Option<Shape> {
        match self {
            Type::Matrix(shape, _) => Some(*shape),
            Type::Poison | Type::Multiple(_) => None,
        }
    }

    /// The type in words, with its article.
    pub(super) fn noun(&self) -> String {
        match self {
            Type::Poison => "an expression".to_owned(),
            Type::Multiple(_) => "a multiple of `I`".to_owned(),
            Type::Matrix(shape, _) => format!("a {shape}"),
        }
    }

    /// The same shape with each unit mapped.
    pub(super) fn map(&self, f: impl Fn(ComponentUnit) -> ComponentUnit) -> Type {
        match self {
            Type::Poison => Type::Poison,
            Type::Multiple(unit) => Type::Multiple(f(*unit)),
            Type::Matrix(shape, units) => {
                Type::Matrix(*shape, units.iter().map(|&unit| f(unit)).collect())
            }
        }
    }
}

/// Units of `n×n` components of a multiple of `I`.
pub(super) fn diagonal(n: usize, unit: ComponentUnit) -> Vec<ComponentUnit> {
    (0..n * n)
        .map(|i| if i % (n + 1) == 0 { unit } else { None })
        .collect()
}

/// Position of a component in words, `2` in a vector and `2, 3` in a matrix; empty for a scalar.
pub(super) fn position(shape: Shape, index: usize) -> String {
    match (shape.rows, shape.cols) {
        (1, 1) => String::new(),
        (_, 1) | (1, _) => format!(" in component {}", index + 1),
        (_, n) => format!(" in component ({}, {})", index / n + 1, index % n + 1),
    }
}
