//! Compares printed Jacobians with derivatives.
//!
//! Two expressions are taken as equal when they agree at several generic points: expressions that
//! differ, differ almost everywhere.

use crate::ast::Form;
use crate::dag::Dag;
use crate::dag::Leaf;
use crate::dag::NodeId;
use crate::diagnostic::Errors;
use crate::finding::Difference;
use crate::finding::Finding;
use crate::model::Model;
use crate::model::Shape;
use crate::model::Solved;
use crate::model::Variable;
use crate::sample::Sample;
use crate::system::ClaimedBlock;
use crate::system::Discrete;
use crate::system::Entry;

/// Points tried. More find rarer coincidences; each costs one evaluation of the graph.
const POINTS: u64 = 8;

/// Largest relative difference of equal expressions: a few hundred roundings.
const TOLERANCE: f64 = 1e-10;

/// One finding per claim of the model.
///
/// # Errors
/// Claims marked `require` that differ from the derivative.
pub fn claims(
    model: &Model,
    discrete: &mut Discrete,
    jacobian: &[Entry],
) -> Result<Vec<Finding>, Errors> {
    let printed = std::mem::take(&mut discrete.claims);
    let mut comparison = Comparison::new(model, discrete, jacobian);
    let mut errors = Errors::default();
    let mut findings = Vec::new();
    for (claim, blocks) in model.claims.iter().zip(&printed) {
        let differences = comparison.compare(claim, blocks);
        if let Some(first) = differences.first().filter(|_| claim.required) {
            let others = match differences.len() - 1 {
                0 => String::new(),
                n => format!(" and {n} more"),
            };
            errors.push_with_help(
                claim.range,
                format!(
                    "the required claim {:?} is wrong in {}{others}",
                    claim.label, first.entry
                ),
                format!(
                    "it says `{}`, the derivative is `{}`",
                    first.printed, first.derived
                ),
            );
        }
        findings.push(Finding {
            label: claim.label.clone(),
            line: claim.range.line(),
            differences,
        });
    }
    discrete.claims = printed;
    errors.or(findings)
}

/// The derivative, laid out as the claims are.
struct Comparison<'a> {
    model: &'a Model,
    form: Form,
    dag: &'a mut Dag,
    /// All entries, zeros included, row by row.
    derivative: Vec<NodeId>,
    n: usize,
    /// Height of each equation, width of each block of unknowns.
    heights: Vec<usize>,
    widths: Vec<usize>,
    points: Vec<Vec<f64>>,
}

impl<'a> Comparison<'a> {
    fn new(model: &'a Model, discrete: &'a mut Discrete, jacobian: &[Entry]) -> Self {
        let n = model.n_unknowns();
        let zero = discrete.dag.integer(0);
        let mut derivative = vec![zero; n * n];
        for entry in jacobian {
            derivative[entry.row * n + entry.col] = entry.node;
        }
        let heights = model.residual.iter().map(|e| e.shape.len()).collect();
        let widths = model
            .solved
            .iter()
            .map(|&s| model.solved_variable(s).shape.len())
            .collect();
        let points = (0..POINTS)
            .map(|p| Sample::generic(p).evaluate(&discrete.dag))
            .collect();
        let (form, dag) = (discrete.form, &mut discrete.dag);
        Self {
            model,
            form,
            dag,
            derivative,
            n,
            heights,
            widths,
            points,
        }
    }

    fn compare(
        &mut self,
        claim: &crate::model::Claim,
        blocks: &[Vec<ClaimedBlock>],
    ) -> Vec<Difference> {
        let whole = [vec![self.n], vec![self.n]];
        let rows_fit = blocks.len() == self.heights.len();
        let [heights, widths] = match blocks {
            [row] if row.len() == 1 && !(rows_fit && self.widths.len() == 1) => whole,
            _ if rows_fit && blocks.iter().all(|r| r.len() == self.widths.len()) => {
                [self.heights.clone(), self.widths.clone()]
            }
            _ => match grid(blocks, self.n) {
                Some(grid) => grid,
                None => return vec![self.misfit(blocks)],
            },
        };
        let mut differences = Vec::new();
        let mut row = 0;
        for (i, height) in heights.iter().enumerate() {
            let mut col = 0;
            for (j, width) in widths.iter().enumerate() {
                let place = Place {
                    row,
                    col,
                    shape: Shape {
                        rows: *height,
                        cols: *width,
                    },
                };
                self.compare_block(
                    &blocks[i][j],
                    &claim.blocks[i][j].1,
                    place,
                    &mut differences,
                );
                col += width;
            }
            row += height;
        }
        differences
    }

    /// One block against its place in the derivative.
    fn compare_block(
        &mut self,
        block: &ClaimedBlock,
        text: &str,
        place: Place,
        differences: &mut Vec<Difference>,
    ) {
        let zero = self.dag.integer(0);
        let Some(printed) = spread(self.dag, block, place.shape, zero) else {
            let is = block.shape.unwrap_or(Shape::SCALAR);
            differences.push(Difference {
                row: place.row,
                col: place.col,
                entry: format!("block from {}", self.entry(place.row, place.col)),
                printed: format!("{text}, of shape [{}, {}]", is.rows, is.cols),
                derived: format!(
                    "a block of shape [{}, {}]",
                    place.shape.rows, place.shape.cols
                ),
                values: (f64::NAN, f64::NAN),
            });
            return;
        };
        for (k, printed) in printed.into_iter().enumerate() {
            let (row, col) = (
                place.row + k / place.shape.cols,
                place.col + k % place.shape.cols,
            );
            let derived = self.derivative[row * self.n + col];
            if let Some(values) = self.disagreement(printed, derived) {
                differences.push(Difference {
                    row,
                    col,
                    entry: self.entry(row, col),
                    printed: self.text(printed),
                    derived: self.text(derived),
                    values,
                });
            }
        }
    }

    /// Both values at the first generic point where they differ, if there is one.
    fn disagreement(&self, printed: NodeId, derived: NodeId) -> Option<(f64, f64)> {
        if printed == derived {
            return None;
        }
        let values = self
            .points
            .iter()
            .map(|p| (p[printed.index()], p[derived.index()]));
        let finite: Vec<_> = values
            .filter(|(a, b)| a.is_finite() && b.is_finite())
            .collect();
        if finite.is_empty() {
            return Some((f64::NAN, f64::NAN));
        }
        finite
            .into_iter()
            .find(|(a, b)| (a - b).abs() > TOLERANCE * a.abs().max(b.abs()).max(1.0))
    }

    /// A claim whose blocks cannot be laid over the Jacobian.
    fn misfit(&self, blocks: &[Vec<ClaimedBlock>]) -> Difference {
        let cols = blocks.first().map_or(0, Vec::len);
        Difference {
            row: 0,
            col: 0,
            entry: "layout".into(),
            printed: format!("{} by {cols} blocks", blocks.len()),
            derived: format!(
                "{} equations by {} unknowns, {n} by {n} components",
                self.heights.len(),
                self.widths.len(),
                n = self.n
            ),
            values: (f64::NAN, f64::NAN),
        }
    }

    /// `∂(equation 2.x)/∂(Δω)`
    fn entry(&self, row: usize, col: usize) -> String {
        let mut offset = 0;
        let mut equation = String::new();
        for (i, &height) in self.heights.iter().enumerate() {
            if (offset..offset + height).contains(&row) {
                let part = if height > 1 {
                    format!(".{}", row - offset + 1)
                } else {
                    String::new()
                };
                equation = format!("equation {}{part}", i + 1);
            }
            offset += height;
        }
        format!(
            "∂({equation})/∂({})",
            leaf_name(self.model, self.form, Leaf::Unknown(col))
        )
    }

    fn text(&self, node: NodeId) -> String {
        self.dag
            .text(node, |leaf| leaf_name(self.model, self.form, leaf))
    }
}

/// Where a block lies in the Jacobian.
struct Place {
    row: usize,
    col: usize,
    shape: Shape,
}

/// Heights and widths of a grid whose blocks say their own shapes, if they add up to n by n.
fn grid(blocks: &[Vec<ClaimedBlock>], n: usize) -> Option<[Vec<usize>; 2]> {
    let cols = blocks.first()?.len();
    if blocks.iter().any(|row| row.len() != cols) {
        return None;
    }
    let shape = |b: &ClaimedBlock| b.shape.unwrap_or(Shape::SCALAR);
    let height = |row: &Vec<ClaimedBlock>| row.iter().map(|b| shape(b).rows).max();
    let width = |j: usize| blocks.iter().map(|row| shape(&row[j]).cols).max();
    let heights: Vec<usize> = blocks.iter().map(height).collect::<Option<_>>()?;
    let widths: Vec<usize> = (0..cols).map(width).collect::<Option<_>>()?;
    let adds_up = heights.iter().sum::<usize>() == n && widths.iter().sum::<usize>() == n;
    adds_up.then_some([heights, widths])
}

/// The entries of a block in `shape`: as they are, a literal zero spread out, a multiple of I.
fn spread(dag: &Dag, block: &ClaimedBlock, shape: Shape, zero: NodeId) -> Option<Vec<NodeId>> {
    match block.shape {
        Some(own) if own == shape => Some(block.entries.clone()),
        Some(_) if block.entries.iter().all(|&e| dag.is_zero(e)) => Some(vec![zero; shape.len()]),
        Some(_) => None,
        None => {
            let diagonal = |k: usize| k / shape.cols == k % shape.cols;
            let entry = |k: usize| if diagonal(k) { block.entries[0] } else { zero };
            Some((0..shape.len()).map(entry).collect())
        }
    }
}

/// A leaf as the model calls it: `Γ.x`, `Δω`, `h`.
pub fn leaf_name(model: &Model, form: Form, leaf: Leaf) -> String {
    let plain = |v: &Variable, name: String, i: usize| name + &v.component_suffix(i - v.offset);
    match leaf {
        Leaf::StepSize => "h".into(),
        Leaf::Time => "t".into(),
        Leaf::Parameter(i) => {
            let variables = model.parameters.iter().map(|p| &p.variable);
            holder(variables, i).map_or("?".into(), |v| plain(v, v.name.display.clone(), i))
        }
        Leaf::State(i) => {
            let variables = model.states.iter().map(|s| &s.variable);
            holder(variables, i).map_or("?".into(), |v| plain(v, v.name.display.clone(), i))
        }
        Leaf::Unknown(i) => unknown_name(model, form, i),
    }
}

fn holder<'v>(mut variables: impl Iterator<Item = &'v Variable>, i: usize) -> Option<&'v Variable> {
    variables.find(|v| (v.offset..v.offset + v.shape.len()).contains(&i))
}

fn unknown_name(model: &Model, form: Form, i: usize) -> String {
    let mut offset = 0;
    for &solved in &model.solved {
        let variable = model.solved_variable(solved);
        if i < offset + variable.shape.len() {
            let suffix = variable.component_suffix(i - offset);
            let name = &variable.name.display;
            return match (solved, form) {
                (Solved::Own(_), _) => format!("{name}{suffix}"),
                (Solved::State(_), Form::Next) => format!("{name}[k+1]{suffix}"),
                (Solved::State(_), Form::Increment) => format!("Δ{name}{suffix}"),
            };
        }
        offset += variable.shape.len();
    }
    "?".into()
}
