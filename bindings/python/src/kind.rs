//! The kinds of queries, and their arrays.

use exact_ccd::{EdgeEdge, Kind, Point, VertexEdge, VertexFace, VertexVertex};
use pyo3::PyErr;

use crate::error::refused;

/// The names of the kinds in Python, and the numbers of points of a query. The place of a kind is its number.
pub(crate) const KINDS: [(&str, usize); 4] = [("vf", 4), ("ee", 4), ("ve", 3), ("vv", 2)];

/// A kind of queries in arrays.
pub(crate) trait ArrayKind: Kind + Send + Sync {
    /// The place in [`KINDS`].
    const NUMBER: u8;

    /// The name in Python.
    const NAME: &'static str = KINDS[Self::NUMBER as usize].0;

    /// True if the second primitive is a face.
    const IS_FACE: bool;

    /// Queries as their points, from coordinates.
    fn points(coordinates: &[f64]) -> &[[Self::Points; 2]];

    /// Queries as their vertices.
    fn vertices(indices: &[u32]) -> &[Self::Vertices];
}

/// A kind of queries by its number.
macro_rules! array_kind {
    ($kind:ident, $number:literal, $is_face:literal) => {
        impl ArrayKind for $kind {
            const NUMBER: u8 = $number;
            const IS_FACE: bool = $is_face;

            fn points(coordinates: &[f64]) -> &[[[Point; KINDS[$number].1]; 2]] {
                let points = coordinates.as_chunks().0;
                points.as_chunks().0.as_chunks().0
            }

            fn vertices(indices: &[u32]) -> &[[u32; KINDS[$number].1]] {
                indices.as_chunks().0
            }
        }
    };
}

array_kind!(VertexFace, 0, true);
array_kind!(EdgeEdge, 1, false);
array_kind!(VertexEdge, 2, false);
array_kind!(VertexVertex, 3, false);

/// The error for a kind of another name.
pub(crate) fn unknown(name: &str) -> PyErr {
    let names = KINDS.map(|(name, _)| format!("{name:?}")).join(", ");
    refused(format_args!("kind {name:?}, expected one of {names}"))
}

/// Evaluates an expression for the kind of a name.
macro_rules! for_kind {
    ($name:expr, $kind:ident => $value:expr) => {{
        use exact_ccd::{EdgeEdge, VertexEdge, VertexFace, VertexVertex};
        match $name {
            <VertexFace as ArrayKind>::NAME => {
                type $kind = VertexFace;
                $value
            }
            <EdgeEdge as ArrayKind>::NAME => {
                type $kind = EdgeEdge;
                $value
            }
            <VertexEdge as ArrayKind>::NAME => {
                type $kind = VertexEdge;
                $value
            }
            <VertexVertex as ArrayKind>::NAME => {
                type $kind = VertexVertex;
                $value
            }
            name => Err($crate::kind::unknown(name)),
        }
    }};
}
pub(crate) use for_kind;
