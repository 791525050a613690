//! What can touch.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{PairKind, TriangleMesh};

/// The triangles that can touch, and which of their vertices belong to obstacles.
#[derive(Clone, Debug)]
pub struct Surface {
    mesh: TriangleMesh,
    /// Vertices of faces, the others being inside a solid.
    vertices: Vec<u32>,
    obstacle: Vec<bool>,
}

impl Surface {
    /// The surface of a mesh. `obstacle` tells of each vertex whether it belongs to an obstacle: contact between
    /// two of these is no concern. Vertices of which it tells nothing do not.
    #[must_use]
    pub fn new(mesh: TriangleMesh, mut obstacle: Vec<bool>) -> Self {
        obstacle.resize(mesh.vertex_count(), false);
        let (_, vertices) = mesh.without_loose_vertices();
        Self {
            mesh,
            vertices,
            obstacle,
        }
    }

    /// The connectivity.
    #[must_use]
    pub fn mesh(&self) -> &TriangleMesh {
        &self.mesh
    }

    /// The vertices of faces, increasing: without those inside of solids.
    #[must_use]
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The vertices of a pair of a vertex and a face.
    ///
    /// # Panics
    /// If there is no such face.
    #[must_use]
    pub fn vertex_face(&self, pair: [u32; 2]) -> [u32; 4] {
        VertexFace::vertices(&self.mesh, pair).expect("the mesh has both")
    }

    /// The vertices of a pair of edges.
    ///
    /// # Panics
    /// If there is no such edge.
    #[must_use]
    pub fn edge_edge(&self, pair: [u32; 2]) -> [u32; 4] {
        EdgeEdge::vertices(&self.mesh, pair).expect("the mesh has both")
    }

    /// Whether two primitives have no vertex in common, and are not both of obstacles.
    pub(super) fn is_of_concern(&self, a: &[u32], b: &[u32]) -> bool {
        let is_obstacle = |vertex: &u32| self.obstacle[*vertex as usize];
        a.iter().all(|vertex| !b.contains(vertex)) && !a.iter().chain(b).all(is_obstacle)
    }
}
