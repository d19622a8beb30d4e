//! Types of `[a, b]` and `[[a, b], [c, d]]`.

use super::types::Type;
use super::typing::Typing;
use crate::ast::ExprId;
use crate::ast::LARGEST_DIMENSION;
use crate::diagnostic::Range;
use crate::model::Op;
use crate::model::Shape;

/// What a block says about its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    /// Its own.
    Fixed(Shape),
    /// Any square: a multiple of `I`.
    Square,
    /// Any: a literal 0.
    Any,
}

impl Typing<'_> {
    /// A matrix of blocks; all rows have as many.
    pub(super) fn blocks(&mut self, rows: Vec<Vec<ExprId>>, range: Range) -> ExprId {
        let mut sizes = Vec::new();
        for row in &rows {
            let mut list = Vec::new();
            for &block in row {
                list.push(match self.ty(block) {
                    Type::Poison => return self.poison(range),
                    Type::Multiple(_) => Size::Square,
                    Type::Matrix(..) if self.is_zero(block) => Size::Any,
                    Type::Matrix(shape, _) => Size::Fixed(*shape),
                });
            }
            sizes.push(list);
        }
        let (heights, widths) = match self.extents(&rows, &sizes) {
            Ok(extents) => extents,
            Err(poison) => return poison,
        };
        let shape = Shape {
            rows: heights.iter().sum(),
            cols: widths.iter().sum(),
        };
        if shape.rows.max(shape.cols) > LARGEST_DIMENSION {
            let message = format!("expected at most {LARGEST_DIMENSION} rows, found a {shape}");
            return self.fail(range, message);
        }
        if !self.within_bounds() {
            return self.poison(range);
        }
        let mut units = vec![None; shape.len()];
        let mut top = 0;
        for (row, &height) in rows.iter().zip(&heights) {
            let mut left = 0;
            for (&block, &width) in row.iter().zip(&widths) {
                let size = Shape {
                    rows: height,
                    cols: width,
                };
                for (i, unit) in self.spread(self.ty(block), size).into_iter().enumerate() {
                    units[(top + i / width) * shape.cols + left + i % width] = unit;
                }
                left += width;
            }
            top += height;
        }
        let op = Op::Blocks {
            rows,
            heights,
            widths,
        };
        self.push(op, Type::Matrix(shape, units), range)
    }

    /// Height of each block row and width of each block column.
    fn extents(
        &mut self,
        rows: &[Vec<ExprId>],
        sizes: &[Vec<Size>],
    ) -> Result<(Vec<usize>, Vec<usize>), ExprId> {
        let mut heights = vec![None; sizes.len()];
        let mut widths = vec![None; sizes[0].len()];
        for (i, row) in sizes.iter().enumerate() {
            for (j, size) in row.iter().enumerate() {
                let Size::Fixed(shape) = *size else { continue };
                let height = *heights[i].get_or_insert(shape.rows);
                let width = *widths[j].get_or_insert(shape.cols);
                if height != shape.rows {
                    let message = format!("a {shape} in a row of blocks {height} high");
                    return Err(self.fail(self.range(rows[i][j]), message));
                }
                if width != shape.cols {
                    let message = format!("a {shape} in a column of blocks {width} wide");
                    return Err(self.fail(self.range(rows[i][j]), message));
                }
            }
        }
        settle(sizes, &mut heights, &mut widths);
        for (i, row) in sizes.iter().enumerate() {
            for (j, size) in row.iter().enumerate() {
                let message = match (size, heights[i], widths[j]) {
                    (Size::Square, Some(h), Some(w)) if h != w => {
                        format!("a multiple of `I` in a block of size {h}×{w}")
                    }
                    (Size::Square, None, _) | (Size::Square, _, None) => {
                        "the size of `I` is not known here".to_owned()
                    }
                    _ => continue,
                };
                return Err(self.fail(self.range(rows[i][j]), message));
            }
        }
        // What is left open has only zeros.
        let close = |list: Vec<Option<usize>>| list.into_iter().map(|n| n.unwrap_or(1)).collect();
        Ok((close(heights), close(widths)))
    }
}

/// Carries known heights over to widths, and back, through the square blocks.
fn settle(sizes: &[Vec<Size>], heights: &mut [Option<usize>], widths: &mut [Option<usize>]) {
    let mut changed = true;
    while changed {
        changed = false;
        for (i, row) in sizes.iter().enumerate() {
            for (j, size) in row.iter().enumerate() {
                if *size == Size::Square && heights[i].is_some() != widths[j].is_some() {
                    heights[i] = heights[i].or(widths[j]);
                    widths[j] = heights[i];
                    changed = true;
                }
            }
        }
    }
}
