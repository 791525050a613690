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
        match pair {
            Pair::VertexFace { vertex, face } => Self {
                vertices: vec![vertex],
                faces: vec![face],
                edges: Vec::new(),
            },
            Pair::EdgeEdge { a, b } => Self {
                edges: [a, b].into_iter().filter_map(|edge| ends(mesh, edge)).collect(),
                ..Self::default()
            },
            Pair::VertexEdge { vertex, edge } => Self {
                vertices: vec![vertex],
                edges: ends(mesh, edge).into_iter().collect(),
                faces: Vec::new(),
            },
            Pair::VertexVertex { a, b } => Self {
                vertices: vec![a, b],
                ..Self::default()
            },
        }
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
