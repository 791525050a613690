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
        let components = self.components();
        let least = (0..).zip(&components).filter(|(vertex, least)| vertex == *least);
        least.count()
    }

    /// The least vertex of the connected component of each vertex.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::with_edges(6, vec![[0, 4, 2]], &[[5, 3]])?;
    /// assert_eq!(mesh.components(), [0, 1, 0, 3, 0, 3]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn components(&self) -> Vec<u32> {
        let mut sets = DisjointSets::new(self.vertex_count());
        for &[a, b] in self.edges() {
            sets.unite(a, b);
        }
        let mut least = vec![u32::MAX; self.vertex_count()];
        let of_vertex = |vertex: u32| {
            let least = &mut least[sets.root(vertex) as usize];
            *least = vertex.min(*least);
            *least
        };
        (0..self.vertex_count() as u32).map(of_vertex).collect()
    }
}
