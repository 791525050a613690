//! Welding: one vertex in place of coincident ones.

mod within;

use std::collections::HashMap;

use exact_ccd::Point;

use super::motion::{Motion, MotionError};
use crate::mesh::{DisjointSets, Frame, TriangleMesh};

/// One vertex in place of all vertices that coincide in every frame of a motion.
///
/// Such vertices coincide at all times in between as well, so the surface stays the same. Separate
/// bodies that share such a point become neighbours there, and pairs of primitives that share a
/// vertex are not tested. Vertices that coincide in some frames only are kept apart. The new
/// vertices are numbered in the order of first appearance, and the faces keep their order.
/// Coordinates are compared as numbers: −0.0 equals 0.0.
///
/// ```
/// use exact_ccd_mesh::Welding;
///
/// let mut welding = Welding::default();
/// welding.restrict(&[[0.0; 3], [1.0; 3], [0.0; 3], [1.0; 3]]);
/// assert_eq!(welding.positions(&[[5.0; 3], [6.0; 3], [5.0; 3], [7.0; 3]]), [[5.0; 3], [6.0; 3]]);
/// // In this frame the second and the last vertex are apart.
/// welding.restrict(&[[5.0; 3], [6.0; 3], [5.0; 3], [7.0; 3]]);
/// assert_eq!(welding.positions(&[[0.0; 3], [1.0; 3], [0.0; 3], [1.0; 3]]), [[0.0; 3], [1.0; 3], [1.0; 3]]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Welding {
    /// The new vertex of each vertex. Before the first frame, all vertices count as the same one.
    vertex_of: Vec<u32>,
    /// The first vertex that became each of the new ones.
    first: Vec<usize>,
}

impl Welding {
    /// Separates the vertices that do not coincide in a frame with these positions. All frames have
    /// the same number of vertices.
    pub fn restrict(&mut self, positions: &[Point]) {
        let mut numbers = HashMap::with_capacity(self.first.len());
        self.vertex_of.resize(positions.len(), 0);
        self.first.clear();
        for (index, (vertex, &position)) in self.vertex_of.iter_mut().zip(positions).enumerate() {
            *vertex = *numbers.entry((*vertex, key(position))).or_insert_with(|| {
                self.first.push(index);
                self.first.len() as u32 - 1
            });
        }
    }

    /// Keeps apart the vertices that coincide but are not ends of coinciding edges: the seams remain at
    /// which exporters split vertices, for texture coordinates or normals.
    ///
    /// Vertices are welded if two edges of `mesh` that end in them coincide, and so are the vertices that a
    /// chain of such edges connects. Bodies that touch in single points, and loose vertices, stay apart.
    ///
    /// ```
    /// use exact_ccd_mesh::{TriangleMesh, Welding};
    ///
    /// // Two faces with a common side, and a third one that touches them in a corner.
    /// let mesh = TriangleMesh::new(9, vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]])?;
    /// let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
    /// let mut welding = Welding::default();
    /// welding.restrict(&[a, b, c, c, b, d, a, [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]]);
    /// let welding = welding.along_edges(&mesh);
    /// assert_eq!(welding.mesh(&mesh)?.faces(), [[0, 1, 2], [2, 1, 3], [4, 5, 6]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn along_edges(self, mesh: &TriangleMesh) -> Self {
        let place = |vertex: u32| self.vertex_of.get(vertex as usize).copied();
        let mut welded = DisjointSets::new(self.vertex_of.len());
        let mut edges: HashMap<[u32; 2], [u32; 2]> = HashMap::new();
        for &[a, b] in mesh.edges() {
            let (Some(at_a), Some(at_b)) = (place(a), place(b)) else {
                continue;
            };
            let ends = if at_a < at_b { [a, b] } else { [b, a] };
            if at_a == at_b {
                continue;
            }
            let first = *edges.entry([at_a.min(at_b), at_a.max(at_b)]).or_insert(ends);
            for (x, y) in first.into_iter().zip(ends) {
                welded.unite(x, y);
            }
        }
        let mut first = Vec::new();
        let mut number_of = vec![None; self.vertex_of.len()];
        let vertices = 0..self.vertex_of.len();
        let number = |vertex: usize| {
            *number_of[welded.root(vertex as u32) as usize].get_or_insert_with(|| {
                first.push(vertex);
                first.len() as u32 - 1
            })
        };
        let vertex_of = vertices.map(number).collect();
        Self { vertex_of, first }
    }

    /// The mesh with the new vertices.
    ///
    /// # Errors
    /// [`MotionError::VertexCount`] if the number of vertices differs from that of the frames of
    /// this welding.
    pub fn mesh(&self, mesh: &TriangleMesh) -> Result<TriangleMesh, MotionError> {
        if mesh.vertex_count() != self.vertex_of.len() {
            return Err(MotionError::VertexCount {
                start: self.vertex_of.len(),
                end: mesh.vertex_count(),
            });
        }
        let weld = |vertex: u32| self.vertex_of[vertex as usize];
        let faces = mesh.faces().iter().map(|face| face.map(weld)).collect();
        let edges: Vec<_> = mesh.loose_edges().iter().map(|edge| edge.map(weld)).collect();
        Ok(TriangleMesh::with_edges(self.first.len(), faces, &edges).expect("every vertex has its new one"))
    }

    /// The new vertex in place of a vertex, if the frames have it.
    #[must_use]
    pub fn vertex_of(&self, vertex: u32) -> Option<u32> {
        self.vertex_of.get(vertex as usize).copied()
    }

    /// The position of each new vertex: that of the first of its vertices.
    #[must_use]
    pub fn positions(&self, positions: &[Point]) -> Vec<Point> {
        self.first
            .iter()
            .filter_map(|&vertex| positions.get(vertex).copied())
            .collect()
    }

    /// The first of the vertices in place of which each new vertex is.
    #[must_use]
    pub fn first_vertices(&self) -> &[usize] {
        &self.first
    }
}

impl Motion {
    /// The motion from one frame to another, with vertices welded that coincide both at t = 0 and
    /// at t = 1: see [`Welding`].
    ///
    /// # Errors
    /// As [`Motion::new`].
    pub fn weld(start: Frame, end: Frame) -> Result<Self, MotionError> {
        let split = Self::new(start, end)?;
        let mut welding = Welding::default();
        welding.restrict(&split.x0);
        welding.restrict(&split.x1);
        Ok(Self {
            mesh: welding.mesh(&split.mesh)?,
            x0: welding.positions(&split.x0),
            x1: welding.positions(&split.x1),
        })
    }
}

/// A key that is equal for positions that are equal as numbers.
fn key(position: Point) -> [u64; 3] {
    // By the bits: a sum with 0.0 depends on the floating-point environment.
    position.map(|x| if x.to_bits() == 1 << 63 { 0 } else { x.to_bits() })
}
