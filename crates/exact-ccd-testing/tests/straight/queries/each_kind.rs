//! Tests of every kind of query.

/// A test of each kind of query: `$test::<K>()`.
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
