//! The kinds of query.

use crate::error::Error;

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

const KINDS: [Kind; 4] = [
    Kind::VertexFace,
    Kind::EdgeEdge,
    Kind::VertexEdge,
    Kind::VertexVertex,
];

/// The kind that a number stands for.
pub(crate) fn kind_of(number: u32) -> Result<Kind, Error> {
    let kind = KINDS.into_iter().find(|&kind| kind as u32 == number);
    kind.ok_or_else(|| {
        Error::argument(format_args!(
            "kind is {number}, expected a value of exact_ccd_kind, 0 to {}",
            KINDS.len() - 1
        ))
    })
}

/// Evaluates an expression with a type `$K`, the kind that the number stands for.
macro_rules! with_kind {
    ($number:expr, $K:ident => $body:expr) => {
        $crate::kind::with_kind!($number, $K => $body; VertexFace, EdgeEdge, VertexEdge, VertexVertex)
    };
    ($number:expr, $K:ident => $body:expr; $($kind:ident),+) => {
        match $crate::kind::kind_of($number) {
            $(Ok($crate::kind::Kind::$kind) => {
                type $K = exact_ccd::$kind;
                $body
            })+
            Err(error) => Err(error),
        }
    };
}
pub(crate) use with_kind;
