//! The faces of tetrahedra, and which of them lie on the boundary.

use crate::tet_mesh::TetMeshError;

/// The faces of a tetrahedron of positive volume, outward: (b − a) · ((c − a) × (d − a)) > 0.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// A face as one tetrahedron sees it, with what it takes to sort them.
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

impl Side {
    /// The corners, counterclockwise as seen from outside.
    fn outward(&self) -> [u32; 3] {
        let [a, b, c] = self.face;
        if self.even { [a, b, c] } else { [a, c, b] }
    }
}

/// The faces of some tetrahedra, each as often as it belongs to one.
pub(crate) struct Sides(Vec<Side>);

impl Sides {
    /// Those of tetrahedra that are meant to have positive volumes. Where they are does not matter.
    pub(crate) fn of(tetrahedra: impl IntoIterator<Item = [u32; 4]>) -> Self {
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

    /// Whether no two tetrahedra are on the same side of a face; of three that have one in common, two are.
    ///
    /// # Errors
    /// [`TetMeshError::Overlap`] names the first two that are.
    pub(crate) fn check(&self) -> Result<(), TetMeshError> {
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
    pub(crate) fn boundary(&self) -> Vec<[u32; 3]> {
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

    /// Whether a triangle is a face of a tetrahedron.
    pub(crate) fn contain(&self, triangle: [u32; 3]) -> bool {
        let face = sorted(triangle);
        self.0.binary_search_by_key(&face, |side| side.face).is_ok()
    }
}

fn sorted(mut face: [u32; 3]) -> [u32; 3] {
    face.sort_unstable();
    face
}
