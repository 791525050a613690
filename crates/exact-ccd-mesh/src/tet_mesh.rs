//! A mesh of tetrahedra and its surface.

use std::cmp::Ordering;
use std::path::Path;

use exact_ccd::Point;
use exact_ccd::predicates::orient3d;

use crate::boundary::Sides;
use crate::frame::Frame;
use crate::positions::{self, PositionsError};
use crate::read::{self, ParseError, ReadError};

/// A body of tetrahedra at one time, and its surface.
#[derive(Clone, Debug, PartialEq)]
pub struct TetMesh {
    positions: Vec<Point>,
    tetrahedra: Vec<[u32; 4]>,
    surface: Vec<[u32; 3]>,
}

/// What keeps positions and tetrahedra from being a [`TetMesh`]. All are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TetMeshError {
    /// The positions are not sound.
    #[error(transparent)]
    Positions(#[from] PositionsError),
    /// A tetrahedron names a vertex that has no position.
    #[error("tetrahedron {tetrahedron} names vertex {vertex}, but there are only {vertex_count} vertices")]
    Index {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// All four corners of a tetrahedron lie in one plane, exactly.
    #[error("tetrahedron {tetrahedron} has no volume")]
    Flat {
        /// The tetrahedron.
        tetrahedron: usize,
    },
    /// Two tetrahedra are on the same side of a face that they share, or three share one.
    #[error("tetrahedra {first} and {second} are on the same side of their common face {face:?}")]
    Overlap {
        /// The first tetrahedron with that face.
        first: usize,
        /// The next one on its side.
        second: usize,
        /// The three vertices of the face, in increasing order.
        face: [u32; 3],
    },
}

impl TetMesh {
    /// The mesh of these tetrahedra, each four indices into `positions`.
    ///
    /// The surface are the faces that belong to one tetrahedron only, in the order of the tetrahedra, their corners
    /// counterclockwise as seen from outside. Tetrahedra stay as they are; their volumes may have either sign.
    ///
    /// ```
    /// use exact_ccd_mesh::TetMesh;
    ///
    /// // Two tetrahedra with a common face.
    /// let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
    /// let mesh = TetMesh::new(positions, vec![[0, 1, 2, 3], [1, 2, 3, 4]])?;
    /// assert_eq!(mesh.surface(), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]]);
    /// # Ok::<(), exact_ccd_mesh::TetMeshError>(())
    /// ```
    ///
    /// # Errors
    /// [`TetMeshError`] names the coordinate that is not finite, the index that is out of range, the first tetrahedron
    /// without volume, or two of which one must be inside out.
    pub fn new(positions: Vec<Point>, tetrahedra: Vec<[u32; 4]>) -> Result<Self, TetMeshError> {
        positions::check_all(positions.len(), &positions)?;
        let oriented = tetrahedra
            .iter()
            .enumerate()
            .map(|(tetrahedron, &corners)| oriented(&positions, tetrahedron, corners));
        let sides = Sides::of(oriented.collect::<Result<Vec<_>, _>>()?);
        sides.check()?;
        let surface = sides.boundary();
        Ok(Self {
            positions,
            tetrahedra,
            surface,
        })
    }

    /// The mesh in a Gmsh file, `.msh`, version 2.2 or 4.1, text or binary.
    ///
    /// Vertices and tetrahedra keep their order in the file and are counted from 0, whatever tags they have. Triangles may
    /// be listed or not, if only they are faces of tetrahedra; points and lines are skipped.
    ///
    /// # Errors
    /// [`ReadError`] names the file, the place in it, and what was expected there.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ReadError> {
        read::read_tet_mesh(path.as_ref())
    }

    /// The mesh in the contents of a Gmsh file, as [`TetMesh::read`] gives it.
    ///
    /// # Errors
    /// [`ParseError`] names the place and what was expected there.
    pub fn parse(bytes: &[u8]) -> Result<Self, ParseError> {
        read::parse_tet_mesh(bytes)
    }

    /// The same mesh elsewhere. The surface keeps its orientation, even where tetrahedra turn inside out.
    ///
    /// # Errors
    /// [`PositionsError`] says which positions are too many, too few or not finite.
    pub fn moved(&self, positions: Vec<Point>) -> Result<Self, PositionsError> {
        positions::check_all(self.positions.len(), &positions)?;
        Ok(Self {
            positions,
            tetrahedra: self.tetrahedra.clone(),
            surface: self.surface.clone(),
        })
    }

    /// The position of each vertex.
    #[must_use]
    pub fn positions(&self) -> &[Point] {
        &self.positions
    }

    /// The tetrahedra, in the order and with the corners that were given.
    #[must_use]
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.tetrahedra
    }

    /// The triangles of the surface, counterclockwise as seen from outside, with the numbers that vertices have here.
    #[must_use]
    pub fn surface(&self) -> &[[u32; 3]] {
        &self.surface
    }

    /// The surface alone, and for each of its vertices the number that it has here, increasing.
    ///
    /// Vertices that are inside, or in no tetrahedron, are left out: a surface that passes over its own inside is no contact.
    #[must_use]
    pub fn surface_frame(&self) -> (Frame, Vec<u32>) {
        let frame = Frame::new(self.positions.clone(), self.surface.clone());
        frame
            .expect("its positions and faces are sound")
            .without_loose_vertices()
    }
}

/// The corners of a tetrahedron, with two of them swapped if its volume is negative.
fn oriented(positions: &[Point], tetrahedron: usize, corners: [u32; 4]) -> Result<[u32; 4], TetMeshError> {
    let vertex_count = positions.len();
    if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertex_count) {
        return Err(TetMeshError::Index {
            tetrahedron,
            vertex,
            vertex_count,
        });
    }
    let volume = orient3d(corners.map(|vertex| positions[vertex as usize]));
    let [a, b, c, d] = corners;
    match volume {
        Ok(Ordering::Greater) => Ok(corners),
        Ok(Ordering::Less) => Ok([b, a, c, d]),
        // All coordinates are finite.
        Ok(Ordering::Equal) | Err(_) => Err(TetMeshError::Flat { tetrahedron }),
    }
}
