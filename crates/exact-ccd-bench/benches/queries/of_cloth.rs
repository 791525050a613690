//! The candidates of a step as queries of a batch.

use exact_ccd::{AnyKind, EdgeEdge, VertexFace};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, PairKind, Step};

/// For each candidate vertex and face the four vertices of the query.
pub(crate) fn vertex_face(step: Step<'_>) -> Vec<[u32; 4]> {
    queries::<VertexFace>(step, candidates(step).of_kind(AnyKind::VertexFace))
}

/// For each two candidate edges the four vertices of the query.
pub(crate) fn edge_edge(step: Step<'_>) -> Vec<[u32; 4]> {
    queries::<EdgeEdge>(step, candidates(step).of_kind(AnyKind::EdgeEdge))
}

/// The pairs whose boxes around the path meet. Most of them are easy, as with other broad phases.
fn candidates(step: Step<'_>) -> Candidates {
    let options = CandidateOptions::default().with_boxes(BoxKind::Swept);
    Candidates::with_options(step, &Bvh, &options).expect("the default distances are 0")
}

fn queries<K: PairKind>(step: Step<'_>, pairs: &[[u32; 2]]) -> Vec<K::Vertices> {
    let vertices = |&ids| K::vertices(step.mesh(), ids);
    pairs.iter().filter_map(vertices).collect()
}
