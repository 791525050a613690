//! The candidates of a step as queries of a batch.

use exact_ccd_mesh::{Bvh, Candidates, Step};

/// For each candidate vertex and face the four vertices of the query.
pub(crate) fn vertex_face(step: Step<'_>) -> Vec<[u32; 4]> {
    let faces = step.mesh().faces();
    let query = |&[vertex, face]: &[u32; 2]| {
        let [a, b, c] = faces[face as usize];
        [vertex, a, b, c]
    };
    Candidates::new(step, &Bvh)
        .vertex_face()
        .iter()
        .map(query)
        .collect()
}

/// For each two candidate edges the four vertices of the query.
pub(crate) fn edge_edge(step: Step<'_>) -> Vec<[u32; 4]> {
    let edges = step.mesh().edges();
    let query = |&[a, b]: &[u32; 2]| {
        let ([a0, a1], [b0, b1]) = (edges[a as usize], edges[b as usize]);
        [a0, a1, b0, b1]
    };
    Candidates::new(step, &Bvh)
        .edge_edge()
        .iter()
        .map(query)
        .collect()
}
