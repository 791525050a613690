//! The primitives that take part in a step, in the order of their first vertices.

use std::collections::HashSet;

use crate::mesh::{TriangleMesh, sides};
use crate::pairs::CanCollide;

/// Those of the edges that belong to no face that takes part.
pub(super) fn loose_edges(mesh: &TriangleMesh, edges: &[u32], can_collide: &CanCollide) -> Vec<u32> {
    let takes_part = |face: &&[u32; 3]| can_collide.takes_part(*face);
    let left_out = mesh.faces().iter().filter(|face| !takes_part(face));
    // Only edges of faces that are left out may lack a face.
    let mut lacking: HashSet<[u32; 2]> = left_out.flat_map(sides).collect();
    if !lacking.is_empty() {
        for side in mesh.faces().iter().filter(takes_part).flat_map(sides) {
            lacking.remove(&side);
        }
    }
    let first_loose = mesh.edges().len() - mesh.loose_edges().len();
    let is_loose =
        |&edge: &u32| edge as usize >= first_loose || lacking.contains(&mesh.edges()[edge as usize]);
    edges.iter().copied().filter(is_loose).collect()
}

/// The indices of the primitives that take part, in the order of the ranks of their first vertices.
pub(super) fn by_first_vertex<const N: usize>(
    rank: &[u32],
    primitives: &[[u32; N]],
    can_collide: &CanCollide,
) -> Vec<u32> {
    let first = |vertices: &[u32; N]| vertices.iter().map(|&v| rank[v as usize]).min().unwrap_or(0);
    let taking_part = || {
        (0..)
            .zip(primitives)
            .filter(|(_, vertices)| can_collide.takes_part(*vertices))
    };
    // A counting sort: `begin` has the first place of each rank.
    let mut begin = vec![0u32; rank.len() + 1];
    let mut sum = 0;
    for (_, vertices) in taking_part() {
        begin[first(vertices) as usize + 1] += 1;
        sum += 1;
    }
    let mut ids = vec![0; sum];
    let mut sum = 0;
    for count in &mut begin {
        sum += *count;
        *count = sum;
    }
    for (id, vertices) in taking_part() {
        let place = &mut begin[first(vertices) as usize];
        ids[*place as usize] = id;
        *place += 1;
    }
    ids
}
