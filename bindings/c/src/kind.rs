//! The kinds of query.

/// The kind of a query: the two primitives, and the order of its points.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A vertex and the three corners of a face: 4 points.
    VertexFace = 0,
    /// The two ends of an edge, and those of another edge: 4 points.
    EdgeEdge = 1,
    /// A vertex and the two ends of an edge: 3 points.
    VertexEdge = 2,
    /// Two vertices: 2 points.
    VertexVertex = 3,
}

/// Evaluates an expression with a type `$K`, the kind that the number stands for.
macro_rules! with_kind {
    ($number:expr, $K:ident => $body:expr) => {
        match $number {
            0 => {
                type $K = exact_ccd::VertexFace;
                $body
            }
            1 => {
                type $K = exact_ccd::EdgeEdge;
                $body
            }
            2 => {
                type $K = exact_ccd::VertexEdge;
                $body
            }
            3 => {
                type $K = exact_ccd::VertexVertex;
                $body
            }
            other => Err($crate::error::Error::argument(format_args!(
                "kind is {other}, expected a value of exact_ccd_kind, 0 to 3"
            ))),
        }
    };
}
pub(crate) use with_kind;
