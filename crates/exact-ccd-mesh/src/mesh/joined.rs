//! Several meshes as one.

use super::connectivity::{MeshError, TriangleMesh};

impl TriangleMesh {
    /// The mesh of the faces, loose edges and vertices of several meshes, one after the other.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let face = TriangleMesh::new(3, vec![[0, 1, 2]])?;
    /// let rod = TriangleMesh::with_edges(2, Vec::new(), &[[0, 1]])?;
    /// let mesh = TriangleMesh::joined([&face, &rod, &face])?;
    /// assert_eq!((mesh.vertex_count(), mesh.faces()), (8, &[[0, 1, 2], [5, 6, 7]][..]));
    /// assert_eq!(mesh.loose_edges(), [[3, 4]]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// [`MeshError::TooManyVertices`], if all have more than 2³² − 1 vertices.
    pub fn joined<'a>(meshes: impl IntoIterator<Item = &'a Self>) -> Result<Self, MeshError> {
        let (mut vertex_count, mut faces, mut edges) = (0_usize, Vec::new(), Vec::new());
        for mesh in meshes {
            // Indices that do not fit are an error below: there are too many vertices.
            let first = vertex_count as u32;
            let place = |vertex: u32| vertex.wrapping_add(first);
            faces.extend(mesh.faces().iter().map(|face| face.map(place)));
            edges.extend(mesh.loose_edges().iter().map(|edge| edge.map(place)));
            let count = vertex_count.checked_add(mesh.vertex_count());
            vertex_count = count.ok_or(MeshError::TooManyVertices {
                vertex_count: usize::MAX,
            })?;
        }
        Self::with_edges(vertex_count, faces, &edges)
    }
}
