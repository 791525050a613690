//! The surface on which contact acts.

use exact_ccd_mesh::{Point, TriangleMesh};

/// The mesh of all surfaces, with the data on which their barriers depend. One entry for each vertex.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The connectivity.
    pub mesh: &'a TriangleMesh,
    /// The positions at rest, in m, from which mollifiers take the lengths of edges.
    pub rest: &'a [Point],
    /// The offsets of the contact surface from the mesh, in m. Vertices without an entry have none.
    pub offsets: &'a [f64],
}

impl Surface<'_> {
    /// ξ of two primitives: the sum of their offsets. The offset of a primitive is the largest of its
    /// vertices.
    pub(crate) fn thickness(&self, a: &[u32], b: &[u32]) -> f64 {
        let offset = |vertices: &[u32]| {
            let offsets = vertices
                .iter()
                .filter_map(|&vertex| self.offsets.get(vertex as usize));
            offsets.fold(0.0, |largest: f64, &offset| largest.max(offset))
        };
        offset(a) + offset(b)
    }
}
