//! Types of block matrices and of components.

use super::types::ComponentUnit;
use super::types::Type;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::diagnostic::Range;
use crate::model::Op;
use crate::model::Shape;
use num_traits::ToPrimitive;

impl Typing<'_> {
    /// `[[a, b], [c, d]]`; a stack is a column of blocks.
    pub(super) fn blocks(&mut self, rows: Vec<Vec<ExprId>>, range: Range) -> ExprId {
        if rows
            .iter()
            .flatten()
            .any(|&id| matches!(self.ty(id), Type::Poison))
        {
            return self.poison(range);
        }
        let cols = rows.first().map_or(0, Vec::len);
        if cols == 0 {
            return self.fail(range, "expected at least one entry between the brackets");
        }
        if let Some(row) = rows.iter().find(|row| row.len() != cols) {
            let message = format!("this row has {} blocks, the first one {cols}", row.len());
            let at = row.first().map_or(range, |&first| self.range(first));
            return self.fail(at, message);
        }
        let (heights, widths) = match self.block_sizes(&rows) {
            Ok(sizes) => sizes,
            Err((at, message)) => return self.fail(at, message),
        };
        let shape = Shape {
            rows: heights.iter().sum(),
            cols: widths.iter().sum(),
        };
        self.count(shape.len(), range);
        if !self.within_bounds() {
            return self.poison(range);
        }
        let units = self.block_units(&rows, &heights, &widths);
        self.push(
            Op::Blocks {
                rows,
                heights,
                widths,
            },
            Type::Matrix(shape, units),
            range,
        )
    }

    /// Heights of the block rows and widths of the block columns. A literal 0 fits any size, a
    /// multiple of I any square one.
    fn block_sizes(
        &self,
        rows: &[Vec<ExprId>],
    ) -> Result<(Vec<usize>, Vec<usize>), (Range, String)> {
        let mut heights = vec![None; rows.len()];
        let mut widths = vec![None; rows[0].len()];
        for (i, row) in rows.iter().enumerate() {
            for (j, &block) in row.iter().enumerate() {
                let Some(shape) = self.ty(block).shape().filter(|_| !self.is_zero(block)) else {
                    continue;
                };
                let height = *heights[i].get_or_insert(shape.rows);
                let width = *widths[j].get_or_insert(shape.cols);
                if height != shape.rows || width != shape.cols {
                    let expected = Shape {
                        rows: height,
                        cols: width,
                    };
                    let message =
                        format!("this block is a {shape}, expected a {expected} beside the others");
                    return Err((self.range(block), message));
                }
            }
        }
        self.size_identities(rows, &mut heights, &mut widths)?;
        let settled =
            |sizes: Vec<Option<usize>>| sizes.into_iter().map(|s| s.unwrap_or(1)).collect();
        Ok((settled(heights), settled(widths)))
    }

    /// Spreads sizes over multiples of I, which are square, until nothing changes.
    fn size_identities(
        &self,
        rows: &[Vec<ExprId>],
        heights: &mut [Option<usize>],
        widths: &mut [Option<usize>],
    ) -> Result<(), (Range, String)> {
        let places = || (0..rows.len()).flat_map(|i| (0..rows[i].len()).map(move |j| (i, j)));
        let identities: Vec<_> = places()
            .filter(|&(i, j)| matches!(self.ty(rows[i][j]), Type::Multiple(_)))
            .collect();
        for _ in 0..identities.len() {
            for &(i, j) in &identities {
                let size = heights[i].or(widths[j]);
                heights[i] = size;
                widths[j] = widths[j].or(size);
            }
        }
        for (i, j) in identities {
            let at = self.range(rows[i][j]);
            match (heights[i], widths[j]) {
                (Some(height), Some(width)) if height == width => {}
                (Some(rows), Some(cols)) => {
                    let place = Shape { rows, cols };
                    return Err((
                        at,
                        format!("`I` stands in the place of a {place}, expected a square one"),
                    ));
                }
                _ => return Err((at, "the size of `I` cannot be told here".to_owned())),
            }
        }
        Ok(())
    }

    fn block_units(
        &self,
        rows: &[Vec<ExprId>],
        heights: &[usize],
        widths: &[usize],
    ) -> Vec<ComponentUnit> {
        let mut units = Vec::new();
        for (row, &height) in rows.iter().zip(heights) {
            let spread: Vec<_> = row
                .iter()
                .zip(widths)
                .map(|(&block, &width)| {
                    (
                        self.spread(
                            self.ty(block),
                            Shape {
                                rows: height,
                                cols: width,
                            },
                        ),
                        width,
                    )
                })
                .collect();
            for i in 0..height {
                for (block, width) in &spread {
                    units.extend_from_slice(&block[i * width..(i + 1) * width]);
                }
            }
        }
        units
    }

    /// `a.x`, `a.y`, `a.z`
    pub(super) fn field(&mut self, a: ExprId, index: usize, range: Range) -> ExprId {
        let (name, valid) = match self.ty(a) {
            Type::Poison => return self.poison(range),
            ty => (
                ty.noun(),
                ty.shape()
                    .filter(|s| s.cols == 1 && s.rows > 1)
                    .map(|s| s.rows),
            ),
        };
        let letter = ["x", "y", "z"][index - 1];
        match valid {
            Some(n) if index <= n => self.pick(a, index - 1, 0, range),
            Some(_) => {
                let message = format!("`.{letter}` of {name}, which ends with `.y`");
                self.fail(range, message)
            }
            None => self.fail(range, format!("`.{letter}` of {name}, expected a vector")),
        }
    }

    /// `a(i)`, `a(i, j)`, counted from 1.
    pub(super) fn component(&mut self, a: ExprId, indices: &[ExprId], range: Range) -> ExprId {
        let any_poison = |id: &ExprId| matches!(self.ty(*id), Type::Poison);
        if any_poison(&a) || indices.iter().any(any_poison) {
            return self.poison(range);
        }
        let noun = self.ty(a).noun();
        let Some(shape) = self.ty(a).shape().filter(|s| !s.is_scalar()) else {
            let message = format!("this is {noun}, which has no components");
            let help = "write * between two factors";
            return self.fail_with_help(range, message, help);
        };
        let is_vector = shape.cols == 1 || shape.rows == 1;
        let counts = match (indices.len(), is_vector) {
            (1, true) => vec![shape.len()],
            (2, _) => vec![shape.rows, shape.cols],
            (found, _) => {
                let expected = if is_vector {
                    "one index"
                } else {
                    "two indices, row and column"
                };
                return self.fail(range, format!("{noun} takes {expected}, found {found}"));
            }
        };
        let mut positions = Vec::with_capacity(2);
        for (&index, n) in indices.iter().zip(counts) {
            match self.index(index, n) {
                Some(position) => positions.push(position),
                None => return self.poison(range),
            }
        }
        match positions.as_slice() {
            [i] => self.pick(a, i / shape.cols, i % shape.cols, range),
            [i, j] => self.pick(a, *i, *j, range),
            _ => self.poison(range),
        }
    }

    /// A constant index from 1 to `n`, counted from 0.
    fn index(&mut self, index: ExprId, n: usize) -> Option<usize> {
        let value = self.fact(index).constant.filter(|c| c.is_integer());
        let position = value
            .and_then(|c| c.to_usize())
            .filter(|i| (1..=n).contains(i));
        if position.is_none() {
            let message = format!("expected a whole number from 1 to {n}");
            self.errors.push(self.range(index), message);
        }
        position.map(|i| i - 1)
    }

    fn pick(&mut self, a: ExprId, row: usize, col: usize, range: Range) -> ExprId {
        let unit = match self.ty(a) {
            Type::Matrix(shape, units) => units[row * shape.cols + col],
            Type::Poison | Type::Multiple(_) => None,
        };
        self.push(Op::Component(a, row, col), Type::scalar(unit), range)
    }
}
