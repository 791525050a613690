//! Candidates in chunks, as queries of the kernel.

use crate::mesh::TriangleMesh;
use crate::pairs::PairKind;

/// The number of pairs in a chunk.
const CHUNK: usize = 256;

/// Calls a function with the pairs of each chunk that the mesh has and that can collide, and their vertices.
#[inline(always)]
pub(super) fn for_each_chunk<K: PairKind>(
    mesh: &TriangleMesh,
    pairs: &[[u32; 2]],
    can_collide: impl Fn(&K::Vertices) -> bool,
    mut examine: impl FnMut(&[[u32; 2]], &[K::Vertices]),
) {
    let (mut colliding, mut queries) = ([[0; 2]; CHUNK], [K::Vertices::default(); CHUNK]);
    for pairs in pairs.chunks(CHUNK) {
        let mut count = 0;
        for &ids in pairs {
            if let Some(vertices) = K::vertices(mesh, ids) {
                // Without a branch, which may be hard to predict.
                (colliding[count % CHUNK], queries[count % CHUNK]) = (ids, vertices);
                count += usize::from(can_collide(&vertices));
            }
        }
        examine(&colliding[..count], &queries[..count]);
    }
}
