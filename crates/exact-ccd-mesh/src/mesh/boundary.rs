//! The faces of tetrahedra, and the boundary faces among them.

use super::tet_error::TetMeshError;

/// The faces of a tetrahedron of positive volume, outward: (b − a) · ((c − a) × (d − a)) > 0.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// A face of one tetrahedron. The order of the fields is the order in which faces are sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    /// The vertices in increasing order.
    face: [u32; 3],
    /// True if these vertices are counterclockwise as seen from outside of the tetrahedron.
    even: bool,
    tetrahedron: usize,
    /// The index of the face in [`FACES`].
    number: usize,
}

impl Side {
    /// The corners, counterclockwise as seen from outside.
    fn outward(&self) -> [u32; 3] {
        let [a, b, c] = self.face;
        if self.even { [a, b, c] } else { [a, c, b] }
    }
}

/// The faces of tetrahedra, by connectivity alone: positions do not matter.
///
/// A face that two tetrahedra share occurs twice.
///
/// ```
/// use exact_ccd_mesh::TetFaces;
///
/// let faces = TetFaces::of([[0, 1, 2, 3], [1, 2, 3, 4]]);
/// assert!(faces.contains([3, 2, 1]) && !faces.contains([0, 1, 4]));
/// assert_eq!(faces.boundary()[..3], [[0, 2, 1], [0, 1, 3], [0, 3, 2]]);
/// ```
#[derive(Clone, Debug)]
pub struct TetFaces(Vec<Side>);

impl TetFaces {
    /// The faces of tetrahedra whose volumes count as positive in the order of their corners.
    #[must_use]
    pub fn of(tetrahedra: impl IntoIterator<Item = [u32; 4]>) -> Self {
        let mut sides = Vec::new();
        for (tetrahedron, corners) in tetrahedra.into_iter().enumerate() {
            for (number, face) in FACES.into_iter().enumerate() {
                let [a, b, c] = face.map(|k| corners[k]);
                sides.push(Side {
                    face: sorted([a, b, c]),
                    even: (a < b) == ((b < c) == (a < c)),
                    tetrahedron,
                    number,
                });
            }
        }
        sides.sort_unstable();
        Self(sides)
    }

    /// Checks that no two tetrahedra are on the same side of a face. Of three with a common face,
    /// two always are.
    ///
    /// # Errors
    /// [`TetMeshError::Overlap`] names the first two on the same side.
    pub fn check(&self) -> Result<(), TetMeshError> {
        let mut pairs = self.0.windows(2).map(|pair| [pair[0], pair[1]]);
        match pairs.find(|[s, t]| s.face == t.face && s.even == t.even) {
            None => Ok(()),
            Some([first, second]) => Err(TetMeshError::Overlap {
                first: first.tetrahedron,
                second: second.tetrahedron,
                face: first.face,
            }),
        }
    }

    /// The faces that belong to one tetrahedron only, outward, in the order of the tetrahedra.
    #[must_use]
    pub fn boundary(&self) -> Vec<[u32; 3]> {
        let faces = self.0.chunk_by(|s, t| s.face == t.face);
        let mut boundary: Vec<&Side> = faces
            .filter_map(|sides| match sides {
                [side] => Some(side),
                _ => None,
            })
            .collect();
        boundary.sort_unstable_by_key(|side| (side.tetrahedron, side.number));
        boundary.into_iter().map(Side::outward).collect()
    }

    /// Returns true if a triangle is a face of a tetrahedron, with its corners in any order.
    #[must_use]
    pub fn contains(&self, triangle: [u32; 3]) -> bool {
        let face = sorted(triangle);
        self.0.binary_search_by_key(&face, |side| side.face).is_ok()
    }
}

fn sorted(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}
