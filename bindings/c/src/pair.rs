//! Pairs of primitives as C structures.

use exact_ccd_mesh::TriangleMesh;

/// The index of no vertex, no edge and no face.
pub const EXACT_CCD_NONE: u32 = 0xFFFF_FFFF;

/// Two primitives of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The kind of the pair, of `exact_ccd_kind_t`.
    pub kind: u32,
    /// The index of the first primitive: the vertex, or the edge of the smaller index.
    pub first: u32,
    /// The index of the second: the face, the edge or the vertex.
    pub second: u32,
    /// The vertices, in the order of the kind; `EXACT_CCD_NONE` in the places that the kind does not use.
    pub vertices: [u32; 4],
}

impl Pair {
    pub(crate) fn of(mesh: &TriangleMesh, pair: exact_ccd_mesh::Pair) -> Self {
        let [first, second] = pair.ids();
        let mut vertices = [EXACT_CCD_NONE; 4];
        // A pair is of primitives that the mesh has.
        let of_pair = pair.vertices(mesh).unwrap_or_default();
        for (place, &vertex) in vertices.iter_mut().zip(&of_pair) {
            *place = vertex;
        }
        Self {
            kind: pair.kind() as u32,
            first,
            second,
            vertices,
        }
    }
}
