//! A triangle mesh at one time.

use std::path::Path;

use exact_ccd::Point;

use crate::mesh::{MeshError, TriangleMesh};
use crate::positions::{self, PositionsError};
use crate::read::{self, Format, ParseError, ReadError};
#[cfg(doc)]
use crate::tet_mesh::TetMesh;

/// A triangle mesh at one time: its connectivity and where its vertices are.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The faces, and the edges that they share.
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
    /// A coordinate is not finite.
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

    /// The mesh of these faces and edges, each three or two indices into `positions`; see [`TriangleMesh::with_edges`].
    ///
    /// # Errors
    /// The first index that is out of range, or else the first coordinate that is not finite.
    pub fn with_edges(
        positions: Vec<Point>,
        faces: Vec<[u32; 3]>,
        edges: &[[u32; 2]],
    ) -> Result<Self, FrameError> {
        let mesh = TriangleMesh::with_edges(positions.len(), faces, edges)?;
        positions::check(&mesh, &positions)?;
        Ok(Self { mesh, positions })
    }

    /// The frame in a file. The extension tells the format, see [`Format::of_path`].
    ///
    /// Vertices and faces keep the numbers that they have in the file, counted from 0. Each coordinate is the `f64`
    /// nearest to the decimal text, or exactly the binary number. An STL file knows no shared vertices: it reads as
    /// three vertices for each face. Of a .msh file of tetrahedra, it is the surface alone, see [`TetMesh::surface_frame`]; of a
    /// .vtu file, that and the triangles beside it, with tetrahedra taken to be positive in their order.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError> {
        read::read(path.as_ref())
    }

    /// The frame in the contents of a file, as [`Frame::read`] gives it.
    ///
    /// ```
    /// use exact_ccd_mesh::{Format, Frame};
    ///
    /// let frame = Frame::parse(b"v 0 0 0\nv 0.1 0 0\nv 0 1 0\nf 1 2 3\n", Format::Obj)?;
    /// assert_eq!(frame.positions[1], [0.1, 0.0, 0.0]);
    /// assert_eq!(frame.mesh.faces(), [[0, 1, 2]]);
    ///
    /// let error = Frame::parse(b"v 0 0 zero", Format::Obj).unwrap_err();
    /// assert_eq!(error.to_string(), "line 1: expected a number, found `zero`");
    /// # Ok::<(), exact_ccd_mesh::ParseError>(())
    /// ```
    ///
    /// # Errors
    /// [`ParseError`] names the place and what was expected there.
    pub fn parse(bytes: &[u8], format: Format) -> Result<Self, ParseError> {
        read::parse(bytes, format)
    }

    /// The frame without the vertices that no face names, and for each of the others the number that it has here, increasing.
    #[must_use]
    pub fn without_loose_vertices(&self) -> (Self, Vec<u32>) {
        let (mesh, vertices) = self.mesh.without_loose_vertices();
        let positions = vertices
            .iter()
            .filter_map(|&vertex| self.positions.get(vertex as usize).copied());
        let frame = Self {
            positions: positions.collect(),
            mesh,
        };
        (frame, vertices)
    }
}
