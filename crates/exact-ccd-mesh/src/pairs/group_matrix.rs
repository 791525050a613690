//! The pairs of groups that can collide.

/// A symmetric matrix of groups: an entry is true if the vertices of its two groups can collide.
///
/// The diagonal is the pairs of a group with itself. Robots are described so: the links that touch by design
/// are the pairs that cannot collide. [`CanCollide::by_groups`](super::CanCollide::by_groups) takes it.
///
/// ```
/// use exact_ccd_mesh::GroupMatrix;
///
/// // Three links in a row: neighbours overlap at their joint.
/// let matrix = GroupMatrix::from_fn(3, |a, b| a.abs_diff(b) > 1);
/// assert!(matrix.allows(2, 0) && !matrix.allows(1, 2) && !matrix.allows(1, 1));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroupMatrix {
    group_count: usize,
    /// The rows of the matrix, one after the other.
    entries: Vec<bool>,
}

impl GroupMatrix {
    /// The matrix with these rows, one after the other.
    ///
    /// # Errors
    /// [`GroupError::Length`] if the entries are not `group_count` rows of that length;
    /// [`GroupError::Asymmetric`] if a pair of groups has two answers.
    pub fn new(group_count: usize, entries: Vec<bool>) -> Result<Self, GroupError> {
        if group_count.checked_mul(group_count) != Some(entries.len()) {
            let actual = entries.len();
            return Err(GroupError::Length { group_count, actual });
        }
        let matrix = Self { group_count, entries };
        for row in 0..group_count {
            if let Some(column) =
                (0..row).find(|&column| matrix.entry(row, column) != matrix.entry(column, row))
            {
                return Err(GroupError::Asymmetric { row, column });
            }
        }
        Ok(matrix)
    }

    /// The matrix whose entry of two groups `a <= b` is `can_collide(a, b)`.
    #[must_use]
    pub fn from_fn(group_count: usize, can_collide: impl Fn(usize, usize) -> bool) -> Self {
        let rows = 0..group_count;
        let entry = |a: usize, b: usize| can_collide(a.min(b), a.max(b));
        let entries = rows.flat_map(|a| (0..group_count).map(move |b| (a, b)));
        Self {
            group_count,
            entries: entries.map(|(a, b)| entry(a, b)).collect(),
        }
    }

    /// The number of groups.
    #[must_use]
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// Returns true if the vertices of two groups can collide. A group that the matrix does not have can
    /// collide with every group.
    #[must_use]
    pub fn allows(&self, a: u32, b: u32) -> bool {
        let (a, b) = (a as usize, b as usize);
        a.max(b) >= self.group_count || self.entry(a, b)
    }

    fn entry(&self, row: usize, column: usize) -> bool {
        self.entries[row * self.group_count + column]
    }

    /// Checks that the matrix has the group of every vertex.
    pub(super) fn check(&self, groups: &[u32]) -> Result<(), GroupError> {
        let is_missing = |&group: &u32| group as usize >= self.group_count;
        groups.iter().position(is_missing).map_or(Ok(()), |vertex| {
            Err(GroupError::NoSuchGroup {
                vertex,
                group: groups[vertex],
                group_count: self.group_count,
            })
        })
    }
}

/// The error for groups and a matrix that do not belong together, or for a matrix that is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GroupError {
    /// The entries are not a square.
    #[error("{actual} entries, expected {group_count} rows of {group_count}")]
    Length {
        /// The number of groups.
        group_count: usize,
        /// The number of entries.
        actual: usize,
    },
    /// A pair of groups can collide by one entry, and cannot by the other.
    #[error(
        "the entries ({row}, {column}) and ({column}, {row}) differ: set both, since they are one pair of groups"
    )]
    Asymmetric {
        /// The larger group.
        row: usize,
        /// The smaller group.
        column: usize,
    },
    /// A vertex is in a group that the matrix does not have.
    #[error(
        "vertex {vertex} is in group {group}, but the matrix has {group_count} groups, numbered from 0: \
         add a row and a column for each group"
    )]
    NoSuchGroup {
        /// The vertex.
        vertex: usize,
        /// Its group.
        group: u32,
        /// The number of groups of the matrix.
        group_count: usize,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_square_and_symmetric() {
        let error = GroupMatrix::new(2, vec![true; 3]).unwrap_err();
        assert_eq!(
            error,
            GroupError::Length {
                group_count: 2,
                actual: 3
            }
        );
        assert!(GroupMatrix::new(usize::MAX, Vec::new()).is_err());
        let entries = vec![false, true, false, true, false, false, false, true, false];
        let error = GroupMatrix::new(3, entries).unwrap_err();
        assert_eq!(error, GroupError::Asymmetric { row: 2, column: 1 });
        assert_eq!(
            error.to_string(),
            "the entries (2, 1) and (1, 2) differ: set both, since they are one pair of groups"
        );
        assert_eq!(
            GroupMatrix::new(2, vec![false, true, true, false]),
            Ok(GroupMatrix::from_fn(2, |a, b| a != b))
        );
    }

    #[test]
    fn every_vertex_has_a_group_of_the_matrix() {
        let matrix = GroupMatrix::from_fn(2, |_, _| false);
        assert_eq!(matrix.check(&[0, 1, 1]), Ok(()));
        let error = matrix.check(&[0, 2]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "vertex 1 is in group 2, but the matrix has 2 groups, numbered from 0: \
             add a row and a column for each group"
        );
        assert_eq!(GroupMatrix::from_fn(0, |_, _| false).check(&[]), Ok(()));
    }
}
