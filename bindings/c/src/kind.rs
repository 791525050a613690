//! The kinds of query.

use crate::error::Error;

/// The kind of a query: the two primitives, and the order of its points.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A vertex and the three corners of a face: 4 points.
    VertexFace = 0,
    /// The two ends of an edge, and the two ends of another edge: 4 points.
    EdgeEdge = 1,
    /// A vertex and the two ends of an edge: 3 points.
    VertexEdge = 2,
    /// Two vertices: 2 points.
    VertexVertex = 3,
    /// An edge and a face that meet at rest: the kind of an intersection, which is no query.
    EdgeFace = 4,
}

/// Evaluates an expression with a type `$K`, the kind that the number stands for.
macro_rules! with_kind {
    ($number:expr, $K:ident => $body:expr) => {
        $crate::kind::with_kind!($number, $K => $body; VertexFace, EdgeEdge, VertexEdge, VertexVertex)
    };
    ($number:expr, $K:ident => $body:expr; $($kind:ident),+) => {
        match $number {
            $(number if number == $crate::kind::Kind::$kind as u32 => {
                type $K = exact_ccd::$kind;
                $body
            })+
            other => Err($crate::kind::unknown(other)),
        }
    };
}
pub(crate) use with_kind;

#[cold]
pub(crate) fn unknown(number: u32) -> Error {
    Error::argument(format_args!(
        "kind is {number}, expected the kind of a query, 0 to {}: see exact_ccd_kind_t",
        Kind::VertexVertex as u32
    ))
}
