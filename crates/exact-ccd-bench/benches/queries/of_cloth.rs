//! The candidates of a step as queries of a batch.

use exact_ccd::{EdgeEdge, VertexFace};
use exact_ccd_mesh::{Bvh, Candidates, PairKind, Step};

/// For each candidate vertex and face the four vertices of the query.
pub(crate) fn vertex_face(step: Step<'_>) -> Vec<[u32; 4]> {
    queries::<VertexFace>(step, Candidates::new(step, &Bvh).vertex_face())
}

/// For each two candidate edges the four vertices of the query.
pub(crate) fn edge_edge(step: Step<'_>) -> Vec<[u32; 4]> {
    queries::<EdgeEdge>(step, Candidates::new(step, &Bvh).edge_edge())
}

fn queries<K: PairKind>(step: Step<'_>, pairs: &[[u32; 2]]) -> Vec<K::Vertices> {
    let vertices = |&ids| K::vertices(step.mesh(), ids);
    pairs.iter().filter_map(vertices).collect()
}
