//! The sparsity pattern of a symmetric matrix of 3 × 3 blocks.

use faer::sparse::SymbolicSparseColMat;
use nalgebra::Matrix3;

/// The pairs of unknowns that interact, as the lower triangle of a block matrix in compressed columns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Pattern {
    /// The start of each block column in `rows`.
    starts: Vec<usize>,
    /// The block rows, sorted in each column. The first of a column is the diagonal block.
    rows: Vec<u32>,
}

/// A pair of unknowns as one integer, which sorts by the smaller unknown first.
pub(crate) fn key(a: u32, b: u32) -> u64 {
    (u64::from(a.min(b)) << 32) | u64::from(a.max(b))
}

impl Pattern {
    /// The pattern of these pairs and the diagonal. The pairs may be in any order and may repeat.
    pub(crate) fn new(count: usize, mut keys: Vec<u64>) -> Self {
        keys.extend((0..count as u32).map(|i| key(i, i)));
        keys.sort_unstable();
        keys.dedup();
        let mut starts = vec![0; count + 1];
        for key in &keys {
            starts[(key >> 32) as usize + 1] += 1;
        }
        for column in 0..count {
            starts[column + 1] += starts[column];
        }
        let rows = keys
            .iter()
            .map(|key| (key & u64::from(u32::MAX)) as u32)
            .collect();
        Self { starts, rows }
    }

    /// The number of scalars in the lower triangle.
    pub(crate) fn scalar_count(&self) -> usize {
        let columns = self.starts.len() - 1;
        9 * self.rows.len() - 3 * columns
    }

    /// The pattern of the blocks.
    pub(crate) fn blocks(&self) -> SymbolicSparseColMat<usize> {
        let columns = self.starts.len() - 1;
        let rows = self.rows.iter().map(|&row| row as usize).collect();
        SymbolicSparseColMat::new_checked(columns, columns, self.starts.clone(), None, rows)
    }

    /// The pattern of the scalars.
    pub(crate) fn scalars(&self) -> SymbolicSparseColMat<usize> {
        let columns = self.starts.len() - 1;
        let mut pointers = Vec::with_capacity(3 * columns + 1);
        let mut rows = Vec::with_capacity(self.scalar_count());
        pointers.push(0);
        for column in 0..columns {
            for axis in 0..3 {
                let blocks = &self.rows[self.starts[column]..self.starts[column + 1]];
                let scalars = blocks
                    .iter()
                    .flat_map(|&row| [0, 1, 2].map(|k: usize| 3 * row as usize + k));
                rows.extend(scalars.skip(axis));
                pointers.push(rows.len());
            }
        }
        SymbolicSparseColMat::new_checked(3 * columns, 3 * columns, pointers, None, rows)
    }

    /// Calls a function with the row, the column and the value of each scalar in the lower triangle.
    pub(crate) fn each(&self, values: &mut [f64], mut visit: impl FnMut([usize; 2], &mut f64)) {
        let mut values = values.iter_mut();
        for (column, ends) in self.starts.windows(2).enumerate() {
            for axis in 0..3 {
                let blocks = self.rows[ends[0]..ends[1]].iter();
                let rows = blocks.flat_map(|&row| [0, 1, 2].map(|k: usize| 3 * row as usize + k));
                for (row, value) in rows.skip(axis).zip(&mut values) {
                    visit([row, 3 * column + axis], value);
                }
            }
        }
    }

    /// Adds the block of row `a` and column `b` to the values of the scalars. Each off-diagonal block must be
    /// given in one triangle only. Of a diagonal block, the lower triangle is used.
    pub(crate) fn add(&self, values: &mut [f64], a: u32, b: u32, block: &Matrix3<f64>) {
        let (row, column) = (a.max(b), a.min(b) as usize);
        let (start, end) = (self.starts[column], self.starts[column + 1]);
        let Ok(place) = self.rows[start..end].binary_search(&row) else {
            return;
        };
        // The columns before have 9 scalars a block, without the 3 above the diagonal of each diagonal block.
        let mut scalar = 9 * start - 3 * column;
        for axis in 0..3 {
            let length = 3 * (end - start) - axis;
            for k in 0..3 {
                if place > 0 || k >= axis {
                    let entry = if a >= b {
                        block[(k, axis)]
                    } else {
                        block[(axis, k)]
                    };
                    values[scalar + 3 * place + k - axis] += entry;
                }
            }
            scalar += length;
        }
    }
}
