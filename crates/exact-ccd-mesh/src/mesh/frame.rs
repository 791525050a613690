//! A triangle mesh at one time.

use exact_ccd::Point;

use super::connectivity::{MeshError, TriangleMesh};
use super::positions::{PositionsError, check_positions};
use crate::broad_phase::Aabb;

/// A triangle mesh at one time: its connectivity and the positions of its vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The connectivity.
    pub mesh: TriangleMesh,
    /// The position of each vertex of `mesh`.
    pub positions: Vec<Point>,
}

/// The reason why positions, faces and edges do not form a [`Frame`].
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FrameError {
    /// A face or an edge names a vertex that has no position.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The positions are not valid.
    #[error(transparent)]
    Positions(#[from] PositionsError),
}

impl Frame {
    /// The mesh of these faces, each three indices into `positions`.
    ///
    /// ```
    /// use exact_ccd_mesh::{Frame, FrameError};
    ///
    /// let square = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    /// let frame = Frame::new(square.clone(), vec![[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(frame.mesh.edges(), [[0, 1], [0, 2], [1, 2], [0, 3], [2, 3]]);
    ///
    /// let error = Frame::new(square, vec![[0, 1, 4]]).unwrap_err();
    /// assert_eq!(error.to_string(), "face 0 names vertex 4, but there are only 4 vertices");
    /// # Ok::<(), FrameError>(())
    /// ```
    ///
    /// # Errors
    /// The first index that is out of range, or else the first coordinate that is not finite.
    pub fn new(positions: Vec<Point>, faces: Vec<[u32; 3]>) -> Result<Self, FrameError> {
        Self::with_edges(positions, faces, &[])
    }

    /// The mesh of these faces and edges, each three or two indices into `positions`; see
    /// [`TriangleMesh::with_edges`].
    ///
    /// # Errors
    /// The first index that is out of range, or else the first coordinate that is not finite.
    pub fn with_edges(
        positions: Vec<Point>,
        faces: Vec<[u32; 3]>,
        edges: &[[u32; 2]],
    ) -> Result<Self, FrameError> {
        let mesh = TriangleMesh::with_edges(positions.len(), faces, edges)?;
        let frame = Self { mesh, positions };
        frame.check()?;
        Ok(frame)
    }

    /// Checks that there is one position for each vertex and that all coordinates are finite.
    ///
    /// # Errors
    /// [`PositionsError`] names the count, or the first coordinate that is not finite.
    pub fn check(&self) -> Result<(), PositionsError> {
        check_positions(self.mesh.vertex_count(), &self.positions)
    }

    /// The frame without the vertices of no face and no edge, and the index here of each remaining
    /// vertex, in increasing order.
    ///
    /// See [`TriangleMesh::without_unused_vertices`]: rods stay, points do not.
    #[must_use]
    pub fn without_unused_vertices(&self) -> (Self, Vec<u32>) {
        let (mesh, vertices) = self.mesh.without_unused_vertices();
        let positions = vertices
            .iter()
            .filter_map(|&vertex| self.positions.get(vertex as usize).copied());
        let frame = Self {
            positions: positions.collect(),
            mesh,
        };
        (frame, vertices)
    }

    /// The box around all vertices.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.positions.iter().copied().collect()
    }
}
