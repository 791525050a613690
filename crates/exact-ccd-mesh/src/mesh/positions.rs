//! Checks of the positions of a mesh's vertices.

use exact_ccd::Point;

/// The reason why points are not valid positions of the vertices of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PositionsError {
    /// The numbers of positions and vertices differ.
    #[error("{positions} positions, expected one for each of {vertex_count} vertices")]
    Count {
        /// The number of positions.
        positions: usize,
        /// The number of vertices of the mesh.
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

/// Checks that there is one position for each of `vertex_count` vertices and that all coordinates
/// are finite.
///
/// # Errors
/// [`PositionsError`] names the count, or the first coordinate that is not finite.
pub fn check_positions(vertex_count: usize, positions: &[Point]) -> Result<(), PositionsError> {
    if positions.len() != vertex_count {
        return Err(PositionsError::Count {
            positions: positions.len(),
            vertex_count,
        });
    }
    // Without a branch for each coordinate.
    let coordinates = positions.as_flattened().iter();
    if coordinates.fold(true, |all, x| all & x.is_finite()) {
        return Ok(());
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
