//! The surface on which contact acts.

use exact_ccd_mesh::{Point, TriangleMesh};

use super::weights::Weights;
use crate::half_space::HalfSpace;

/// The mesh of all surfaces, with the data on which their barriers depend.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    /// The connectivity.
    pub(crate) mesh: &'a TriangleMesh,
    /// The positions at rest, in m, from which mollifiers take the lengths of edges.
    pub(crate) rest: &'a [Point],
    /// The offsets of the contact surface from the mesh, in m. Vertices without an entry have none.
    pub(crate) offsets: &'a [f64],
    pub(crate) half_spaces: &'a [HalfSpace],
    /// The vertices for which half spaces are obstacles.
    pub(crate) grounded: &'a [u32],
    /// True for the vertices that never move. Vertices without an entry may move.
    pub(crate) fixed: &'a [bool],
    /// The weights of the convergent formulation; `None` for the sum over all pairs of primitives.
    pub(crate) weights: Option<&'a Weights>,
}

impl<'a> Surface<'a> {
    /// The surface of a mesh with these positions at rest, without offsets, half spaces and weights.
    #[cfg(test)]
    pub(crate) fn new(mesh: &'a TriangleMesh, rest: &'a [Point]) -> Self {
        Self {
            mesh,
            rest,
            offsets: &[],
            half_spaces: &[],
            grounded: &[],
            fixed: &[],
            weights: None,
        }
    }

    /// Returns true if a vertex never moves.
    pub(super) fn is_fixed(&self, vertex: u32) -> bool {
        self.fixed.get(vertex as usize).is_some_and(|&is_fixed| is_fixed)
    }

    /// The weight of the terms of a vertex. `None` if it has none.
    pub(super) fn weight_of_vertex(&self, vertex: u32) -> Option<f64> {
        self.weights
            .map_or(Some(1.0), |weights| weights.of_vertex(vertex))
    }

    /// The weight of the term of two edges. `None` if there is none.
    pub(super) fn weight_of_edges(&self, edges: [u32; 2]) -> Option<f64> {
        self.weights.map_or(Some(1.0), |weights| weights.of_edges(edges))
    }

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
