//! Generated cloth as a mesh in motion, and the candidates of a step of it as queries of a batch.

use exact_ccd::{AnyKind, EdgeEdge, VertexFace};
use exact_ccd_mesh::{BoxKind, Bvh, CandidateOptions, Candidates, Motion, PairKind, Step, TriangleMesh};
use exact_ccd_testing::meshes::cloth;

/// Sheets of cloth that fall onto each other.
pub struct Cloth(Motion);

impl Cloth {
    /// Sheets of `side` × `side` vertices whose distance falls to `nearest`, apart from their unevenness.
    #[must_use]
    pub fn new(side: usize, nearest: f64) -> Self {
        let cloth::Cloth { faces, x0, x1 } = cloth::Cloth::new(side, nearest);
        let mesh = TriangleMesh::new(x0.len(), faces).expect("all vertices of faces are there");
        Self(Motion { mesh, x0, x1 })
    }

    /// The step of all sheets.
    #[must_use]
    pub fn step(&self) -> Step<'_> {
        let step = self.0.step();
        step.expect("the positions are as many as vertices, and finite")
    }
}

/// For each candidate vertex and face the four vertices of the query.
pub fn vertex_face(step: Step<'_>) -> Vec<[u32; 4]> {
    queries::<VertexFace>(step, candidates(step).of_kind(AnyKind::VertexFace))
}

/// For each two candidate edges the four vertices of the query.
pub fn edge_edge(step: Step<'_>) -> Vec<[u32; 4]> {
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
