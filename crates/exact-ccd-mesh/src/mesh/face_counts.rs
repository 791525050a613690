//! The number of faces at each edge.

use rayon::prelude::*;

use super::connectivity::{TriangleMesh, sides};

impl TriangleMesh {
    /// The number of faces at each of the [edges](Self::edges): 1 at a rim, 0 for a loose edge. A face that
    /// has an edge twice counts twice.
    ///
    /// ```
    /// use exact_ccd_mesh::TriangleMesh;
    ///
    /// let mesh = TriangleMesh::with_edges(5, vec![[0, 1, 2], [2, 1, 3]], &[[3, 4]])?;
    /// assert_eq!(mesh.edges(), [[0, 1], [0, 2], [1, 2], [1, 3], [2, 3], [3, 4]]);
    /// assert_eq!(mesh.face_counts(), [1, 1, 2, 1, 1, 0]);
    /// # Ok::<(), exact_ccd_mesh::MeshError>(())
    /// ```
    #[must_use]
    pub fn face_counts(&self) -> Vec<u32> {
        let all = self.faces().par_iter().flat_map_iter(sides);
        let mut all: Vec<[u32; 2]> = all.filter(|[a, b]| a != b).collect();
        // The order of the edges: each run of equal sides is the next edge.
        all.par_sort_unstable_by_key(|&[a, b]| (b, a));
        let runs = all.chunk_by(|a, b| a == b).map(|run| run.len() as u32);
        runs.chain(self.loose_edges().iter().map(|_| 0)).collect()
    }
}
