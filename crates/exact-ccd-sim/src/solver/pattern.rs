//! The sparsity pattern of a symmetric matrix of 3 × 3 blocks.

use faer::sparse::SymbolicSparseColMat;

use crate::energies::term::Block;

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

/// The larger unknown of a pair.
fn row(key: u64) -> u32 {
    (key & u64::from(u32::MAX)) as u32
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
        let rows = keys.iter().map(|&key| row(key)).collect();
        Self { starts, rows }
    }

    /// The pattern with more pairs. They may be in any order and may repeat.
    pub(crate) fn with(&self, mut keys: Vec<u64>) -> Self {
        if keys.is_empty() {
            return self.clone();
        }
        keys.sort_unstable();
        keys.dedup();
        let mut keys = keys.into_iter().peekable();
        let mut rows = Vec::with_capacity(self.rows.len() + keys.len());
        let mut starts = Vec::with_capacity(self.starts.len());
        starts.push(0);
        for (column, ends) in (0_u32..).zip(self.starts.windows(2)) {
            for &own in &self.rows[ends[0]..ends[1]] {
                while let Some(key) = keys.next_if(|&other| other < key(column, own)) {
                    rows.push(row(key));
                }
                keys.next_if_eq(&key(column, own));
                rows.push(own);
            }
            while let Some(key) = keys.next_if(|&other| other >> 32 == u64::from(column)) {
                rows.push(row(key));
            }
            starts.push(rows.len());
        }
        Self { starts, rows }
    }

    /// The place of each block in another pattern. `None` if that pattern has not all of the pairs.
    pub(crate) fn places_in(&self, other: &Self) -> Option<Vec<u32>> {
        if self == other {
            return Some((0..self.rows.len() as u32).collect());
        }
        if self.starts.len() != other.starts.len() {
            return None;
        }
        let mut places = Vec::with_capacity(self.rows.len());
        for (own, theirs) in self.starts.windows(2).zip(other.starts.windows(2)) {
            let mut place = theirs[0];
            for row in &self.rows[own[0]..own[1]] {
                place += other.rows[place..theirs[1]]
                    .iter()
                    .position(|other| other == row)?;
                places.push(place as u32);
            }
        }
        Some(places)
    }

    /// The number of blocks.
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The place of the block of a pair of unknowns, in either order.
    pub(crate) fn place(&self, a: u32, b: u32) -> Option<usize> {
        let (row, column) = (a.max(b), a.min(b) as usize);
        let start = self.starts[column];
        let rows = &self.rows[start..self.starts[column + 1]];
        rows.binary_search(&row).ok().map(|place| start + place)
    }

    /// The number of scalars in the lower triangle.
    fn scalar_count(&self) -> usize {
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

    /// The values of the scalars, from the blocks. Only the lower triangle of a diagonal block counts.
    pub(crate) fn values(&self, blocks: &[Block]) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.scalar_count());
        for ends in self.starts.windows(2) {
            let [diagonal, others @ ..] = &blocks[ends[0]..ends[1]] else {
                continue;
            };
            for axis in 0..3 {
                values.extend_from_slice(&diagonal[4 * axis..3 * axis + 3]);
                for block in others {
                    values.extend_from_slice(&block[3 * axis..3 * axis + 3]);
                }
            }
        }
        values
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
}
