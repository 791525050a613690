//! A mesh of tetrahedra and its surface.

use std::cmp::Ordering;

use exact_ccd::Point;
use exact_ccd::predicates::orient3d;

use super::boundary::TetFaces;
use super::connectivity::has_indices;
use super::frame::Frame;
use super::positions::check_positions;
use super::tet_error::TetMeshError;

/// A body of tetrahedra at one time, and its surface.
#[derive(Clone, Debug, PartialEq)]
pub struct TetMesh {
    positions: Vec<Point>,
    tetrahedra: Vec<[u32; 4]>,
    surface: Vec<[u32; 3]>,
}

impl TetMesh {
    /// The mesh of these tetrahedra, each four indices into `positions`.
    ///
    /// The surface consists of the faces that belong to one tetrahedron only, in the order of the
    /// tetrahedra, their corners counterclockwise as seen from outside. Volumes may have either
    /// sign; the order of corners is kept.
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
    /// [`TetMeshError`] names the coordinate that is not finite, the index that is out of range,
    /// the first tetrahedron without volume, or two tetrahedra on the same side of a common face.
    pub fn new(positions: Vec<Point>, tetrahedra: Vec<[u32; 4]>) -> Result<Self, TetMeshError> {
        check_positions(positions.len(), &positions)?;
        if !has_indices(positions.len()) {
            let vertex_count = positions.len();
            return Err(TetMeshError::TooManyVertices { vertex_count });
        }
        let oriented = tetrahedra
            .iter()
            .enumerate()
            .map(|(tetrahedron, &corners)| oriented(&positions, tetrahedron, corners));
        let faces = TetFaces::of(oriented.collect::<Result<Vec<_>, _>>()?);
        faces.check()?;
        let surface = faces.boundary();
        Ok(Self {
            positions,
            tetrahedra,
            surface,
        })
    }

    /// The position of each vertex.
    #[must_use]
    pub fn positions(&self) -> &[Point] {
        &self.positions
    }

    /// The tetrahedra and their corners, in the given order.
    #[must_use]
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.tetrahedra
    }

    /// The triangles of the surface, counterclockwise as seen from outside, as indices into
    /// [`TetMesh::positions`].
    #[must_use]
    pub fn surface(&self) -> &[[u32; 3]] {
        &self.surface
    }

    /// The surface alone, and the index here of each of its vertices, in increasing order.
    ///
    /// Vertices inside the body or in no tetrahedron are left out. Otherwise they would count as
    /// points, and the surface would be in contact with the inside of its own body.
    #[must_use]
    pub fn surface_frame(&self) -> (Frame, Vec<u32>) {
        let frame = Frame::new(self.positions.clone(), self.surface.clone());
        frame
            .expect("positions and faces of a `TetMesh` are valid")
            .without_unused_vertices()
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
    // `Less` for a positive volume.
    let side = orient3d(corners.map(|vertex| positions[vertex as usize]));
    let [a, b, c, d] = corners;
    match side {
        Ok(Ordering::Less) => Ok(corners),
        Ok(Ordering::Greater) => Ok([b, a, c, d]),
        // All coordinates are finite.
        Ok(Ordering::Equal) | Err(_) => Err(TetMeshError::Flat { tetrahedron }),
    }
}
