//! Marked parts of a mesh.

use exact_ccd_mesh::{Intersection, Pair, TriangleMesh};

/// Parts of a mesh to draw in a distinct colour, for example those in contact.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Vertices.
    pub vertices: Vec<u32>,
    /// Edges, each by its two vertices.
    pub edges: Vec<[u32; 2]>,
    /// Faces, by their index.
    pub faces: Vec<u32>,
}

impl Marks {
    /// The two primitives of a pair. Indices out of range are left out.
    #[must_use]
    pub fn pair(mesh: &TriangleMesh, pair: Pair) -> Self {
        let mut marks = Self::default();
        for (id, size) in pair.ids().into_iter().zip(pair.kind().sizes()) {
            match size {
                1 => marks.vertices.push(id),
                2 => marks.edges.extend(ends(mesh, id)),
                _ => marks.faces.push(id),
            }
        }
        marks
    }

    /// The edge and the face of an intersection. Indices out of range are left out.
    #[must_use]
    pub fn intersection(mesh: &TriangleMesh, intersection: Intersection) -> Self {
        Self {
            edges: ends(mesh, intersection.edge).into_iter().collect(),
            faces: vec![intersection.face],
            vertices: Vec::new(),
        }
    }
}

fn ends(mesh: &TriangleMesh, edge: u32) -> Option<[u32; 2]> {
    mesh.edges().get(edge as usize).copied()
}
