//! The kinds of query.

use exact_ccd::AnyKind;

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

// The kinds of queries have the same numbers in both lists.
const _: () = assert!(Kind::EdgeFace as usize == AnyKind::ALL.len());

/// The kind of query that a number stands for.
pub(crate) fn query_kind(number: u32) -> Result<AnyKind, Error> {
    let kind = AnyKind::ALL.get(number as usize).copied();
    kind.ok_or_else(|| {
        Error::argument(format_args!(
            "kind is {number}, expected the kind of a query, 0 to {}: see exact_ccd_kind_t",
            AnyKind::ALL.len() - 1
        ))
    })
}
