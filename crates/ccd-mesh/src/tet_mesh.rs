//! A mesh of tetrahedra and its surface.

use std::cmp::Ordering;
use std::path::Path;

use exact_ccd::{Point, orientation};

use crate::frame::Frame;
use crate::mesh::TriangleMesh;
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

/// The faces of a tetrahedron of positive volume, outward: (b − a) · ((c − a) × (d − a)) > 0.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// One side of a face, with what it takes to sort them.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    /// The vertices in increasing order.
    face: [u32; 3],
    /// Whether the face, seen from outside of the tetrahedron, turns as these vertices do.
    even: bool,
    tetrahedron: usize,
    /// Which face of the tetrahedron.
    number: usize,
}

impl TetMesh {
    /// The mesh of these tetrahedra, each four indices into `positions`.
    ///
    /// The surface are the faces that belong to one tetrahedron only, in the order of the tetrahedra, their corners
    /// counterclockwise as seen from outside. Tetrahedra stay as they are; their volumes may have either sign.
    ///
    /// ```
    /// use ccd_mesh::TetMesh;
    ///
    /// // Two tetrahedra with a common face.
    /// let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
    /// let mesh = TetMesh::new(positions, vec![[0, 1, 2, 3], [1, 2, 3, 4]])?;
    /// assert_eq!(mesh.surface(), [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]]);
    /// # Ok::<(), ccd_mesh::TetMeshError>(())
    /// ```
    ///
    /// # Errors
    /// [`TetMeshError`] names the coordinate that is not finite, the index that is out of range, the first tetrahedron
    /// without volume, or two of which one must be inside out.
    pub fn new(positions: Vec<Point>, tetrahedra: Vec<[u32; 4]>) -> Result<Self, TetMeshError> {
        positions::check_all(positions.len(), &positions)?;
        let surface = surface(&positions, &tetrahedra)?;
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
        self.frame_of(&self.surface)
    }

    /// The surface, and those of some triangles that are no faces of tetrahedra, as shells beside solids, without vertices
    /// that are in none of them.
    pub(crate) fn surface_with_shells(&self, triangles: &[[u32; 3]]) -> Frame {
        let shells = self.no_faces(triangles).map(|triangle| triangles[triangle]);
        let faces: Vec<[u32; 3]> = self.surface.iter().copied().chain(shells).collect();
        self.frame_of(&faces).0
    }

    /// These faces alone, and for each of their vertices the number that it has here, increasing.
    fn frame_of(&self, faces: &[[u32; 3]]) -> (Frame, Vec<u32>) {
        let mut vertices = faces.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let mut number = vec![0; self.positions.len()];
        for (new, &old) in (0..).zip(&vertices) {
            number[old as usize] = new;
        }
        let renumber = |face: &[u32; 3]| face.map(|vertex| number[vertex as usize]);
        let faces = faces.iter().map(renumber).collect();
        let frame = Frame {
            mesh: TriangleMesh::new(vertices.len(), faces).expect("all vertices of the faces are there"),
            positions: vertices
                .iter()
                .map(|&vertex| self.positions[vertex as usize])
                .collect(),
        };
        (frame, vertices)
    }

    /// Those of these triangles that are not faces of any tetrahedron, by their places, increasing.
    pub(crate) fn no_faces(&self, triangles: &[[u32; 3]]) -> impl Iterator<Item = usize> {
        let corners = self.tetrahedra.iter().filter(|_| !triangles.is_empty());
        let mut faces: Vec<[u32; 3]> = corners
            .flat_map(|corners| FACES.map(|face| sorted(face.map(|k| corners[k]))))
            .collect();
        faces.sort_unstable();
        let is_no_face = move |triangle: [u32; 3]| faces.binary_search(&sorted(triangle)).is_err();
        triangles
            .iter()
            .enumerate()
            .filter(move |&(_, &triangle)| is_no_face(triangle))
            .map(|(place, _)| place)
    }
}

fn sorted(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}

fn surface(positions: &[Point], tetrahedra: &[[u32; 4]]) -> Result<Vec<[u32; 3]>, TetMeshError> {
    let mut sides = Vec::with_capacity(4 * tetrahedra.len());
    for (tetrahedron, &corners) in tetrahedra.iter().enumerate() {
        for (number, face) in outward_faces(positions, tetrahedron, corners)?
            .into_iter()
            .enumerate()
        {
            let [a, b, c] = face;
            sides.push(Side {
                face: sorted(face),
                even: (a < b) == ((b < c) == (a < c)),
                tetrahedron,
                number,
            });
        }
    }
    sides.sort_unstable();
    let mut boundary = Vec::new();
    for same_face in sides.chunk_by(|s, t| s.face == t.face) {
        if let Some(pair) = same_face.windows(2).find(|pair| pair[0].even == pair[1].even) {
            return Err(TetMeshError::Overlap {
                first: pair[0].tetrahedron,
                second: pair[1].tetrahedron,
                face: pair[0].face,
            });
        }
        if let [side] = same_face {
            boundary.push(*side);
        }
    }
    boundary.sort_unstable_by_key(|side| (side.tetrahedron, side.number));
    let outward = |side: Side| {
        let [a, b, c] = side.face;
        if side.even { [a, b, c] } else { [a, c, b] }
    };
    Ok(boundary.into_iter().map(outward).collect())
}

fn outward_faces(
    positions: &[Point],
    tetrahedron: usize,
    corners: [u32; 4],
) -> Result<[[u32; 3]; 4], TetMeshError> {
    let vertex_count = positions.len();
    if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertex_count) {
        return Err(TetMeshError::Index {
            tetrahedron,
            vertex,
            vertex_count,
        });
    }
    let volume = orientation(corners.map(|vertex| positions[vertex as usize]));
    let faces = FACES.map(|face| face.map(|k| corners[k]));
    match volume {
        Ok(Ordering::Greater) => Ok(faces),
        Ok(Ordering::Less) => Ok(faces.map(|[a, b, c]| [a, c, b])),
        // All coordinates are finite.
        Ok(Ordering::Equal) | Err(_) => Err(TetMeshError::Flat { tetrahedron }),
    }
}
