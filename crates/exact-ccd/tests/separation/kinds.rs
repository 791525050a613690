//! Queries of all kinds from four points.

use exact_ccd::{EdgeEdge, Kind, Query, VertexEdge, VertexFace, VertexVertex};

use crate::primitives::Points;

/// A kind of query whose points are some of four.
pub(crate) trait FromFour: Kind + 'static {
    /// Orders of the four points that leave the primitives the same.
    const RENAMINGS: &'static [[usize; 4]];

    /// The points that the kind uses, at t = 0 and at t = 1.
    fn points(points: &Points) -> [Self::Points; 2];

    /// The query of these points, which are finite.
    fn query(points: &Points) -> Query<Self> {
        let [start, end] = Self::points(points);
        Query::new(start, end).unwrap()
    }
}

impl FromFour for VertexFace {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [0, 2, 1, 3], [0, 3, 1, 2], [0, 3, 2, 1]];

    fn points(points: &Points) -> [Self::Points; 2] {
        *points
    }
}

impl FromFour for EdgeEdge {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [1, 0, 2, 3], [2, 3, 0, 1], [3, 2, 0, 1]];

    fn points(points: &Points) -> [Self::Points; 2] {
        *points
    }
}

impl FromFour for VertexEdge {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [0, 1, 3, 2]];

    fn points(points: &Points) -> [Self::Points; 2] {
        points.map(|now| [now[0], now[2], now[3]])
    }
}

impl FromFour for VertexVertex {
    const RENAMINGS: &'static [[usize; 4]] = &[[0, 1, 2, 3], [2, 3, 0, 1]];

    fn points(points: &Points) -> [Self::Points; 2] {
        points.map(|now| [now[0], now[2]])
    }
}

/// A test of each kind: `$test::<K>()`.
macro_rules! for_each_kind {
    ($($name:ident => $test:ident;)*) => { $(
        mod $name {
            #[test]
            fn vertex_face() {
                super::$test::<exact_ccd::VertexFace>();
            }

            #[test]
            fn edge_edge() {
                super::$test::<exact_ccd::EdgeEdge>();
            }

            #[test]
            fn vertex_edge() {
                super::$test::<exact_ccd::VertexEdge>();
            }

            #[test]
            fn vertex_vertex() {
                super::$test::<exact_ccd::VertexVertex>();
            }
        }
    )* };
}
pub(crate) use for_each_kind;
