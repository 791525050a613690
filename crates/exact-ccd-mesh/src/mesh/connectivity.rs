//! The connectivity of a triangle mesh.

use std::sync::Arc;

/// The connectivity of a mesh: faces, edges and vertices. An edge is *loose* if it belongs to no face, such
/// as the edges of rods. A vertex is loose if it has no edge, such as points.
///
/// A clone shares the faces and the edges: the frames of a motion have them in memory once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TriangleMesh {
    vertex_count: usize,
    faces: Arc<[[u32; 3]]>,
    /// The edges of the faces, then the loose edges. Each edge occurs once.
    edges: Arc<[[u32; 2]]>,
    face_edge_count: usize,
}

/// The reason why faces and edges do not form a [`TriangleMesh`]. All are counted from 0.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The index of a corner is out of range.
    #[error("face {face} names vertex {vertex}, but there are only {vertex_count} vertices")]
    Face {
        /// The index of the face.
        face: usize,
        /// The index of the corner.
        vertex: u32,
        /// The number of vertices.
        vertex_count: usize,
    },
    /// The index of an end point is out of range.
    #[error("edge {edge} names vertex {vertex}, but there are only {vertex_count} vertices")]
    Edge {
        /// The index of the edge among the given ones.
        edge: usize,
        /// The index of the end point.
        vertex: u32,
        /// The number of vertices.
        vertex_count: usize,
    },
    /// Vertices have 32-bit indices.
    #[error("{vertex_count} vertices, expected at most 2^32 - 1")]
    TooManyVertices {
        /// The number of vertices.
        vertex_count: usize,
    },
}

/// Returns true if the vertices, and their number, are indices.
pub(super) fn has_indices(vertex_count: usize) -> bool {
    u32::try_from(vertex_count).is_ok()
}

impl TriangleMesh {
    /// The mesh of these faces, each three indices of vertices from 0.
    ///
    /// # Errors
    /// [`MeshError`] names the first face with an index that is not below `vertex_count`, or that
    /// count if it exceeds 2³² − 1.
    pub fn new(vertex_count: usize, faces: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        Self::with_edges(vertex_count, faces, &[])
    }

    /// The mesh of these faces and edges, each three or two indices of vertices from 0.
    ///
    /// [`TriangleMesh::edges`] has the edges of the faces first, with the same indices as without
    /// `edges`, then the `edges` that belong to no face. Each edge occurs once. An edge from a vertex to
    /// itself is left out: it is the same set of points as the vertex.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// // A triangle, and a rod that leads away from it. Vertex 5 is a point.
    /// let mesh = TriangleMesh::with_edges(6, vec![[0, 1, 2]], &[[4, 3], [1, 0], [2, 3], [3, 4]])?;
    /// assert_eq!(mesh.edges(), [[0, 1], [0, 2], [1, 2], [2, 3], [3, 4]]);
    /// assert_eq!(mesh.loose_edges(), [[2, 3], [3, 4]]);
    /// assert_eq!(mesh.loose_vertices().collect::<Vec<_>>(), [5]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// [`MeshError`] names the first face or edge with an index that is not below `vertex_count`,
    /// or that count if it exceeds 2³² − 1.
    pub fn with_edges(
        vertex_count: usize,
        faces: Vec<[u32; 3]>,
        edges: &[[u32; 2]],
    ) -> Result<Self, MeshError> {
        if !has_indices(vertex_count) {
            return Err(MeshError::TooManyVertices { vertex_count });
        }
        if let Some((face, vertex)) = out_of_range(&faces, vertex_count) {
            return Err(MeshError::Face {
                face,
                vertex,
                vertex_count,
            });
        }
        if let Some((edge, vertex)) = out_of_range(edges, vertex_count) {
            return Err(MeshError::Edge {
                edge,
                vertex,
                vertex_count,
            });
        }
        let mut all = unique(faces.iter().flat_map(sides));
        let face_edge_count = all.len();
        let mut loose = unique(edges.iter().copied());
        loose.retain(|&edge| all.binary_search_by_key(&order(edge), |&e| order(e)).is_err());
        all.append(&mut loose);
        Ok(Self {
            vertex_count,
            faces: faces.into(),
            edges: all.into(),
            face_edge_count,
        })
    }

    /// The mesh without the vertices of no face and no edge, and the index here of each remaining
    /// vertex, in increasing order.
    ///
    /// Faces and edges keep their order.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::new(9, vec![[7, 4, 2]])?;
    /// let (compact, vertices) = mesh.without_unused_vertices();
    /// assert_eq!((compact.vertex_count(), compact.faces()), (3, &[[2, 1, 0]][..]));
    /// assert_eq!(vertices, [2, 4, 7]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn without_unused_vertices(&self) -> (Self, Vec<u32>) {
        let vertices = self.used_vertices();
        // Memory is proportional to the faces and edges: a table of all vertices could exceed any
        // memory.
        let index = |vertex: u32| vertices.partition_point(|&used| used < vertex) as u32;
        let mesh = Self {
            vertex_count: vertices.len(),
            faces: self.faces.iter().map(|face| face.map(index)).collect(),
            // The map is increasing, so edges stay in order.
            edges: self.edges.iter().map(|edge| edge.map(index)).collect(),
            face_edge_count: self.face_edge_count,
        };
        (mesh, vertices)
    }

    /// The number of vertices, at most 2³² − 1.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// The faces, in the given order.
    #[must_use]
    pub fn faces(&self) -> &[[u32; 3]] {
        &self.faces
    }

    /// The edges of the faces, then the loose edges.
    ///
    /// Both parts hold pairs (i, j) with i < j, each once, sorted by j, then by i. That is the
    /// order of the published data sets.
    #[must_use]
    pub fn edges(&self) -> &[[u32; 2]] {
        &self.edges
    }

    /// The edges that are not edges of a face, as of rods: the last ones of [`TriangleMesh::edges`].
    #[must_use]
    pub fn loose_edges(&self) -> &[[u32; 2]] {
        &self.edges[self.face_edge_count..]
    }

    /// The index of the edge between two vertices, if there is one.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::with_edges(5, vec![[2, 1, 0]], &[[4, 3]])?;
    /// assert_eq!([[2, 0], [3, 4], [2, 3]].map(|[a, b]| mesh.edge(a, b)), [Some(1), Some(3), None]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn edge(&self, a: u32, b: u32) -> Option<u32> {
        let key = order([a.min(b), a.max(b)]);
        let place = |edges: &[[u32; 2]]| edges.binary_search_by_key(&key, |&edge| order(edge)).ok();
        let (of_faces, loose) = self.edges.split_at(self.face_edge_count);
        let edge = place(of_faces).or_else(|| Some(of_faces.len() + place(loose)?));
        edge.map(|edge| edge as u32)
    }

    /// The vertices without an edge, in increasing order.
    ///
    /// A vertex of a face whose three corners are the same vertex is loose, too. The iterator is lazy: a
    /// mesh may have more vertices than fit into memory.
    pub fn loose_vertices(&self) -> impl Iterator<Item = u32> + use<> {
        let mut used = sorted(self.edges.as_flattened().to_vec()).into_iter().peekable();
        (0..self.vertex_count as u32).filter(move |&vertex| used.next_if_eq(&vertex).is_none())
    }

    /// The vertices of faces and edges, each once, in increasing order.
    fn used_vertices(&self) -> Vec<u32> {
        let corners = self.faces.as_flattened().iter();
        sorted(corners.chain(self.edges.as_flattened()).copied().collect())
    }
}

/// Vertices in increasing order, each once.
fn sorted(mut vertices: Vec<u32>) -> Vec<u32> {
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

/// The edges of a face as pairs (i, j), i ≤ j.
pub(crate) fn sides(&[a, b, c]: &[u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}

/// The first element with a vertex that is out of range, and that vertex.
fn out_of_range<const N: usize>(elements: &[[u32; N]], vertex_count: usize) -> Option<(usize, u32)> {
    let bad = |corners: &[u32; N]| {
        corners
            .iter()
            .copied()
            .find(|&vertex| vertex as usize >= vertex_count)
    };
    elements
        .iter()
        .enumerate()
        .find_map(|(index, corners)| Some((index, bad(corners)?)))
}

/// Edges as pairs (i, j) with i < j, each once, sorted. Pairs of equal vertices are left out.
fn unique(pairs: impl Iterator<Item = [u32; 2]>) -> Vec<[u32; 2]> {
    let mut edges: Vec<[u32; 2]> = pairs
        .filter(|[a, b]| a != b)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    edges.sort_unstable_by_key(|&edge| order(edge));
    edges.dedup();
    edges
}

fn order([i, j]: [u32; 2]) -> (u32, u32) {
    (j, i)
}
