//! Positions that fit a mesh.

use exact_ccd::Point;

use crate::mesh::TriangleMesh;

/// What keeps points from being the positions of a mesh's vertices.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PositionsError {
    /// There is not one position for each vertex.
    #[error("{positions} positions, expected one for each of {vertex_count} vertices")]
    Count {
        /// How many positions there are.
        positions: usize,
        /// How many vertices the mesh has.
        vertex_count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has {axis} = {value}, expected a finite number")]
    NotFinite {
        /// The index of the vertex, from 0.
        vertex: usize,
        /// `x`, `y` or `z`.
        axis: char,
        /// The coordinate.
        value: f64,
    },
}

/// Checks that there is one position for each vertex and that all coordinates are finite.
pub(crate) fn check(mesh: &TriangleMesh, positions: &[Point]) -> Result<(), PositionsError> {
    check_all(mesh.vertex_count(), positions)
}

/// [`check`] for any mesh of that many vertices.
pub(crate) fn check_all(vertex_count: usize, positions: &[Point]) -> Result<(), PositionsError> {
    if positions.len() != vertex_count {
        return Err(PositionsError::Count {
            positions: positions.len(),
            vertex_count,
        });
    }
    for (vertex, position) in positions.iter().enumerate() {
        for (axis, &value) in ['x', 'y', 'z'].into_iter().zip(position) {
            if !value.is_finite() {
                return Err(PositionsError::NotFinite { vertex, axis, value });
            }
        }
    }
    Ok(())
}
