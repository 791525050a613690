//! The connected components of a mesh.

use super::connectivity::TriangleMesh;
use super::disjoint_sets::DisjointSets;

impl TriangleMesh {
    /// The number of connected components: sets of vertices that edges connect, and each loose vertex.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::with_edges(7, vec![[0, 1, 2]], &[[2, 3], [4, 5]])?;
    /// assert_eq!(mesh.component_count(), 3);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn component_count(&self) -> usize {
        let mut components = DisjointSets::new(self.vertex_count());
        let joining = self.edges().iter().filter(|[a, b]| components.unite(*a, *b));
        self.vertex_count() - joining.count()
    }
}
