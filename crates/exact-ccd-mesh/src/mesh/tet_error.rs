//! Errors of meshes of tetrahedra.

use super::positions::PositionsError;

/// The reason why positions and tetrahedra do not form a [`TetMesh`](crate::TetMesh). All are
/// counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TetMeshError {
    /// The positions are not valid.
    #[error(transparent)]
    Positions(#[from] PositionsError),
    /// A tetrahedron names a vertex that has no position.
    #[error("tetrahedron {tetrahedron} names vertex {vertex}, but there are only {vertex_count} vertices")]
    Index {
        /// The index of the tetrahedron.
        tetrahedron: usize,
        /// The index of the corner.
        vertex: u32,
        /// The number of vertices.
        vertex_count: usize,
    },
    /// All four corners of a tetrahedron lie in one plane, exactly.
    #[error("tetrahedron {tetrahedron} has no volume")]
    Flat {
        /// The index of the tetrahedron.
        tetrahedron: usize,
    },
    /// Two tetrahedra are on the same side of a face that they share, or three share one.
    #[error("tetrahedra {first} and {second} are on the same side of their common face {face:?}")]
    Overlap {
        /// The first tetrahedron with that face.
        first: usize,
        /// The next one on the same side.
        second: usize,
        /// The three vertices of the face, in increasing order.
        face: [u32; 3],
    },
    /// Vertices have 32-bit indices.
    #[error("{vertex_count} vertices, expected at most 2^32 - 1")]
    TooManyVertices {
        /// The number of vertices.
        vertex_count: usize,
    },
}
