//! The kinds of query, each from four points.

use exact_ccd::{EdgeEdge, Kind, VertexEdge, VertexFace, VertexVertex};

use crate::primitives::Primitives;

/// A kind of query, made of four points like one of two primitives of a mesh. A vertex of an edge is that
/// edge at a parameter that is fixed.
pub trait Hard: Kind {
    /// The kind of query with four points.
    type Four: Primitives;
    /// The name in files.
    const NAME: &'static str;
    /// The ends of e₁ and e₂ among the four points: their cross product is the normal.
    const SPANNING: [[usize; 2]; 2];
    /// The place (t, u, v) of the query with four points at which this query is.
    fn in_place(place: [f64; 3]) -> [f64; 3] {
        place
    }
}

impl Hard for VertexFace {
    type Four = Self;
    const NAME: &'static str = "vf";
    const SPANNING: [[usize; 2]; 2] = [[1, 2], [1, 3]];
}

impl Hard for EdgeEdge {
    type Four = Self;
    const NAME: &'static str = "ee";
    const SPANNING: [[usize; 2]; 2] = [[0, 1], [2, 3]];
}

impl Hard for VertexEdge {
    type Four = EdgeEdge;
    const NAME: &'static str = "ve";
    const SPANNING: [[usize; 2]; 2] = EdgeEdge::SPANNING;

    fn in_place([t, _, v]: [f64; 3]) -> [f64; 3] {
        [t, 0.0, v]
    }
}

impl Hard for VertexVertex {
    type Four = EdgeEdge;
    const NAME: &'static str = "vv";
    const SPANNING: [[usize; 2]; 2] = EdgeEdge::SPANNING;

    fn in_place([t, _, _]: [f64; 3]) -> [f64; 3] {
        [t, 0.0, 1.0]
    }
}
