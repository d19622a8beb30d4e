//! Matrices of nodes, for the stages that work between vectors and scalars.

use crate::dag::Dag;
use crate::dag::Node;
use crate::dag::NodeId;
use crate::model::Shape;
use crate::normal::rational;

/// The columns to take from the rows of an n×n matrix, n ≤ 3, for each term of its determinant: even permutations first.
pub fn permutations(n: usize) -> &'static [&'static [usize]] {
    match n {
        0 => &[&[]],
        1 => &[&[0]],
        2 => &[&[0, 1], &[1, 0]],
        _ => &[
            &[0, 1, 2],
            &[1, 2, 0],
            &[2, 0, 1],
            &[0, 2, 1],
            &[1, 0, 2],
            &[2, 1, 0],
        ],
    }
}

/// A matrix of nodes, row by row. Scalars are 1×1, vectors n×1.
#[derive(Clone, Debug)]
pub struct Matrix {
    /// Rows and columns.
    pub shape: Shape,
    /// Row by row.
    pub entries: Vec<NodeId>,
}

impl Matrix {
    /// A 1×1 matrix.
    pub fn scalar(node: NodeId) -> Self {
        Self {
            shape: Shape::SCALAR,
            entries: vec![node],
        }
    }

    /// A column.
    pub fn vector(entries: Vec<NodeId>) -> Self {
        Self {
            shape: Shape::vector(entries.len()),
            entries,
        }
    }

    /// A matrix from its rows.
    pub fn from_rows<const N: usize, const M: usize>(rows: [[NodeId; M]; N]) -> Self {
        Self {
            shape: Shape { rows: N, cols: M },
            entries: rows.concat(),
        }
    }

    /// `diagonal` on the diagonal of an otherwise zero matrix of `shape`.
    pub fn diagonal(dag: &mut Dag, shape: Shape, diagonal: NodeId) -> Self {
        let zero = dag.integer(0);
        let entry = |i: usize| {
            if i / shape.cols == i % shape.cols {
                diagonal
            } else {
                zero
            }
        };
        Self {
            shape,
            entries: (0..shape.len()).map(entry).collect(),
        }
    }

    /// The entry in row `i`, column `j`.
    pub fn at(&self, i: usize, j: usize) -> NodeId {
        self.entries[i * self.shape.cols + j]
    }

    /// Each entry through `f`.
    pub fn map(&self, mut f: impl FnMut(NodeId) -> NodeId) -> Self {
        Self {
            shape: self.shape,
            entries: self.entries.iter().map(|&e| f(e)).collect(),
        }
    }

    /// Entries of two matrices of one shape through `f`.
    pub fn zip(&self, other: &Self, mut f: impl FnMut(NodeId, NodeId) -> NodeId) -> Self {
        let pairs = self.entries.iter().zip(&other.entries);
        Self {
            shape: self.shape,
            entries: pairs.map(|(&a, &b)| f(a, b)).collect(),
        }
    }

    /// Aᵀ
    pub fn transpose(&self) -> Self {
        let Shape { rows, cols } = self.shape;
        let entries = (0..rows * cols)
            .map(|i| self.at(i % rows, i / rows))
            .collect();
        Self {
            shape: Shape {
                rows: cols,
                cols: rows,
            },
            entries,
        }
    }

    /// A B
    pub fn product(&self, dag: &mut Dag, other: &Self) -> Self {
        let shape = Shape {
            rows: self.shape.rows,
            cols: other.shape.cols,
        };
        let mut entries = Vec::with_capacity(shape.len());
        for i in 0..shape.rows {
            for j in 0..shape.cols {
                let terms: Vec<_> = (0..self.shape.cols)
                    .map(|k| dag.mul(self.at(i, k), other.at(k, j)))
                    .collect();
                entries.push(add_all(dag, &terms));
            }
        }
        Self { shape, entries }
    }

    /// The cofactor of entry (i, j) of a square matrix up to 3×3.
    pub fn cofactor(&self, dag: &mut Dag, i: usize, j: usize) -> NodeId {
        match self.shape.rows {
            1 => dag.integer(1),
            2 => {
                let entry = self.at(1 - i, 1 - j);
                if i == j { entry } else { dag.neg(entry) }
            }
            _ => {
                let (r, s) = ((i + 1) % 3, (i + 2) % 3);
                let (p, q) = ((j + 1) % 3, (j + 2) % 3);
                let straight = dag.mul(self.at(r, p), self.at(s, q));
                let crossed = dag.mul(self.at(r, q), self.at(s, p));
                dag.sub(straight, crossed)
            }
        }
    }

    /// The adjugate, A⁻¹ det A, of a square matrix up to 3×3.
    pub fn adjugate(&self, dag: &mut Dag) -> Self {
        let n = self.shape.rows;
        let entries = (0..n * n)
            .map(|e| self.cofactor(dag, e % n, e / n))
            .collect();
        Self {
            shape: self.shape,
            entries,
        }
    }

    /// det A of a square matrix up to 3×3: as one sum where its products merge or cancel, else along its first row.
    pub fn determinant(&self, dag: &mut Dag) -> NodeId {
        let products = self.products(dag);
        let signed = products.iter().enumerate().map(|(i, &product)| {
            let is_even = i < products.len().div_ceil(2);
            (rational(if is_even { 1 } else { -1 }), product)
        });
        let whole = dag.sum(signed);
        let terms = match dag.node(whole) {
            Node::Sum(terms) => terms.len(),
            _ => 1,
        };
        if terms < products.len() {
            return whole;
        }
        let terms: Vec<_> = (0..self.shape.rows)
            .map(|j| {
                let cofactor = self.cofactor(dag, 0, j);
                dag.mul(self.at(0, j), cofactor)
            })
            .collect();
        add_all(dag, &terms)
    }

    /// The determinant of a square matrix up to 3×3 with no sign ever changed.
    pub fn permanent(&self, dag: &mut Dag) -> NodeId {
        let products = self.products(dag);
        add_all(dag, &products)
    }

    /// The products of one entry from each row and column of a square matrix up to 3×3, even permutations first.
    fn products(&self, dag: &mut Dag) -> Vec<NodeId> {
        let product = |order: &&[usize]| {
            let entries = order.iter().enumerate().map(|(i, &j)| self.at(i, j));
            let one = dag.integer(1);
            entries.fold(one, |product, entry| dag.mul(product, entry))
        };
        permutations(self.shape.rows).iter().map(product).collect()
    }

    /// Σ aᵢ bᵢ over all entries.
    pub fn dot(&self, dag: &mut Dag, other: &Self) -> NodeId {
        let terms: Vec<_> = self.zip(other, |a, b| dag.mul(a, b)).entries;
        add_all(dag, &terms)
    }
}

/// The sum of `terms`.
pub fn add_all(dag: &mut Dag, terms: &[NodeId]) -> NodeId {
    let one = rational(1);
    dag.sum(terms.iter().map(|&t| (one.clone(), t)))
}
